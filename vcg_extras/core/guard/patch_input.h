// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_GUARD_PATCH_INPUT_H
#define VCG_EXTRAS_CORE_GUARD_PATCH_INPUT_H

#include "patch_labels.h"

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/surface/result_mesh.h>

#include <vector>

namespace gpr {

/// The working surface near patches of a result, as a mesh of its own with short edges.
struct PatchInput {
	HalfEdgeMesh     mesh;        ///< crease edges: the border edges of the working surface
	std::vector<int> inputVertex; ///< per vertex: its vertex of the working surface, or one near
	std::vector<int> byEdges, byPlace; ///< per vertex: vertices of the result, the nearest along
									   ///< edges, and the nearest corner of the nearest point
	int    ownNum = 0;                 ///< first vertices, from the working surface
	double share  = 0; ///< ratio of vertices to allowed vertices; above 1: byPlace is unfinished

	/// Per vertex: a near vertex of the result, its label. Labels are corners of the nearest
	/// points; deep inside patches the nearest vertices along edges. role: of the patches as grown.
	std::vector<int> labels(const HalfEdgeMesh& result, const std::vector<PatchRole>& role) const;
};

/// Length of the longest edge at a vertex.
float longestEdgeAt(const HalfEdgeMesh& mesh, int v);

/// Per vertex of the result: whether the vertex and all its neighbours lie inside a patch.
std::vector<char> deepVertices(const HalfEdgeMesh& result, const std::vector<PatchRole>& role);

/// Collects the faces of the working surface with all corners nearest, along edges, to vertices of
/// the result that are not PatchRole::Far. Splits edges longer than 0.4 of the result's longest
/// edge there (deep inside patches 0.6), so that edges can follow the result's triangles. reach:
/// factor on the search distance from vertices of patches. The collected faces serve as long as
/// patches only grow, and only vertices come near a patch that are not PatchRole::Far. Cost: a pass
/// over the result, and about 5 µs per collected vertex.
PatchInput collectPatchInput(const Surface& surface, const ResultMesh& result,
							 const std::vector<PatchRole>& role, float reach, Workers& workers);

} // namespace gpr

#endif
