// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_RETRIANGULATION_SAMPLED_RESULT_H
#define VCG_EXTRAS_CORE_RETRIANGULATION_SAMPLED_RESULT_H

#include <vcg_extras/core/features/boundary_curves.h>
#include <vcg_extras/core/sampling/front_sampling.h>
#include <vcg_extras/core/surface/result_mesh.h>

#include <vector>

namespace gpr {

/// The mesh while input vertices are removed and afterwards, in the numbering of the start.
struct Retriangulated {
	HalfEdgeMesh     mesh;          ///< with dead faces and vertices
	std::vector<int> sampleVertex;  ///< per sample: its vertex; -1: none
	std::vector<int> surfaceVertex; ///< per vertex: its surface vertex; empty: same numbers
	std::vector<int> todo;          ///< vertices without a sample, to be merged away; in the end
									///< those that had to stay
};

/// Makes a result of the remaining vertices. Moves each to its sample; the others stay in place.
/// Border samples keep their curve; the curve of the others on the border is looked
/// up. Cost: linear, parallel.
ResultMesh resultOfSamples(Retriangulated&& removed, const Surface& surface,
						   const Sampling& sampling, const BoundaryCurves& boundary,
						   Workers& workers);

} // namespace gpr

#endif
