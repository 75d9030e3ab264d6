// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_MESH_COMPONENTS_H
#define VCG_EXTRAS_CORE_MESH_COMPONENTS_H

#include "half_edge_mesh.h"

#include <vcg_extras/core/base/poller.h>

#include <vector>

namespace gpr {

/// The components of a mesh.
struct Components {
	int              num = 0;
	std::vector<int> ofFace; ///< per face: the number of its component; numbers follow the first
							 ///< faces
};

/// Finds the components of a mesh without dead faces. isLinked(h): whether the two faces of edge h
/// count as linked. Cost: linear, serial; polls.
template <class IsLinked>
Components findComponents(const HalfEdgeMesh& m, Workers& workers, const IsLinked& isLinked)
{
	Components       found;
	std::vector<int> stack;
	Poller           poller(workers);
	found.ofFace.assign(std::size_t(m.faceNum), -1);
	const auto visit = [&](int f) {
		if (found.ofFace[f] >= 0) return;
		found.ofFace[f] = found.num;
		stack.push_back(f);
	};
	for (int f = 0; f < m.faceNum; ++f) {
		if (found.ofFace[f] >= 0) continue;
		visit(f);
		while (!stack.empty()) {
			const int g = stack.back();
			stack.pop_back();
			poller.count();
			for (int h = 3 * g; h < 3 * g + 3; ++h) {
				if (m.opposite[h] >= 0 && isLinked(h)) visit(m.opposite[h] / 3);
			}
		}
		++found.num;
	}
	return found;
}

/// Finds the components over all inner edges.
inline Components findComponents(const HalfEdgeMesh& mesh, Workers& workers)
{
	return findComponents(mesh, workers, [](int) { return true; });
}

} // namespace gpr

#endif
