// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "input_stages.h"

#include <vcg_extras/core/base/failure.h>
#include <vcg_extras/core/features/feature_export.h>
#include <vcg_extras/core/input/cleaning.h>
#include <vcg_extras/core/input/memory_need.h>
#include <vcg_extras/core/input/split_long_edges.h>
#include <vcg_extras/core/mesh/measure.h>
#include <vcg_extras/core/results.h>

#include <algorithm>
#include <utility>

namespace gpr {

namespace {

/// The time of the detection, as a share of the time of a run with a tenth of the vertices.
constexpr double detectionShare = 0.5;

// ---- The feature region.

void tellLimits(RunContext& run, const FeatureEdges& features)
{
	if (features.supportCut) {
		run.tell("The feature support was cut to 5 % of the square root of the area; the mesh is "
				 "too coarse for a larger support.");
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
	run.tell("No features were detected, so the run has no feature region.");
	return {};
}

bool areSame(const FeatureThresholds& a, const FeatureThresholds& b)
{
	return a.support == b.support && a.strongDeg == b.strongDeg && a.weakDeg == b.weakDeg &&
		   a.minLength == b.minLength;
}

// ---- Edges that are too long for the sampling.

void splitTooLong(RunContext& run, const LongFaces& tooLong, std::int64_t vertexNum,
				  IndexedMesh& mesh, WorkingSurface& surface)
{
	constexpr double   maxUnseen = 0.02; // of the faces: noise is still visible on the other faces
	const std::int64_t maxFaces  = maxFacesFor(vertexNum, mesh.faceNum);
	if (!(surface.callersMeanEdge > 0) && double(tooLong.faces.size()) > maxUnseen * mesh.faceNum)
		surface.callersMeanEdge = meanEdgeLength(mesh, run.workers);
	surface.cleaned.longEdgesSplit +=
		splitLongEdges(mesh, tooLong.faces, tooLong.longest, maxFaces, run.workers);
}

// ---- The surface.

void nameSides(const RunContext& run, HalfEdgeMesh& mesh, bool hasMeetings)
{
	mesh.meetsAtPlaces = keepsJunctions(run.options) && hasMeetings;
	mesh.mirrorAxis    = run.input.mirrorAxis;
}

/// The cleaned mesh for changes: the mesh of the run, or a copy of a cached mesh.
IndexedMesh takeMesh(RunContext& run, std::shared_ptr<CleanedInput>& input)
{
	IndexedMesh mesh =
		input.use_count() == 1 ? std::move(input->mesh) : copyOf(input->mesh, run.workers);
	input.reset();
	return mesh;
}

/// Takes the whole connected input from the cache. False if seams must be sewn first.
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
		connected.surface.ring.release();
		kept.connected = std::move(connected);
	}
	if (kept.connected->mustSewFirst) return false;
	surface.cleaned                = kept.connected->counts;
	static_cast<Surface&>(surface) = copyOf(kept.connected->surface, run.workers);
	return true;
}

} // namespace

void InputCache::fitTo(const RemeshOptions& wanted)
{
	const auto ofCleaning = std::make_tuple(wanted.sew, wanted.dropComponentsBelow,
											keepsJunctions(wanted), keepsRegionVertices(wanted));
	if (ofCleaning == options) return;
	*this   = InputCache();
	options = ofCleaning;
}

FeatureEdges detectOnInput(RunContext& run, WorkingSurface& surface)
{
	const Sewing sewing  = sewingFor(run.options, Sewing::First);
	IndexedMesh  mesh    = std::move(clean(run, sewing, surface.cleaned)->mesh);
	surface.frame        = mesh.frame;
	const float meanEdge = meanEdgeLength(mesh, run.workers);
	if (!(meanEdge > 0)) throw Failure(Status::UnusableInput, "The surface has no area.");
	connectOrRepair(run, mesh, false, surface.cleaned, surface);
	dropFlatPieces(run, surface.cleaned, surface);
	run.clock.enter(Stage::Detection);
	FeatureEdges features =
		findFeatures(run.options.featureThresholds, meanEdge, run.workers, surface);
	tellLimits(run, features);
	return features;
}

void countInput(RunContext& run, WorkingSurface& surface)
{
	run.clock.enter(Stage::InputFigures);
	surface.figures = figuresOf(surface.mesh, 1 / surface.frame.scale, run.workers);
}

void findRegion(RunContext& run, InputCache* cache, Products& made)
{
	made.regionMarks.clear();
	if (run.options.featureRegion != FeatureRegion::Detected) return;
	InputCache                     own;
	std::optional<DetectedRegion>& kept = (cache != nullptr ? *cache : own).region;
	if (!kept || !areSame(kept->thresholds, run.options.featureThresholds)) {
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
}

InputFacts makeInput(RunContext& run, const Decisions& decisions, InputCache* cache, Products& made)
{
	const Sewing          sewing = sewingFor(run.options, decisions.sewing);
	InputCache            own;
	InputCache::OfSewing& kept = (cache != nullptr ? *cache : own).of(sewing);
	if (!kept.cleaned) kept.cleaned = clean(run, sewing, made.surface.cleaned);
	made.input           = kept.cleaned;
	made.surface.cleaned = made.input->counts;
	made.surface.frame   = made.input->mesh.frame;
	made.surface.area    = made.input->extents.area * (run.input.mirrorAxis < 0 ? 1 : 2);
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
	const LongFaces tooLong = findTooLong(made.input->mesh, made.input->extents,
										  usualRadius(made, run.options, num), run.workers);
	requireMemory(bytesNeeded(facesAfterSplitting(made.input->mesh, tooLong.faces, tooLong.longest),
							  double(num)),
				  availableMemoryBytes());
	bool isConnected = false;
	if (tooLong.faces.empty() && cache != nullptr) {
		isConnected = takeConnected(run, sewing, cache->of(sewing), surface);
	}
	else {
		IndexedMesh mesh = takeMesh(run, made.input);
		if (!tooLong.faces.empty()) splitTooLong(run, tooLong, num, mesh, surface);
		isConnected = connectCleaned(run, sewing, mesh, surface.cleaned, surface);
	}
	nameSides(run, surface.mesh, !surface.meetings.empty());
	surface.border = BorderFigures();
	if (isConnected && run.options.boundary == BoundaryMode::Smooth)
		surface.border.length = borderLength(surface.mesh) / surface.frame.scale;
	return {!isConnected};
}

void splitSurface(RunContext& run, const LongFaces& tooLong, std::int64_t vertexNum,
				  WorkingSurface& surface)
{
	run.clock.enter(Stage::SplitLongEdges);
	IndexedMesh mesh = disconnect(surface);
	splitTooLong(run, tooLong, vertexNum, mesh, surface);
	connectOrRepair(run, mesh, false, surface.cleaned, surface);
	nameSides(run, surface.mesh, !surface.meetings.empty());
}

void fillCache(RunContext& run, InputCache& cache, Products& made)
{
	cache.fitTo(run.options);
	findRegion(run, &cache, made);
	for (Sewing wanted : {Sewing::NotYet, Sewing::First}) {
		const Sewing          sewing = sewingFor(run.options, wanted);
		InputCache::OfSewing& kept   = cache.of(sewing);
		if (!kept.cleaned) kept.cleaned = clean(run, sewing, made.surface.cleaned);
		if (takeConnected(run, sewing, kept, made.surface)) break;
	}
}

} // namespace gpr
