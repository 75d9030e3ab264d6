// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GPR_TESTS_SUPPORT_MESH_ZOO_H
#define GPR_TESTS_SUPPORT_MESH_ZOO_H

#include <vcg_extras/core/mesh_view.h>

#include <ostream>
#include <string>
#include <vector>

namespace gpr::test {

/// A mesh of at most 12 vertices and its facts, known without computing.
struct ZooMesh {
	std::string  name;
	TriangleMesh mesh;
	bool         isManifold    = true; ///< 2-manifold with border, oriented alike
	int          components    = 1;
	int          boundaryLoops = 0;
	int          euler         = 2;
};

inline std::ostream& operator<<(std::ostream& out, const ZooMesh& m)
{
	return out << m.name;
}

/// The smallest meshes of every kind.
std::vector<ZooMesh> meshZoo();

/// For the names of parametrised tests.
template <class Info>
std::string zooName(const Info& info)
{
	return info.param.name;
}

} // namespace gpr::test

#endif
