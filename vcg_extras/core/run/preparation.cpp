// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "preparation.h"

#include "sample_stages.h"

#include <vcg_extras/core/base/failure.h>
#include <vcg_extras/core/features/crease_lines.h>
#include <vcg_extras/core/features/feature_export.h>
#include <vcg_extras/core/features/feature_region.h>
#include <vcg_extras/core/features/given_lines.h>
#include <vcg_extras/core/input/flat_pieces.h>
#include <vcg_extras/core/input/load.h>
#include <vcg_extras/core/input/memory_need.h>
#include <vcg_extras/core/input/repair_manifold.h>
#include <vcg_extras/core/input/small_components.h>
#include <vcg_extras/core/input/split_long_edges.h>
#include <vcg_extras/core/input/stray_faces.h>
#include <vcg_extras/core/mesh/measure.h>
#include <vcg_extras/core/mesh/spatial_order.h>
#include <vcg_extras/core/results.h>

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <string>
#include <utility>

namespace gpr {

namespace {

/// Connected feature lines shorter than this in all are dropped; in ideal edges.
constexpr float leastLineLength = 3;
/// But for the rims of holes, and other clear loops, down to this.
constexpr float leastLoopLength = 1.5f;
/// Of two feature lines nearer to each other than this the weaker is dropped; in ideal edges. The
/// second where lines and borders take more than this share of the vertices.
constexpr float  leastLineGap = 0.15f, leastCrowdedGap = 0.3f;
constexpr double mostOnCurves = 0.5;
/// Share of the vertices that lines given by the caller may take, with borders and feature lines.
constexpr double mostOnGivenLines = 0.5;
/// Longest edge where at most this share of the faces has one beyond longestEdgeInRadii. Single
/// long edges in a dense scan do no harm, and splitting them all would make a tenth more of
/// everything.
constexpr float  longestSingleEdge = 1.1f;
constexpr double mostSingleFaces   = 0.15;
/// Where no more than this share of the faces is split, noise is still seen on those that are
/// there.
constexpr double mostUnseen = 0.02;

} // namespace

void Preparation::detectRegion()
{
	if (options_.featureRegion != FeatureRegion::Detected) return;
	Surface            surface;
	const FeatureEdges features = detectOn(surface, 0.04);
	FeatureResult      found;
	exportFeatures(input_, surface, features, found);
	report_.cleaned = CleanCounts();
	if (found.figures.vertexNum == 0) {
		notes_.push_back("No features were detected, so that there is no feature region.");
		return;
	}
	detected_ = std::move(found.vertexFeature);
}

FeatureEdges Preparation::detectOn(Surface& surface, double until)
{
	clock_.enter("load", "Taking over the mesh", 0.1 * until);
	IndexedMesh mesh     = loadCleaned();
	surface.frame        = mesh.frame;
	const float meanEdge = meanEdgeLength(mesh, workers_);
	if (!(meanEdge > 0)) throw Failure(Status::UnusableInput, "The surface has no area.");
	connectOrRepair(mesh, surface);
	dropFlatPieces(surface);
	clock_.enter("detection", "Detecting features", until);
	FeatureEdges features = findFeatures(surface, options_.featureThresholds, meanEdge, workers_);
	noteDetection(features);
	return features;
}

Prepared Preparation::prepare(std::int64_t fixedTarget)
{
	Prepared p;
	clock_.enter("load", "Taking over the mesh", 0.05);
	IndexedMesh       mesh    = loadCleaned();
	const FaceExtents extents = measureFaces(mesh, workers_);
	p.area                    = extents.area;
	if (!(p.area > 0)) throw Failure(Status::UnusableInput, "The surface has no area.");
	p.surface.frame        = mesh.frame;
	report_.radiusConstant = radiusConstant(options_);
	setTarget(run_,
			  fixedTarget > 0 ? fixedTarget
							  : resolveTarget(input_, options_, p.area, mesh.frame.scale),
			  p);

	clock_.enter("splitLongEdges", "Splitting long edges", 0.06);
	report_.cleaned.longEdgesSplit = splitAsFarAsMemoryGoes(mesh, extents, p);
	connectOrRepair(mesh, p.surface);
	dropFlatPieces(p.surface);
	setSizes(p);
	describeInput(p.surface);
	return p;
}

Prepared Preparation::prepareAgain(std::int64_t targetNum)
{
	report_.cleaned = CleanCounts();
	return prepare(targetNum);
}

void Preparation::findFeatureLines(Prepared& p)
{
	clock_.enter("features", "Finding feature lines", 0.23);
	CreaseRules rules;
	rules.mode        = followsFeatureLines(options_) ? options_.featureMode : FeatureMode::Off;
	rules.strongDeg   = float(options_.featureAngleDeg);
	rules.weakDeg     = 0.5f * rules.strongDeg;
	rules.leastLength = leastLineLength * idealEdge(p);
	rules.leastLoop   = leastLoopLength * idealEdge(p);
	rules.leastTwig   = idealEdge(p);
	rules.leastGap    = leastLineGap * idealEdge(p);

	rules.callersMeanEdge = p.callersMeanEdge;
	double share          = followCreases(rules, p);
	if (share > mostOnCurves) {
		forgetFeatureLines(p);
		rules.leastGap = leastCrowdedGap * idealEdge(p);
		share          = followCreases(rules, p);
	}
	while (share > 1) {
		forgetFeatureLines(p);
		rules.leastLength *= 2;
		rules.leastLoop *= 2;
		share = followCreases(rules, p);
	}
	followGivenLines(p);
	if (!namesSources(p)) p.surface.sourceFace.release();
}

/// Marks lines and tips and samples them. Returns the share that their samples are of the vertices
/// wanted; 0 without lines.
double Preparation::followCreases(const CreaseRules& rules, Prepared& p)
{
	CreaseFindings found   = markCreases(rules, workers_, p.surface);
	report_.featureEdgeNum = found.edgeNum;
	report_.featureTipNum  = std::int64_t(found.tips.size());
	p.tips                 = std::move(found.tips);
	if (found.edgeNum == 0) return 0;
	p.curves       = sampleCurves(p, p.radius, options_.boundary);
	p.curvesRadius = p.radius;
	return shareOf(p.curves, p);
}

/// Whether anything of the result will be named by the caller's faces.
bool Preparation::namesSources(const Prepared& p) const
{
	return options_.anchorsOfVertices || options_.anchorsOfFaces || !p.kept.empty();
}

void Preparation::followGivenLines(Prepared& p)
{
	const bool areAllGiven = options_.featureMode == FeatureMode::Given;
	if (areAllGiven && input_.line == nullptr) {
		throw Failure(Status::BadOptions,
					  "The feature lines shall be the selected edges, but no edge is selected.");
	}
	if (input_.line == nullptr || !followsFeatureLines(options_)) return;
	const HalfEdgeMesh& m = p.surface.mesh;
	Buffer<char>        before(m.crease.size());
	std::copy(m.crease.begin(), m.crease.end(), before.begin());
	const std::int64_t added = markGivenLines(input_, workers_, p.surface);
	if (added == 0) return;
	const BoundaryCurves curves = sampleCurves(p, p.radius, options_.boundary);
	if (shareOf(curves, p) <= mostOnGivenLines) {
		report_.featureEdgeNum += added;
		p.curvesRadius = 0;
		return;
	}
	p.surface.mesh.crease.swap(before);
	notes_.push_back("There are more given lines, like the seams of a texture, than so few "
					 "vertices can follow; triangles lie across them.");
}

void Preparation::forgetFeatureLines(Prepared& p)
{
	p.surface.mesh.crease.release();
	p.tips.clear();
	p.curvesRadius         = 0;
	report_.featureEdgeNum = report_.featureTipNum = 0;
}

void Preparation::describeInput(const Surface& surface)
{
	clock_.enter("audit", "Counting", 0.22);
	report_.cleanedInput   = figuresOf(surface.mesh, 1 / surface.frame.scale, workers_);
	report_.input          = report_.cleanedInput;
	report_.input.vertices = std::int64_t(input_.vertexNum);
	report_.input.faces    = std::int64_t(input_.faceNum);
}

std::int64_t Preparation::mostFacesFor(std::int64_t targetNum, std::int64_t faceNum)
{
	const std::int64_t most = std::max<std::int64_t>(4 * faceNum, 200 * targetNum + 10000000);
	return std::min<std::int64_t>(most, 700000000);
}

/// Gives the surface its sizes, and the largest disks the radius that goes with them. Where
/// small sizes meet edges that are too long for them, those are split and the sizes found anew.
void Preparation::setSizes(Prepared& p)
{
	constexpr int mostRefinements = 4;
	for (int pass = 0; pass <= mostRefinements; ++pass) {
		Sizing sizing = findSizes(p);
		if (sizing.size.empty()) return;
		p.surface.size              = std::move(sizing.size);
		p.radiusFactor              = sizing.radiusFactor;
		report_.curvatureClampedNum = sizing.clampedNum;
		setTarget(run_, p.targetNum, p);
		const float longest = longestEdgeInRadii * p.radius;
		if (pass == mostRefinements || edgesFitSizes(p.surface, longest, workers_)) return;
		refine(p, longest);
	}
}

Sizing Preparation::findSizes(Prepared& p)
{
	clock_.enter("sizing", "Finding the density", 0.23);
	findFeatureRegion(p);
	const float uniform = float(diskRadius(p.area, double(p.targetNum), radiusConstant(options_)));
	return makeSizing({input_, options_, uniform, p.isFeatureVertex, p.kept}, p.surface, workers_);
}

void Preparation::refine(Prepared& p, float longest)
{
	Buffer<float> size = std::move(p.surface.size);
	IndexedMesh   mesh = disconnect(p.surface);
	if (!(p.callersMeanEdge > 0)) p.callersMeanEdge = meanEdgeLength(mesh, workers_);
	report_.cleaned.longEdgesSplit +=
		splitLongEdges(mesh, longest, size, mostFacesFor(p.targetNum, mesh.faceNum), workers_);
	connectOrRepair(mesh, p.surface);
}

void Preparation::findFeatureRegion(Prepared& p)
{
	const bool          bySelection = options_.featureRegion == FeatureRegion::Selection;
	const std::uint8_t* marks       = bySelection         ? input_.selected
									  : detected_.empty() ? nullptr
														  : detected_.data();
	p.isFeatureVertex               = regionVertices(input_, marks, p.surface, workers_);
	if (bySelection && p.isFeatureVertex.empty()) {
		throw Failure(Status::BadOptions,
					  "The selection is to be preserved, but no vertex is selected.");
	}
	const std::vector<int> vertices =
		callersVertices(input_, p.isFeatureVertex, p.surface, workers_);
	report_.regionVertexNum = std::int64_t(vertices.size());
	p.kept.clear();
	if (options_.featureSampling == FeatureSampling::Vertices) p.kept = vertices;
	if (options_.boundary == BoundaryMode::Keep) keepBorder(p);
}

/// Adds the caller's own vertices on the border to those to be kept.
void Preparation::keepBorder(Prepared& p)
{
	const HalfEdgeMesh& m = p.surface.mesh;
	Buffer<char>        onBorder(m.vertexNum);
	for (int v = 0; v < m.vertexNum; ++v)
		onBorder[v] = m.outgoing[v] >= 0 && m.isBorderVertex(v);
	const std::vector<int> border = callersVertices(input_, onBorder, p.surface, workers_);
	std::vector<int>       all;
	std::set_union(p.kept.begin(), p.kept.end(), border.begin(), border.end(),
				   std::back_inserter(all));
	p.kept = std::move(all);
}

double Preparation::shareOf(const BoundaryCurves& curves, const Prepared& p)
{
	return double(curves.samples.size()) / double(p.targetNum);
}

void Preparation::connectOrRepair(IndexedMesh& mesh, Surface& surface)
{
	Buffer<int> faceStart;
	clock_.enter("order", "Ordering", 0.12);
	surface.grid = orderSpatially(mesh, workers_, faceStart);
	clock_.enter("connect", "Connecting", 0.2);
	if (connect(mesh, faceStart, workers_, surface)) return;
	clock_.enter("repair", "Repairing", 0.22);
	repairManifold(mesh, workers_, report_.cleaned);
	surface.grid = orderSpatially(mesh, workers_, faceStart);
	if (!connect(mesh, faceStart, workers_, surface)) {
		throw Failure(Status::InternalError, "The surface could not be made manifold.");
	}
}

/// Pieces without area, left by repair or there from the start, could only be meshed by triangles
/// without area. Pieces that hold others together stay.
void Preparation::dropFlatPieces(Surface& surface)
{
	const std::vector<int> flat = findFlatPieces(surface, workers_);
	if (flat.empty()) return;
	if (int(flat.size()) == surface.mesh.faceNum)
		throw Failure(Status::UnusableInput, "The surface has no area.");
	IndexedMesh mesh = withoutFaces(surface, flat, report_.cleaned.zeroAreaFaces);
	connectOrRepair(mesh, surface);
}

IndexedMesh Preparation::loadCleaned()
{
	IndexedMesh mesh = loadInput(input_, workers_, report_.cleaned);
	if (options_.dropComponentsBelow <= 1 && !allFacesThin(mesh, workers_)) return mesh;
	return withoutUseless(std::move(mesh));
}

/// What must go before the area, and with it the radius, is found: a detour, as it takes a second
/// ordering and connecting.
IndexedMesh Preparation::withoutUseless(IndexedMesh mesh)
{
	Surface surface;
	connectOrRepair(mesh, surface);
	dropFlatPieces(surface);
	dropSmallComponents(surface);
	return disconnect(surface);
}

void Preparation::dropSmallComponents(Surface& surface)
{
	const std::int64_t    least = options_.dropComponentsBelow;
	const SmallComponents small = findSmallComponents(surface.mesh, least, workers_);
	if (small.num == 0) return;
	if (int(small.faces.size()) == surface.mesh.faceNum) {
		throw Failure(Status::UnusableInput, "Nothing would be left: every component has fewer "
											 "than " +
												 std::to_string(least) + " faces.");
	}
	report_.cleaned.droppedComponents = small.num;
	IndexedMesh mesh = withoutFaces(surface, small.faces, report_.cleaned.droppedFaces);
	connectOrRepair(mesh, surface);
}

std::int64_t Preparation::splitAsFarAsMemoryGoes(IndexedMesh& mesh, const FaceExtents& extents,
												 Prepared& p)
{
	float            longest   = longestEdgeInRadii * p.radius;
	std::vector<int> longFaces = findLongFaces(mesh, extents, longest, workers_);
	if (double(longFaces.size()) < mostSingleFaces * mesh.faceNum) {
		longest   = longestSingleEdge * p.radius;
		longFaces = findLongFaces(mesh, longest, longFaces, workers_);
	}
	noteStrayFaces(mesh, longFaces);
	const double faces = facesAfterSplitting(mesh, longFaces, longest);
	requireMemory(bytesNeeded(faces, double(p.targetNum)), availableMemoryBytes());
	const std::int64_t mostFaces = mostFacesFor(p.targetNum, mesh.faceNum);
	if (double(longFaces.size()) > mostUnseen * mesh.faceNum)
		p.callersMeanEdge = meanEdgeLength(mesh, workers_);
	return splitLongEdges(mesh, longFaces, longest, mostFaces, workers_);
}

void Preparation::noteStrayFaces(const IndexedMesh& mesh, const std::vector<int>& longFaces)
{
	const StrayFaces stray = findStrayFaces(mesh, longFaces, workers_);
	if (stray.num == 0) return;
	char sentence[240];
	std::snprintf(sentence, sizeof sentence,
				  "%lld of the faces reach so far out that without them the mesh would be %.0f "
				  "times as small; they have %.2g %% of the area and take as much of the result. "
				  "If they are stray, remove them first.",
				  static_cast<long long>(stray.num), stray.sizeRatio, 100 * stray.areaShare);
	if (std::find(notes_.begin(), notes_.end(), sentence) == notes_.end())
		notes_.push_back(sentence);
}

void Preparation::noteDetection(const FeatureEdges& features)
{
	if (features.supportCut) {
		notes_.push_back("The feature support was cut to 5 % of the square root of the area; "
						 "the mesh is too coarse for more.");
	}
	if (features.cappedRayNum > 0) {
		report_.capsReached.push_back("faces crossed by the rays of the feature support");
	}
}

} // namespace gpr
