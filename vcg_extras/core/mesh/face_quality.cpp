// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "face_quality.h"

#include "mesh_edit.h"

#include <vcg_extras/core/base/portable_math.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace gpr {

namespace {

/// Upper bound of shortest over longest edge of a triangle with the smallest angle α. The ratio is
/// sin α / sin γ with the largest angle γ between 90° - α/2 and 180° - 2α: at most the larger value
/// of both ends. A little more, for rounding.
float largestEdgeRatio(float angle)
{
	return 1.001f * std::max(0.5f / float(portable::cos(double(angle))),
							 2 * float(portable::sin(0.5 * double(angle))));
}

} // namespace

float smallestAngle(const HalfEdgeMesh& m, int face)
{
	const Corners f = m.corners(face);
	return smallestAngle(f.a, f.b, f.c);
}

float obtuseAngle(const HalfEdgeMesh& m, int face)
{
	const auto [a, b, c] = m.corners(face);
	const float ab = squaredLength(b - a), bc = squaredLength(c - b), ca = squaredLength(a - c);
	const float longest = std::max({ab, bc, ca});
	return ab + bc + ca < 2 * longest ? largestAngle(a, b, c) : 0;
}

float smallestAngleAround(const HalfEdgeMesh& m, int v, const Vec3f& p)
{
	const Vec3f here  = m.position[v];
	float       worst = 4;
	forEachOutgoing(m, v, [&](int h) {
		const Vec3f a = m.position[m.target(h)], b = m.position[m.apex(h)];
		const Vec3f now = cross(a - here, b - here), then = cross(a - p, b - p);
		worst = std::min(worst, dot(now, then) <= 0 ? -1.0f : smallestAngle(p, a, b));
	});
	return worst;
}

PoorFaceTest::PoorFaceTest(const HalfEdgeMesh& mesh, float limit) : m_(mesh), limit_(limit)
{
	const float ratio = largestEdgeRatio(limit);
	squaredRatio_     = ratio * ratio;
}

bool PoorFaceTest::operator()(int face) const
{
	return !isDeadFace(m_, face) && angleOrLimit(face) < limit_;
}

float PoorFaceTest::angleOrLimit(int face) const
{
	const auto [a, b, c] = m_.corners(face);
	const float ab = squaredLength(b - a), bc = squaredLength(c - b), ca = squaredLength(a - c);
	const float shortest = std::min({ab, bc, ca}), longest = std::max({ab, bc, ca});
	if (shortest > squaredRatio_ * longest) return limit_;
	return std::min(limit_, smallestAngle(a, b, c));
}

std::vector<int> findPoorFaces(const HalfEdgeMesh& m, float angle, Workers& workers)
{
	const PoorFaceTest isPoor(m, angle);
	return workers.collectIf(m.faceNum, [&](int f) { return isPoor(f); });
}

std::vector<int> poorOnes(const HalfEdgeMesh& m, float angle, const std::vector<int>& faces)
{
	const PoorFaceTest isPoor(m, angle);
	std::vector<int>   poor;
	std::copy_if(faces.begin(), faces.end(), std::back_inserter(poor), isPoor);
	return poor;
}

std::vector<int> findObtuseFaces(const HalfEdgeMesh& m, float angle, Workers& workers)
{
	return workers.collectIf(std::size_t(m.faceNum),
							 [&](int f) { return !isDeadFace(m, f) && obtuseAngle(m, f) > angle; });
}

bool flipKeepsShape(const HalfEdgeMesh& m, int h)
{
	const int   g = m.opposite[h];
	const Vec3f a = m.position[m.origin[h]], b = m.position[m.target(h)];
	const Vec3f c = m.position[m.apex(h)], d = m.position[m.apex(g)];
	const Vec3f normal = cross(b - a, c - a) + cross(a - b, d - b);
	const Vec3f n1 = cross(d - a, c - a), n2 = cross(c - b, d - b);
	if (dot(n1, normal) <= 0 || dot(n2, normal) <= 0) return false;
	if (dot(n1, n2) < minFlipCosine * length(n1) * length(n2)) return false;
	return std::min(smallestAngle(a, d, c), smallestAngle(b, c, d)) >= minFlipAngle;
}

bool hasNoArea(const HalfEdgeMesh& m, int f)
{
	const Corners face = m.corners(f);
	return isLine(face.a, face.b, face.c, face.cross());
}

double surfaceArea(const HalfEdgeMesh& m, Workers& workers)
{
	return workers.sumEach<double>(
		m.faceNum, [&](int f, double& area) { area += 0.5 * double(length(m.faceCross(f))); });
}

float meanEdgeByArea(const HalfEdgeMesh& m, Workers& workers)
{
	const double area = surfaceArea(m, workers);
	return float(std::sqrt(area / std::max(1, m.faceNum) * (4 / std::sqrt(3.0))));
}

} // namespace gpr
