// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_RUN_SAMPLE_STAGES_H
#define VCG_EXTRAS_CORE_RUN_SAMPLE_STAGES_H

#include "products.h"

#include <vcg_extras/core/base/run_context.h>

#include <vector>

namespace gpr {

// From the surface to a mesh with the wanted count.

/// Cuts the surface into blocks that are sampled independently, for disks of a radius.
OctreeBlocks cutForSampling(RunContext& run, const Decisions& decisions, float radius,
							const Surface& surface);

/// Step Samples: places about the wanted number of samples, by the method of the preset.
SampleFacts placeSamples(RunContext& run, const Decisions& decisions, Products& made);

/// Step GivenSamples: takes the points of the user as samples. Throws Failure if a point is not
/// finite.
void takeGivenSamples(RunContext& run, const Decisions& decisions, const std::vector<Vec3d>& points,
					  Products& made);

/// Step Triangles: connects the samples to a mesh by the method of the preset, and flips edges a
/// first time.
void connectSamples(RunContext& run, const Decisions& decisions, Products& made);

/// Step Count: splits and collapses edges until the mesh has the wanted count.
void reachCount(RunContext& run, const Decisions& decisions, Products& made);

/// Splits edges of one sheet that would coincide with edges of other sheets at a junction, then
/// restores the count. Does nothing without junctions.
void separateSheets(RunContext& run, const Decisions& decisions, Products& made);

/// Flips edges. The preset paper limits the number of passes; other presets flip until all edges
/// are Delaunay.
void flipEdges(RunContext& run, ResultMesh& result);

} // namespace gpr

#endif
