// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh.h"

#include "audit.h"
#include "blocks.h"
#include "border_edge_sampling.h"
#include "boundary_curves.h"
#include "conformal_relaxation.h"
#include "connect.h"
#include "crease_lines.h"
#include "curve_slide.h"
#include "delaunay_flips.h"
#include "error_goal.h"
#include "exact_count.h"
#include "face_tree.h"
#include "failure.h"
#include "feature_detection.h"
#include "feature_export.h"
#include "feature_region.h"
#include "fit.h"
#include "fold_repair.h"
#include "front_sampling.h"
#include "fuse_samples.h"
#include "hole_retriangulation.h"
#include "load.h"
#include "measure.h"
#include "relaxation.h"
#include "repair_manifold.h"
#include "sampled_distance.h"
#include "sizing.h"
#include "spatial_order.h"
#include "split_long_edges.h"
#include "surface_point.h"
#include "umbrella_smoothing.h"
#include "valence_glide.h"
#include "vertex_removal.h"
#include "worst_triangles.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <new>
#include <random>

namespace gpr {

namespace {

/// c of eq. (1) as the paper has it, from Fu and Zhou's sampler.
constexpr double printedRadiusConstant = 0.844;
/// Those that land at 98 to 99 % of the target, which the exact count makes up: placement by disk
/// intersection packs tighter than random border edges do.
constexpr double intersectionRadiusConstant = 0.962;
constexpr double borderEdgeRadiusConstant   = 0.802;
/// Spacing of border samples in r: the mean edge length of the result.
constexpr float borderSpacing = 1.04f;
/// Connected feature lines shorter than this in all are dropped; in ideal edges.
constexpr float leastLineLength = 3;
/// Longest edge of the mesh the sampling works on, in r.
constexpr float longestEdge = 0.8f;
/// Least width of a block in r; fewer, larger blocks mean fewer seams in the packing.
constexpr float blockWidth      = 20;
constexpr float smallBlockWidth = 12;
constexpr int   smallMeshFaces  = 2000000;
/// Angles below these get a pass of their own at the end.
constexpr float poorAngleDeg = 32, poorAngleFullDeg = 38;
/// What is left of the weight of the triangles' shape in the fit where sizes follow the error: who
/// asks for that wants to be close first.
constexpr double adaptedShapeWeight = 0.2;
/// Rounds of the fit, and of the quick one.
constexpr int fitRounds      = 4;
constexpr int quickFitRounds = 2;

/// Edge length in largest errors that a search for the count of an error begins with: many
/// triangles a trial cost more than a trial.
constexpr double edgePerError = 5;

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start)
{
	return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Times stages and tells progress. Stages follow each other without a gap, so that their seconds
/// add up to the whole.
class StageClock {
public:
	StageClock(Workers& workers, RemeshReport& report) :
			workers_(workers), report_(report), stageStart_(Clock::now())
	{
	}
	~StageClock() { finish(); }
	StageClock(const StageClock&)            = delete;
	StageClock& operator=(const StageClock&) = delete;

	/// The run is not all of the work but that from `from` to `to`, shares of 1.
	void tellWithin(double from, double to)
	{
		from_ = from;
		span_ = to - from;
	}

	void enter(const char* key, const char* phrase, double until)
	{
		finish();
		key_  = key;
		until = std::max(until, share_); // stages that are gone through again
		workers_.enterStage(phrase, from_ + share_ * span_, from_ + until * span_);
		share_ = until;
	}

private:
	Workers&          workers_;
	RemeshReport&     report_;
	double            from_ = 0, span_ = 1;
	Clock::time_point stageStart_;
	const char*       key_   = nullptr;
	double            share_ = 0;

	void finish()
	{
		const double seconds = secondsSince(stageStart_);
		stageStart_          = Clock::now();
		if (key_ == nullptr) return;
		for (StageTime& s : report_.stages) {
			if (s.stage == key_) {
				s.seconds += seconds;
				return;
			}
		}
		report_.stages.push_back({key_, seconds});
	}
};

/// The input made ready, and what was learnt on the way.
struct Prepared {
	Surface          surface;
	double           area         = 0; ///< working units squared
	std::int64_t     targetNum    = 0;
	float            radius       = 0; ///< of the largest disks, working units
	double           radiusFactor = 1; ///< that over the radius of eq. (1): see Sizing
	Buffer<char>     isFeatureVertex;  ///< of the region to be preserved; empty: none
	std::vector<int> tips;             ///< vertices at tips of cones
	std::vector<int> kept;             ///< the caller's vertices that stay
};

/// Vertices of about-equilateral triangles of this edge length that cover the area.
double vertexNumForEdgeLength(double area, double edgeLength)
{
	return 2 * area / (std::sqrt(3.0) * edgeLength * edgeLength);
}

/// Eq. (1).
double diskRadius(double area, double vertexNum, double constant)
{
	return 2 * std::sqrt(area) * std::sqrt(1 / (2 * std::sqrt(3.0) * vertexNum)) * constant;
}

std::int64_t resolveTarget(const MeshView& input, const RemeshOptions& o, double area, double scale)
{
	double n = 0;
	switch (o.targetMode) {
	case TargetMode::VertexNum:
		n = double(o.targetVertexNum);
		break;
	case TargetMode::Percent:
		n = o.targetPercent / 100 * double(input.vertexNum);
		break;
	case TargetMode::EdgeLength:
		n = vertexNumForEdgeLength(area, o.targetEdgeLen * scale);
		break;
	case TargetMode::MaxError: // a sampling alone has no error to look at
		n = vertexNumForEdgeLength(area, edgePerError * o.targetMaxError * scale);
		break;
	}
	n = std::round(n);
	if (n > 2e8) {
		throw Failure(Status::OutOfMemory, "The result would have more than 200,000,000 vertices.");
	}
	return std::max<std::int64_t>(1, std::int64_t(n));
}

std::uint32_t freshSeed()
{
	std::random_device device;
	return std::max(1u, std::uint32_t(device()));
}

/// One call of the engine: the stages in order, each one function of its own header.
class Run {
public:
	Run(const MeshView& input, const RemeshOptions& options, Workers& workers, RemeshReport& report,
		std::vector<std::string>& notes) :
			input_(input),
			options_(options), workers_(workers), report_(report), notes_(notes),
			clock_(workers, report)
	{
		if (options_.seed == 0) options_.seed = freshSeed();
		report_.seed    = options_.seed;
		report_.threads = workers.threadNum();
	}

	/// For one of several runs: the share of all the work that this one is.
	void tellProgressWithin(double from, double to) { clock_.tellWithin(from, to); }

	void remesh(RemeshResult& out, bool measuresError = false)
	{
		detectRegion();
		Prepared p = prepare(0);
		requireRoomForKept(p);
		findFeatureLines(p);
		if (options_.featureMode == FeatureMode::Lines && !followsFeatureLines())
			out.notes.push_back(
				"Feature lines are not followed where vertices are removed one by one.");
		ResultMesh result = sampleAndImprove(p);
		if (options_.exactCount && result.mesh.vertexNum != p.targetNum &&
			report_.featureEdgeNum > 0) {
			out.notes.push_back(
				"The number of vertices could not be reached with feature lines, so "
				"that there are none.");
			forgetFeatureLines(p);
			result = sampleAndImprove(p);
		}
		if (options_.exactCount && result.mesh.vertexNum != p.targetNum) {
			if (p.kept.empty()) {
				result = reachByTopology(p, out);
			}
			else {
				acceptNearest(p, result.mesh.vertexNum, out);
			}
		}
		fit(p, result);
		if (measuresError) measureError(p, result);
		finish(p, result, out);
	}

	void sample(SamplingResult& out)
	{
		detectRegion();
		Prepared p = prepare(0);
		requireRoomForKept(p);
		findFeatureLines(p);
		const BlockPartition partition = cut(p);
		BoundaryCurves       boundary;
		const Sampling       sampling = sampleAll(p, partition, boundary);
		clock_.enter("export", "Handing out the samples", 1);
		for (const Sample& s : sampling.samples) {
			out.points.push_back(p.surface.frame.toCaller(s.anchor.position));
			out.anchors.push_back(surfacePoint(input_, p.surface, s.anchor));
			out.radii.push_back(report_.diskRadius * double(s.size));
		}
		out.diskRadius = report_.diskRadius;
	}

	void retriangulate(const std::vector<Vec3d>& points, RemeshResult& out)
	{
		if (points.empty()) throw Failure(Status::BadOptions, "There are no samples.");
		Prepared             p = prepare(std::int64_t(points.size()));
		BoundaryCurves       boundary;
		const Sampling       sampling  = takeOver(p, points);
		const BlockPartition partition = cut(p);
		clock_.enter("retriangulation", "Retriangulating", 0.9);
		ResultMesh result = retriangulateFrom(p, sampling, boundary, partition);
		clock_.enter("flips", "Flipping edges", 0.95);
		flipEdges(result);
		report_.targetVertexNum = result.mesh.vertexNum;
		p.targetNum             = 0;
		finish(p, result, out);
		nameSamples(points, result, out);
	}

	void detect(FeatureResult& out)
	{
		Surface            surface;
		const FeatureEdges features = detectOn(surface, 0.95);
		describeInput(surface);
		clock_.enter("export", "Handing out the features", 1);
		exportFeatures(input_, surface, features, out);
	}

private:
	const MeshView&           input_;
	RemeshOptions             options_;
	Workers&                  workers_;
	RemeshReport&             report_;
	std::vector<std::string>& notes_;
	StageClock                clock_;
	const Buffer<char>        noRegion_;
	FusedMesh                 fused_;       ///< with the samples of the border-edge placement
	std::vector<char>         sampleMoved_; ///< retriangulate: samples that were off the surface
	std::vector<std::uint8_t> detected_;    ///< per caller's vertex: of the detected features

	// ---- the input

	/// Loads, cleans, splits, orders and connects. fixedTarget replaces the options' target if
	/// above 0.
	Prepared prepare(std::int64_t fixedTarget)
	{
		Prepared p;
		clock_.enter("load", "Taking over the mesh", 0.05);
		IndexedMesh mesh = loadInput(input_, workers_, report_.cleaned);
		p.area           = surfaceArea(mesh, workers_);
		if (!(p.area > 0)) throw Failure(Status::UnusableInput, "The surface has no area.");
		p.surface.frame        = mesh.frame;
		report_.radiusConstant = radiusConstant();
		setTarget(p, fixedTarget > 0 ? fixedTarget
									 : resolveTarget(input_, options_, p.area, mesh.frame.scale));

		clock_.enter("splitLongEdges", "Splitting long edges", 0.06);
		report_.cleaned.longEdgesSplit = splitLongEdges(
			mesh, longestEdge * p.radius, mostFacesFor(p.targetNum, mesh.faceNum), workers_);
		connectOrRepair(mesh, p.surface);
		setSizes(p);
		describeInput(p.surface);
		return p;
	}

	static std::int64_t mostFacesFor(std::int64_t targetNum, std::int64_t faceNum)
	{
		const std::int64_t most = std::max<std::int64_t>(4 * faceNum, 200 * targetNum + 10000000);
		return std::min<std::int64_t>(most, 700000000);
	}

	/// Gives the surface its sizes, and the largest disks the radius that goes with them. Where
	/// small sizes meet edges that are too long for them, those are split and the sizes found anew.
	void setSizes(Prepared& p)
	{
		constexpr int mostRefinements = 4;
		for (int pass = 0; pass <= mostRefinements; ++pass) {
			Sizing sizing = findSizes(p);
			if (sizing.size.empty()) return;
			p.surface.size              = std::move(sizing.size);
			p.radiusFactor              = sizing.radiusFactor;
			report_.curvatureClampedNum = sizing.clampedNum;
			setTarget(p, p.targetNum);
			const float longest = longestEdge * p.radius;
			if (pass == mostRefinements || edgesFitSizes(p.surface, longest, workers_)) return;
			refine(p, longest);
		}
	}

	Sizing findSizes(Prepared& p)
	{
		clock_.enter("sizing", "Finding the density", 0.23);
		findFeatureRegion(p);
		const float uniform = float(diskRadius(p.area, double(p.targetNum), radiusConstant()));
		return makeSizing({input_, options_, uniform, p.isFeatureVertex}, p.surface, workers_);
	}

	void refine(Prepared& p, float longest)
	{
		IndexedMesh mesh;
		mesh.frame         = p.surface.frame;
		mesh.vertexNum     = p.surface.mesh.vertexNum;
		mesh.faceNum       = p.surface.mesh.faceNum;
		mesh.position      = std::move(p.surface.mesh.position);
		mesh.triangle      = std::move(p.surface.mesh.origin);
		mesh.sourceFace    = std::move(p.surface.sourceFace);
		Buffer<float> size = std::move(p.surface.size);
		p.surface          = Surface();
		p.surface.frame    = mesh.frame;
		report_.cleaned.longEdgesSplit +=
			splitLongEdges(mesh, longest, size, mostFacesFor(p.targetNum, mesh.faceNum), workers_);
		connectOrRepair(mesh, p.surface);
	}

	/// Finds the features on the caller's own mesh, before any split, so that they are those which
	/// detectFeatures finds.
	void detectRegion()
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

	FeatureEdges detectOn(Surface& surface, double until)
	{
		clock_.enter("load", "Taking over the mesh", 0.1 * until);
		IndexedMesh mesh     = loadInput(input_, workers_, report_.cleaned);
		surface.frame        = mesh.frame;
		const float meanEdge = meanEdgeLength(mesh, workers_);
		if (!(meanEdge > 0)) throw Failure(Status::UnusableInput, "The surface has no area.");
		connectOrRepair(mesh, surface);
		clock_.enter("detection", "Detecting features", until);
		FeatureEdges features =
			findFeatures(surface, options_.featureThresholds, meanEdge, workers_);
		noteDetection(features);
		return features;
	}

	void findFeatureRegion(Prepared& p)
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
		if (options_.featureSampling == FeatureSampling::Vertices) p.kept = vertices;
	}

	void requireRoomForKept(const Prepared& p)
	{
		if (std::int64_t(p.kept.size()) <= p.targetNum) return;
		throw Failure(Status::BadOptions,
					  "The feature region has " + std::to_string(p.kept.size()) +
						  " vertices to be kept, more than the " + std::to_string(p.targetNum) +
						  " of the result; ask for more vertices, or have the region sampled by "
						  "disks.");
	}

	/// Vertices to be kept leave no way to the count: the nearest one, where that may be.
	void acceptNearest(Prepared& p, std::int64_t nearest, RemeshResult& out)
	{
		if (!options_.allowNearest && options_.targetMode == TargetMode::VertexNum) {
			out.smallestVertexNum = nearest;
			throw Failure(Status::CountTooSmall,
						  "The surface cannot be meshed with " + std::to_string(p.targetNum) +
							  " vertices that include the " + std::to_string(p.kept.size()) +
							  " of the feature region, but with " + std::to_string(nearest) + ".");
		}
		out.notes.push_back("The result has " + std::to_string(nearest) + " vertices instead of " +
							std::to_string(p.targetNum) +
							", with those of the feature region the nearest that could be "
							"reached.");
		setTarget(p, nearest);
	}

	/// Marks the feature lines; from here on the surface does not change any more. Where there are
	/// more of them than the wanted vertices can follow, the shorter ones are left out.
	void findFeatureLines(Prepared& p)
	{
		clock_.enter("features", "Finding feature lines", 0.23);
		CreaseRules rules;
		rules.mode        = followsFeatureLines() ? options_.featureMode : FeatureMode::Off;
		rules.strongDeg   = float(options_.featureAngleDeg);
		rules.weakDeg     = 0.5f * rules.strongDeg;
		rules.leastLength = leastLineLength * idealEdge(p);
		rules.leastTwig   = idealEdge(p);

		CreaseFindings found = markCreases(rules, workers_, p.surface);
		while (found.edgeNum > 0 && tooManySamples(p)) {
			forgetFeatureLines(p);
			rules.leastLength *= 2;
			found = markCreases(rules, workers_, p.surface);
		}
		p.tips                 = found.tips;
		report_.featureEdgeNum = found.edgeNum;
		report_.featureTipNum  = std::int64_t(found.tips.size());
	}

	/// The paper's removal of vertices knows no curves but the border.
	bool followsFeatureLines() const
	{
		return options_.retriangulation == Retriangulation::LabelCollapse;
	}

	void forgetFeatureLines(Prepared& p)
	{
		p.surface.mesh.crease.release();
		p.tips.clear();
		report_.featureEdgeNum = report_.featureTipNum = 0;
	}

	static bool tooManySamples(const Prepared& p)
	{
		return sampleCurves(p, p.radius).samples.size() > std::size_t(p.targetNum);
	}

	static BoundaryCurves sampleCurves(const Prepared& p, float radius)
	{
		return sampleBoundary(p.surface, radius, borderSpacing * radius, p.tips, p.kept);
	}

	void connectOrRepair(IndexedMesh& mesh, Surface& surface)
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

	void describeInput(const Surface& surface)
	{
		clock_.enter("audit", "Counting", 0.22);
		report_.cleanedInput   = figuresOf(surface.mesh, 1 / surface.frame.scale, workers_);
		report_.input          = report_.cleanedInput;
		report_.input.vertices = std::int64_t(input_.vertexNum);
		report_.input.faces    = std::int64_t(input_.faceNum);
	}

	// ---- sampling and what follows

	BlockPartition cut(const Prepared& p) { return cut(p, p.radius); }

	BlockPartition cut(const Prepared& p, float radius)
	{
		const bool small = p.surface.mesh.faceNum < smallMeshFaces;
		return cutIntoBlocks(p.surface, (small ? smallBlockWidth : blockWidth) * radius, workers_);
	}

	/// Samples of about the wanted number.
	Sampling sampleAll(const Prepared& p, const BlockPartition& partition, BoundaryCurves& boundary)
	{
		const int mostCorrections = p.kept.empty() ? 2 : 6;
		float     radius          = p.radius;
		Sampling  sampling        = sampleOnce(p, radius, partition, boundary);
		for (int i = 0; i < mostCorrections; ++i) {
			const float corrected = correctedRadius(p, sampling, radius);
			if (corrected == radius) break;
			radius   = corrected;
			sampling = sampleOnce(p, radius, p.kept.empty() ? partition : cut(p, radius), boundary);
		}
		report_.sampleNum         = std::int64_t(sampling.samples.size());
		report_.boundarySampleNum = sampling.boundarySampleNum;
		report_.diskRadius        = double(radius) / p.surface.frame.scale;
		if (sampling.capped) report_.capsReached.push_back("samples of a block");
		return sampling;
	}

	/// Feature lines leave gaps between them and the front, all the more the nearer they are to
	/// each other; so the radius is lowered by what the first go missed. Vertices to be kept are a
	/// fixed number of the samples, however near to each other: the others get what they leave.
	static float correctedRadius(const Prepared& p, const Sampling& sampling, float radius)
	{
		constexpr float aim = 0.985f, near = 0.02f; // of the wanted number
		constexpr float mostOnCurves = 0.7f;
		if (!p.surface.mesh.hasCreases() && p.kept.empty()) return radius;
		const float kept   = float(p.kept.size());
		const float wanted = aim * float(p.targetNum) - kept;
		const float share  = (float(sampling.samples.size()) - kept) / wanted;
		if (!(wanted > 0) || std::abs(share - 1) <= near) return radius;
		const float onCurves = float(sampling.boundarySampleNum) - kept;
		if (onCurves > mostOnCurves * (float(p.targetNum) - kept)) return radius;
		if (p.kept.empty()) return radius * std::sqrt(share);
		// Edges are cut for this radius; much smaller disks would own no vertices.
		constexpr float leastRadius = 0.8f, leastShare = 0.25f, mostShare = 4;
		return std::max(leastRadius * p.radius,
						radius * std::sqrt(std::clamp(share, leastShare, mostShare)));
	}

	Sampling sampleOnce(const Prepared& p, float radius, const BlockPartition& partition,
						BoundaryCurves& boundary)
	{
		clock_.enter("boundary", "Sampling the boundary", 0.24);
		boundary = sampleCurves(p, radius);
		clock_.enter("sampling", "Sampling", 0.6);
		if (options_.placement == Placement::BorderEdge)
			return sampleOnBorderEdges(p, radius, boundary);
		return sampleFront(p.surface, boundary, partition, radius, options_.seed, workers_,
						   presampled(p));
	}

	/// What of the surface is sampled first.
	const Buffer<char>& presampled(const Prepared& p) const
	{
		return options_.featureSampling == FeatureSampling::Disks ? p.isFeatureVertex : noRegion_;
	}

	/// The paper's placement; keeps the mesh that the samples were fused into.
	Sampling sampleOnBorderEdges(const Prepared& p, float radius, const BoundaryCurves& boundary)
	{
		BorderEdgeOptions o;
		o.radius                  = radius;
		o.seed                    = options_.seed;
		o.mostSamples             = 100000 + 10 * p.targetNum;
		o.region                  = &presampled(p);
		BorderEdgeSampling placed = sampleBorderEdges(p.surface, boundary, o, workers_);
		if (options_.retriangulation == Retriangulation::VertexRemoval)
			fused_ = std::move(placed.fused);
		return std::move(placed.sampling);
	}

	/// From the samples to a mesh of about, or exactly, the wanted count.
	ResultMesh sampleAndImprove(const Prepared& p)
	{
		BoundaryCurves boundary;
		ResultMesh     result = sampleAndRetriangulate(p, boundary);
		if (options_.exactCount) {
			clock_.enter("count", "Reaching the count", 0.87);
			collapseShortEdges(p.surface, result, workers_);
			reachExactCount(p.surface, boundary, p.targetNum, result, workers_);
		}
		relax(p, boundary, result);
		return result;
	}

	ResultMesh sampleAndRetriangulate(const Prepared& p, BoundaryCurves& boundary)
	{
		const BlockPartition partition = cut(p);
		Sampling             sampling  = sampleAll(p, partition, boundary);
		clock_.enter("retriangulation", "Retriangulating", 0.8);
		ResultMesh result = retriangulateFrom(p, sampling, boundary, partition);
		result.idealEdge  = idealEdge(p);
		sampling          = Sampling();
		clock_.enter("flips", "Flipping edges", 0.83);
		flipEdges(result);
		mendFolds(p.surface, boundary, true, result, workers_);
		return result;
	}

	/// From samples to a mesh of them, in the way the options ask for.
	ResultMesh retriangulateFrom(const Prepared& p, const Sampling& sampling,
								 const BoundaryCurves& boundary, const BlockPartition& partition)
	{
		if (options_.retriangulation == Retriangulation::LabelCollapse)
			return removeVertices(p.surface, sampling, boundary, partition, workers_);
		return removeOriginalVertices(takeFused(p, sampling, boundary), p.surface, sampling,
									  boundary, partition, workers_);
	}

	/// The mesh that the border-edge placement fused its samples into, or one made now.
	FusedMesh takeFused(const Prepared& p, const Sampling& sampling, const BoundaryCurves& boundary)
	{
		FusedMesh fused;
		std::swap(fused, fused_);
		if (!fused.sampleVertex.empty()) return fused;
		return fuseSamples(p.surface, sampling, boundary, workers_);
	}

	void flipEdges(ResultMesh& result)
	{
		flipToDelaunay(result, workers_, options_.flipIterations);
	}

	/// The paper's post-processing: umbrella and flips in turn, or flips alone.
	void smoothAsWritten(const Prepared& p, const BoundaryCurves& boundary, ResultMesh& result)
	{
		const bool moves = options_.smoothing == Smoothing::Umbrella2;
		for (int step = 0; moves && step < options_.relaxIterations; ++step) {
			smoothByUmbrella2(p.surface, result, workers_);
			flipEdges(result);
		}
		mendFolds(p.surface, boundary, false, result, workers_);
	}

	void relax(const Prepared& p, const BoundaryCurves& boundary, ResultMesh& result)
	{
		clock_.enter("relaxation", "Relaxing", 0.95);
		if (options_.smoothing != Smoothing::Barycentric)
			return smoothAsWritten(p, boundary, result);
		const bool isFull = options_.regularity == Regularity::Full;
		if (options_.relaxIterations > 0) {
			if (isFull)
				makeRegular(p, boundary, result);
			else
				relaxPlainly(p, boundary, result);
			raiseWorstAngles(p.surface, isFull ? poorAngleFullDeg : poorAngleDeg, result, workers_);
		}
		mendFolds(p.surface, boundary, false, result, workers_);
	}

	/// The first two steps leave the edges alone: flips straight away would undo what the exact
	/// count did for the valences.
	void relaxPlainly(const Prepared& p, const BoundaryCurves& boundary, ResultMesh& result)
	{
		constexpr int stepsWithoutFlips = 2;
		for (int step = 0; step < options_.relaxIterations; ++step) {
			relaxOnce(p.surface, result, workers_);
			slideAlongCreases(p.surface, boundary, result);
			if (step >= stepsWithoutFlips) flipEdges(result);
		}
	}

	/// Chains of flips shear triangles; a relaxation before each round gives them room.
	void makeRegular(const Prepared& p, const BoundaryCurves& boundary, ResultMesh& result)
	{
		constexpr int rounds = 2;
		for (int round = 0; round < rounds; ++round) {
			relaxOnce(p.surface, result, workers_);
			slideAlongCreases(p.surface, boundary, result);
			glideDislocations(result, workers_);
		}
		ConformalSteps steps = conformalSteps(2 * options_.relaxIterations);
		steps.flipPasses     = options_.flipIterations;
		relaxConformally(p.surface, boundary, steps, result, workers_);
	}

	/// The last to move vertices: those before walk on the surface, which this leaves.
	void fit(const Prepared& p, ResultMesh& result)
	{
		if (options_.fit == Fit::Off) return;
		clock_.enter("fit", "Fitting to the input", 0.97);
		FitSettings settings;
		settings.rounds        = options_.fit == Fit::Quick ? quickFitRounds : fitRounds;
		settings.leastAngleDeg = poorAngleDeg;
		settings.shapeWeight *= float(std::pow(adaptedShapeWeight, options_.adapt));
		const FitOutcome outcome = fitToInput(p.surface, settings, result, workers_);
		if (outcome.capped) report_.capsReached.push_back("moves of the fit");
		report_.largestFitDistance = double(outcome.farthest) / p.surface.frame.scale;
	}

	void measureError(const Prepared& p, const ResultMesh& result)
	{
		clock_.enter("error", "Measuring the error", 0.975);
		const float largest  = largestSampledDistance(p.surface.mesh, result.mesh, workers_);
		report_.largestError = double(largest) / p.surface.frame.scale;
	}

	void noteOperations(const ResultMesh& result)
	{
		report_.leftoverVertexNum = result.leftoverNum;
		report_.splitNum          = result.splitNum;
		report_.collapseNum       = result.collapseNum;
		report_.flipNum           = result.flipNum;
	}

	/// Without the exact count eq. (1) is left to itself: tells how near it came, and the constant
	/// that would have hit the target, as the count goes with 1/c².
	void noteCountReached(const Prepared& p, const ResultMesh& result, RemeshResult& out)
	{
		if (options_.exactCount || p.targetNum == 0) return;
		const double share              = double(result.mesh.vertexNum) / double(p.targetNum);
		report_.radiusConstantForTarget = report_.radiusConstant * std::sqrt(share);
		char sentence[160];
		std::snprintf(
			sentence, sizeof sentence,
			"%lld vertices of %lld wanted (%+.1f %%); with %.3f instead of %.3f in eq. (1) "
			"it would have been about as many as wanted.",
			static_cast<long long>(result.mesh.vertexNum), static_cast<long long>(p.targetNum),
			100 * (share - 1), report_.radiusConstantForTarget, report_.radiusConstant);
		out.notes.push_back(sentence);
	}

	void noteKept(const Prepared& p, const ResultMesh& result)
	{
		const auto isPinned   = [](const ResultVertex& v) { return v.isPinned; };
		report_.keptVertexNum = std::count_if(result.vertex.begin(), result.vertex.end(), isPinned);
		const std::int64_t lost = std::int64_t(p.kept.size()) - report_.keptVertexNum;
		if (2 * report_.keptVertexNum > result.mesh.vertexNum) {
			notes_.push_back("More than half of the vertices are those of the feature region; the "
							 "triangles beside it are uneven.");
		}
		if (lost > 0) {
			notes_.push_back(std::to_string(lost) + " of the " + std::to_string(p.kept.size()) +
							 " vertices of the feature region could not be kept.");
		}
	}

	/// The count could not be reached from samples of the right spacing. Starts from the fewest
	/// samples instead and changes the count by topology alone; what even that cannot reach is
	/// refused, or, where the target was a wish, raised to the smallest possible count.
	ResultMesh reachByTopology(Prepared& p, RemeshResult& out)
	{
		const std::int64_t asked   = p.targetNum;
		ResultMesh         result  = meshByTopology(p, asked);
		const std::int64_t nearest = result.mesh.vertexNum;
		if (nearest == asked) return result;

		const bool mayRaise = options_.allowNearest || options_.targetMode != TargetMode::VertexNum;
		if (!mayRaise) {
			out.smallestVertexNum = nearest;
			throw Failure(Status::CountTooSmall, "The surface cannot be meshed with " +
													 std::to_string(asked) +
													 " vertices; the smallest possible number is " +
													 std::to_string(nearest) + ".");
		}
		out.notes.push_back("The result has " + std::to_string(nearest) + " vertices instead of " +
							std::to_string(asked) + ", the smallest number that could be reached.");
		// Samples of the right spacing, if they lead there, make better triangles.
		p                = prepareAgain(nearest);
		ResultMesh again = sampleAndImprove(p);
		if (again.mesh.vertexNum == nearest) return again;
		return meshByTopology(p, nearest);
	}

	/// Everything before the count is the same for every target, so that the smallest count is.
	ResultMesh meshByTopology(Prepared& p, std::int64_t targetNum)
	{
		p = prepareAgain(1);
		BoundaryCurves boundary;
		ResultMesh     result = sampleAndRetriangulate(p, boundary);
		setTarget(p, targetNum);
		result.idealEdge = idealEdge(p);
		clock_.enter("count", "Reaching the count", 0.87);
		reachCountByTopology(p.surface, boundary, targetNum, result, workers_);
		setTarget(p, result.mesh.vertexNum);
		relax(p, boundary, result);
		return result;
	}

	Prepared prepareAgain(std::int64_t targetNum)
	{
		report_.cleaned = CleanCounts();
		return prepare(targetNum);
	}

	/// c of eq. (1) for the equations and the placement chosen.
	double radiusConstant() const
	{
		if (options_.equations == Equations::AsPrinted) return printedRadiusConstant;
		return options_.placement == Placement::BorderEdge ? borderEdgeRadiusConstant
														   : intersectionRadiusConstant;
	}

	/// Of the largest triangles.
	static float idealEdge(const Prepared& p)
	{
		return float(p.radiusFactor * diskRadius(p.area, double(p.targetNum), 1));
	}

	void setTarget(Prepared& p, std::int64_t targetNum)
	{
		p.targetNum = targetNum;
		p.radius = float(p.radiusFactor * diskRadius(p.area, double(targetNum), radiusConstant()));
		report_.targetVertexNum = targetNum;
		report_.diskRadius      = double(p.radius) / p.surface.frame.scale;
	}

	// ---- samples of any origin

	Sampling takeOver(const Prepared& p, const std::vector<Vec3d>& points)
	{
		clock_.enter("sampling", "Putting the samples on the surface", 0.6);
		const FaceTree tree(p.surface.mesh);
		const float    onSurface = 1e-5f;
		Sampling       sampling;
		sampling.radius = p.radius;
		float farthest  = 0;
		for (const Vec3d& point : points) {
			workers_.poll();
			const Vec3f  q = p.surface.frame.toWorking(point);
			const Anchor a = tree.nearest(q);
			if (a.face < 0) throw Failure(Status::BadOptions, "A sample is not finite.");
			const float moved = length(a.position - q);
			sampleMoved_.push_back(moved > onSurface);
			report_.samplesMoved += moved > onSurface;
			farthest = std::max(farthest, moved);
			sampling.samples.push_back({a, p.surface.mesh.faceNormal(a.face)});
		}
		report_.largestSampleMove = double(farthest) / p.surface.frame.scale;
		report_.sampleNum         = std::int64_t(points.size());
		sampling.nearest          = assignToSamples(p.surface, sampling.samples, workers_);
		return sampling;
	}

	/// A sample that lay on the surface, up to rounding, keeps its very coordinates.
	void nameSamples(const std::vector<Vec3d>& points, const ResultMesh& result, RemeshResult& out)
	{
		out.sampleOf.resize(result.vertex.size());
		for (std::size_t v = 0; v < result.vertex.size(); ++v) {
			const int s     = result.vertex[v].sample;
			out.sampleOf[v] = s;
			if (s >= 0 && !sampleMoved_[s]) out.mesh.positions[v] = points[s];
		}
	}

	// ---- features

	void noteDetection(const FeatureEdges& features)
	{
		if (features.supportCut) {
			notes_.push_back("The feature support was cut to 5 % of the square root of the area; "
							 "the mesh is too coarse for more.");
		}
		if (features.cappedRayNum > 0) {
			report_.capsReached.push_back("faces crossed by the rays of the feature support");
		}
	}

	// ---- the result

	void finish(const Prepared& p, const ResultMesh& result, RemeshResult& out)
	{
		clock_.enter("audit", "Checking", 0.98);
		const double unit           = 1 / p.surface.frame.scale;
		report_.result              = figuresOf(result.mesh, unit, workers_);
		const std::int64_t promised = options_.exactCount ? p.targetNum : 0;
		noteOperations(result);
		noteCountReached(p, result, out);
		noteKept(p, result);
		report_.audit =
			audit(p.surface, result, report_.cleanedInput, report_.result, promised, workers_);
		if (!report_.audit.passed) {
			throw Failure(Status::PromiseBroken, describeFailure(report_.audit));
		}
		if (report_.audit.flippedFaces > 0) {
			out.notes.push_back(std::to_string(report_.audit.flippedFaces) +
								" faces look against the input's normals, where the surface is "
								"thinner than the triangles are wide.");
		}
		clock_.enter("export", "Handing out the result", 1);
		exportMesh(p.surface, result, out);
		report_.quality = measureQuality(out.mesh.view(), workers_);
	}

	void exportMesh(const Surface& surface, const ResultMesh& result, RemeshResult& out)
	{
		const HalfEdgeMesh& m = result.mesh;
		out.mesh.positions.resize(m.vertexNum);
		out.anchors.resize(m.vertexNum);
		out.mesh.triangles.assign(m.origin.data(), m.origin.data() + m.halfEdgeNum());
		workers_.forRange(m.vertexNum, [&](std::size_t begin, std::size_t end) {
			for (std::size_t v = begin; v < end; ++v) {
				out.mesh.positions[v] = surface.frame.toCaller(m.position[v]);
				out.anchors[v]        = surfacePoint(input_, surface, result.vertex[v].anchor);
			}
		});
	}
};

/// Finds the count for a largest error by whole runs, and hands out the best of them.
class ErrorGoalRun {
public:
	ErrorGoalRun(const MeshView& input, const RemeshOptions& options, Workers& workers) :
			input_(input), options_(options), workers_(workers), extent_(extentOf(input))
	{
		const double unit = options.maxErrorIsPercent ? extent_.diagonal / 100 : 1;
		goal_.largest     = options.targetMaxError * unit;
		goal_.most = std::min<std::int64_t>(200000000, 1000 + 2 * std::int64_t(input.vertexNum));
		const double edge = edgePerError * goal_.largest;
		const double n    = edge > 0 ? vertexNumForEdgeLength(extent_.area, edge) : 1;
		goal_.start       = std::int64_t(std::min(double(goal_.most), std::max(1.0, n)));

		options_.targetMode   = TargetMode::VertexNum;
		options_.allowNearest = true;
		if (options_.seed == 0) options_.seed = freshSeed();
	}

