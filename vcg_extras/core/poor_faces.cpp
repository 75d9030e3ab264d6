// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "poor_faces.h"

#include "mesh_edit.h"
#include "result_mesh.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace gpr {

namespace {

/// Shortest over longest edge of a triangle with the smallest angle α are sin α / sin γ, γ being
/// the largest angle, between 90° - α/2 and 180° - 2α: at most the larger of these. A little more,
/// for rounding.
float largestEdgeRatio(float angle)
{
	return 1.001f * std::max(0.5f / std::cos(angle), 2 * std::sin(0.5f * angle));
}

class PoorFaceTest {
public:
	PoorFaceTest(const HalfEdgeMesh& mesh, float angle) : m_(mesh), angle_(angle)
	{
		const float ratio = largestEdgeRatio(angle);
		squaredRatio_     = ratio * ratio;
	}

	bool operator()(int f) const
	{
		if (isDeadFace(m_, f)) return false;
		const Vec3f a = m_.position[m_.origin[3 * f]], b = m_.position[m_.origin[3 * f + 1]];
		const Vec3f c  = m_.position[m_.origin[3 * f + 2]];
		const float ab = squaredLength(b - a), bc = squaredLength(c - b), ca = squaredLength(a - c);
		const float shortest = std::min({ab, bc, ca}), longest = std::max({ab, bc, ca});
		return !(shortest > squaredRatio_ * longest) && smallestAngle(a, b, c) < angle_;
	}

private:
	const HalfEdgeMesh& m_;
	float               angle_;
	float               squaredRatio_;
};

} // namespace

std::vector<int> findPoorFaces(const HalfEdgeMesh& m, float angle, Workers& workers)
{
	const PoorFaceTest isPoor(m, angle);
	return workers.collect<int>(m.faceNum, [&](std::size_t begin, std::size_t end, auto& out) {
		for (int f = int(begin); f < int(end); ++f) {
			if (isPoor(f)) out.push_back(f);
		}
	});
}

std::vector<int> poorOnes(const HalfEdgeMesh& m, float angle, const std::vector<int>& faces)
{
	const PoorFaceTest isPoor(m, angle);
	std::vector<int>   poor;
	std::copy_if(faces.begin(), faces.end(), std::back_inserter(poor), isPoor);
	return poor;
}

} // namespace gpr
