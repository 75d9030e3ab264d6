// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "face_contact.h"

#include "face_boxes.h"
#include "face_pairs.h"
#include "flat_stars.h"
#include "mesh_edit.h"

#include <vcg_extras/core/base/box.h>
#include <vcg_extras/core/base/orientation.h>
#include <vcg_extras/core/base/sort_unique.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace gpr {

namespace {

using Corners3 = std::array<Vec3f, 3>;
using Corners2 = std::array<Vec2f, 3>;

/// The corners of a triangle, beginning at the k-th.
Corners3 cornersFrom(const NamedTriangle& t, int k)
{
	return {t.at[k], t.at[(k + 1) % 3], t.at[(k + 2) % 3]};
}

Corners2 dropAxis(const Corners3& t, int axis)
{
	return {dropAxis(t[0], axis), dropAxis(t[1], axis), dropAxis(t[2], axis)};
}

// ---- in a plane

bool isWithin(const Vec2f& p, const Corners2& t)
{
	const int a = orientation(t[0], t[1], p), b = orientation(t[1], t[2], p);
	const int c = orientation(t[2], t[0], p);
	return (a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0);
}

bool doIntervalsMeet(float a, float b, float c, float d)
{
	return std::max(a, b) >= std::min(c, d) && std::max(c, d) >= std::min(a, b);
}

bool doSegmentsMeet(const Vec2f& a, const Vec2f& b, const Vec2f& c, const Vec2f& d)
{
	return doIntervalsMeet(a.x, b.x, c.x, d.x) && doIntervalsMeet(a.y, b.y, c.y, d.y) &&
		   orientation(a, b, c) * orientation(a, b, d) <= 0 &&
		   orientation(c, d, a) * orientation(c, d, b) <= 0;
}

bool doesSegmentMeet(const Vec2f& p, const Vec2f& q, const Corners2& t)
{
	if (isWithin(p, t) || isWithin(q, t)) return true;
	for (int k = 0; k < 3; ++k) {
		if (doSegmentsMeet(p, q, t[k], t[(k + 1) % 3])) return true;
	}
	return false;
}

/// An axis along which the triangle has a projection with area, or -1 for a degenerate triangle.
int axisOf(const Corners3& t)
{
	for (int axis = 0; axis < 3; ++axis) {
		if (orientation(dropAxis(t[0], axis), dropAxis(t[1], axis), dropAxis(t[2], axis)) != 0)
			return axis;
	}
	return -1;
}

/// For p and q in the plane of t. A degenerate t counts as meeting, so that no contact is missed:
/// its edges are tested against the other triangle only.
bool doesSegmentMeetInPlane(const Vec3f& p, const Vec3f& q, const Corners3& t)
{
	const int axis = axisOf(t);
	return axis < 0 || doesSegmentMeet(dropAxis(p, axis), dropAxis(q, axis), dropAxis(t, axis));
}

// ---- in space

int sideOf(const Corners3& t, const Vec3f& p)
{
	return orientation(t[0], t[1], t[2], p);
}

/// Whether a closed segment meets a closed triangle; sideP and sideQ are the sides of its ends.
bool doesSegmentMeet(const Vec3f& p, const Vec3f& q, int sideP, int sideQ, const Corners3& t)
{
	if (sideP * sideQ > 0) return false;
	if (sideP == 0 && sideQ == 0) return doesSegmentMeetInPlane(p, q, t);
	const int a = orientation(p, q, t[0], t[1]), b = orientation(p, q, t[1], t[2]);
	if (a * b < 0) return false;
	const int c = orientation(p, q, t[2], t[0]);
	return (a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0);
}

bool anyEdgeMeets(const Corners3& s, const std::array<int, 3>& sideOfCorner, const Corners3& t)
{
	for (int k = 0; k < 3; ++k) {
		const int l = (k + 1) % 3;
		if (doesSegmentMeet(s[k], s[l], sideOfCorner[k], sideOfCorner[l], t)) return true;
	}
	return false;
}

bool areOnOneSide(const std::array<int, 3>& side)
{
	return side[0] != 0 && side[0] == side[1] && side[1] == side[2];
}

std::array<int, 3> sidesOf(const Corners3& t, const Corners3& s)
{
	return {sideOf(t, s[0]), sideOf(t, s[1]), sideOf(t, s[2])};
}

/// Whether a way from a point of an edge leads to its outer side, beyond all rounding. Sums of
/// coordinates bound the lengths without roots.
bool isBeyond(const Vec3d& way, const Vec3d& outward)
{
	constexpr double margin = 1e-12; // many roundings of a double
	const auto size = [](const Vec3d& a) { return std::abs(a.x) + std::abs(a.y) + std::abs(a.z); };
	return dot(way, outward) > margin * size(way) * size(outward);
}

/// Whether all of t lies beyond an edge of s, seen along the normal of s. This test separates most
/// pairs of a nearly flat surface.
bool liesBeyondAnEdge(const Corners3& t, const Corners3& s)
{
	const Vec3d o(s[0]), normal = cross(Vec3d(s[1]) - o, Vec3d(s[2]) - o);
	for (int k = 0; k < 3; ++k) {
		const Vec3d from(s[k]), outward = cross(Vec3d(s[(k + 1) % 3]) - from, normal);
		const auto  isCornerBeyond = [&](const Vec3f& p) {
            return isBeyond(Vec3d(p) - from, outward);
		};
		if (std::all_of(t.begin(), t.end(), isCornerBeyond)) return true;
	}
	return false;
}

bool doApartOnesTouch(const Corners3& s, const Corners3& t)
{
	if (liesBeyondAnEdge(s, t) || liesBeyondAnEdge(t, s)) return false;
	const std::array<int, 3> sideOfS = sidesOf(t, s);
	if (areOnOneSide(sideOfS)) return false;
	const std::array<int, 3> sideOfT = sidesOf(s, t);
	if (areOnOneSide(sideOfT)) return false;
	return anyEdgeMeets(s, sideOfS, t) || anyEdgeMeets(t, sideOfT, s);
}

/// Whether a plane through the shared corner 0 and an edge of s, perpendicular to s, has s on one
/// side and the rest of t strictly on the other.
bool isSplitAtCorner(const Corners3& s, const Corners3& t)
{
	const Vec3d o(s[0]), a = Vec3d(s[1]) - o, b = Vec3d(s[2]) - o, normal = cross(a, b);
	const Vec3d p = Vec3d(t[1]) - o, q = Vec3d(t[2]) - o;
	const auto  areBeyond = [&](const Vec3d& outward) {
        return isBeyond(p, outward) && isBeyond(q, outward);
	};
	return areBeyond(cross(a, normal)) || areBeyond(cross(normal, b));
}

/// Whether triangles with the same corner 0 touch elsewhere: only if an edge opposite corner 0
/// meets the other triangle.
bool doCornerNeighboursTouch(const Corners3& s, const Corners3& t)
{
	if (isSplitAtCorner(s, t) || isSplitAtCorner(t, s)) return false;
	const int p = sideOf(t, s[1]), q = sideOf(t, s[2]);
	if (p * q <= 0 && doesSegmentMeet(s[1], s[2], p, q, t)) return true;
	const int u = sideOf(s, t[1]), v = sideOf(s, t[2]);
	return u * v <= 0 && doesSegmentMeet(t[1], t[2], u, v, s);
}

/// Whether triangles with the same edge 0 1 touch elsewhere: only if folded onto each other.
bool doEdgeNeighboursTouch(const Corners3& s, const Vec3f& apex)
{
	const Vec3d o(s[0]), edge = Vec3d(s[1]) - o;
	const Vec3d ofS = cross(edge, Vec3d(s[2]) - o), ofT = cross(edge, Vec3d(apex) - o);
	if (dot(ofS, ofT) < 0) return false;
	if (sideOf(s, apex) != 0) return false;
	const int axis = axisOf(s);
	if (axis < 0) return true;
	const Corners2 flat = dropAxis(s, axis);
	return orientation(flat[0], flat[1], flat[2]) *
			   orientation(flat[0], flat[1], dropAxis(apex, axis)) >=
		   0;
}

/// The shared corners of two triangles: their number, the last shared corner in each triangle, and
/// the sums of corner numbers, which give the corner that is not shared.
struct Shared {
	int num = 0, inS = 0, inT = 0;
	int sumS = 0, sumT = 0;
};

Shared sharedBy(const NamedTriangle& s, const NamedTriangle& t, bool meetsAtPlaces)
{
	const auto isOne = [&](int k, int l) {
		return s.vertex[k] == t.vertex[l] || (meetsAtPlaces && s.at[k] == t.at[l]);
	};
	// Border vertices at the same place have the same name, so that a triangle may have a name
	// twice: each corner counts once.
	Shared shared;
	bool   isTaken[3] = {false, false, false};
	for (int k = 0; k < 3; ++k) {
		for (int l = 0; l < 3; ++l) {
			if (isTaken[l] || !isOne(k, l)) continue;
			isTaken[l] = true;
			++shared.num;
			shared.inS = k;
			shared.inT = l;
			shared.sumS += k;
			shared.sumT += l;
			break;
		}
	}
	return shared;
}

/// The name of a corner: the smallest border vertex of `other` at the same place, or the own
/// vertex.
int nameOf(const HalfEdgeMesh& m, int f, int k, const NamedTriangle& other)
{
	const int v = m.origin[3 * f + k];
	if (!m.isBorderVertex(v)) return v;
	for (int l = 0; l < 3; ++l) {
		const int w = other.vertex[l];
		if (w < v && m.position[w] == m.position[v] && m.isBorderVertex(w)) return w;
	}
	return v;
}

bool doFacesTouch(const HalfEdgeMesh& m, int f, int g, Seams seams)
{
	NamedTriangle s = triangleOf(m, f), t = triangleOf(m, g);
	if (m.meetsAtPlaces) return touch(s, t, true);
	const int ownNum = seams == Seams::Apart ? sharedBy(s, t, false).num : 0;
	for (int k = 0; k < 3; ++k)
		s.vertex[k] = nameOf(m, f, k, t);
	for (int k = 0; k < 3; ++k)
		t.vertex[k] = nameOf(m, g, k, s);
	if (seams == Seams::Apart && sharedBy(s, t, false).num > std::max(1, ownNum))
		return true; // on both sides of a seam
	return touch(s, t);
}

/// The wanted faces, or all if `wanted` is empty, that reach the mirror image.
std::vector<int> facesAtMirror(const HalfEdgeMesh& m, const std::vector<char>& wanted,
							   Workers& workers)
{
	if (m.mirrorAxis < 0) return {};
	return workers.collectIf(std::size_t(m.faceNum), [&](int f) {
		return (wanted.empty() || wanted[f] != 0) && reachesMirrorImage(m, f);
	});
}

std::vector<FacePair> findPairs(const HalfEdgeMesh& m, Workers& workers, Seams seams,
								const std::vector<char>& wanted, FacePairs::Extent extent)
{
	const FaceBoxes boxes(m, wanted, workers);
	const FlatStars stars(m, workers);
	const auto      doTouch = [&](int f, int g) {
        return !stars.areInOne(f, g) && doFacesTouch(m, f, g, seams);
	};
	std::vector<FacePair> found = FacePairs(boxes, wanted).collect(workers, extent, doTouch);
	for (int f : facesAtMirror(m, wanted, workers))
		found.emplace_back(f, f);
	return found;
}

} // namespace

