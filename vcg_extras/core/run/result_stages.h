// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_RUN_RESULT_STAGES_H
#define VCG_EXTRAS_CORE_RUN_RESULT_STAGES_H

#include "products.h"

#include <vcg_extras/core/base/run_context.h>
#include <vcg_extras/core/optimization/fit.h>
#include <vcg_extras/core/optimization/relaxation.h>
#include <vcg_extras/core/results.h>

namespace gpr {

// From a mesh with the right count to the result.

/// The fit's settings for the options. countsLargest: the largest distance is what the user asked
/// for.
FitSettings fitSettings(const RemeshOptions& options, bool countsLargest);

/// The first half of the regular way: relaxes, and lets dislocations glide together.
void relaxAndGlide(RunContext& run, const Surface& surface, const BoundaryCurves& curves,
				   ResultMesh& result);

/// Step Relaxation: makes the triangles regular on the surface, by the smoothing and the regularity
/// that the options choose; last the inverted faces are repaired.
MeshFacts relaxTriangles(RunContext& run, Products& made);

/// Step Fit: the last to move all vertices: the steps before walk on the surface, which this one
/// leaves. Then the worst angles are raised, with or without a fit.
FitFacts fitResult(RunContext& run, const Decisions& decisions, Products& made);

/// Step Release: feature lines that are too close to each other for good angles are released, and
/// the fit begins anew. Without some lines the surface may be lost; then the result stays as it
/// was.
NoFacts releaseLinesAndFit(RunContext& run, const Decisions& decisions, Products& made);

/// Step Contacts: takes self-intersections out of the result where the options ask for that.
ContactFacts removeContacts(RunContext& run, const Decisions& decisions, Products& made);

/// Tells the user of vertices that the step Contacts has just made.
void tellMade(RunContext& run, const Products& made);

/// Step Check: audits the result, thoroughly where the options ask for it. Throws Failure where a
/// promise is broken.
NoFacts checkResult(RunContext& run, const Decisions& decisions, Products& made);

/// Step Export: writes the mesh in the caller's frame.
ExportFacts exportMesh(RunContext& run, Products& made, RemeshResult& out);

} // namespace gpr

#endif
