// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_release.h"

#include <vcg_extras/core/base/sort_unique.h>
#include <vcg_extras/core/mesh/face_quality.h>

#include <cstddef>
#include <vector>

namespace gpr {

namespace {

/// Lines are crowded above this share of poor faces at lines. After all other repair the share is
/// 0.2 % on the fandisk, with single faces left at corners and ends of lines, 3 to 5 % on other
/// parts, and 7 to 20 % on parts with walls as thin as an edge.
constexpr double fewestPoor = 0.06;
/// Above this share the triangles are too large for the part. The search after the fit then has
/// more poor faces than the search works on, and crease edges would be lost for little gain.
constexpr double mostPoor = 0.25;
/// Rings round poor faces in which lines are released. With 1 or 0 rings the mean distance grows
/// more, because fewer vertices can give way.
constexpr int ringNum = 2;

std::vector<int> facesAtLines(const HalfEdgeMesh& m, Workers& workers)
{
	const auto isAtLine = [&](int f) {
		const int* c = &m.origin[3 * f];
		return m.isCreaseVertex(c[0]) || m.isCreaseVertex(c[1]) || m.isCreaseVertex(c[2]);
	};
	return workers.collectIf(m.faceNum, isAtLine);
}

/// The normals of the two sides of a wall have a smaller cosine than this.
constexpr float mostOfWall = -0.5f;
/// Thickest wall that keeps its lines, in ideal edges. A thicker wall is hardly thinner without
/// lines, and has better angles.
constexpr float thickestWall = 0.25f;

/// Whether a feature line at a vertex has a side that faces away from a sheet.
bool facesAway(const HalfEdgeMesh& m, const Vec3f& sheet, int v)
{
	const auto isFaceAway = [&](int h) { return dot(sheet, m.faceNormal(h / 3)) < mostOfWall; };
	return anyOutgoing(m, v, [&](int h) {
		return m.isCreaseEdge(h) && (isFaceAway(h) || isFaceAway(m.opposite[h]));
	});
}

/// Whether only two close lines hold two sheets apart: the rim of a plate, a blunt trailing edge. h
/// lies on the first line; the second line is at most two faces away.
bool holdsWall(const ResultMesh& result, int h)
{
	const HalfEdgeMesh& m      = result.mesh;
	const Vec3f         sheet  = m.faceNormal(m.opposite[h] / 3);
	const Vec3f         from   = m.position[m.origin[h]];
	const Vec3f         along  = normalized(m.position[m.target(h)] - from);
	const int           apex   = m.apex(h);
	const auto          isOver = [&](int v) {
        const float gap = length(cross(along, m.position[v] - from));
        return gap < thickestWall * result.idealEdge && facesAway(m, sheet, v);
	};
	return isOver(apex) || (!m.isCurveVertex(apex) && anyNeighbour(m, apex, isOver));
}

/// Removes the marks of line edges at these vertices. Returns the ends of the edges.
std::vector<int> takeMarksOff(const std::vector<int>& vertices, ResultMesh& result)
{
	HalfEdgeMesh&    m = result.mesh;
	std::vector<int> ends;
	for (int v : vertices) {
		if (result.vertex[v].isPinned) continue;
		forEachOutgoing(m, v, [&](int h) {
			const int w = m.target(h);
			if (!m.isCreaseEdge(h) || result.vertex[w].isPinned) return;
			if (holdsWall(result, h) || holdsWall(result, m.opposite[h])) return;
			m.crease[h] = m.crease[m.opposite[h]] = 0;
			ends.insert(ends.end(), {v, w});
		});
	}
	sortUnique(ends);
	return ends;
}

} // namespace

bool areLinesCrowded(float angleDeg, const ResultMesh& result, Workers& workers)
{
	const HalfEdgeMesh& m = result.mesh;
	if (!m.hasCreases()) return false;
	const std::vector<int> atLines = facesAtLines(m, workers);
	const std::size_t      poorNum = poorOnes(m, angleDeg * radians, atLines).size();
	return double(poorNum) > fewestPoor * double(atLines.size()) &&
		   double(poorNum) < mostPoor * double(atLines.size());
}

std::int64_t releaseLines(float angleDeg, ResultMesh& result, Workers& workers)
{
	const HalfEdgeMesh& m = result.mesh;
	if (!m.hasCreases()) return 0;
	const std::vector<int> poor        = poorOnes(m, angleDeg * radians, facesAtLines(m, workers));
	std::int64_t           releasedNum = 0;
	for (int v : takeMarksOff(verticesOf(m, widened(m, poor, ringNum)), result)) {
		if (m.isCurveVertex(v)) continue;
		ResultVertex& record = result.vertex[v];
		record.curve         = -1;
		record.arc           = 0;
		record.isCorner      = false;
		++releasedNum;
	}
	return releasedNum;
}

} // namespace gpr
