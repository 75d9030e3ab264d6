// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "distance_guard.h"

#include <vcg_extras/core/base/triangle.h>
#include <vcg_extras/core/surface/local_nearest.h>

#include <algorithm>
#include <cmath>

namespace gpr {

namespace {

/// Most points to check per vertex.
constexpr std::size_t mostOfVertex = 64;

bool mayMoveThere(const GuardedMesh& g, int v)
{
	return !g.isFixed(v) || anyNeighbour(g.mesh, v, [&](int w) { return !g.isFixed(w); });
}

float squaredDistance(const Vec3f& p, const NamedTriangle& t)
{
	return squaredLength(p - nearestOnTriangle(p, t.at[0], t.at[1], t.at[2]));
}

} // namespace

DistanceGuard::DistanceGuard(const GuardedMesh& g, double enough, Workers& workers) :
		m_(g.mesh), squaredEnough_(float(enough * enough)), pointsOf_(std::size_t(g.mesh.faceNum))
{
	std::vector<Vec3f> point;
	std::vector<int>   from; // per point: its vertex
	for (int v = 0; v < m_.vertexNum; ++v) {
		if (m_.outgoing[v] < 0 || !mayMoveThere(g, v)) continue;
		const std::vector<Vec3f>& own = g.vertex[v].points;
		for (std::size_t i = 0; i < own.size(); i += 1 + own.size() / mostOfVertex) {
			point.push_back(own[i]);
			from.push_back(v);
		}
	}
	std::vector<SurfacePoint> nearest(point.size());
	workers.forEach(point.size(),
					[&](int i) { nearest[i] = nearestByDescent(m_, from[i], point[i]); });
	for (std::size_t i = 0; i < point.size(); ++i) {
		const float squared = squaredLength(point[i] - nearest[i].position);
		pointsOf_[nearest[i].face].push_back({point[i], squared});
	}
}

bool DistanceGuard::allows(const std::vector<NamedTriangle>& made,
						   const std::vector<int>&           gone) const
{
	float most = squaredEnough_;
	for (int f : gone) {
		for (const Point& p : pointsOf_[f])
			most = std::max(most, p.squared);
	}
	const auto isNear = [&](const Point& p) {
		return std::any_of(made.begin(), made.end(), [&](const NamedTriangle& t) {
			return squaredDistance(p.at, t) <= most;
		});
	};
	return std::all_of(gone.begin(), gone.end(), [&](int f) {
		const std::vector<Point>& points = pointsOf_[f];
		return std::all_of(points.begin(), points.end(), isNear);
	});
}

void DistanceGuard::follow(const std::vector<int>& changed)
{
	std::vector<Point> points;
	for (int f : changed) {
		std::vector<Point>& own = pointsOf_[f];
		points.insert(points.end(), own.begin(), own.end());
		own.clear();
	}
	for (Point& p : points) {
		int nearest = changed.front();
		p.squared   = HUGE_VALF;
		for (int f : changed) {
			const float squared = squaredDistance(p.at, triangleOf(m_, f));
			if (squared >= p.squared) continue;
			p.squared = squared;
			nearest   = f;
		}
		pointsOf_[nearest].push_back(p);
	}
}

} // namespace gpr
