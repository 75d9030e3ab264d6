// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "edge_middle.h"

#include "curve_slide.h"

#include <vcg_extras/core/surface/walk.h>

#include <vector>

namespace gpr {

namespace {

/// The largest distance of the point from the straight middle of the edge, over the length of the
/// edge.
constexpr float farthestOff = 0.25f;

/// Sets `middle` to the point nearest to the straight middle of an edge. False if none is near.
bool takeNearest(const HalfEdgeMesh& m, int a, int b, const std::vector<ResultVertex>& points,
				 ResultVertex& middle)
{
	const Vec3f straight = (m.position[a] + m.position[b]) * 0.5f;
	float       nearest  = farthestOff * length(m.position[b] - m.position[a]);
	bool        found    = false;
	for (const ResultVertex& point : points) {
		const float off = length(point.point.position - straight);
		if (off >= nearest) continue;
		nearest = off;
		middle  = point;
		found   = true;
	}
	return found;
}

/// Sets `middle` to a point of the surface halfway from a to b, by a walk that starts at `from`.
/// False if the walk stops early or ends much nearer to one end than half the edge.
bool walkHalfway(const Surface& surface, const HalfEdgeMesh& m, int a, int b,
				 const SurfacePoint& from, ResultVertex& middle)
{
	middle.point        = from;
	middle.normal       = surface.mesh.faceNormal(from.face);
	const Vec3f half    = (m.position[b] - m.position[a]) * 0.5f;
	const Vec3f flat    = tangential(half, middle.normal);
	const float reach   = length(half);
	const float flatLen = length(flat);
	if (!(flatLen > 0)) return false;
	if (!walkBy(surface, flat * (reach / flatLen), middle)) return false;
	return length(middle.point.position - m.position[a]) > 0.5f * reach &&
		   length(middle.point.position - m.position[b]) > 0.5f * reach;
}

/// Tries a walk from every face at a and keeps the walk that ends nearest to the straight middle.
bool findMiddleFromCrease(const Surface& surface, const ResultMesh& result, int a, int b,
						  ResultVertex& middle)
{
	const HalfEdgeMesh&       m = result.mesh;
	std::vector<ResultVertex> points;
	for (int face : facesAt(surface.mesh, result.vertex[a].point)) {
		ResultVertex trial;
		if (walkHalfway(surface, m, a, b, {m.position[a], face}, trial)) points.push_back(trial);
	}
	return takeNearest(m, a, b, points, middle);
}

} // namespace

bool findMiddle(const Surface& surface, const ResultMesh& result, int a, int b,
				ResultVertex& middle)
{
	const HalfEdgeMesh& m          = result.mesh;
	const bool          fromCrease = m.isCreaseVertex(a), toCrease = m.isCreaseVertex(b);
	if (fromCrease && toCrease) return findMiddleFromCrease(surface, result, a, b, middle);
	if (!fromCrease && walkHalfway(surface, m, a, b, result.vertex[a].point, middle)) return true;
	return !toCrease && walkHalfway(surface, m, b, a, result.vertex[b].point, middle);
}

bool findMiddleOnCurve(const Surface& surface, const BoundaryCurves& curves,
					   const ResultMesh& result, int a, int b, ResultVertex& middle)
{
	std::vector<ResultVertex> points;
	for (int v : {a, b}) {
		const SlideRoom room = slideRoom(result, curves, v);
		for (float by : {0.5f * room.forward, -0.5f * room.backward}) {
			if (by == 0) continue;
			ResultVertex trial = slid(surface, curves, result.vertex[v], by);
			trial.isCorner = trial.isShared = trial.isPinned = false;
			trial.sample                                     = -1;
			points.push_back(trial);
		}
	}
	return takeNearest(result.mesh, a, b, points, middle);
}

} // namespace gpr
