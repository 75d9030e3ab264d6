// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface_stages.h"

#include "input_stages.h"

#include <vcg_extras/core/base/failure.h>
#include <vcg_extras/core/features/feature_region.h>
#include <vcg_extras/core/features/given_lines.h>
#include <vcg_extras/core/features/shared_borders.h>
#include <vcg_extras/core/input/split_long_edges.h>
#include <vcg_extras/core/mesh/measure.h>
#include <vcg_extras/core/sampling/error_sizes.h>
#include <vcg_extras/core/sampling/sizing.h>
#include <vcg_extras/core/sampling/target.h>
#include <vcg_extras/core/surface/barycentric_point.h>
#include <vcg_extras/core/surface/junctions.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace gpr {

namespace {

/// Shorter connected feature lines are dropped, total length in ideal edges.
constexpr float minLineLength = 3;
/// The same for loops, like the rims of holes.
constexpr float minLoopLength = 1.5f;
/// Gap between two feature lines, in ideal edges, below which the weaker line is dropped. The
/// second gap applies if lines and borders take more than half of the vertices.
constexpr float minLineGap = 0.15f, minCrowdedGap = 0.3f;
/// The largest share of the vertices on borders, feature lines and given lines together.
constexpr double maxOnGivenLines = 0.5;

// ---- The feature region.

/// Marks of the input vertices in the feature region; null: no region.
const std::uint8_t* regionMarks(const RunContext& run, const FeatureMarks& detected)
{
	if (run.options.featureRegion == FeatureRegion::Selection) return run.input.selected;
	return detected.empty() ? nullptr : detected.data();
}

void findRegionOnSurface(RunContext& run, Products& made)
{
	Sizes&         sizes   = made.sizes;
	const Surface& surface = made.surface;
	sizes.isFeatureVertex =
		regionVertices(run.input, regionMarks(run, made.regionMarks), surface, run.workers);
	if (run.options.featureRegion == FeatureRegion::Selection && sizes.isFeatureVertex.empty()) {
		throw Failure(Status::BadOptions,
					  "The feature region is the selection, but no vertex is selected.");
	}
	const std::vector<int> vertices =
		callersVertices(run.input, sizes.isFeatureVertex, surface, run.workers);
	sizes.regionVertexNum = std::int64_t(vertices.size());
	sizes.kept.clear();
	if (keepsRegionVertices(run.options)) sizes.kept = vertices;
	if (run.options.boundary == BoundaryMode::Keep)
		sizes.kept = unionOf(sizes.kept, borderVertices(run.input, surface, run.workers));
	if (!surface.meetings.empty()) {
		const Junctions junctions(surface.mesh, surface.meetings, run.workers);
		sizes.kept = unionOf(sizes.kept, junctions.touchingVertices());
	}
}

/// Names the region to the user, because marks of the input may have chosen the region.
void tellRegion(RunContext& run, const Sizes& sizes)
{
	if (sizes.regionVertexNum == 0) return;
	const bool isSelection = run.options.featureRegion == FeatureRegion::Selection;
	run.tell("The feature region is made of " + std::to_string(sizes.regionVertexNum) +
			 (isSelection ? " selected" : " detected") + " vertices.");
}

// ---- Feature lines.

/// The seams that distinguish creases from noise. None if most edges were seams: the pieces were
/// single faces then, and tell nothing about creases.
std::vector<int> tellingSeams(RunContext& run, const WorkingSurface& surface)
{
	constexpr double   mostPerFace = 0.75; // every second edge
	const CleanCounts& cleaned     = surface.cleaned;
	const bool areMost = double(cleaned.sewnEdges) > mostPerFace * double(run.input.faceNum);
	if (cleaned.sewnEdges == 0 || cleaned.weldedVertices > 0 || areMost) return {};
	return findSeamEdges(run.input, surface, run.workers);
}

CreaseRules creaseRules(RunContext& run, const Decisions& decisions, const Products& made)
{
	const RemeshOptions& options = run.options;
	// If sizes follow lines, the lines shall be the same as before the sizes: the rules use the
	// same edge length.
	const float edge = made.sizes.followLines ? evenEdge(made.surface.area, decisions.spacedFor())
											  : idealEdge(made, decisions.spacedFor());
	CreaseRules rules;
	// The removal of vertices of the preset paper knows no curves except the border.
	rules.mode            = isPaper(options) ? FeatureMode::Off : options.featureMode;
	rules.strongDeg       = float(options.featureAngleDeg);
	rules.weakDeg         = 0.5f * rules.strongDeg;
	rules.minLength       = minLineLength * edge;
	rules.minLoop         = minLoopLength * edge;
	rules.minSpur         = edge;
	rules.minGap          = (decisions.lineLimit > 0 ? minCrowdedGap : minLineGap) * edge;
	rules.callersMeanEdge = made.surface.callersMeanEdge;
	for (int limit = 1; limit < decisions.lineLimit; ++limit) {
		rules.minLength *= 2;
		rules.minLoop *= 2;
	}
	if (rules.mode == FeatureMode::Auto) rules.seams = tellingSeams(run, made.surface);
	return rules;
}

/// Whether the lines found before the sizes are the lines to follow. The longer edges of larger
/// sizes add no lines.
bool areAsKnown(const CreaseRules& rules, const Lines& known)
{
	if (!known.areKnown) return false;
	return known.found.edgeNum == 0
			   ? rules.minLength >= known.rules.minLength
			   : rules.minLength == known.rules.minLength && rules.minGap == known.rules.minGap;
}

/// Whether feature lines leave room for triangles of other sizes between the lines.
bool leavePlace(const Buffer<char>& marks, const Decisions& decisions, const Products& made)
{
	constexpr double    mostOnLines = 0.35; // of the vertices
	const HalfEdgeMesh& m           = made.surface.mesh;
	const std::int64_t  num         = decisions.spacedFor();
	double              along       = 0; // each edge twice
	for (int h = 0; h < m.halfEdgeNum(); ++h) {
		if (marks[h]) along += double(m.edgeLength(h));
	}
	return m.sideNum() * along / 2 <
		   mostOnLines * double(num) * double(evenEdge(made.surface.area, num));
}

/// Finds lines before the sizes, and keeps the lines for the step Lines.
bool hasFeatureLines(RunContext& run, const Decisions& decisions, Products& made)
{
	Lines lines;
	lines.rules    = creaseRules(run, decisions, made);
	lines.found    = markCreases(lines.rules, run.workers, made.surface);
	lines.marks    = std::move(made.surface.mesh.crease);
	lines.areKnown = true;
	made.lines     = std::move(lines);
	return made.lines.found.edgeNum > 0;
}

/// The share of the wanted vertices on borders and feature lines.
double shareOf(const BoundaryCurves& curves, const Decisions& decisions, const HalfEdgeMesh& mesh)
{
	return double(wholeNum(mesh, curves.samples, curves.samples.size())) /
		   double(decisions.spacedFor());
}

// ---- Sizes.

void requireWantedEdges(const MeshView& input)
{
	for (std::size_t c = 0; c < 3 * input.faceNum; ++c) {
		const std::int32_t v = input.vertexOf(c);
		if (v < 0 || std::size_t(v) >= input.vertexNum) continue;
		if (!(input.wantedEdge[v] > 0) || !std::isfinite(input.wantedEdge[v])) {
			throw Failure(Status::BadOptions,
						  "The wanted edge lengths must be finite numbers above 0.");
		}
	}
}

/// The wanted edge lengths at the vertices of the surface, working units; empty: no wishes.
Buffer<float> wantedEdges(RunContext& run, const Surface& surface)
{
	Buffer<float> wanted;
	if (run.input.wantedEdge == nullptr) return wanted;
	requireWantedEdges(run.input);
	const HalfEdgeMesh& m     = surface.mesh;
	const float         scale = float(surface.frame.scale);
	wanted.reset(std::size_t(m.vertexNum));
	run.workers.forEach(wanted.size(), [&](int v) {
		const SurfacePoint     at{m.position[v], m.outgoing[v] / 3};
		const BarycentricPoint point = barycentricPoint(run.input, surface, at);
		float                  sum   = 0;
		for (int k = 0; k < 3; ++k) {
			const std::size_t corner = 3 * std::size_t(point.face) + std::size_t(k);
			sum += point.weight[k] * run.input.wantedEdge[run.input.vertexOf(corner)];
		}
		wanted[v] = sum * scale;
	});
	return wanted;
}

Sizing findSizes(RunContext& run, const Decisions& decisions, Products& made)
{
	run.clock.enter(Stage::Sizing);
	findRegionOnSurface(run, made);
	RemeshOptions      options = run.options;
	const std::int64_t num     = decisions.spacedFor();
	// A forecast finds the sizes. By topology the disks would be as large as the surface.
	if (decisions.purpose == Purpose::Forecast || decisions.way == Way::ByTopology)
		options.adapt = 0;
	const bool  hasLines = options.adapt > 0 && hasFeatureLines(run, decisions, made);
	const float uniform =
		float(diskRadius(made.surface.area, double(num), radiusConstant(options)));
	const bool mayFollow = hasLines && decisions.way == Way::WithFeatureLines &&
						   leavePlace(made.lines.marks, decisions, made);
	if (hasLines && !mayFollow) options.adapt = 0;
	made.sizes.followLines = mayFollow;
	made.sizes.adapt       = options.adapt;
	const Buffer<char>  none;
	const Buffer<float> wanted = wantedEdges(run, made.surface);
	return makeSizing({options, uniform, evenEdge(made.surface.area, num),
					   mayFollow ? made.lines.marks : none, made.sizes.isFeatureVertex,
					   made.sizes.kept, wanted},
					  made.surface, run.workers);
}

/// Makes edges and sizes agree: a disk must cover a few vertices.
void matchSizesAndEdges(RunContext& run, const Decisions& decisions, Products& made)
{
	// Splits of a smaller share of the faces are spared on meshes with more faces than this:
	// connecting anew would take a tenth of the run, and the distances are the same. On smaller
	// meshes it takes hundredths of a second.
	constexpr double maxSpared  = 0.002;
	constexpr int    manyFaces  = 200'000;
	WorkingSurface&  surface    = made.surface;
	const bool       areByError = made.sizes.areByError;
	const float      longest    = (areByError ? longestSingleEdge : longestEdgeInRadii) *
						  usualRadius(made, run.options, decisions.spacedFor());
	const LongFaces tooLong = findTooLong(surface, longest, run.workers);
	if (tooLong.faces.empty()) return;
	const int  faceNum = surface.mesh.faceNum;
	const bool areFew =
		faceNum > manyFaces && double(tooLong.faces.size()) < maxSpared * double(faceNum);
	if (areByError && areFew && !surface.sharesBorders()) return raiseSizes(tooLong, surface);
	splitSurface(run, tooLong, decisions.spacedFor(), surface);
	made.lines = Lines();
	findRegionOnSurface(run, made);
}

/// Gives the surface its sizes, and the largest disks the radius for the sizes.
void setSizes(RunContext& run, const Decisions& decisions, Products& made)
{
	static_cast<Sizing&>(made.sizes) = findSizes(run, decisions, made);
	made.surface.ring.release();
	if (made.sizes.size.empty()) return;
	made.surface.size = std::move(made.sizes.size);
	if (made.surface.sharesBorders()) equalizeSizes(made.surface);
	matchSizesAndEdges(run, decisions, made);
}

/// Without a change of the border, the possible numbers of vertices or faces are multiples of this
/// number. An inner vertex adds two faces, and twice as many to half a symmetric mesh; a vertex on
/// the mirror plane adds one vertex to the whole mesh.
std::int64_t countStep(const WorkingSurface& surface, bool countsFaces)
{
	const HalfEdgeMesh& m = surface.mesh;
	if (countsFaces) return m.sideNum() * (surface.figures.boundaryLoops > 0 ? 1 : 2);
	for (int v = 0; v < m.vertexNum; ++v)
		if (m.multiplicity(m.position[v]) == 1) return 1;
	return 2;
}

/// Whether the number of vertices follows from the number or the size of the triangles.
bool countsTriangles(TargetMode mode)
{
	return mode == TargetMode::FaceNum || mode == TargetMode::EdgeLength ||
		   mode == TargetMode::Detail;
}

/// The facts about the whole mesh.
SizeFacts factsOf(const RunContext& run, const Decisions& decisions, const Products& made)
{
	const HalfEdgeMesh& m = made.surface.mesh;
	SizeFacts           facts;
	for (int v : made.sizes.kept)
		facts.keptNum += m.multiplicity(m.position[v]);
	facts.euler = m.sideNum() * made.surface.figures.eulerCharacteristic;
	if (countsTriangles(run.options.targetMode)) facts.borderLength = borderLength(m);
	facts.vertexNum     = made.sizes.vertexNum;
	facts.borderEdgeNum = made.sizes.borderEdgeNum;
	facts.followLines   = made.sizes.followLines;
	facts.countStep     = countStep(made.surface, decisions.faceNum > 0);
	return facts;
}

} // namespace

