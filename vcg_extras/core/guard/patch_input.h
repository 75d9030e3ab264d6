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
	HalfEdgeMesh     mesh;          ///< border edges of the working surface are marked as creases
	std::vector<int> inputVertex;   ///< per vertex: vertex of the working surface, the same or near
	std::vector<int> label;         ///< per vertex: a near vertex of the result
	int              ownNum    = 0; ///< vertices of the working surface; the rest split edges
	double           share     = 0; ///< number of vertices over the most allowed
	bool             isTooMuch = false; ///< more vertices than allowed: unfinished
};

/// Length of the longest edge at a vertex.
float longestEdgeAt(const HalfEdgeMesh& mesh, int v);

/// Whether a vertex of the result and all its neighbours lie inside a patch.
bool isDeep(const HalfEdgeMesh& result, const std::vector<PatchRole>& role, int v);

/// The faces of the working surface with all corners nearest, along edges, to vertices of the
/// result that are not Far. Edges are split until the edges can follow the result's triangles at
/// the border of the patches. The label of a vertex is the vertex of the result with the largest
/// weight at the nearest point of the result; deep inside patches the nearest vertex along edges.
/// reach: factor on the search distance at patches. Cost: a pass over the vertices of the working
/// surface and the result, and about 5 µs per collected vertex.
PatchInput collectPatchInput(const Surface& surface, const ResultMesh& result,
							 const std::vector<PatchRole>& role, float reach, Workers& workers);

} // namespace gpr

#endif
