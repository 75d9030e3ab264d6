// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample_stages.h"

#include "surface_stages.h"

#include <vcg_extras/core/mesh/same_place.h>
#include <vcg_extras/core/optimization/delaunay_flips.h>
#include <vcg_extras/core/optimization/exact_count.h>
#include <vcg_extras/core/optimization/face_repair.h>
#include <vcg_extras/core/optimization/false_edges.h>
#include <vcg_extras/core/retriangulation/hole_retriangulation.h>
#include <vcg_extras/core/retriangulation/vertex_removal.h>
#include <vcg_extras/core/sampling/border_edge_sampling.h>
#include <vcg_extras/core/sampling/fused_mesh.h>
#include <vcg_extras/core/surface/junctions.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace gpr {

namespace {

/// Whether the first sampling may miss the count by much. Ridges and thin parts hold fewer disks
/// than the area lets expect, on scans up to a tenth of all disks. With sizes that follow the
/// error, small disks are missing there, and later splits would fall elsewhere.
bool mayMissCount(const RemeshOptions& options, const Products& made)
{
	const bool hasErrorSizes = options.adapt >= 0.5 && !made.surface.size.empty();
	return hasErrorSizes || made.surface.mesh.meetsAtPlaces || made.sizes.vertexNum > 0 ||
		   made.surface.mesh.hasCreases() || !made.sizes.kept.empty();
}

/// Places samples by the method of the paper, which also fuses the samples into a mesh. The removal
/// of vertices uses the mesh.
void sampleOnBorderEdges(RunContext& run, const Decisions& decisions, const Buffer<char>& first,
						 Products& made)
{
	BorderEdgeOptions o;
	o.radius     = made.samples.radius;
	o.seed       = run.options.seed;
	o.maxSamples = 100000 + 10 * decisions.spacedFor();
	o.region     = &first;
	BorderEdgeSampling placed =
		sampleBorderEdges(made.surface, made.samples.curves, o, run.workers);
	made.samples.sampling = std::move(placed.sampling);
	made.samples.fused    = std::move(placed.fused);
}

/// Frees the source faces, unless the result refers to faces of the input.
void releaseSources(const RemeshOptions& options, Products& made)
{
	const bool areNeeded = options.surfacePointsOfVertices || options.surfacePointsOfFaces ||
						   !made.sizes.kept.empty() || made.surface.mesh.meetsAtPlaces;
	if (!areNeeded) made.surface.sourceFace.release();
}

/// The number of samples that are copies of other samples at junctions. All copies lie on curves,
/// except at vertices at which sheets only touch.
std::int64_t copiesAmong(const Sampling& sampling, const Surface& surface)
{
	if (!surface.mesh.meetsAtPlaces) return 0;
	std::vector<Vec3f> places;
	for (const Sample& s : sampling.samples)
		places.push_back(s.point.position);
	std::sort(places.begin(), places.end(), isBefore<float>);
	return places.end() - std::unique(places.begin(), places.end());
}

/// The mesh fused by the border-edge placement, or a mesh fused now.
FusedMesh fusedMesh(RunContext& run, Products& made)
{
	if (!made.samples.fused.sampleVertex.empty()) return std::move(made.samples.fused);
	return fuseSamples(made.surface, made.samples.sampling, made.samples.curves, run.workers);
}

} // namespace

OctreeBlocks cutForSampling(RunContext& run, const Decisions& decisions, float radius,
							const Surface& surface)
{
	// Least width of a block, in radii. Larger blocks leave fewer seams in the packing, but few
	// samples would leave threads without a block.
	constexpr float        blockWidth = 20, smallBlockWidth = 12;
	constexpr std::int64_t fewSamples = 100000;
	const float width = decisions.spacedFor() < fewSamples ? smallBlockWidth : blockWidth;
	return cutIntoBlocks(surface, width * radius, run.workers);
}

