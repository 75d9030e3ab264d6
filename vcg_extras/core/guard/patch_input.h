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
	HalfEdgeMesh     mesh;          ///< crease edges: the border edges of the working surface
	std::vector<int> inputVertex;   ///< per vertex: its vertex of the working surface, or one near
	std::vector<int> label;         ///< per vertex: a near vertex of the result
	int              ownNum    = 0; ///< first vertices, from the working surface
	double           share     = 0; ///< ratio of vertices to allowed vertices
	bool             isTooMuch = false; ///< share above 1: labels unfinished
};

/// Length of the longest edge at a vertex.
float longestEdgeAt(const HalfEdgeMesh& mesh, int v);

/// Whether a vertex of the result and all its neighbours lie inside a patch.
bool isDeep(const HalfEdgeMesh& result, const std::vector<PatchRole>& role, int v);

/// Collects the faces of the working surface with all corners nearest, along edges, to vertices of
/// the result that are not PatchRole::Far. Splits edges longer than 0.4 of the result's longest
/// edge there (deep inside patches 0.6), so that edges can follow the result's triangles. The label
/// of a vertex is the corner with the largest weight at the nearest point of the result; deep
/// inside patches the nearest vertex along edges. reach: factor on the search distance from
/// vertices of patches. Cost: a pass over the result, and about 5 µs per collected vertex.
PatchInput collectPatchInput(const Surface& surface, const ResultMesh& result,
							 const std::vector<PatchRole>& role, float reach, Workers& workers);

} // namespace gpr

#endif
