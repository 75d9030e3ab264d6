// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "self_intersections.h"

#include "face_boxes.h"
#include "face_pairs.h"
#include "flat_stars.h"
#include "mesh_edit.h"

#include <vcg_extras/core/base/box.h>
#include <vcg_extras/core/base/sort_unique.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>

namespace gpr {

namespace {

/// Six times the signed volume of a tetrahedron.
double volume(const Vec3f& a, const Vec3f& b, const Vec3f& c, const Vec3f& d)
{
	const Vec3d o(a);
	return dot(cross(Vec3d(b) - o, Vec3d(c) - o), Vec3d(d) - o);
}

/// Whether the segment p q passes through the inside of the triangle a b c.
bool passesThrough(const Vec3f& p, const Vec3f& q, const Vec3f* t)
{
	const double below = volume(t[0], t[1], t[2], p), above = volume(t[0], t[1], t[2], q);
	if (!(below * above < 0)) return false;
	const double u = volume(p, q, t[0], t[1]), v = volume(p, q, t[1], t[2]);
	const double w = volume(p, q, t[2], t[0]);
	return (u > 0 && v > 0 && w > 0) || (u < 0 && v < 0 && w < 0);
}

/// Whether all of t lies beyond an edge of s, seen along the normal of s: neighbours on a nearly
/// flat surface, that is most of all pairs, are told apart so. In float, with a margin for
/// rounding.
bool liesBeyondAnEdge(const Vec3f* t, const Vec3f* s)
{
	constexpr float margin = 1e-5f; // some hundred roundings of a float
	const Vec3f     normal = cross(s[1] - s[0], s[2] - s[0]);
	for (int k = 0; k < 3; ++k) {
		const Vec3f edge    = s[(k + 1) % 3] - s[k];
		const Vec3f outward = cross(edge, normal);
		const Vec3f a = t[0] - s[k], b = t[1] - s[k], c = t[2] - s[k];
		const float far =
			squaredLength(edge) + squaredLength(a) + squaredLength(b) + squaredLength(c);
		const float least = margin * std::sqrt(squaredLength(outward) * far);
		if (dot(a, outward) > least && dot(b, outward) > least && dot(c, outward) > least)
			return true;
	}
	return false;
}

/// The face's corners, from the k-th on.
void cornersOf(const HalfEdgeMesh& m, int f, int k, Vec3f* corner)
{
	for (int i = 0; i < 3; ++i)
		corner[i] = m.position[m.origin[3 * f + (k + i) % 3]];
}

bool crossBeyondVertex(const HalfEdgeMesh& m, int f, int k, int g, int l)
{
	Vec3f a[3], b[3];
	cornersOf(m, f, k, a);
	cornersOf(m, g, l, b);
	return passesThrough(a[1], a[2], b) || passesThrough(b[1], b[2], a);
}

/// Whether the plane of t has all of s on one side.
bool onOneSide(const Vec3f* s, const Vec3f* t)
{
	const double a = volume(t[0], t[1], t[2], s[0]), b = volume(t[0], t[1], t[2], s[1]);
	const double c = volume(t[0], t[1], t[2], s[2]);
	return (a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0);
}

bool crossApart(const HalfEdgeMesh& m, int f, int g)
{
	Vec3f a[3], b[3];
	cornersOf(m, f, 0, a);
	cornersOf(m, g, 0, b);
	if (liesBeyondAnEdge(a, b) || liesBeyondAnEdge(b, a)) return false;
	if (onOneSide(a, b) || onOneSide(b, a)) return false;
	for (int k = 0; k < 3; ++k) {
		if (passesThrough(a[k], a[(k + 1) % 3], b)) return true;
		if (passesThrough(b[k], b[(k + 1) % 3], a)) return true;
	}
	return false;
}

/// What two faces share: how many corners, and the last of them by its place in either.
struct SharedCorners {
	int num = 0, ofF = 0, ofG = 0;
};

SharedCorners sharedCorners(const HalfEdgeMesh& m, int f, int g)
{
	SharedCorners shared;
	for (int k = 0; k < 3; ++k) {
		for (int l = 0; l < 3; ++l) {
			if (m.origin[3 * f + k] == m.origin[3 * g + l]) shared = {shared.num + 1, k, l};
		}
	}
	return shared;
}

/// Of faces that share less than an edge.
bool facesCross(const HalfEdgeMesh& m, int f, int g, const SharedCorners& shared)
{
	return shared.num == 1 ? crossBeyondVertex(m, f, shared.ofF, g, shared.ofG)
						   : crossApart(m, f, g);
}

} // namespace

std::vector<int> findIntersectingFaces(const HalfEdgeMesh& m, Workers& workers)
{
	const FaceBoxes boxes(m, workers);
	FlatStars       stars(m);
	stars.findAll(workers);
	const auto compare = [&](int f, int g, std::vector<int>& out) {
		if (stars.areInOne(f, g)) return;
		const SharedCorners shared = sharedCorners(m, f, g);
		if (shared.num > 1) return;
		if (!facesCross(m, f, g, shared)) return;
		out.push_back(f);
		out.push_back(g);
	};
	const std::vector<char> all; // no face is left out
	std::vector<int>        found = FacePairs(boxes, all).collect<int>(workers, compare);
	sortUnique(found);
	return found;
}

int countIntersectingPairs(const HalfEdgeMesh& m, const std::vector<int>& faces,
						   const std::vector<int>& near, std::int64_t* work)
{
	std::vector<int> others;
	std::set_union(faces.begin(), faces.end(), near.begin(), near.end(),
				   std::back_inserter(others));
	std::vector<Box<float>> boxes(faces.size());
	Box<float>              all;
	for (std::size_t i = 0; i < faces.size(); ++i) {
		if (!isDeadFace(m, faces[i])) boxes[i] = boxOfFace(m, faces[i]);
		all += boxes[i];
	}
	int num = 0;
	for (int g : others) {
		if (isDeadFace(m, g)) continue;
		const Box<float> box = boxOfFace(m, g);
		if (!box.meets(all)) continue;
		const bool isOneOfThem = std::binary_search(faces.begin(), faces.end(), g);
		for (std::size_t i = 0; i < faces.size(); ++i) {
			// The empty box of a dead face meets none.
			if (!boxes[i].meets(box) || (isOneOfThem && faces[i] >= g)) continue;
			const SharedCorners shared = sharedCorners(m, faces[i], g);
			num += shared.num < 2 && facesCross(m, faces[i], g, shared);
			if (work != nullptr) ++*work;
		}
	}
	return num;
}

} // namespace gpr
