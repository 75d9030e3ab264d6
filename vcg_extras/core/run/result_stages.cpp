// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "result_stages.h"

#include "sample_stages.h"

#include <vcg_extras/core/base/pages.h>
#include <vcg_extras/core/base/portable_math.h>
#include <vcg_extras/core/features/given_lines.h>
#include <vcg_extras/core/features/regular_count.h>
#include <vcg_extras/core/guard/contact_removal.h>
#include <vcg_extras/core/mesh/face_quality.h>
#include <vcg_extras/core/mesh/measure.h>
#include <vcg_extras/core/optimization/exact_count.h>
#include <vcg_extras/core/optimization/face_repair.h>
#include <vcg_extras/core/optimization/goal_refinement.h>
#include <vcg_extras/core/optimization/line_release.h>
#include <vcg_extras/core/optimization/valence_glide.h>
#include <vcg_extras/core/output/export.h>
#include <vcg_extras/core/sampling/target.h>
#include <vcg_extras/core/surface/certified_distance.h>
#include <vcg_extras/core/surface/surface_distance.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace gpr {

namespace {

/// Smaller angles are raised at the end, degrees.
constexpr float poorAngleDeg = 32;
/// If all sizes follow the error, distance matters more than shape: factor on the shape weight of
/// the fit, and the smallest angle that the fit and the repair keep, degrees.
constexpr double adaptedShapeWeight = 0.5;
constexpr float  adaptedAngleDeg    = 30;
/// Rounds of the fit; quick: with the preset fast-fitted. A fourth round lowers the error by 1 to 3
/// % with nearly equal sizes, and by twice as much with sizes that follow the error.
constexpr int fitRounds        = 3;
constexpr int adaptedFitRounds = 4;
constexpr int quickFitRounds   = 2;
/// Rounds against the largest distances, if these matter. A round lowers the largest distance by a
/// fifth.
constexpr int manyWorstRounds = 4;

/// After a release of lines: the largest distance of a point of a face from the surface while
/// angles are raised, in ideal edges. A smaller distance left by the fit is the limit instead.
constexpr float maxReleasedGap = 0.3f;
/// Limits for a mesh with released lines: the distance from the input may grow by this factor over
/// the mesh before the fit, and distances below the other two, in ideal edges, are invisible.
constexpr double mostFarther = 1.02;
constexpr double nearMean = 0.015, nearMost = 0.3;
/// Points of these measurements. Ten, as for the report, took a ninth of the run on small CAD parts
/// and changed one decision in a hundred.
constexpr int pointsPerFace = 2;

int roundsOfFit(const RemeshOptions& options)
{
	if (!isFittedInRounds(options)) return 0;
	if (options.preset == Preset::FastFitted) return quickFitRounds;
	return options.adapt > 0.5 ? adaptedFitRounds : fitRounds;
}

float minAngleDeg(const RemeshOptions& options)
{
	return poorAngleDeg + float(*options.adapt) * (adaptedAngleDeg - poorAngleDeg);
}

// ---- Relaxation.

/// The paper's post-processing: umbrella smoothing and flips in turn.
void smoothAsWritten(RunContext& run, Products& made)
{
	for (int step = 0; step < run.options.umbrellaSteps; ++step) {
		smoothByUmbrella2(made.surface, made.result, run.workers);
		flipEdges(run, made.result);
	}
}

void relaxPlainly(RunContext& run, Products& made)
{
	for (int step = 0; step < relaxationSteps; ++step) {
		relaxOnce(made.surface, made.result, run.workers);
		slideAlongCreases(made.surface, made.curves, made.result);
		flipEdges(run, made.result);
	}
	if (!raiseAnglesOnSurface(made.surface, made.curves, poorAngleDeg, made.result, run.workers))
		run.tellCap("changes for small angles");
}

void relax(RunContext& run, Products& made)
{
	if (isPaper(run.options)) return smoothAsWritten(run, made);
	if (run.options.preset != Preset::Default) return relaxPlainly(run, made);
	relaxAndGlide(run, made.surface, made.curves, made.result);
	relaxConformally(made.surface, made.curves, 2 * relaxationSteps, made.result, run.workers);
}

// ---- Fit and angles.

/// Given lines and lines of FeatureMode::Lines stay, because textures, selections and regions
/// depend on the lines. Without a fit, released vertices would not return to the crease edge.
bool mayReleaseLines(const RunContext& run)
{
	return run.options.preset == Preset::Default && isFitted(run.options) &&
		   !hasGivenLines(run.input) && run.options.featureMode != FeatureMode::Lines;
}

/// Whether a mesh with released lines is too far from the input, by root mean square or at most:
/// farther than nearMean or nearMost, and farther than the mesh before the fit by the factor
/// mostFarther.
bool hasLostSurface(const Surface& surface, const ResultMesh& released, const ResultMesh& start,
					Workers& workers)
{
	const MeasuredSurface input(viewOf(surface.mesh), workers);
	const auto            distance = [&](const ResultMesh& result) { // in ideal edges
        const MeasuredSurface from(viewOf(result.mesh), input, workers);
        return sampledDistance({surface.mesh, input}, {result.mesh, from}, pointsPerFace, workers)
            .mutual.larger()
            .times(1 / double(result.idealEdge));
	};
	const SurfaceDistance of = distance(released);
	if (of.rms <= nearMean && of.max <= nearMost) return false;
	const SurfaceDistance before = distance(start);
	return of.rms > std::max(nearMean, mostFarther * before.rms) ||
		   of.max > std::max(nearMost, mostFarther * before.max);
}

/// Fits the mesh, if the options ask for a fit, and sets the goal of the repair of poor faces.
void fit(RunContext& run, const Decisions& decisions, Products& made)
{
	made.poor          = {};
	made.poor.angleDeg = minAngleDeg(run.options);
	made.poor.target   = decisions.countTarget();
	if (!isFitted(run.options)) return;
	run.clock.enter(Stage::Fit);
	returnReleasedMemory(); // this stage sets the peak
	FitSettings settings = fitSettings(run.options, decisions.purpose == Purpose::Trial);
	// Curves between regions keep the areas of the regions.
	if (run.input.hasManyRegions()) settings.curveFit = CurveFit::Mean;
	FitOutcome outcome = fitToInput(made.surface, made.curves, settings, made.result, run.workers);
	if (outcome.capped) run.tellCap("moves of the fit");
	made.poor.largestGap = outcome.largestGap;
	made.poor.map        = std::move(outcome.map);
}

void raiseAngles(RunContext& run, Products& made)
{
	if (run.options.preset != Preset::Default) return;
	run.clock.enter(Stage::Angles);
	returnReleasedMemory();
	if (!raiseSmallAngles(made.surface, made.curves, made.poor, made.result, run.workers))
		run.tellCap("changes for small angles");
}

// ---- Contacts.

/// Made vertices keep the vertex count, but patches on the border may change the face count, and
/// patches on a mirror plane the vertex count of the whole. Most rounds that restore the count.
constexpr int countRounds = 3;

bool missesCount(const Decisions& decisions, const Products& made)
{
	if (made.guarded.vertexNum == 0) return false;
	if (decisions.faceNum > 0) return made.result.faceNum() != decisions.faceNum;
	return made.result.mesh.mirrorAxis >= 0 && made.result.vertexNum() != decisions.wholeNum();
}

// ---- The trials for an error bound.

/// The share of the area of the input that is farther from the result than the bound.
double shareBeyond(const ComparedSurfaces& both, double bound, double area, Workers& workers)
{
	double beyond = 0;
	for (const FarPlace& p : placesBeyond(both.input, both.result, bound, workers))
		beyond += p.area;
	return std::min(1.0, beyond / std::max(area, 1e-300));
}

// ---- Check and export.

/// Tells the user about vertices made by the guard.
void tellMade(RunContext& run, const Products& made)
{
	if (made.guarded.vertexNum == 0) return;
	run.tell("At thin places of the surface the triangles would intersect each other. Guarded edge "
			 "collapses of the input made " +
			 std::to_string(made.guarded.vertexNum) + " of the " +
			 std::to_string(made.result.vertexNum()) +
			 " vertices, at these places. The triangles there are less regular.");
}

/// Tells about cut junctions that are longer than some edges. Shorter junctions are faults of a
/// scan.
void tellCutJunctions(RunContext& run, const Products& made)
{
	constexpr double leastEdges = 3;
	const double     extent     = made.surface.cleaned.longestJunction;
	if (made.surface.mesh.meetsAtPlaces || extent < leastEdges * double(made.result.idealEdge))
		return;
	run.tell(
		"Edges with more than two faces were cut, so the sheets there are separate now. The option "
		"junctions with the value keep meshes these edges once for all sheets, which stay joined.");
}

/// Two digits, as a forecast has.
std::int64_t rounded(double number)
{
	double unit = 1;
	while (number >= 100 * unit)
		unit *= 10;
	return std::int64_t(unit * std::round(number / unit));
}

/// Whether many crease edges are on no feature line, so that triangles may round them off.
bool leavesCreases(const CreaseFindings& found)
{
	constexpr double share = 0.1;
	return double(found.creaseNum - found.edgeNum) > share * double(found.creaseNum);
}

/// A result with too few vertices for its shape names the number with which it would be regular.
/// Crease edges that the triangles round off are told, too, however regular the triangles are.
void tellRegularNum(RunContext& run, Products& made)
{
	constexpr double   mostIrregular = 20; // percent of the faces
	const bool         isIrregular   = made.quality.below30Percent > mostIrregular;
	const double       leastGrowth   = isIrregular ? 1.2 : 2;
	const std::int64_t num           = made.result.vertexNum();
	if (isPaper(run.options) || !(isIrregular || leavesCreases(made.lines.found))) return;
	const float  angle = float(run.options.featureAngleDeg) * radians;
	const float  even  = evenEdge(made.surface.area, num);
	const double ratio = double(
		even / edgeForRegularity(made.surface.mesh, made.surface.area / made.surface.mesh.sideNum(),
								 even, angle, run.workers));
	if (ratio * ratio < leastGrowth) return;
	made.regularNum    = rounded(ratio * ratio * double(num));
	std::string effect = "crease edges are rounded off there", gain = "keep these edges";
	if (isIrregular) {
		effect = std::to_string(std::lround(made.quality.below30Percent)) +
				 " % of the faces have an angle below 30 degrees";
		gain = "make nearly all faces regular";
	}
	run.tell("The triangles are wider than much of the surface between crease edges, so " + effect +
			 ". About " + std::to_string(made.regularNum) + " vertices (" +
			 std::to_string(2 * made.regularNum) + " faces) are forecast to " + gain + ".");
}

MeshSize sizeOf(const ResultMesh& result)
{
	return {result.vertexNum(), result.faceNum()};
}

MakingOfVertices makingOf(const RunContext& run, const Products& made)
{
	return {made.surface, made.curves, made.sizes.kept, isFitted(run.options), *run.options.adapt};
}

} // namespace

