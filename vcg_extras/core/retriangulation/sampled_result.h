// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_RETRIANGULATION_SAMPLED_RESULT_H
#define VCG_EXTRAS_CORE_RETRIANGULATION_SAMPLED_RESULT_H

#include <vcg_extras/core/features/boundary_curves.h>
#include <vcg_extras/core/sampling/front_sampling.h>
#include <vcg_extras/core/surface/result_mesh.h>

#include <vector>

namespace gpr {

/// What a removal of the input's vertices ends with, in the numbering it began with.
struct Retriangulated {
	HalfEdgeMesh     mesh;          ///< dead faces and vertices among the living ones
	std::vector<int> sampleVertex;  ///< per sample: the vertex that is or stands for it; -1: none
	std::vector<int> leftover;      ///< vertices that had to stay though no sample is there
	std::vector<int> surfaceVertex; ///< per vertex: the surface's; empty: they are numbered alike
};

/// The vertices that are left become the result, each at its sample's place; those left over stay
/// where they were. Samples of the border keep their curve, leftovers on the border find theirs.
/// Cost: linear, parallel.
ResultMesh resultOfSamples(Retriangulated&& removed, const Surface& surface,
						   const Sampling& sampling, const BoundaryCurves& boundary,
						   Workers& workers);

} // namespace gpr

#endif
