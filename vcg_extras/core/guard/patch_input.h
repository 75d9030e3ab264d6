// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_GUARD_PATCH_INPUT_H
#define VCG_EXTRAS_CORE_GUARD_PATCH_INPUT_H

#include "patch_labels.h"

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/surface/result_mesh.h>

#include <vector>

namespace gpr {

/// The input near patches of a result, as a mesh of its own with short edges.
struct PatchInput {
	HalfEdgeMesh     mesh;          ///< the input's border edges are marked as creases
	std::vector<int> inputVertex;   ///< per vertex: of the input, the same or one near
	std::vector<int> label;         ///< per vertex: of the result, near it
	int              ownNum    = 0; ///< vertices that are the input's; those after them split edges
	double           share     = 0; ///< vertices, of as many as may be worked on
	bool             isTooMuch = false; ///< there are so many that it was given up
};

/// The longest edge at a vertex.
float longestEdgeAt(const HalfEdgeMesh& mesh, int v);

/// Whether a vertex of the result lies inside a patch and all its neighbours do.
bool isDeep(const HalfEdgeMesh& result, const std::vector<PatchRole>& role, int v);

/// The faces of the input whose corners are nearest, along the input's edges, to vertices of the
/// result that are not Far. Edges are split until they can follow the result's triangles on the
/// border of the patches. Each vertex is labelled by the vertex of the result that has the largest
/// weight at the nearest point of the result's triangles; deep inside patches by the nearest vertex
/// alone. reach: inside patches the input is looked for so many times two edges of the result away.
/// Cost: a pass over the vertices of input and result, and about 5 µs per vertex there.
PatchInput collectPatchInput(const Surface& surface, const ResultMesh& result,
							 const std::vector<PatchRole>& role, float reach, Workers& workers);

} // namespace gpr

#endif
