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

// From a mesh with the wanted count to the result.

/// The settings of the fit for the options. countsLargest: the target is the largest distance.
FitSettings fitSettings(const RemeshOptions& options, bool countsLargest);

/// The first half of the relaxation of the default preset: relaxes the mesh, and lets dislocations
/// glide together.
void relaxAndGlide(RunContext& run, const Surface& surface, const BoundaryCurves& curves,
				   ResultMesh& result);

/// Step Relaxation: makes the triangles regular on the surface, by the method of the preset, then
/// repairs inverted faces.
RelaxationFacts relaxTriangles(RunContext& run, Products& made);

/// Step Fit: fits the mesh to the input, if the options ask for a fit, then raises small angles by
/// moves and flips. The fit is the last step to move all vertices; vertices leave the surface in
/// this step.
FitFacts fitResult(RunContext& run, const Decisions& decisions, Products& made);

/// Step Release: releases feature lines that are too close to each other for good angles, and fits
/// the mesh from before the fit again. If the mesh is then too far from the surface, the result
/// stays as before the step.
void releaseLinesAndFit(RunContext& run, const Decisions& decisions, Products& made);

/// Step Angles: raises the small angles that are left, and lowers large angles.
void repairAngles(RunContext& run, Products& made);

/// Step Contacts: removes self-intersections from the result, if the options ask for that.
ContactFacts removeContacts(RunContext& run, const Decisions& decisions, Products& made);

/// Step Refinement: makes triangles smaller at places beyond the error bound, unless there are too
/// many places. Returns the number of added vertices.
RefinementFacts refineResult(RunContext& run, const ErrorGoal& goal, Products& made);

/// Step Error: proves the largest distance, and measures the share of the input beyond the bound.
/// Cost: a proof, and a search for each triangle perhaps beyond the bound, in parallel.
ErrorFacts measureError(RunContext& run, const ErrorGoal& goal, Products& made);

/// Step Check: audits the result, thoroughly if the options ask for that. Throws Failure if the
/// result breaks a promise.
void checkResult(RunContext& run, const Decisions& decisions, Products& made);

/// Step Export: writes the mesh in the frame of the input.
ExportFacts exportMesh(RunContext& run, Products& made, RemeshResult& out);

} // namespace gpr

#endif
