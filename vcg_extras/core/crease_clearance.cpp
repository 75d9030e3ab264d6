// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "crease_clearance.h"

#include <algorithm>
#include <cmath>

namespace gpr {

namespace {

/// A sharp edge is clear of noise if the edges beside it are so many times flatter.
constexpr float clearRatio = 3;
/// In place of an angle, of faces that have no edges but creases, and of those far from any.
constexpr float none = -1, notAsked = -2;

/// An edge beside a crease, of one of the caller's faces.
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
	return std::atan2(length(cross(a, b)), dot(a, b));
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
	for (int h : edges) {
		ask(h);
		ask(m_.opposite[h]);
	}
	const auto find = [&](std::size_t begin, std::size_t end, std::vector<Beside>& out) {
		for (int h = int(begin); h < int(end); ++h) {
			if (isBesideCrease(h))
				out.push_back({surface_.sourceFace[h / 3], dihedralAngle(m_, h)});
		}
	};
	for (const Beside& b : workers.collect<Beside>(m_.halfEdgeNum(), find))
		steepest_[b.face] = std::max(steepest_[b.face], b.angle);
}

void CreaseClearance::ask(int h)
{
	const std::size_t face = std::size_t(surface_.sourceFace[h / 3]);
	if (face >= steepest_.size()) steepest_.resize(face + 1, notAsked);
	steepest_[face] = none;
}

/// Whether h is part of an edge of one of the caller's faces that is asked for, and no crease.
bool CreaseClearance::isBesideCrease(int h) const
{
	const int face = surface_.sourceFace[h / 3];
	if (face >= int(steepest_.size()) || steepest_[face] == notAsked) return false;
	const int g = m_.opposite[h];
	return !m_.isCreaseEdge(h) && (g < 0 || surface_.sourceFace[g / 3] != face);
}

/// Of the edges beside h on its own side.
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