	void run(bool allowNearest, RemeshResult& out)
	{
		const bool met = searchCount(goal_, [&](std::int64_t n) { return tryCount(n); }) > 0;
		best_.report.errorGoal     = goal_.largest;
		best_.report.errorTrialNum = trialNum_;
		if (!met && !allowNearest) throw Failure(Status::BadOptions, complaint());
		best_.report.stages.push_back(
			{"otherTrials", stageSeconds_ - secondsOf(best_.report.stages)});
		best_.notes.push_back(note(met));
		out = std::move(best_);
	}

private:
	const MeshView& input_;
	RemeshOptions   options_;
	Workers&        workers_;
	MeshExtent      extent_;
	ErrorGoal       goal_;
	RemeshResult    best_;
	int             trialNum_     = 0;
	double          stageSeconds_ = 0; ///< of all trials

	static double secondsOf(const std::vector<StageTime>& stages)
	{
		double sum = 0;
		for (const StageTime& s : stages)
			sum += s.seconds;
		return sum;
	}

	ErrorTrial tryCount(std::int64_t vertexNum)
	{
		RemeshResult trial;
		options_.targetVertexNum = vertexNum;
		const double share       = 1.0 / goal_.mostTrials;
		Run          run(input_, options_, workers_, trial.report, trial.notes);
		run.tellProgressWithin(trialNum_ * share, (trialNum_ + 1) * share);
		run.remesh(trial, true);
		++trialNum_;
		stageSeconds_ += secondsOf(trial.report.stages);
		const ErrorTrial outcome{std::int64_t(trial.mesh.vertexNum()), trial.report.largestError};
		if (trialNum_ == 1 || isBetter(trial)) best_ = std::move(trial);
		return outcome;
	}