FitSettings fitSettings(const RemeshOptions& options, bool countsLargest)
{
	FitSettings settings;
	settings.minAngleDeg = minAngleDeg(options);
	settings.worstRounds = countsLargest || options.adapt > 0 ? manyWorstRounds : 1;
	settings.rounds      = roundsOfFit(options);
	settings.shapeWeight *= float(portable::pow(adaptedShapeWeight, *options.adapt));
	return settings;
}

/// Chains of flips shear triangles; a relaxation before each round gives room for the flips.
void relaxAndGlide(RunContext& run, const Surface& surface, const BoundaryCurves& curves,
				   ResultMesh& result)
{
	constexpr int rounds = 2; // 1 leaves a worse smallest angle, 4 gain nothing
	for (int round = 0; round < rounds; ++round) {
		relaxOnce(surface, result, run.workers);
		slideAlongCreases(surface, curves, result);
		glideDislocations(result, run.workers);
	}
}

RelaxationFacts relaxTriangles(RunContext& run, Products& made)
{
	run.clock.enter(Stage::Relaxation);
	relax(run, made);
	if (!repairInvertedFaces(made.surface, made.curves, false, made.result, run.workers))
		run.tellCap("changes for inverted faces");
	return {sizeOf(made.result), made.lines.edgeNum > 0,
			lineFaceNum(made.result.mesh, run.workers) > 0, made.result.hasSmoothBorder,
			made.surface.isSewn()};
}

