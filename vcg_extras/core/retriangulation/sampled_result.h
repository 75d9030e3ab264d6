// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_RETRIANGULATION_SAMPLED_RESULT_H
#define VCG_EXTRAS_CORE_RETRIANGULATION_SAMPLED_RESULT_H

#include <vcg_extras/core/features/boundary_curves.h>
#include <vcg_extras/core/sampling/front_sampling.h>
#include <vcg_extras/core/surface/result_mesh.h>

#include <vector>

namespace gpr {

/// The mesh after the removal of input vertices, in the numbering of the start.
struct Retriangulated {
	HalfEdgeMesh     mesh;          ///< with dead faces and vertices
	std::vector<int> sampleVertex;  ///< per sample: its vertex; -1: none
	std::vector<int> leftover;      ///< vertices that had to stay without a sample
	std::vector<int> surfaceVertex; ///< per vertex: its surface vertex; empty: same numbers
};

/// Makes a result of the remaining vertices. Moves each to its sample; leftover vertices stay in
/// place. Border samples keep their curve; the curve of leftover vertices on the border is looked
/// up. Cost: linear, parallel.
ResultMesh resultOfSamples(Retriangulated&& removed, const Surface& surface,
						   const Sampling& sampling, const BoundaryCurves& boundary,
						   Workers& workers);

} // namespace gpr

#endif