	/// Fewer vertices among those that meet the goal, else the smaller error.
	bool isBetter(const RemeshResult& trial) const
	{
		const double error = trial.report.largestError, least = best_.report.largestError;
		const bool   meets = error <= goal_.largest, met = least <= goal_.largest;
		if (meets != met) return meets;
		return meets ? trial.mesh.vertexNum() < best_.mesh.vertexNum() : error < least;
	}

	std::string lengthText(double length) const
	{
		char text[80];
		std::snprintf(text, sizeof text, "%.4g (%.3g %% of the diagonal)", length,
					  100 * length / extent_.diagonal);
		return text;
	}

	std::string complaint() const
	{
		return "An error of at most " + lengthText(goal_.largest) + " was not reached: with " +
			   std::to_string(best_.mesh.vertexNum()) + " vertices it is " +
			   lengthText(best_.report.largestError) + ".";
	}

	std::string note(bool met) const
	{
		if (!met) return complaint();
		return "The largest distance from the input that was found with " +
			   std::to_string(best_.mesh.vertexNum()) + " vertices is " +
			   lengthText(best_.report.largestError) + ", in " + std::to_string(trialNum_) +
			   " trials. It was found by sampling, which is no proof.";
	}
};

/// Runs body and turns what it throws into status and message; on failure nothing but those, the
/// report and the notes is handed out.
template <class Result, class Body>
Result guarded(const RemeshOptions& options, const ProgressCallback& progress, const Body& body)
{
	const Clock::time_point start = Clock::now();
	Result                  result;
	const auto              fail = [&](Status status, const std::string& message) {
        Result failed;
        failed.status  = status;
        failed.message = message;
        failed.report  = std::move(result.report);
        failed.notes   = std::move(result.notes);
        return failed;
	};
	const std::vector<std::string> complaints = validate(options);
	if (!complaints.empty()) return fail(Status::BadOptions, complaints.front());
	try {
		{
			Workers workers(options.threads, progress);
			body(workers, result);
		}
		result.status               = Status::Ok;
		result.report.remeshSeconds = secondsSince(start);
		return result;
	}
	catch (const Failure& f) {
		Result failed = fail(f.status, f.message);
		return failed;
	}
	catch (const CancelledError&) {
		return fail(Status::Cancelled, "Cancelled.");
	}
	catch (const std::bad_alloc&) {
		return fail(Status::OutOfMemory, "There is not enough memory.");
	}
	catch (const std::exception& e) {
		return fail(Status::InternalError, std::string("Internal error: ") + e.what());
	}
}

} // namespace