FitFacts fitResult(RunContext& run, const Decisions& decisions, Products& made)
{
	made.releasedNum     = 0;
	made.refined         = GoalOutcome::Open;
	const float minAngle = minAngleDeg(run.options);
	const bool  mayRelease =
		mayReleaseLines(run) && areLinesCrowded(minAngle, made.result, run.workers);
	if (mayRelease)
		made.beforeFit = std::make_unique<ResultMesh>(copyResult(made.result, run.workers));
	fit(run, decisions, made);
	raiseAngles(run, made);
	return {mayRelease && areLinesCrowded(minAngle, made.result, run.workers)};
}

void releaseLinesAndFit(RunContext& run, const Decisions& decisions, Products& made)
{
	ResultMesh withLines     = std::move(made.result);
	PoorFaces  poorWithLines = std::move(made.poor);
	made.result              = copyResult(*made.beforeFit, run.workers);
	made.releasedNum         = releaseLines(minAngleDeg(run.options), made.result, run.workers);
	fit(run, decisions, made);
	if (hasLostSurface(made.surface, made.result, *made.beforeFit, run.workers)) {
		made.releasedNum = 0;
		made.result      = std::move(withLines);
		made.poor        = std::move(poorWithLines);
		return;
	}
	run.tell("Some feature lines are too close to each other for good angles; " +
			 std::to_string(made.releasedNum) + " of their vertices may leave the lines.");
	const float most = maxReleasedGap * made.result.idealEdge;
	made.poor.maxGap = made.poor.largestGap > 0 ? std::min(most, made.poor.largestGap) : most;
	raiseAngles(run, made);
}

