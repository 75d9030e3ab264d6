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
constexpr int mostOfVertex = 64;

bool mayMoveThere(const GuardedMesh& g, int v)
{
	bool mayMove = !g.isFixed(v);
	forEachNeighbour(g.mesh, v, [&](int w) { mayMove = mayMove || !g.isFixed(w); });
	return mayMove;
}

float squaredDistance(const Vec3f& p, const NamedTriangle& t)
{
	return squaredLength(p - nearestOnTriangle(p, t.at[0], t.at[1], t.at[2]));
}

} // namespace

DistanceGuard::DistanceGuard(const GuardedMesh& g, double enough, Workers& workers) :
		m_(g.mesh), squaredEnough_(float(enough * enough)), first_(std::size_t(g.mesh.faceNum), -1)
{
	std::vector<int> from; // per point
	for (int v = 0; v < m_.vertexNum; ++v) {
		if (m_.outgoing[v] < 0 || !mayMoveThere(g, v)) continue;
		const int step = 1 + g.points.numOf(v) / mostOfVertex;
		int       num  = 0;
		g.points.forEach(v, [&](const Vec3f& at) {
			if (num++ % step != 0) return;
			point_.push_back({at, -1, 0, -1});
			from.push_back(v);
		});
	}
	workers.forEach(point_.size(), [&](int i) {
		Point&             p       = point_[std::size_t(i)];
		const SurfacePoint nearest = nearestByDescent(m_, from[std::size_t(i)], p.at);
		p.face                     = nearest.face;
		p.squared                  = squaredLength(p.at - nearest.position);
	});
	for (std::size_t i = 0; i < point_.size(); ++i)
		putInList(int(i));
}

bool DistanceGuard::allows(const std::vector<NamedTriangle>& made,
						   const std::vector<int>&           gone) const
{
	float most = squaredEnough_;
	forEachPointOf(gone, [&](const Point& p) { most = std::max(most, p.squared); });
	bool areNear = true;
	forEachPointOf(gone, [&](const Point& p) {
		areNear = areNear && std::any_of(made.begin(), made.end(), [&](const NamedTriangle& t) {
					  return squaredDistance(p.at, t) <= most;
				  });
	});
	return areNear;
}

void DistanceGuard::follow(const std::vector<int>& changed)
{
	std::vector<int> points;
	for (int f : changed) {
		for (int i = first_[std::size_t(f)]; i >= 0; i = point_[std::size_t(i)].next)
			points.push_back(i);
		first_[std::size_t(f)] = -1;
	}
	for (int i : points) {
		Point& p  = point_[std::size_t(i)];
		p.squared = HUGE_VALF;
		for (int f : changed) {
			const float squared = squaredDistance(p.at, triangleOf(m_, f));
			if (squared >= p.squared) continue;
			p.squared = squared;
			p.face    = f;
		}
		putInList(i);
	}
}

void DistanceGuard::putInList(int i)
{
	Point& p                    = point_[std::size_t(i)];
	p.next                      = first_[std::size_t(p.face)];
	first_[std::size_t(p.face)] = i;
}

} // namespace gpr
