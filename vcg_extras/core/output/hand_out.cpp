// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "hand_out.h"

#include "audit.h"
#include "face_anchor.h"
#include "thorough_check.h"

#include <vcg_extras/core/base/failure.h>
#include <vcg_extras/core/carry_over.h>
#include <vcg_extras/core/mesh/measure.h>
#include <vcg_extras/core/surface/barycentric_point.h>
#include <vcg_extras/core/surface/surface_point.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

namespace gpr {

namespace {

/// How far rounding may have taken a kept vertex of the caller's, in working units. Others lie
/// farther from any: they come from splitting long edges between kept vertices.
constexpr double farthestFromItself = 1e-5;

class HandOut : RunPart {
public:
	explicit HandOut(RunContext& run) : RunPart(run) {}

	void finish(const Surface& surface, const ResultMesh& result, const Expected& expected,
				RemeshResult& out)
	{
		clock_.enter("audit", "Checking", 0.98);
		const double unit           = 1 / surface.frame.scale;
		report_.result              = figuresOf(result.mesh, unit, workers_);
		const std::int64_t promised = options_.exactCount ? expected.vertexNum : 0;
		noteOperations(result);
		noteCountReached(expected, result, out);
		noteKept(expected, result);
		report_.audit =
			audit(surface, result, report_.cleanedInput, report_.result, promised, workers_);
		if (!report_.audit.passed) {
			throw Failure(Status::PromiseBroken, describeFailure(report_.audit));
		}
		if (report_.audit.flippedFaces > 0) {
			out.notes.push_back(std::to_string(report_.audit.flippedFaces) +
								" faces look against the input's normals, where the surface is "
								"thinner than the triangles are wide.");
		}
		if (options_.check) check(surface, result);
		clock_.enter("export", "Handing out the result", 1);
		exportMesh(surface, result, out);
		if (options_.anchorsOfVertices || report_.keptVertexNum > 0)
			exportAnchors(surface, result, out);
		if (report_.keptVertexNum > 0) exportKept(result, 1 / surface.frame.scale, out);
		if (options_.anchorsOfFaces) exportFaceAnchors(surface, result, out);
		requireAreas(out.mesh);
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

	void requireAreas(const TriangleMesh& mesh)
	{
		report_.audit.zeroAreaFaces = zeroAreaFaceNum(mesh, workers_);
		report_.audit.passed        = report_.audit.zeroAreaFaces == 0;
		if (!report_.audit.passed)
			throw Failure(Status::PromiseBroken, describeFailure(report_.audit));
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
	void noteCountReached(const Expected& expected, const ResultMesh& result, RemeshResult& out)
	{
		if (options_.exactCount || expected.vertexNum == 0) return;
		const double share = double(result.mesh.vertexNum) / double(expected.vertexNum);
		report_.radiusConstantForTarget = report_.radiusConstant * std::sqrt(share);
		char sentence[160];
		std::snprintf(
			sentence, sizeof sentence,
			"%lld vertices of %lld wanted (%+.1f %%); with %.3f instead of %.3f in eq. (1) "
			"it would have been about as many as wanted.",
			static_cast<long long>(result.mesh.vertexNum),
			static_cast<long long>(expected.vertexNum), 100 * (share - 1),
			report_.radiusConstantForTarget, report_.radiusConstant);
		out.notes.push_back(sentence);
	}

	void noteKept(const Expected& expected, const ResultMesh& result)
	{
		const auto isPinned   = [](const ResultVertex& v) { return v.isPinned; };
		report_.keptVertexNum = std::count_if(result.vertex.begin(), result.vertex.end(), isPinned);
		const std::int64_t lost = expected.keptNum - report_.keptVertexNum;
		if (2 * report_.keptVertexNum > result.mesh.vertexNum) {
			notes_.push_back("More than half of the vertices had to stay where they were; the "
							 "triangles beside them are uneven.");
		}
		if (lost > 0) {
			notes_.push_back(std::to_string(lost) + " of the " + std::to_string(expected.keptNum) +
							 " vertices that were to stay could not be kept.");
		}
	}

	void exportMesh(const Surface& surface, const ResultMesh& result, RemeshResult& out)
	{
		const HalfEdgeMesh& m = result.mesh;
		out.mesh.positions.resize(m.vertexNum);
		out.mesh.triangles.assign(m.origin.data(), m.origin.data() + m.halfEdgeNum());
		workers_.forRange(m.vertexNum, [&](std::size_t begin, std::size_t end) {
			for (std::size_t v = begin; v < end; ++v)
				out.mesh.positions[v] = surface.frame.toCaller(m.position[v]);
		});
	}

	void exportAnchors(const Surface& surface, const ResultMesh& result, RemeshResult& out)
	{
		out.anchors.resize(result.vertex.size());
		workers_.forRange(result.vertex.size(), [&](std::size_t begin, std::size_t end) {
			for (std::size_t v = begin; v < end; ++v)
				out.anchors[v] = surfacePoint(input_, surface, result.vertex[v].anchor);
		});
	}

	/// Vertices that stayed get the caller's own bits back. unit: the caller's length of a working
	/// one.
	void exportKept(const ResultMesh& result, double unit, RemeshResult& out)
	{
		out.callersVertex.assign(result.vertex.size(), -1);
		for (std::size_t v = 0; v < result.vertex.size(); ++v) {
			if (!result.vertex[v].isPinned) continue;
			SurfacePoint&      at     = out.anchors[v];
			const int          corner = nearestCorner(at);
			const std::size_t  i      = 3 * std::size_t(at.face) + std::size_t(corner);
			const std::int32_t c      = input_.vertexOf(i);
			const Vec3d        place  = input_.position(std::size_t(c));
			if (length(place - out.mesh.positions[v]) > unit * farthestFromItself) continue;
			for (int k = 0; k < 3; ++k)
				at.weight[k] = k == corner;
			out.callersVertex[v]  = c;
			out.mesh.positions[v] = place;
		}
	}

	void exportFaceAnchors(const Surface& surface, const ResultMesh& result, RemeshResult& out)
	{
		out.faceAnchors.resize(result.mesh.faceNum);
		workers_.forRange(result.mesh.faceNum, [&](std::size_t begin, std::size_t end) {
			for (std::size_t f = begin; f < end; ++f) {
				const Anchor middle = anchorOfFace(surface, result, int(f));
				out.faceAnchors[f]  = surfacePoint(input_, surface, middle);
			}
		});
	}
};

} // namespace

void handOut(RunContext& run, const Surface& surface, const ResultMesh& result,
			 const Expected& expected, RemeshResult& out)
{
	HandOut(run).finish(surface, result, expected, out);
}

} // namespace gpr
