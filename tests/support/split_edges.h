// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GPR_TESTS_SUPPORT_SPLIT_EDGES_H
#define GPR_TESTS_SUPPORT_SPLIT_EDGES_H

#include <vcg_extras/core/input/split_long_edges.h>

#include <numeric>
#include <vector>

namespace gpr::test {

/// splitLongEdges for all faces of a mesh.
inline std::int64_t splitLongEdges(IndexedMesh& mesh, float maxLength, std::int64_t maxFaces,
								   Workers& workers)
{
	std::vector<int> all(std::size_t(mesh.faceNum));
	std::iota(all.begin(), all.end(), 0);
	return gpr::splitLongEdges(mesh, findLongFaces(mesh, maxLength, all, workers), maxLength,
							   maxFaces, workers);
}

} // namespace gpr::test

#endif