SampleFacts placeSamples(RunContext& run, const Decisions& decisions, Products& made)
{
	const RemeshOptions& options = run.options;
	Samples&             samples = made.samples;
	const float          usual   = usualRadius(made, options, decisions.spacedFor());
	releaseSources(options, made);
	samples.radius = decisions.radius.value_or(usual);
	if (!decisions.radius || !made.sizes.kept.empty())
		samples.partition = cutForSampling(run, decisions, samples.radius, made.surface);
	samples.spacedFor = decisions.spacedFor();
	run.clock.enter(Stage::Boundary);
	samples.curves = samples.radius == made.lines.radius
						 ? made.lines.curves
						 : sampleCurves(run, decisions, samples.radius, made);
	run.clock.enter(Stage::Sampling);
	const Buffer<char>  noRegion;
	const bool          beginsInRegion = !keepsRegionVertices(options);
	const Buffer<char>& first          = beginsInRegion ? made.sizes.isFeatureVertex : noRegion;
	if (isPaper(options))
		sampleOnBorderEdges(run, decisions, first, made);
	else
		samples.sampling = sampleFront(made.surface, samples.curves, samples.partition,
									   samples.radius, options.seed, run.workers, first);
	if (samples.sampling.capped) run.tellCap("samples of a block");
	const std::int64_t copyNum = copiesAmong(samples.sampling, made.surface);
	const auto&        all     = samples.sampling.samples;
	samples.num                = wholeNum(made.surface.mesh, all, all.size()) - copyNum;
	samples.onCurveNum =
		wholeNum(made.surface.mesh, all, std::size_t(samples.sampling.boundarySampleNum)) - copyNum;
	return {mayMissCount(options, made), samples.num, samples.onCurveNum, samples.radius, usual};
}

void takeGivenSamples(RunContext& run, const Decisions& decisions, const std::vector<Vec3d>& points,
					  Products& made)
{
	run.clock.enter(Stage::GivenSamples);
	Samples& samples        = made.samples;
	samples.given           = takeOverSamples(made.surface, points, run.workers);
	samples.radius          = usualRadius(made, run.options, decisions.spacedFor());
	samples.spacedFor       = decisions.spacedFor();
	samples.num             = std::int64_t(points.size());
	samples.sampling        = std::move(samples.given.sampling);
	samples.sampling.radius = samples.radius;
	samples.partition       = cutForSampling(run, decisions, samples.radius, made.surface);
}

void connectSamples(RunContext& run, const Decisions& decisions, Products& made)
{
	run.clock.enter(Stage::Retriangulation);
	ResultMesh& result = made.result;
	if (!isPaper(run.options))
		result = removeVertices(made.surface, made.samples.sampling, made.samples.curves,
								made.surface.figures, run.workers);
	else
		result = removeOriginalVertices(fusedMesh(run, made), made.surface, made.samples.sampling,
										made.samples.curves, made.samples.partition, run.workers);
	result.mesh.mirrorAxis = run.input.mirrorAxis;
	made.curves            = std::move(made.samples.curves);
	made.samples.release();
	result.idealEdge       = idealEdge(made, decisions.spacedFor());
	result.keepsBorder     = run.options.boundary == BoundaryMode::Keep;
	result.hasSmoothBorder = borderMode(run.options, decisions) == BoundaryMode::Smooth &&
							 made.surface.border.isSmooth();
	if (made.surface.mesh.meetsAtPlaces) {
		result.mesh.meetsAtPlaces = true;
		result.copyNum = Junctions(result.mesh, made.surface.meetings, run.workers).copyNum();
	}
	run.clock.enter(Stage::Flips);
	flipEdges(run, result);
	if (decisions.purpose == Purpose::OfGivenSamples) return;
	if (!repairInvertedFaces(made.surface, made.curves, true, result, run.workers))
		run.tellCap("changes for inverted faces");
}

void reachCount(RunContext& run, const Decisions& decisions, Products& made)
{
	const CountTarget target = decisions.countTarget();
	if (decisions.way == Way::ByTopology) {
		made.result.idealEdge = idealEdge(made, decisions.vertexNum);
		run.clock.enter(Stage::Count);
		reachCountByTopology(made.surface, made.curves, target, made.result, run.workers);
	}
	else if (!isPaper(run.options)) {
		run.clock.enter(Stage::Count);
		reachExactCount(made.surface, made.curves, target, made.result, run.workers);
	}
	separateSheets(run, decisions, made);
}

void separateSheets(RunContext& run, const Decisions& decisions, Products& made)
{
	constexpr int rounds = 8; // the collapses for added vertices may make false edges again
	if (!made.surface.mesh.meetsAtPlaces) return;
	int before = std::numeric_limits<int>::max();
	for (int round = 0; round < rounds; ++round) {
		const int num = splitFalseEdges(made.surface, made.result, run.workers);
		if (num == 0) return;
		reachExactCount(made.surface, made.curves, decisions.countTarget(), made.result,
						run.workers);
		if (num > before) return; // whole sheets at one place: every split makes more of them
		before = num;
	}
}

void flipEdges(RunContext& run, ResultMesh& result)
{
	flipToDelaunay(result, run.workers,
				   isPaper(run.options) ? run.options.flipPasses : untilDelaunay);
}

} // namespace gpr
