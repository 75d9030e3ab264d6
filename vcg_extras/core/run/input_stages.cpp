// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "input_stages.h"

#include <vcg_extras/core/base/failure.h>
#include <vcg_extras/core/features/feature_export.h>
#include <vcg_extras/core/input/border_spikes.h>
#include <vcg_extras/core/input/contract_edges.h>
#include <vcg_extras/core/input/flat_pieces.h>
#include <vcg_extras/core/input/load.h>
#include <vcg_extras/core/input/memory_need.h>
#include <vcg_extras/core/input/repair_manifold.h>
#include <vcg_extras/core/input/sew_seams.h>
#include <vcg_extras/core/input/small_components.h>
#include <vcg_extras/core/input/split_long_edges.h>
#include <vcg_extras/core/input/stray_faces.h>
#include <vcg_extras/core/mesh/measure.h>
#include <vcg_extras/core/mesh/spatial_order.h>
#include <vcg_extras/core/results.h>

#include <algorithm>
#include <cstdio>
#include <utility>

namespace gpr {

namespace {

/// Share of the faces that may have an edge of more than longestEdgeInRadii.
constexpr double maxSingleFaces = 0.15;
/// Of the time of a run with a tenth of the vertices, about.
constexpr double detectionShare = 0.5;

// ---- Cleaning.

/// What the options ask for. Components must be whole where small ones are dropped.
Sewing sewingFor(const RemeshOptions& options, Sewing wanted)
{
	if (!options.sew || wanted == Sewing::Never) return Sewing::Never;
	return options.dropComponentsBelow > 1 ? Sewing::First : wanted;
}

/// Orders the mesh in space and connects its faces; repairs it where it is not manifold. The mesh
/// is used up.
void connectOrRepair(RunContext& run, IndexedMesh& mesh, CleanCounts& counts, Surface& surface)
{
	Buffer<int> faceStart;
	run.clock.enter(Stage::Order);
	surface.grid = orderSpatially(mesh, run.workers, faceStart);
	run.clock.enter(Stage::Connect);
	if (connect(mesh, faceStart, run.workers, surface)) return;
	run.clock.enter(Stage::Repair);
	repairManifold(mesh, run.workers, counts);
	surface.grid = orderSpatially(mesh, run.workers, faceStart);
	if (!connect(mesh, faceStart, run.workers, surface)) {
		throw Failure(Status::InternalError, "The surface could not be made manifold.");
	}
}

void dropFaces(RunContext& run, const std::vector<int>& faces, std::int64_t& droppedNum,
			   CleanCounts& counts, Surface& surface)
{
	IndexedMesh mesh = withoutFaces(surface, faces, droppedNum);
	connectOrRepair(run, mesh, counts, surface);
}

/// Pieces without area, left by repair or there from the start, could only be meshed by triangles
/// without area. Pieces that hold others together stay.
void dropFlatPieces(RunContext& run, CleanCounts& counts, Surface& surface)
{
	const std::vector<int> flat = findFlatPieces(surface, run.workers);
	if (flat.empty()) return;
	if (int(flat.size()) == surface.mesh.faceNum)
		throw Failure(Status::UnusableInput, "The surface has no area.");
	dropFaces(run, flat, counts.zeroAreaFaces, counts, surface);
}

void dropSmallComponents(RunContext& run, CleanCounts& counts, Surface& surface)
{
	const std::int64_t    least = run.options.dropComponentsBelow;
	const SmallComponents small = findSmallComponents(surface.mesh, least, run.workers);
	if (small.num == 0) return;
	if (int(small.faces.size()) == surface.mesh.faceNum) {
		throw Failure(Status::UnusableInput,
					  "Nothing would be left: every component has fewer than " +
						  std::to_string(least) + " faces.");
	}
	counts.droppedComponents = small.num;
	dropFaces(run, small.faces, counts.droppedFaces, counts, surface);
}

/// A detour, as it takes a second ordering and connecting.
IndexedMesh withoutUselessPieces(RunContext& run, IndexedMesh mesh, CleanCounts& counts)
{
	Surface surface;
	connectOrRepair(run, mesh, counts, surface);
	dropFlatPieces(run, counts, surface);
	dropSmallComponents(run, counts, surface);
	return disconnect(surface);
}

/// Orders and connects a mesh, which is used up, and drops pieces without area. False where its
/// seams must be sewn first: most meshes have none, which is soon seen where the border is known.
/// To look for them before would take a tenth of a quick run.
bool connectCleaned(RunContext& run, Sewing sewing, IndexedMesh& mesh, CleanCounts& counts,
					Surface& surface)
{
	connectOrRepair(run, mesh, counts, surface);
	if (sewing == Sewing::NotYet && mayHaveSeams(surface, run.workers)) return false;
	dropFlatPieces(run, counts, surface);
	return true;
}

/// The caller's mesh without faulty faces and without the components that the options drop.
std::shared_ptr<CleanedInput> clean(RunContext& run, Sewing sewing, CleanCounts& counts)
{
	counts = CleanCounts(); // an earlier attempt may have counted
	run.clock.enter(Stage::Load);
	IndexedMesh mesh = loadInput(run.input, run.workers, counts);
	contractEdgesWithoutLength(mesh, run.workers, counts);
	if (sewing == Sewing::First) {
		run.clock.enter(Stage::Sew);
		sewSeams(mesh, run.workers, counts);
	}
	if (run.options.dropComponentsBelow > 1 || allFacesThin(mesh, run.workers))
		mesh = withoutUselessPieces(run, std::move(mesh), counts);
	const auto cleaned = std::make_shared<CleanedInput>();
	cleaned->extents   = measureFaces(mesh, run.workers);
	cleaned->mesh      = std::move(mesh);
	cleaned->counts    = counts;
	return cleaned;
}

// ---- The feature region.

void tellLimits(RunContext& run, const FeatureEdges& features)
{
	if (features.supportCut) {
		run.tell("The feature support was cut to 5 % of the square root of the area; the mesh is "
				 "too coarse for more.");
	}
	if (features.cappedRayNum > 0) run.tellCap("faces crossed by the rays of the feature support");
}

FeatureMarks detectRegion(RunContext& run)
{
	run.clock.beginFirstPart(Pipeline::Detection, detectionShare);
	WorkingSurface     surface;
	const FeatureEdges found = detectOnInput(run, surface);
	FeatureResult      result;
	exportFeatures(run.input, surface, found, result);
	run.clock.endFirstPart();
	if (result.figures.vertexNum > 0) return result.vertexFeature;
	run.tell("No features were detected, so that there is no feature region.");
	return {};
}

bool areSame(const FeatureThresholds& a, const FeatureThresholds& b)
{
	return a.support == b.support && a.strongDeg == b.strongDeg && a.weakDeg == b.weakDeg &&
		   a.minLength == b.minLength;
}

// ---- Edges that are too long for the sampling.

/// Faces with such edges.
struct LongFaces {
	std::vector<int> faces;
	float            longest = 0; ///< edges longer than this are split, working units
};

LongFaces findTooLong(RunContext& run, const CleanedInput& input, float radius)
{
	LongFaces found;
	found.longest = longestEdgeInRadii * radius;
	found.faces   = findLongFaces(input.mesh, input.extents, found.longest, run.workers);
	if (double(found.faces.size()) < maxSingleFaces * input.mesh.faceNum) {
		found.longest = longestSingleEdge * radius;
		found.faces   = findLongFaces(input.mesh, found.longest, found.faces, run.workers);
	}
	return found;
}

void tellStrayFaces(RunContext& run, const IndexedMesh& mesh, const std::vector<int>& longFaces)
{
	const StrayFaces stray = findStrayFaces(mesh, longFaces, run.workers);
	if (stray.num == 0) return;
	char sentence[240];
	std::snprintf(sentence, sizeof sentence,
				  "%lld of the faces reach so far out that without them the mesh would be %.0f "
				  "times as small; they have %.2g %% of the area and take as much of the result. "
				  "If they are stray, remove them first.",
				  static_cast<long long>(stray.num), stray.sizeRatio, 100 * stray.areaShare);
	run.tell(sentence);
}

void splitTooLong(RunContext& run, const LongFaces& tooLong, std::int64_t vertexNum,
				  IndexedMesh& mesh, WorkingSurface& surface)
{
	const std::int64_t maxFaces = maxFacesFor(vertexNum, mesh.faceNum);
	if (double(tooLong.faces.size()) > maxUnseen * mesh.faceNum)
		surface.callersMeanEdge = meanEdgeLength(mesh, run.workers);
	surface.cleaned.longEdgesSplit =
		splitLongEdges(mesh, tooLong.faces, tooLong.longest, maxFaces, run.workers);
}

// ---- The surface.

/// The cleaned mesh, to be changed: the run's own, or a copy of the one that is kept.
IndexedMesh takeMesh(RunContext& run, std::shared_ptr<CleanedInput>& input)
{
	IndexedMesh mesh =
		input.use_count() == 1 ? std::move(input->mesh) : copyOf(input->mesh, run.workers);
	input.reset();
	return mesh;
}

/// The whole input, connected, from the cache. False where seams must be sewn first.
bool takeConnected(RunContext& run, Sewing sewing, InputCache::OfSewing& kept,
				   WorkingSurface& surface)
{
	if (!kept.connected) {
		IndexedMesh    mesh = copyOf(kept.cleaned->mesh, run.workers);
		ConnectedInput connected;
		connected.surface.frame = mesh.frame;
		connected.mustSewFirst =
			!connectCleaned(run, sewing, mesh, surface.cleaned, connected.surface);
		connected.counts = surface.cleaned;
		if (connected.mustSewFirst) connected.surface = Surface();
		kept.connected = std::move(connected);
	}
	if (kept.connected->mustSewFirst) return false;
	surface.cleaned                = kept.connected->counts;
	static_cast<Surface&>(surface) = copyOf(kept.connected->surface, run.workers);
	return true;
}

/// With BoundaryMode::Smooth, cuts spikes off the surface that are narrower than an edge of the
/// result. The area changes with it.
void cutBorderSpikes(RunContext& run, float edge, WorkingSurface& surface)
{
	const double   unit           = 1 / surface.frame.scale;
	BorderFigures& border         = surface.border;
	border                        = BorderFigures();
	border.length                 = unit * borderLength(surface.mesh);
	border.isSmooth               = border.length > 0;
	border.area                   = unit * unit * surface.area;
	const std::vector<int> spikes = findBorderSpikes(surface.mesh, edge);
	if (spikes.empty()) return;
	IndexedMesh mesh = withoutFaces(surface, spikes, border.cutFaceNum);
	surface.area     = measureFaces(mesh, run.workers).area;
	border.cutArea   = border.area - unit * unit * surface.area;
	connectOrRepair(run, mesh, surface.cleaned, surface);
}

} // namespace

std::int64_t maxFacesFor(std::int64_t vertexNum, std::int64_t faceNum)
{
	const std::int64_t most = std::max<std::int64_t>(4 * faceNum, 200 * vertexNum + 10000000);
	return std::min<std::int64_t>(most, 700000000);
}

InputCache::OfSewing& InputCache::of(const RemeshOptions& options, Sewing sewing)
{
	fitTo(options);
	return of_[std::size_t(sewing)];
}

std::optional<DetectedRegion>& InputCache::region(const RemeshOptions& options)
{
	fitTo(options);
	if (region_ && !areSame(region_->thresholds, options.featureThresholds)) region_.reset();
	return region_;
}

void InputCache::fitTo(const RemeshOptions& options)
{
	if (sew_ == options.sew && dropComponentsBelow_ == options.dropComponentsBelow) return;
	*this                = InputCache();
	sew_                 = options.sew;
	dropComponentsBelow_ = options.dropComponentsBelow;
}

FeatureEdges detectOnInput(RunContext& run, WorkingSurface& surface)
{
	const Sewing sewing  = sewingFor(run.options, Sewing::First);
	IndexedMesh  mesh    = std::move(clean(run, sewing, surface.cleaned)->mesh);
	surface.frame        = mesh.frame;
	const float meanEdge = meanEdgeLength(mesh, run.workers);
	if (!(meanEdge > 0)) throw Failure(Status::UnusableInput, "The surface has no area.");
	connectOrRepair(run, mesh, surface.cleaned, surface);
	dropFlatPieces(run, surface.cleaned, surface);
	run.clock.enter(Stage::Detection);
	FeatureEdges features =
		findFeatures(surface, run.options.featureThresholds, meanEdge, run.workers);
	tellLimits(run, features);
	return features;
}

void countInput(RunContext& run, WorkingSurface& surface)
{
	run.clock.enter(Stage::InputFigures);
	surface.figures = figuresOf(surface.mesh, 1 / surface.frame.scale, run.workers);
}

NoFacts findRegion(RunContext& run, InputCache* cache, Products& made)
{
	made.regionMarks.clear();
	if (run.options.featureRegion != FeatureRegion::Detected) return {};
	InputCache                     own;
	std::optional<DetectedRegion>& kept = (cache != nullptr ? *cache : own).region(run.options);
	if (!kept) {
		const std::size_t notes = run.notes.size(), caps = run.capsReached.size();
		DetectedRegion    found{run.options.featureThresholds, detectRegion(run), {}, {}};
		found.notes.assign(run.notes.begin() + std::ptrdiff_t(notes), run.notes.end());
		found.caps.assign(run.capsReached.begin() + std::ptrdiff_t(caps), run.capsReached.end());
		kept = std::move(found);
	}
	for (const std::string& note : kept->notes)
		run.tell(note);
	for (const std::string& cap : kept->caps)
		run.tellCap(cap);
	made.regionMarks = kept->marks;
	return {};
}

InputFacts makeInput(RunContext& run, const Decisions& decisions, InputCache* cache, Products& made)
{
	const Sewing sewing = sewingFor(run.options, decisions.sewing);
	if (cache == nullptr) {
		made.input = clean(run, sewing, made.surface.cleaned);
	}
	else {
		InputCache::OfSewing& kept = cache->of(run.options, sewing);
		if (!kept.cleaned) kept.cleaned = clean(run, sewing, made.surface.cleaned);
		made.input = kept.cleaned;
	}
	made.surface.cleaned = made.input->counts;
	made.surface.frame   = made.input->mesh.frame;
	made.surface.area    = made.input->extents.area;
	if (!(made.surface.area > 0)) throw Failure(Status::UnusableInput, "The surface has no area.");
	return {made.surface.area, made.surface.frame.scale};
}

SurfaceFacts makeSurface(RunContext& run, const Decisions& decisions, InputCache* cache,
						 Products& made)
{
	WorkingSurface&    surface = made.surface;
	const Sewing       sewing  = sewingFor(run.options, decisions.sewing);
	const std::int64_t num     = decisions.spacedFor();
	run.clock.enter(Stage::SplitLongEdges);
	const LongFaces tooLong = findTooLong(run, *made.input, usualRadius(made, run.options, num));
	tellStrayFaces(run, made.input->mesh, tooLong.faces);
	requireMemory(bytesNeeded(facesAfterSplitting(made.input->mesh, tooLong.faces, tooLong.longest),
							  double(num)),
				  availableMemoryBytes());
	bool isConnected = false;
	if (tooLong.faces.empty() && cache != nullptr) {
		isConnected = takeConnected(run, sewing, cache->of(run.options, sewing), surface);
	}
	else {
		IndexedMesh mesh = takeMesh(run, made.input);
		if (!tooLong.faces.empty()) splitTooLong(run, tooLong, num, mesh, surface);
		isConnected = connectCleaned(run, sewing, mesh, surface.cleaned, surface);
	}
	if (isConnected && run.options.boundary == BoundaryMode::Smooth)
		cutBorderSpikes(run, idealEdge(made, num), surface);
	return {!isConnected, {surface.area, surface.frame.scale}};
}

void fillCache(RunContext& run, InputCache& cache, Products& made)
{
	findRegion(run, &cache, made);
	for (Sewing wanted : {Sewing::NotYet, Sewing::First}) {
		const Sewing          sewing = sewingFor(run.options, wanted);
		InputCache::OfSewing& kept   = cache.of(run.options, sewing);
		if (!kept.cleaned) kept.cleaned = clean(run, sewing, made.surface.cleaned);
		if (takeConnected(run, sewing, kept, made.surface)) break;
	}
}

} // namespace gpr
