// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "export.h"

#include "audit.h"
#include "face_point.h"
#include "region_labels.h"

#include <vcg_extras/core/base/failure.h>
#include <vcg_extras/core/carry_over.h>
#include <vcg_extras/core/mesh/measure.h>
#include <vcg_extras/core/surface/barycentric_point.h>
#include <vcg_extras/core/surface/junctions.h>

#include <algorithm>
#include <locale>
#include <sstream>

namespace gpr {

namespace {

/// Largest distance of a kept vertex from its input vertex by rounding, in working units. Pinned
/// vertices farther from all input vertices come from long edges split between kept vertices.
constexpr double farthestFromItself = 1e-5;

void exportMesh(RunContext& run, const Surface& surface, const HalfEdgeMesh& m, TriangleMesh& out)
{
	out.positions.resize(m.vertexNum);
	out.triangles.assign(m.origin.data(), m.origin.data() + m.halfEdgeNum());
	run.workers.forEach(m.vertexNum,
						[&](int v) { out.positions[v] = surface.frame.toCaller(m.position[v]); });
}

/// The points of the input at points of the surface; pointAt(i) is point i of the surface.
template <class PointAt>
std::vector<BarycentricPoint> pointsOfInput(RunContext& run, const Surface& surface,
											std::size_t num, const PointAt& pointAt)
{
	std::vector<BarycentricPoint> points(num);
	run.workers.forEach(
		num, [&](int i) { points[i] = barycentricPoint(run.input, surface, pointAt(i)); });
	return points;
}

/// Gives kept vertices the exact coordinates of the input. unit: length of a working unit, mesh
/// units.
void exportKept(const MeshView& input, const ResultMesh& result, double unit, RemeshResult& out)
{
	out.callersVertex.assign(result.vertex.size(), -1);
	for (std::size_t v = 0; v < result.vertex.size(); ++v) {
		if (!result.vertex[v].isPinned) continue;
		BarycentricPoint&  at     = out.surfacePoints[v];
		const std::size_t  face   = std::size_t(at.face);
		const std::size_t  corner = std::size_t(nearestCorner(at));
		const std::int32_t c      = input.vertexOf(3 * face + corner);
		const Vec3d        place  = input.position(std::size_t(c));
		if (length(place - out.mesh.positions[v]) > unit * farthestFromItself) continue;
		at                    = BarycentricPoint::ofCorner(face, corner);
		out.callersVertex[v]  = c;
		out.mesh.positions[v] = place;
	}
}

std::vector<BarycentricPoint> facePoints(RunContext& run, const Surface& surface,
										 const ResultMesh& result)
{
	return pointsOfInput(run, surface, result.mesh.faceNum,
						 [&](int f) { return pointOfFace(surface, result, f); });
}

/// Most parts of regions that a note names.
constexpr std::size_t mostNamed = 5;

std::string nameOf(const MeshView& input, const RegionPiece& piece)
{
	const std::vector<std::string>* names = input.regionNames;
	const std::size_t               i     = std::size_t(piece.label);
	const bool hasName = names != nullptr && i < names->size() && !(*names)[i].empty();
	return hasName ? "'" + (*names)[i] + "'" : std::to_string(piece.label);
}

std::string lostNote(const MeshView& input, const std::vector<RegionPiece>& lost)
{
	if (lost.empty()) return {};
	std::ostringstream text;
	text.imbue(std::locale::classic());
	text << "Too small for a face of the result: " << lost.size()
		 << (lost.size() == 1 ? " part of a region (" : " parts of regions (");
	for (std::size_t i = 0; i < std::min(lost.size(), mostNamed); ++i)
		text << (i > 0 ? ", " : "") << nameOf(input, lost[i]) << " of area " << lost[i].area;
	text << (lost.size() > mostNamed ? ", ...)." : ").");
	return text.str();
}

void exportRegions(RunContext& run, const Surface& surface, const ResultMesh& result,
				   RemeshResult& out)
{
	const RegionLabels labels = labelFaces(run.input, surface, result, run.workers);
	out.facePoints =
		pointsOfInput(run, surface, labels.middle.size(), [&](int f) { return labels.middle[f]; });
	for (const BarycentricPoint& at : out.facePoints)
		out.region.push_back(run.input.region[at.face]);
	run.tell(lostNote(run.input, labels.lost));
}

/// Per face of the input: whether cleaning reversed the face.
std::vector<char> turnedFaces(RunContext& run, const Surface& surface)
{
	std::vector<char> isTurned(run.input.faceNum, 0);
	for (int f = 0; f < surface.mesh.faceNum; ++f) {
		const std::size_t source = std::size_t(surface.sourceFace[f]);
		if (dot(run.input.faceCross(source), Vec3d(surface.mesh.faceCross(f))) < 0)
			isTurned[source] = 1;
	}
	return isTurned;
}

/// Gives each face of the result the orientation of the input face at its middle. The engine works
/// on sheets with consistent orientation.
void turnAsInput(RunContext& run, const Surface& surface, const ResultMesh& result,
				 RemeshResult& out)
{
	const std::vector<BarycentricPoint> at =
		out.facePoints.empty() ? facePoints(run, surface, result) : out.facePoints;
	const std::vector<char> isTurned = turnedFaces(run, surface);
	for (std::size_t f = 0; f < at.size(); ++f) {
		if (isTurned[at[f].face])
			std::swap(out.mesh.triangles[3 * f + 1], out.mesh.triangles[3 * f + 2]);
	}
}

/// Merges the vertices of all sheets at the same place of a junction. Takes the exact coordinates
/// of an input vertex, if any.
void joinSheets(const std::vector<int>& first, RemeshResult& out)
{
	std::vector<std::int32_t> newIndex(first.size());
	const bool  hasPoints = !out.surfacePoints.empty(), hasCallers = !out.callersVertex.empty();
	std::size_t num = 0;
	const auto  put = [&](std::size_t from, std::size_t to) {
        out.mesh.positions[to] = out.mesh.positions[from];
        if (hasPoints) out.surfacePoints[to] = out.surfacePoints[from];
        if (hasCallers) out.callersVertex[to] = out.callersVertex[from];
	};
	for (std::size_t v = 0; v < first.size(); ++v) {
		const bool isFirst = first[v] == int(v);
		newIndex[v]        = isFirst ? std::int32_t(num++) : newIndex[first[v]];
		if (isFirst || (hasCallers && out.callersVertex[v] >= 0)) put(v, std::size_t(newIndex[v]));
	}
	out.mesh.positions.resize(num);
	if (hasPoints) out.surfacePoints.resize(num);
	if (hasCallers) out.callersVertex.resize(num);
	for (std::int32_t& v : out.mesh.triangles)
		v = newIndex[v];
}

/// Checks for degenerate faces in the frame of the input, with its other rounding.
void requireAreas(RunContext& run, const MeshView& mesh, AuditFigures& audited)
{
	audited.zeroAreaFaces =
		run.workers.sumEach<std::int64_t>(mesh.faceNum, [&](int f, std::int64_t& num) {
			num += mesh.faceCross(f) == Vec3d(); // squares could underflow
		});
	audited.passed = audited.zeroAreaFaces == 0;
	if (!audited.passed) throw Failure(Status::PromiseBroken, describeFailure(audited));
}

} // namespace

QualityFigures exportResult(RunContext& run, const Surface& surface, const ResultMesh& result,
							bool hasKept, bool turnsFaces, AuditFigures& audited, RemeshResult& out)
{
	run.clock.enter(Stage::Export);
	exportMesh(run, surface, result.mesh, out.mesh);
	if (run.options.surfacePointsOfVertices || hasKept)
		out.surfacePoints = pointsOfInput(run, surface, result.vertex.size(),
										  [&](int v) { return result.vertex[v].point; });
	if (hasKept) exportKept(run.input, result, 1 / surface.frame.scale, out);
	if (run.input.region != nullptr)
		exportRegions(run, surface, result, out);
	else if (run.options.surfacePointsOfFaces)
		out.facePoints = facePoints(run, surface, result);
	if (result.mesh.meetsAtPlaces && turnsFaces) turnAsInput(run, surface, result, out);
	if (result.mesh.meetsAtPlaces)
		joinSheets(Junctions(result.mesh, surface.meetings, run.workers).first(), out);
	requireAreas(run, out.mesh.view(), audited);
	return measureQuality(out.mesh.view(), run.workers);
}

void nameSamples(const std::vector<Vec3d>& points, const std::vector<char>& isMoved,
				 const ResultMesh& result, RemeshResult& out)
{
	out.sampleOf.resize(result.vertex.size());
	for (std::size_t v = 0; v < result.vertex.size(); ++v) {
		const int s     = result.vertex[v].sample;
		out.sampleOf[v] = s;
		if (s >= 0 && !isMoved[s]) out.mesh.positions[v] = points[s];
	}
}

} // namespace gpr