RemeshResult remesh(const MeshView& input, const RemeshOptions& options,
					const ProgressCallback& progress)
{
	std::int64_t smallest = 0;
	RemeshResult result =
		guarded<RemeshResult>(options, progress, [&](Workers& workers, RemeshResult& r) {
			try {
				if (options.targetMode == TargetMode::MaxError)
					ErrorGoalRun(input, options, workers).run(options.allowNearest, r);
				else
					Run(input, options, workers, r.report, r.notes).remesh(r);
			}
			catch (const Failure&) {
				smallest = r.smallestVertexNum;
				throw;
			}
		});
	result.smallestVertexNum = smallest;
	return result;
}

SamplingResult samplePoissonDisks(const MeshView& input, const RemeshOptions& options,
								  const ProgressCallback& progress)
{
	return guarded<SamplingResult>(options, progress, [&](Workers& workers, SamplingResult& r) {
		Run(input, options, workers, r.report, r.notes).sample(r);
	});
}

RemeshResult retriangulate(const MeshView& input, const std::vector<Vec3d>& samples,
						   const RemeshOptions& options, const ProgressCallback& progress)
{
	return guarded<RemeshResult>(options, progress, [&](Workers& workers, RemeshResult& r) {
		Run(input, options, workers, r.report, r.notes).retriangulate(samples, r);
	});
}

FeatureResult detectFeatures(const MeshView& input, const RemeshOptions& options,
							 const ProgressCallback& progress)
{
	return guarded<FeatureResult>(options, progress, [&](Workers& workers, FeatureResult& r) {
		Run(input, options, workers, r.report, r.notes).detect(r);
	});
}

const char* statusName(Status status)
{
	switch (status) {
	case Status::Ok:
		return "ok";
	case Status::BadOptions:
		return "bad options";
	case Status::UnusableInput:
		return "unusable input";
	case Status::CountTooSmall:
		return "count too small";
	case Status::PromiseBroken:
		return "promise broken";
	case Status::OutOfMemory:
		return "out of memory";
	case Status::Cancelled:
		return "cancelled";
	case Status::InternalError:
		return "internal error";
	}
	return "unknown";
}

} // namespace gpr
