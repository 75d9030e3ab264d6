// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curve_slide.h"

#include "mesh_edit.h"

#include <algorithm>

namespace gpr {

namespace {

/// Arc length of the curve from a vertex to a neighbour, or 0 if that is not on the curve.
float arcBetween(const Curve& c, const ResultVertex& from, const ResultVertex& to)
{
	return from.curve == to.curve ? c.wrap(to.arc - from.arc) : 0.0f;
}

SlideRoom roomAtBorder(const ResultMesh& r, const Curve& c, int v)
{
	const ResultVertex& here = r.vertex[v];
	const ResultVertex& last = r.vertex[borderNeighbour(r.mesh, v, false)];
	const ResultVertex& next = r.vertex[borderNeighbour(r.mesh, v, true)];
	return {arcBetween(c, last, here), arcBetween(c, here, next)};
}

/// Arc at which neighbour w of v lies on v's open curve: its own, or the end it stands at. Where
/// both ends are the same node, the nearer one is meant.
float arcOfNeighbour(const Curve& c, const ResultVertex& v, const ResultVertex& w)
{
	if (!w.isCorner && w.curve == v.curve) return w.arc;
	if (w.isCorner && w.curve == v.curve && w.arc > 0 && w.arc < c.length) return w.arc;
	const bool atFront = w.anchor.position == c.point.front();
	const bool atBack  = w.anchor.position == c.point.back();
	if (atFront && atBack) return v.arc < 0.5f * c.length ? 0.0f : c.length;
	if (atFront) return 0;
	return atBack ? c.length : v.arc;
}

SlideRoom roomOnCrease(const ResultMesh& r, const Curve& c, int v)
{
	int neighbour[2] = {-1, -1}, n = 0;
	forEachOutgoing(r.mesh, v, [&](int h) {
		if (r.mesh.isCreaseEdge(h) && n < 2) neighbour[n++] = r.mesh.target(h);
	});
	if (n < 2 || r.mesh.creaseNum(v) != 2) return {};
	const ResultVertex &here = r.vertex[v], &a = r.vertex[neighbour[0]],
					   &b = r.vertex[neighbour[1]];
	if (c.isClosed) {
		const float toA = arcBetween(c, here, a), toB = arcBetween(c, here, b);
		return toA <= toB ? SlideRoom{arcBetween(c, b, here), toA}
						  : SlideRoom{arcBetween(c, a, here), toB};
	}
	const float arcA = arcOfNeighbour(c, here, a), arcB = arcOfNeighbour(c, here, b);
	return {std::max(0.0f, here.arc - std::min(arcA, arcB)),
			std::max(0.0f, std::max(arcA, arcB) - here.arc)};
}

} // namespace

SlideRoom slideRoom(const ResultMesh& result, const BoundaryCurves& curves, int v)
{
	const ResultVertex& here = result.vertex[v];
	if (here.curve < 0) return {};
	const Curve& c = curves.curves[here.curve];
	if (result.mesh.isBorderVertex(v))
		return result.mesh.isCreaseVertex(v) ? SlideRoom() : roomAtBorder(result, c, v);
	return here.isCorner ? SlideRoom() : roomOnCrease(result, c, v);
}

ResultVertex slid(const Surface& surface, const BoundaryCurves& curves, const ResultVertex& vertex,
				  float step)
{
	const Curve& c     = curves.curves[vertex.curve];
	ResultVertex moved = vertex;
	moved.arc          = c.wrap(vertex.arc + step);
	moved.anchor       = {c.at(moved.arc), c.face[c.segmentAt(moved.arc)]};
	moved.normal       = surface.mesh.faceNormal(moved.anchor.face);
	return moved;
}

} // namespace gpr