SizeFacts makeSizes(RunContext& run, const Decisions& decisions, Products& made)
{
	setSizes(run, decisions, made);
	countInput(run, made.surface);
	if (decisions.purpose != Purpose::OfGivenSamples) tellRegion(run, made.sizes);
	return factsOf(run, decisions, made);
}

ForecastFacts forecastCount(RunContext& run, const Decisions& decisions, const ErrorGoal& goal,
							Products& made)
{
	hasFeatureLines(run, decisions, made);
	const Buffer<char> lines = std::move(made.lines.marks);
	made.lines               = Lines();
	const bool isWithinError = run.options.targetMode == TargetMode::MaxError;
	return {countForFlatness(made.surface, lines, isWithinError ? rangeWithinError : rangeOfCount,
							 made.surface.area, decisions.vertexNum, goal.largest, goal.most,
							 run.workers)};
}

LineFacts findLines(RunContext& run, const Decisions& decisions, Products& made)
{
	HalfEdgeMesh& m = made.surface.mesh;
	if (decisions.way != Way::WithFeatureLines) {
		m.crease.release();
		made.lines = Lines();
		return {};
	}
	run.clock.enter(Stage::FeatureLines);
	made.lines.radius         = 0;
	const FeatureMode mode    = run.options.featureMode;
	const bool        isAsked = mode != FeatureMode::Off && mode != FeatureMode::Auto;
	if (isAsked && isPaper(run.options) && decisions.purpose != Purpose::SamplesOnly)
		run.tell("Feature lines are not followed with the preset paper.");
	const CreaseRules rules = creaseRules(run, decisions, made);
	if (areAsKnown(rules, made.lines)) {
		m.crease = std::move(made.lines.marks);
	}
	else {
		m.crease.release();
		made.lines.found = markCreases(rules, run.workers, made.surface);
	}
	made.lines.areKnown = false;
	made.lines.edgeNum  = made.lines.found.edgeNum;
	if (made.lines.edgeNum == 0) return {};
	made.lines.radius = usualRadius(made, run.options, decisions.spacedFor());
	made.lines.curves = sampleCurves(run, decisions, made.lines.radius, made);
	return {shareOf(made.lines.curves, decisions, m), made.lines.found.spareDoublings};
}

