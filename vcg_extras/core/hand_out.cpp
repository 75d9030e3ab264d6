// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "hand_out.h"

#include "audit.h"
#include "failure.h"
#include "measure.h"
#include "surface_point.h"
#include "thorough_check.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

namespace gpr {

namespace {

class HandOut : RunPart {
public:
	explicit HandOut(RunContext& run) : RunPart(run) {}

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
		if (options_.check) check(p.surface, result);
		clock_.enter("export", "Handing out the result", 1);
		exportMesh(p.surface, result, out);
		report_.quality = measureQuality(out.mesh.view(), workers_);
	}

private:
	void check(const Surface& surface, const ResultMesh& result)
	{
		clock_.enter("check", "Looking for crossings and distances", 0.99);
		const double      unit    = 1 / surface.frame.scale;
		CheckFigures      figures = checkThoroughly(surface, result.mesh, workers_);
		const std::string failure = describeFailure(figures, report_.largestFitDistance / unit);
		figures.vertexDistance *= unit;
		figures.largestDistance *= unit;
		report_.check = figures;
		if (!failure.empty()) throw Failure(Status::PromiseBroken, failure);
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

} // namespace

void handOut(RunContext& run, const Prepared& p, const ResultMesh& result, RemeshResult& out)
{
	HandOut(run).finish(p, result, out);
}

} // namespace gpr