bool reachesMirrorImage(const HalfEdgeMesh& m, const NamedTriangle& t)
{
	if (m.mirrorAxis < 0) return false;
	for (int k = 0; k < 3; ++k) {
		const float height = coordinate(t.at[k], m.mirrorAxis);
		if (height < 0 || (height == 0 && !m.isBorderVertex(t.vertex[k]))) return true;
	}
	return false;
}

bool reachesMirrorImage(const HalfEdgeMesh& m, int face)
{
	return !isDeadFace(m, face) && reachesMirrorImage(m, triangleOf(m, face));
}

NamedTriangle triangleOf(const HalfEdgeMesh& m, int f)
{
	NamedTriangle t;
	for (int k = 0; k < 3; ++k) {
		t.vertex[k] = m.origin[3 * f + k];
		t.at[k]     = m.position[t.vertex[k]];
	}
	return t;
}

bool touch(const NamedTriangle& s, const NamedTriangle& t, bool meetsAtPlaces)
{
	const Shared shared = sharedBy(s, t, meetsAtPlaces);
	if (shared.num == 0) return doApartOnesTouch(cornersFrom(s, 0), cornersFrom(t, 0));
	if (shared.num == 1)
		return doCornerNeighboursTouch(cornersFrom(s, shared.inS), cornersFrom(t, shared.inT));
	if (shared.num > 2) return true;
	// The numbers of all corners have the sum 3, which gives the apex.
	const int apexOfS = 3 - shared.sumS, apexOfT = 3 - shared.sumT;
	return doEdgeNeighboursTouch(cornersFrom(s, (apexOfS + 1) % 3), t.at[apexOfT]);
}

