// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curve_slide.h"

#include <vcg_extras/core/mesh/mesh_edit.h>

#include <algorithm>
#include <initializer_list>
#include <utility>

namespace gpr {

namespace {

/// Arc length of the curve from a vertex to a neighbour; 0 if the neighbour is on another curve.
float arcBetween(const Curve& c, const ResultVertex& from, const ResultVertex& to)
{
	return from.curve == to.curve ? c.wrap(to.arc - from.arc) : 0.0f;
}

SlideRoom roomAtBorder(const ResultMesh& r, const Curve& c, int v)
{
	const int last = borderNeighbour(r.mesh, v, false), next = borderNeighbour(r.mesh, v, true);
	return {arcBetween(c, r.vertex[last], r.vertex[v]), arcBetween(c, r.vertex[v], r.vertex[next]),
			last, next};
}

/// Arc of neighbour w of v on the open curve of v: the own arc of w, or the end of the curve at w.
/// If both ends are the same node, the nearer end counts.
float arcOfNeighbour(const Curve& c, const ResultVertex& v, const ResultVertex& w)
{
	if (!w.isCorner && w.curve == v.curve) return w.arc;
	if (w.isCorner && w.curve == v.curve && w.arc > 0 && w.arc < c.length) return w.arc;
	const bool atFront = w.point.position == c.point.front();
	const bool atBack  = w.point.position == c.point.back();
	if (atFront && atBack) return v.arc < 0.5f * c.length ? 0.0f : c.length;
	if (atFront) return 0;
	return atBack ? c.length : v.arc;
}

SlideRoom roomOnCrease(const ResultMesh& r, const Curve& c, int v)
{
	int last = -1, next = -1;
	forEachOutgoing(r.mesh, v, [&](int h) {
		if (!r.mesh.isCreaseEdge(h)) return;
		last = next;
		next = r.mesh.target(h);
	});
	if (r.mesh.creaseNum(v) != 2) return {};
	const ResultVertex& here = r.vertex[v];
	if (c.isClosed) {
		const auto arcTo = [&](int w) { return arcBetween(c, here, r.vertex[w]); };
		if (arcTo(last) <= arcTo(next)) std::swap(last, next);
		return {arcBetween(c, r.vertex[last], here), arcTo(next), last, next};
	}
	const auto arcOf = [&](int w) { return arcOfNeighbour(c, here, r.vertex[w]); };
	if (arcOf(next) < arcOf(last)) std::swap(last, next);
	return {std::max(0.0f, here.arc - arcOf(last)), std::max(0.0f, arcOf(next) - here.arc), last,
			next};
}

/// Arcs between neighbours on a curve, in wanted edges.
constexpr float minSpacing = 0.7f, maxSpacing = 1.3f;

/// Largest distance of the curve of v from a polygon: from the last neighbour through vertices at
/// the given arcs to the next neighbour.
float deviationBy(const BoundaryCurves& curves, const ResultVertex& v, const SlideRoom& room,
				  std::initializer_list<float> arcs)
{
	const Curve& c    = curves.curves[v.curve];
	float        from = v.arc - room.backward, worst = 0;
	// On a closed curve the stretch may begin before the first point.
	const float lap = from < 0 ? c.length : 0.0f;
	for (float to : arcs) {
		worst = std::max(worst, deviation(c, from + lap, to + lap));
		from  = to;
	}
	return std::max(worst, deviation(c, from + lap, v.arc + room.forward + lap));
}

/// The largest allowed distance of the curve from new chords: the curveTolerance of spacing, or the
/// distance from the chords of now.
float allowedDeviation(const ResultMesh& result, const BoundaryCurves& curves,
					   const ResultVertex& v, const SlideRoom& room)
{
	const float size = curves.curves[v.curve].sizeAt(v.arc);
	return std::max(deviationBy(curves, v, room, {v.arc}),
					curveTolerance * result.idealEdge * size);
}

/// Normal of the working surface beside the curve at arc s, on the left of the direction of growing
/// arcs, or on the right.
Vec3f normalBeside(const HalfEdgeMesh& input, const Curve& c, float s, bool left)
{
	const int along = c.halfEdge[c.segmentAt(s)];
	const int h     = left ? along : input.opposite[along];
	return h >= 0 ? input.faceNormal(h / 3) : Vec3f();
}

/// Normal of the working surface on the side of h, looked up at v, an end of h; zero if v never
/// moves along its line.
Vec3f normalBesideEdge(const Surface& surface, const BoundaryCurves& curves, const ResultMesh& r,
					   int h, int v)
{
	const ResultVertex& here = r.vertex[v];
	if (here.curve < 0 || r.mesh.isBorderVertex(v)) return {};
	const SlideRoom room = slideRoom(r, curves, v);
	if (!room.isOpen()) return {};
	const Curve& c         = curves.curves[here.curve];
	const int    w         = r.mesh.origin[h] == v ? r.mesh.target(h) : r.mesh.origin[h];
	const Vec3f  place     = r.vertex[w].point.position;
	const float  toForward = squaredLength(c.at(here.arc + room.forward) - place);
	const float  toBack    = squaredLength(c.at(here.arc - room.backward) - place);
	const bool   forward   = toForward <= toBack;
	const float  middle    = here.arc + 0.5f * (forward ? room.forward : -room.backward);
	return normalBeside(surface.mesh, c, middle, forward == (r.mesh.origin[h] == v));
}

} // namespace

SlideRoom slideRoom(const ResultMesh& result, const BoundaryCurves& curves, int v)
{
	const ResultVertex& here = result.vertex[v];
	if (here.curve < 0 || here.isPinned || here.isShared) return {};
	const Curve& c = curves.curves[here.curve];
	if (result.mesh.isBorderVertex(v))
		return result.mesh.isCreaseVertex(v) ? SlideRoom() : roomAtBorder(result, c, v);
	return here.isCorner ? SlideRoom() : roomOnCrease(result, c, v);
}

Vec3f slideDirection(const BoundaryCurves& curves, const ResultVertex& vertex,
					 const SlideRoom& room)
{
	const Curve& c = curves.curves[vertex.curve];
	return normalized(c.at(vertex.arc + 0.25f * room.forward) -
					  c.at(vertex.arc - 0.25f * room.backward));
}

bool slideKeepsToCurve(const ResultMesh& result, const BoundaryCurves& curves, int v,
					   const SlideRoom& room, float step)
{
	const ResultVertex& here = result.vertex[v];
	return deviationBy(curves, here, room, {here.arc + step}) <=
		   allowedDeviation(result, curves, here, room);
}

bool mayLeaveCurve(const ResultMesh& result, const BoundaryCurves& curves, int v)
{
	const SlideRoom room = slideRoom(result, curves, v);
	if (!room.isOpen()) return false;
	const ResultVertex& here = result.vertex[v];
	return deviationBy(curves, here, room, {}) <= allowedDeviation(result, curves, here, room);
}

bool slideKeepsSpacing(const ResultMesh& result, const BoundaryCurves& curves, int v,
					   const SlideRoom& room, float step)
{
	const ResultVertex& here  = result.vertex[v];
	const float         edge  = result.idealEdge * curves.curves[here.curve].sizeAt(here.arc);
	const float         least = std::min({minSpacing * edge, room.backward, room.forward});
	const float         most  = std::max({maxSpacing * edge, room.backward, room.forward});
	const float         back = room.backward + step, ahead = room.forward - step;
	return std::min(back, ahead) >= least && std::max(back, ahead) <= most;
}

ResultVertex slid(const Surface& surface, const BoundaryCurves& curves, const ResultVertex& vertex,
				  float step)
{
	const Curve& c     = curves.curves[vertex.curve];
	ResultVertex moved = vertex;
	moved.arc          = c.wrap(vertex.arc + step);
	moved.point        = {c.at(moved.arc), c.faceAt(moved.arc)};
	moved.normal       = surface.mesh.faceNormal(moved.point.face);
	return moved;
}

float creaseAgreement(const Surface& surface, const BoundaryCurves& curves,
					  const ResultMesh& result, int h)
{
	const HalfEdgeMesh& m = result.mesh;
	if (!m.isCreaseEdge(h)) return 1;
	for (int v : {m.origin[h], m.target(h)}) {
		const Vec3f wanted = normalBesideEdge(surface, curves, result, h, v);
		if (squaredLength(wanted) > 0) return dot(wanted, m.faceNormal(h / 3));
	}
	return 1;
}

} // namespace gpr