void repairAngles(RunContext& run, Products& made)
{
	made.beforeFit.reset();
	if (run.options.preset == Preset::Default) {
		run.clock.enter(Stage::Angles);
		if (!repairPoorFaces(made.surface, made.curves, made.poor, made.result, run.workers))
			run.tellCap("changes for small angles");
	}
	made.poor = {};
}

ContactFacts removeContacts(RunContext& run, const Decisions& decisions, Products& made)
{
	const std::int64_t before = made.result.vertexNum();
	separateSheets(run, decisions, made);
	if (!run.options.guard || isPaper(run.options))
		return {{before, made.result.faceNum()}, before};
	run.clock.enter(Stage::Contacts);
	MakingOfVertices making   = makingOf(run, made);
	making.mayEndAbove        = decisions.mayEndAbove;
	made.guarded.foundPairNum = 0;
	ContactOutcome outcome;
	for (int round = 0; true; ++round) {
		const std::int64_t known = made.guarded.foundPairNum;
		outcome                  = removeContacts(making, made.result, made.guarded, run.workers);
		if (outcome.isCapped) run.tellCap("patches made anew");
		const bool isDone = outcome.isRefused || made.guarded.foundPairNum == known;
		if (isDone || round == countRounds || !missesCount(decisions, made)) break;
		reachExactCount(made.surface, made.curves, decisions.countTarget(), made.result,
						run.workers);
	}
	const std::int64_t lacking = outcome.vertexNum - made.result.mesh.vertexNum;
	return {sizeOf(made.result).plus(made.result.mesh.sideNum() * lacking), before,
			outcome.isRefused};
}

RefinementFacts refineResult(RunContext& run, const ErrorGoal& goal, Products& made)
{
	// Before came the removal of contacts. Where it found none the mesh is as it was refined.
	const bool isSame = made.guarded.foundPairNum == 0 && !made.surface.mesh.meetsAtPlaces;
	if (made.refined == GoalOutcome::OutOfReach || (made.refined == GoalOutcome::Kept && isSame))
		return {};
	run.clock.enter(Stage::Fit);
	const double         largest = goal.largest * made.surface.frame.scale;
	const std::int64_t   before  = made.result.vertexNum();
	const GoalRefinement refined =
		refineToGoal(made.surface, made.curves, largest, made.result, run.workers);
	made.refined = refined.outcome;
	if (run.options.guard && !refined.farFaces.empty()) {
		if (!makeFiner(makingOf(run, made), refined.farFaces, made.result, run.workers))
			run.tellCap("patches made anew");
	}
	return {int(made.result.vertexNum() - before), true};
}

ErrorFacts measureError(RunContext& run, const ErrorGoal& goal, Products& made)
{
	run.clock.enter(Stage::Error);
	const ComparedSurfaces both(made.surface, made.result, run.workers);
	made.verified.proof =
		proveDistance(run, made.surface, made.surface.figures.diagonal, both, goal.largest);
	ErrorFacts facts;
	facts.error = made.verified.proof.bounds.hausdorff().upper;
	if (facts.error > goal.largest)
		facts.share = shareBeyond(both, goal.largest * made.surface.frame.scale,
								  surfaceArea(made.surface.mesh, run.workers), run.workers);
	return facts;
}

void checkResult(RunContext& run, const Decisions& decisions, Products& made)
{
	const bool isOfOurs = decisions.purpose != Purpose::OfGivenSamples;
	tellMade(run, made);
	if (isOfOurs) tellSmoothBorder(run, made.surface.frame, made.result, made.surface.border);
	tellCutJunctions(run, made);
	const Expected expected{made.surface.figures, isOfOurs ? decisions.wholeNum() : 0,
							std::int64_t(made.sizes.kept.size())};
	verifyResult(run, made.surface, made.result, expected, made.verified);
}

ExportFacts exportMesh(RunContext& run, Products& made, RemeshResult& out)
{
	made.quality = exportResult(run, made.surface, made.result, made.verified.keptNum > 0,
								made.surface.cleaned.reorientedFaces > 0, made.verified.audit, out);
	tellRegularNum(run, made);
	return {sizeOf(made.result)};
}

} // namespace gpr