std::vector<FacePair> findTouchingPairs(const HalfEdgeMesh& m, Workers& workers, Seams seams,
										const std::vector<char>& wanted)
{
	std::vector<FacePair> found = findPairs(m, workers, seams, wanted, FacePairs::Extent::All);
	std::sort(found.begin(), found.end());
	return found;
}

std::vector<int> findTouchingFaces(const HalfEdgeMesh& m, Workers& workers, Seams seams)
{
	return facesOf(findPairs(m, workers, seams, {}, FacePairs::Extent::AllFaces));
}

std::vector<int> facesOf(const std::vector<FacePair>& pairs)
{
	int              last = -1;
	std::vector<int> faces;
	for (const FacePair& pair : pairs) {
		faces.insert(faces.end(), {pair.first, pair.second});
		last = std::max(last, pair.second);
	}
	sortUniqueBelow(last + 1, faces);
	return faces;
}

int countTouchingPairs(const HalfEdgeMesh& m, const std::vector<int>& faces,
					   const std::vector<int>& near, std::int64_t* work)
{
	std::vector<Box<float>> boxes(faces.size());
	Box<float>              all;
	for (std::size_t i = 0; i < faces.size(); ++i) {
		if (!isDeadFace(m, faces[i])) boxes[i] = boxOfFace(m, faces[i]);
		all += boxes[i];
	}
	int num = int(
		std::count_if(faces.begin(), faces.end(), [&](int f) { return reachesMirrorImage(m, f); }));
	const auto countUntil = [&](std::size_t end, int g, const Box<float>& box) {
		for (std::size_t i = 0; i < end; ++i) {
			if (!boxes[i].meets(box)) continue; // the empty box of a dead face meets no box
			num += doFacesTouch(m, faces[i], g, Seams::Joined);
			if (work != nullptr) ++*work;
		}
	};
	for (std::size_t i = 0; i < faces.size(); ++i)
		countUntil(i, faces[i], boxes[i]); // each pair of these faces once
	for (int g : near) {
		if (isDeadFace(m, g)) continue;
		const Box<float> box = boxOfFace(m, g);
		const bool isOther   = box.meets(all) && !std::binary_search(faces.begin(), faces.end(), g);
		if (isOther) countUntil(faces.size(), g, box);
	}
	return num;
}

} // namespace gpr
