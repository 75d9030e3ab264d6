// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "improvement.h"

#include <vcg_extras/core/base/pages.h>
#include <vcg_extras/core/base/portable_math.h>
#include <vcg_extras/core/optimization/delaunay_flips.h>
#include <vcg_extras/core/optimization/face_repair.h>
#include <vcg_extras/core/optimization/fit.h>
#include <vcg_extras/core/optimization/line_release.h>
#include <vcg_extras/core/optimization/relaxation.h>
#include <vcg_extras/core/optimization/valence_glide.h>
#include <vcg_extras/core/output/distance_proof.h>
#include <vcg_extras/core/surface/sampled_distance.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>

namespace gpr {

namespace {

/// Angles below this are raised at the end.
constexpr float poorAngleDeg = 32;
/// Where all sizes follow the error closeness comes first: what is left of the weight of the
/// triangles' shape in the fit, and the angles that the fit and the last pass hold.
constexpr double adaptedShapeWeight = 0.5;
constexpr float  adaptedAngleDeg    = 30;
/// Rounds of the fit, and of the quick one; a fourth takes 1 to 3 % off the error where sizes are
/// nearly the same everywhere, and as much again where they follow it.
constexpr int fitRounds        = 3;
constexpr int adaptedFitRounds = 4;
constexpr int quickFitRounds   = 2;
/// Rounds of lowering the largest distances where they matter; one of them takes a fifth off.
constexpr int manyWorstRounds = 4;

/// Where lines were released, no point of a face gets farther than this from the surface while
/// angles are raised, in ideal edges, or than the largest distance that the fit left.
constexpr float maxReleasedGap = 0.3f;
/// A mesh without these lines may be so much farther from the input than the one before the fit, or
/// so far, in ideal edges: nobody sees that.
constexpr double mostFarther = 1.02;
constexpr double nearMean = 0.015, nearMost = 0.3;

/// What the fit leaves for the repair of poor faces.
struct Fitted {
	std::unique_ptr<ClosestFaceMap> map; ///< of the last round, if there was one
	PoorFaces                       poor;
	KnownContacts                   contacts;
};

float minAngleDeg(const RemeshOptions& options)
{
	return poorAngleDeg + float(*options.adapt) * (adaptedAngleDeg - poorAngleDeg);
}

int roundsOfFit(const RemeshOptions& options)
{
	if (options.preset == Preset::FastFitted) return quickFitRounds;
	return options.adapt > 0.5 ? adaptedFitRounds : fitRounds;
}

int worstRounds(const RemeshOptions& options, LargestDistance largest)
{
	return largest == LargestDistance::Counts || options.adapt > 0 ? manyWorstRounds : 1;
}

FitSettings fitSettings(const RemeshOptions& options, LargestDistance largest)
{
	FitSettings settings;
	settings.rounds      = roundsOfFit(options);
	settings.minAngleDeg = minAngleDeg(options);
	settings.worstRounds = worstRounds(options, largest);
	settings.shapeWeight *= float(portable::pow(adaptedShapeWeight, *options.adapt));
	return settings;
}

/// The paper's post-processing: umbrella and flips in turn.
void smoothAsWritten(RunContext& run, const Prepared& p, ResultMesh& result)
{
	for (int step = 0; step < run.options.umbrellaSteps; ++step) {
		smoothByUmbrella2(p.surface, result, run.workers);
		flipEdges(run, result);
	}
}

void relaxPlainly(RunContext& run, const Prepared& p, const BoundaryCurves& boundary,
				  ResultMesh& result)
{
	for (int step = 0; step < relaxationSteps; ++step) {
		relaxOnce(p.surface, result, run.workers);
		slideAlongCreases(p.surface, boundary, result);
		flipEdges(run, result);
	}
}

/// Chains of flips shear triangles; a relaxation before each round gives them room.
void makeRegular(RunContext& run, const Prepared& p, const BoundaryCurves& boundary,
				 ResultMesh& result)
{
	constexpr int rounds = 2; // one leaves a worse smallest angle, four gain nothing
	for (int round = 0; round < rounds; ++round) {
		relaxOnce(p.surface, result, run.workers);
		slideAlongCreases(p.surface, boundary, result);
		glideDislocations(result, run.workers);
	}
	relaxConformally(p.surface, boundary, conformalSteps(2 * relaxationSteps), result, run.workers);
}

void relax(RunContext& run, const Prepared& p, const BoundaryCurves& boundary, ResultMesh& result)
{
	if (run.options.preset == Preset::Default) return makeRegular(run, p, boundary, result);
	relaxPlainly(run, p, boundary, result);
	if (!raiseAnglesOnSurface(p.surface, boundary, poorAngleDeg, result, run.workers))
		run.tellCap("changes for small angles");
}

/// Lines that the caller gave stay: textures and selections hang on them. Without a fit nothing
/// would draw what is released to the sharp edge again.
bool mayReleaseLines(const RunContext& run)
{
	return run.options.preset == Preset::Default && run.input.line == nullptr;
}

bool areLinesCrowded(RunContext& run, const ResultMesh& result)
{
	return areLinesCrowded(minAngleDeg(run.options), result, run.workers);
}

void tellReleased(RunContext& run)
{
	run.notes.push_back("Feature lines are so close to each other that they would leave acute "
						"angles; " +
						std::to_string(run.report.releasedVertexNum) +
						" vertices there need not stay on them.");
}

/// How far the input and a mesh are from each other, in ideal edges.
struct Distance {
	double rms     = 0;
	double largest = 0; ///< no point is farther: proven
};

Distance distanceFromInput(RunContext& run, const Surface& surface, const ResultMesh& result)
{
	const double           unit = 1 / double(result.idealEdge);
	const ComparedSurfaces both(surface, result, run.workers);
	const SampledDistance  sampled =
		sampledDistance({surface.mesh, both.input}, {result.mesh, both.result}, run.workers);
	return {sampled.mutual.larger().rms * unit,
			boundsOf(run, surface, both).hausdorff().upper * unit};
}

/// Whether a mesh whose lines were released is farther from the input than it was before the fit,
/// on the mean or at most, and farther than is near enough.
bool hasLostSurface(RunContext& run, const Surface& surface, const ResultMesh& released,
					const ResultMesh& start)
{
	const Distance of = distanceFromInput(run, surface, released);
	if (of.rms <= nearMean && of.largest <= nearMost) return false;
	const Distance before = distanceFromInput(run, surface, start);
	return of.rms > std::max(nearMean, mostFarther * before.rms) ||
		   of.largest > std::max(nearMost, mostFarther * before.largest);
}

/// How far faces may get from the surface while angles are raised; 0: not limited.
float maxGapAfter(const RunContext& run, float largestGap, const ResultMesh& result)
{
	if (run.report.releasedVertexNum == 0) return 0;
	const float most = maxReleasedGap * result.idealEdge;
	return largestGap > 0 ? std::min(most, largestGap) : most;
}

Fitted fit(RunContext& run, const Prepared& p, const BoundaryCurves& boundary,
		   LargestDistance largest, ResultMesh& result)
{
	if (!isFitted(run.options)) return {};
	run.clock.enter(Stage::Fit);
	returnReleasedMemory(); // this stage sets the peak
	const FitSettings settings = fitSettings(run.options, largest);
	FitOutcome        outcome  = fitToInput(p.surface, boundary, settings, result, run.workers);
	if (outcome.capped) run.tellCap("moves of the fit");
	Fitted fitted;
	run.report.largestFitDistance = double(outcome.farthest) / p.surface.frame.scale;
	fitted.poor.largestGap        = outcome.largestGap;
	fitted.map                    = std::move(outcome.map);
	fitted.contacts               = std::move(outcome.contacts);
	return fitted;
}

void repairFaces(RunContext& run, const Prepared& p, const BoundaryCurves& boundary, Fitted fitted,
				 ResultMesh& result)
{
	if (run.options.preset != Preset::Default) return;
	run.clock.enter(Stage::Angles);
	returnReleasedMemory();
	fitted.poor.angleDeg  = minAngleDeg(run.options);
	fitted.poor.targetNum = p.targetNum;
	fitted.poor.maxGap    = maxGapAfter(run, fitted.poor.largestGap, result);
	if (!repairPoorFaces(p.surface, boundary, fitted.poor, fitted.map, result, run.workers))
		run.tellCap("changes for small angles");
	// Vertices have come and gone.
	run.report.largestFitDistance = double(farthestFromSurface(result)) / p.surface.frame.scale;
}

KnownContacts fitAndRepair(RunContext& run, const Prepared& p, const BoundaryCurves& boundary,
						   LargestDistance largest, ResultMesh& result)
{
	Fitted        fitted   = fit(run, p, boundary, largest, result);
	KnownContacts contacts = std::move(fitted.contacts);
	repairFaces(run, p, boundary, std::move(fitted), result);
	return contacts;
}

/// Lines are let go only where all other means fail; then these begin anew. Without some lines the
/// surface may be lost; then the result stays as it was.
void releaseLinesAndFit(RunContext& run, const Prepared& p, const BoundaryCurves& boundary,
						LargestDistance largest, const ResultMesh& start, KnownContacts& contacts,
						ResultMesh& result)
{
	const double fitDistance     = run.report.largestFitDistance;
	ResultMesh   released        = copyResult(start, run.workers);
	run.report.releasedVertexNum = releaseLines(minAngleDeg(run.options), released, run.workers);
	KnownContacts ofReleased     = fitAndRepair(run, p, boundary, largest, released);
	if (hasLostSurface(run, p.surface, released, start)) {
		run.report.releasedVertexNum  = 0;
		run.report.largestFitDistance = fitDistance;
		return;
	}
	result   = std::move(released);
	contacts = std::move(ofReleased);
	tellReleased(run);
}

} // namespace

void flipEdges(RunContext& run, ResultMesh& result)
{
	flipToDelaunay(result, run.workers,
				   isPaper(run.options) ? run.options.flipPasses : untilDelaunay);
}

void improve(RunContext& run, const Prepared& p, const BoundaryCurves& boundary, ResultMesh& result)
{
	run.clock.enter(Stage::Relaxation);
	if (isPaper(run.options))
		smoothAsWritten(run, p, result);
	else
		relax(run, p, boundary, result);
	if (!repairInvertedFaces(p.surface, boundary, false, result, run.workers))
		run.tellCap("changes for inverted faces");
}

KnownContacts fitResult(RunContext& run, const Prepared& p, const BoundaryCurves& boundary,
						LargestDistance largest, ResultMesh& result)
{
	if (!mayReleaseLines(run) || !areLinesCrowded(run, result))
		return fitAndRepair(run, p, boundary, largest, result);
	const ResultMesh start    = copyResult(result, run.workers);
	KnownContacts    contacts = fitAndRepair(run, p, boundary, largest, result);
	if (areLinesCrowded(run, result))
		releaseLinesAndFit(run, p, boundary, largest, start, contacts, result);
	return contacts;
}

} // namespace gpr
