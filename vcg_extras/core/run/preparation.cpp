// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "preparation.h"

#include "border_smoothing.h"
#include "error_guide.h"
#include "feature_lines.h"
#include "kept_input.h"
#include "loading.h"
#include "target.h"

#include <vcg_extras/core/base/failure.h>
#include <vcg_extras/core/features/feature_region.h>
#include <vcg_extras/core/features/shared_borders.h>
#include <vcg_extras/core/input/load.h>
#include <vcg_extras/core/input/memory_need.h>
#include <vcg_extras/core/input/sew_seams.h>
#include <vcg_extras/core/input/split_long_edges.h>
#include <vcg_extras/core/input/stray_faces.h>
#include <vcg_extras/core/input/surface_refinement.h>
#include <vcg_extras/core/mesh/measure.h>
#include <vcg_extras/core/sampling/front_sampling.h>
#include <vcg_extras/core/sampling/sizing.h>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <iterator>
#include <utility>
#include <vector>

namespace gpr {

namespace {

/// Share of the faces that may have an edge of more than longestEdgeInRadii.
constexpr double maxSingleFaces = 0.15;
/// Where no more than this share of the faces is split, noise is still seen on those that are
/// there.
constexpr double maxUnseen = 0.02;

std::int64_t maxFacesFor(std::int64_t targetNum, std::int64_t faceNum)
{
	const std::int64_t most = std::max<std::int64_t>(4 * faceNum, 200 * targetNum + 10000000);
	return std::min<std::int64_t>(most, 700000000);
}

void noteStrayFaces(RunContext& run, const IndexedMesh& mesh, const std::vector<int>& longFaces)
{
	const StrayFaces stray = findStrayFaces(mesh, longFaces, run.workers);
	if (stray.num == 0) return;
	char sentence[240];
	std::snprintf(sentence, sizeof sentence,
				  "%lld of the faces reach so far out that without them the mesh would be %.0f "
				  "times as small; they have %.2g %% of the area and take as much of the result. "
				  "If they are stray, remove them first.",
				  static_cast<long long>(stray.num), stray.sizeRatio, 100 * stray.areaShare);
	if (std::find(run.notes.begin(), run.notes.end(), sentence) == run.notes.end())
		run.notes.push_back(sentence);
}

/// Faces with edges that are too long for the sampling.
struct LongFaces {
	std::vector<int> faces;
	float            longest = 0; ///< edges longer than this are split, working units
};

LongFaces findTooLong(RunContext& run, const CleanedInput& input, const Prepared& p)
{
	LongFaces found;
	found.longest = longestEdgeInRadii * p.radius;
	found.faces   = findLongFaces(input.mesh, input.extents, found.longest, run.workers);
	if (double(found.faces.size()) < maxSingleFaces * input.mesh.faceNum) {
		found.longest = longestSingleEdge * p.radius;
		found.faces   = findLongFaces(input.mesh, found.longest, found.faces, run.workers);
	}
	return found;
}

void requireMemoryFor(const LongFaces& tooLong, const IndexedMesh& mesh, const Prepared& p)
{
	const double faces = facesAfterSplitting(mesh, tooLong.faces, tooLong.longest);
	requireMemory(bytesNeeded(faces, double(p.targetNum)), availableMemoryBytes());
}

void splitTooLong(RunContext& run, const LongFaces& tooLong, IndexedMesh& mesh, Prepared& p)
{
	const std::int64_t maxFaces = maxFacesFor(p.targetNum, mesh.faceNum);
	if (double(tooLong.faces.size()) > maxUnseen * mesh.faceNum)
		p.callersMeanEdge = meanEdgeLength(mesh, run.workers);
	run.report.cleaned.longEdgesSplit =
		splitLongEdges(mesh, tooLong.faces, tooLong.longest, maxFaces, run.workers);
}

/// Connects the input, split as far as the sampling needs it. False where seams must be sewn first.
bool splitAndConnect(RunContext& run, Sewing sewing, InputOfRun& input, Prepared& p)
{
	run.clock.enter(Stage::SplitLongEdges);
	const LongFaces tooLong = findTooLong(run, input.cleaned(), p);
	noteStrayFaces(run, input.cleaned().mesh, tooLong.faces);
	requireMemoryFor(tooLong, input.cleaned().mesh, p);
	if (tooLong.faces.empty()) return input.takeSurface(p.surface);
	IndexedMesh mesh = input.takeMesh();
	splitTooLong(run, tooLong, mesh, p);
	return connectCleaned(run, sewingFor(run.options, sewing), mesh, p.surface);
}

/// The caller's own vertices on the border.
std::vector<int> borderVertices(RunContext& run, const Surface& surface)
{
	const HalfEdgeMesh& m = surface.mesh;
	Buffer<char>        onBorder(m.vertexNum);
	for (int v = 0; v < m.vertexNum; ++v)
		onBorder[v] = m.outgoing[v] >= 0 && m.isBorderVertex(v);
	return callersVertices(run.input, onBorder, surface, run.workers);
}

std::vector<int> unionOf(const std::vector<int>& a, const std::vector<int>& b)
{
	std::vector<int> all;
	std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(all));
	return all;
}

/// Which of the caller's vertices make the region, null for none.
const std::uint8_t* regionMarks(const RunContext& run, const FeatureMarks& marks)
{
	if (run.options.featureRegion == FeatureRegion::Selection) return run.input.selected;
	return marks.empty() ? nullptr : marks.data();
}

/// The region may have been chosen by what is selected: the user shall see which it is.
void tellFeatureRegion(RunContext& run)
{
	if (run.report.regionVertexNum == 0) return;
	const bool        isSelection = run.options.featureRegion == FeatureRegion::Selection;
	const std::string number      = std::to_string(run.report.regionVertexNum);
	run.notes.push_back("The feature region is made of " + number +
						(isSelection ? " selected" : " detected") + " vertices.");
}

void findFeatureRegion(RunContext& run, const FeatureMarks& marks, Prepared& p)
{
	p.isFeatureVertex = regionVertices(run.input, regionMarks(run, marks), p.surface, run.workers);
	if (run.options.featureRegion == FeatureRegion::Selection && p.isFeatureVertex.empty()) {
		throw Failure(Status::BadOptions,
					  "The selection is to be preserved, but no vertex is selected.");
	}
	const std::vector<int> vertices =
		callersVertices(run.input, p.isFeatureVertex, p.surface, run.workers);
	run.report.regionVertexNum = std::int64_t(vertices.size());
	p.kept.clear();
	if (keepsRegionVertices(run.options)) p.kept = vertices;
	if (run.options.boundary == BoundaryMode::Keep)
		p.kept = unionOf(p.kept, borderVertices(run, p.surface));
}

Sizing findSizes(RunContext& run, const FeatureMarks& marks, Prepared& p)
{
	run.clock.enter(Stage::Sizing);
	findFeatureRegion(run, marks, p);
	const float uniform =
		float(diskRadius(p.area, double(p.targetNum), radiusConstant(run.options)));
	const bool hasLines = run.options.adapt > 0 && hasFeatureLines(run, p);
	if (hasLines) run.report.adapt = 0;
	const FineSpots* spots = run.guide != nullptr ? &run.guide->spots : nullptr;
	return makeSizing(
		{run.options, uniform, evenEdge(p), hasLines, p.isFeatureVertex, p.kept, spots}, p.surface,
		run.workers);
}

/// Splits what is too long for small triangles. The sizes go with the vertices.
void splitForSizes(RunContext& run, const FeatureMarks& marks, float longest, Prepared& p)
{
	const std::vector<int> longFaces = findLongFaces(p.surface, longest, run.workers);
	if (longFaces.empty()) return;
	run.clock.enter(Stage::SplitLongEdges);
	const int faceNum = p.surface.mesh.faceNum;
	if (!(p.callersMeanEdge > 0) && double(longFaces.size()) > maxUnseen * faceNum)
		p.callersMeanEdge = meanEdgeLength(p.surface.mesh, run.workers);
	const std::int64_t maxFaces = maxFacesFor(p.targetNum, faceNum);
	run.report.cleaned.longEdgesSplit +=
		refineSurface(longFaces, longest, maxFaces, p.surface, run.workers);
	findFeatureRegion(run, marks, p);
}

/// Gives the surface its sizes, and the largest disks the radius that goes with them.
void setSizes(RunContext& run, const FeatureMarks& marks, Prepared& p)
{
	Sizing sizing = findSizes(run, marks, p);
	if (sizing.size.empty()) return;
	p.surface.size = std::move(sizing.size);
	p.radiusFactor = sizing.radiusFactor;
	if (p.sharesBorders) equalizeSizes(p.surface);
	run.report.curvatureClampedNum = sizing.clampedNum;
	setTarget(run, p.targetNum, p);
	splitForSizes(run, marks, sizing.longestEdge * p.radius, p);
}

/// The count to aim at, for an area in working units squared and a scale from mesh to working
/// units.
using TargetOf = std::function<std::int64_t(double area, double scale)>;

Prepared prepareWith(RunContext& run, const FeatureMarks& marks, const TargetOf& targetOf,
					 Sewing sewing)
{
	Prepared   p;
	InputOfRun input(run, sewing);
	p.area          = input.cleaned().extents.area;
	p.sharesBorders = run.report.cleaned.sharedBorderEdges > 0;
	p.isSewn        = run.report.cleaned.sewnEdges > 0;
	if (!(p.area > 0)) throw Failure(Status::UnusableInput, "The surface has no area.");
	p.surface.frame           = input.cleaned().mesh.frame;
	run.report.radiusConstant = radiusConstant(run.options);
	setTarget(run, targetOf(p.area, p.surface.frame.scale), p);

	if (!splitAndConnect(run, sewing, input, p))
		return prepareWith(run, marks, targetOf, Sewing::First);
	if (cutBorderSpikes(run, p)) setTarget(run, targetOf(p.area, p.surface.frame.scale), p);
	p.madeFor = p.targetNum;
	setSizes(run, marks, p);
	describeInput(run, p.surface);
	return p;
}

} // namespace

Prepared prepare(RunContext& run, const FeatureMarks& marks)
{
	const auto targetOf = [&](double area, double scale) {
		return resolveTarget(run.input, run.options, area, scale);
	};
	Prepared p = prepareWith(run, marks, targetOf, Sewing::NotYet);
	tellFeatureRegion(run);
	return p;
}

Prepared prepareFor(RunContext& run, const FeatureMarks& marks, std::int64_t vertexNum,
					Sewing sewing)
{
	return prepareWith(
		run, marks, [&](double, double) { return vertexNum; }, sewing);
}

} // namespace gpr
