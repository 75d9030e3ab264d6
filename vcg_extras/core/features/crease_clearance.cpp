// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "crease_clearance.h"

#include <vcg_extras/core/base/angle.h>

#include <algorithm>
#include <cmath>

namespace gpr {

namespace {

/// A crease edge is clear of noise if its angle is at least this many times the angles beside it.
constexpr float clearRatio = 3;
/// The angle beside a face that has only creases.
constexpr float none = -1;

/// An edge beside a crease, on an input face.
struct Beside {
	int   face;
	float angle;
};

} // namespace

float dihedralAngle(const HalfEdgeMesh& m, int h)
{
	const int g = m.opposite[h];
	if (g < 0) return 0;
	const Vec3f a = m.faceCross(h / 3), b = m.faceCross(g / 3);
	if (!(squaredLength(a) > 0 && squaredLength(b) > 0)) return 0;
	return angleBetween(a, b);
}

bool isSharpEdge(const HalfEdgeMesh& m, int h, float cosine)
{
	const Vec3f a = m.position[m.origin[h]], ab = m.position[m.target(h)] - a;
	const Vec3f own   = cross(ab, m.position[m.apex(h)] - a);
	const Vec3f other = cross(m.position[m.apex(m.opposite[h])] - a, ab);
	// In double: as floats, the fourth powers of short edges would vanish.
	const double scale = double(squaredLength(own)) * double(squaredLength(other));
	const double d     = double(dot(own, other));
	if (!(scale > 0)) return false;
	if (cosine > 0 && d > 0) return d * d <= double(cosine) * double(cosine) * scale;
	return d <= double(cosine) * std::sqrt(scale);
}

CreaseClearance::CreaseClearance(const Surface& surface, bool isSplit,
								 const std::vector<int>& edges, Workers& workers) :
		surface_(surface),
		m_(surface.mesh)
{
	if (isSplit) findSteepest(edges, workers);
}

bool CreaseClearance::isClear(int h) const
{
	const float beside = std::max(steepestBeside(h), steepestBeside(m_.opposite[h]));
	return beside != none && beside * clearRatio <= dihedralAngle(m_, h);
}

void CreaseClearance::findSteepest(const std::vector<int>& edges, Workers& workers)
{
	std::vector<bool> isAsked; // bits stay in the cache
	for (int h : edges) {
		for (int side : {h, m_.opposite[h]}) {
			const std::size_t face = std::size_t(surface_.sourceFace[side / 3]);
			if (face >= isAsked.size()) isAsked.resize(face + 1, false);
			isAsked[face] = true;
		}
	}
	steepest_.assign(isAsked.size(), none);
	const auto find = [&](int h, auto& out) {
		if (isBeside(h, isAsked)) out.push_back({surface_.sourceFace[h / 3], dihedralAngle(m_, h)});
	};
	for (const Beside& b : workers.collectEach<Beside>(m_.halfEdgeNum(), find))
		steepest_[b.face] = std::max(steepest_[b.face], b.angle);
}

/// Whether h is part of an edge of an asked input face, and no crease.
bool CreaseClearance::isBeside(int h, const std::vector<bool>& isAsked) const
{
	const std::size_t face = std::size_t(surface_.sourceFace[h / 3]);
	if (face >= isAsked.size() || !isAsked[face] || m_.isCreaseEdge(h)) return false;
	const int g = m_.opposite[h];
	return g < 0 || surface_.sourceFace[g / 3] != int(face);
}

/// The largest angle at the edges beside h, on the side of h.
float CreaseClearance::steepestBeside(int h) const
{
	if (!steepest_.empty()) return steepest_[surface_.sourceFace[h / 3]];
	float steepest = none;
	for (int e : {nextInFace(h), prevInFace(h)}) {
		if (!m_.isCreaseEdge(e)) steepest = std::max(steepest, dihedralAngle(m_, e));
	}
	return steepest;
}

} // namespace gpr
