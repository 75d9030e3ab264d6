// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_RUN_SAMPLE_STAGES_H
#define VCG_EXTRAS_CORE_RUN_SAMPLE_STAGES_H

#include "products.h"

#include <vcg_extras/core/base/run_context.h>

#include <vector>

namespace gpr {

// From the surface to a mesh with the right count.

/// Blocks of the surface that are sampled by themselves, for disks of a radius.
OctreeBlocks cutForSampling(RunContext& run, const Decisions& decisions, float radius,
							const Surface& surface);

/// Step Samples: places samples of about the wanted number, in the way that the options choose.
SampleFacts placeSamples(RunContext& run, const Decisions& decisions, Products& made);

/// Step GivenSamples: takes the caller's points in the place of samples of our own. Throws Failure
/// where one is not finite.
NoFacts takeGivenSamples(RunContext& run, const Decisions& decisions,
						 const std::vector<Vec3d>& points, Products& made);

/// Step Triangles: from samples to a mesh of them, in the way that the options choose, and the
/// first flips.
NoFacts connectSamples(RunContext& run, const Decisions& decisions, Products& made);

/// Step Count: splits and collapses edges until the mesh has the wanted count.
CountFacts reachCount(RunContext& run, const Decisions& decisions, Products& made);

/// Where sheets meet: splits edges that would become one with those of other sheets, and makes up
/// for the count.
void separateSheets(RunContext& run, const Decisions& decisions, Products& made);

/// Edge flips, in so many passes at most as the options say.
void flipEdges(RunContext& run, ResultMesh& result);

} // namespace gpr

#endif