void followGivenLines(RunContext& run, const Decisions& decisions, Products& made)
{
	if (decisions.way != Way::WithFeatureLines) return;
	const bool areAllGiven = run.options.featureMode == FeatureMode::Given;
	if (areAllGiven && run.input.line == nullptr) {
		throw Failure(Status::BadOptions,
					  "The feature lines are the selected edges, but no edge is selected.");
	}
	if (!hasGivenLines(run.input) || isPaper(run.options)) return;
	HalfEdgeMesh&      m      = made.surface.mesh;
	Buffer<char>       before = copyOf(m.crease, run.workers);
	const std::int64_t added  = markGivenLines(run.input, run.workers, made.surface);
	if (added == 0) return;
	const float radius = usualRadius(made, run.options, decisions.spacedFor());
	if (shareOf(sampleCurves(run, decisions, radius, made), decisions, m) <= maxOnGivenLines) {
		made.lines.edgeNum += added;
		made.lines.radius = 0;
		return;
	}
	m.crease.swap(before);
	run.tell("The vertices are too few for all given lines, such as seams of a texture or region "
			 "borders, so the triangles do not follow these lines.");
}

BoundaryCurves sampleCurves(RunContext& run, const Decisions& decisions, float radius,
							const Products& made)
{
	return sampleBoundary(made.surface, radius, borderSpacing * radius, run.workers,
						  made.lines.found.coneApexes, made.sizes.kept,
						  borderMode(run.options, decisions), made.surface.sharesBorders());
}

} // namespace gpr
