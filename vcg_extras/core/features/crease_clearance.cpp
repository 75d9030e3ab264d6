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

/// Whether h is part of an edge of an asked input face, and no crease.
bool isBeside(const Surface& surface, int h, const std::vector<bool>& isAsked)
{
	const std::size_t face = std::size_t(surface.sourceFace[h / 3]);
	if (face >= isAsked.size() || !isAsked[face] || surface.mesh.isCreaseEdge(h)) return false;
	const int g = surface.mesh.opposite[h];
	return g < 0 || surface.sourceFace[g / 3] != int(face);
}

/// Per input face beside the given edges: the largest angle at its edges, creases left out.
std::vector<float> steepestOfFaces(const Surface& surface, const std::vector<int>& edges,
								   Workers& workers)
{
	const HalfEdgeMesh& m = surface.mesh;
	std::vector<bool>   isAsked; // bits stay in the cache
	for (int h : edges) {
		for (int side : {h, m.opposite[h]}) {
			const std::size_t face = std::size_t(surface.sourceFace[side / 3]);
			if (face >= isAsked.size()) isAsked.resize(face + 1, false);
			isAsked[face] = true;
		}
	}
	std::vector<float> steepest(isAsked.size(), none);
	const auto         find = [&](int h, auto& out) {
        if (isBeside(surface, h, isAsked))
            out.push_back({surface.sourceFace[h / 3], dihedralAngle(m, h)});
	};
	for (const Beside& b : workers.collectEach<Beside>(m.halfEdgeNum(), find))
		steepest[b.face] = std::max(steepest[b.face], b.angle);
	return steepest;
}

/// The largest angle at the edges beside h, on the side of h.
float steepestBeside(const HalfEdgeMesh& m, int h)
{
	float steepest = none;
	for (int e : {nextInFace(h), prevInFace(h)}) {
		if (!m.isCreaseEdge(e)) steepest = std::max(steepest, dihedralAngle(m, e));
	}
	return steepest;
}

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

std::vector<char> clearEdges(const Surface& surface, bool isSplit, const std::vector<int>& edges,
							 Workers& workers)
{
	const HalfEdgeMesh& m = surface.mesh;
	std::vector<float>  ofFaces;
	if (isSplit) ofFaces = steepestOfFaces(surface, edges, workers);
	const auto beside = [&](int h) {
		return isSplit ? ofFaces[surface.sourceFace[h / 3]] : steepestBeside(m, h);
	};
	std::vector<char> isClear(edges.size());
	workers.forEach(edges.size(), [&](int i) {
		const float steepest = std::max(beside(edges[i]), beside(m.opposite[edges[i]]));
		isClear[i] = steepest != none && steepest * clearRatio <= dihedralAngle(m, edges[i]);
	});
	return isClear;
}

} // namespace gpr
