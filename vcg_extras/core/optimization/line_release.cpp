// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_release.h"

#include <vcg_extras/core/base/sort_unique.h>
#include <vcg_extras/core/mesh/face_quality.h>

#include <cstddef>
#include <vector>

namespace gpr {

namespace {

/// Lines are crowded from this share of poor faces at them on. After all other repair it is 0.2 %
/// on the fandisk, where single faces at corners and ends of lines are left, 3 to 5 % on other
/// parts, and 7 to 20 % on parts with walls as thin as an edge.
constexpr double fewestPoor = 0.06;
/// Beyond this share the triangles are too large for the part. The search after the fit has more
/// poor faces then than it works on, and sharp edges would be lost for little.
constexpr double mostPoor = 0.25;
/// Rings round poor faces in which lines are released. With one, or none, the mean distance grows
/// more: fewer vertices can give way.
constexpr int ringNum = 2;

std::vector<int> facesAtLines(const HalfEdgeMesh& m, Workers& workers)
{
	const auto isAtLine = [&](int f) {
		const int* c = &m.origin[3 * f];
		return m.isCreaseVertex(c[0]) || m.isCreaseVertex(c[1]) || m.isCreaseVertex(c[2]);
	};
	return workers.collectIf(m.faceNum, isAtLine);
}

/// Those among the faces at lines.
std::vector<int> poorAtLines(float angleDeg, const HalfEdgeMesh& m, Workers& workers)
{
	return poorOnes(m, angleDeg * radians, facesAtLines(m, workers));
}

std::vector<int> verticesNear(const HalfEdgeMesh& m, const std::vector<int>& faces)
{
	std::vector<int> vertices = verticesOf(m, faces);
	for (int ring = 0; ring < ringNum; ++ring)
		vertices = verticesOf(m, facesRound(m, vertices));
	return vertices;
}

/// Takes the marks off the edges at these vertices. Returns the ends of the edges that had one.
std::vector<int> takeMarksOff(const std::vector<int>& vertices, ResultMesh& result)
{
	HalfEdgeMesh&    m = result.mesh;
	std::vector<int> ends;
	for (int v : vertices) {
		if (result.vertex[v].isPinned) continue;
		forEachOutgoing(m, v, [&](int h) {
			const int w = m.target(h);
			if (!m.isCreaseEdge(h) || result.vertex[w].isPinned) return;
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
	std::int64_t releasedNum = 0;
	for (int v : takeMarksOff(verticesNear(m, poorAtLines(angleDeg, m, workers)), result)) {
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
