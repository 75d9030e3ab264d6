// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "barycentric_point.h"

#include <algorithm>

namespace gpr {

namespace {

/// Weights of corners b and c, for the foot of p on the triangle's plane. False for a degenerate
/// face.
bool weightsInPlane(const Vec3d& p, const Vec3d corner[3], double& wb, double& wc)
{
	// Squared sine of an angle that rounding alone may make.
	constexpr double rounding = 1e-24;
	const Vec3d      b = corner[1] - corner[0], c = corner[2] - corner[0], n = cross(b, c);
	const double     squared = squaredLength(n), longest = squaredLength(b) + squaredLength(c);
	if (!(squared > rounding * longest * longest)) return false;
	wb = dot(cross(p - corner[0], c), n) / squared;
	wc = dot(cross(b, p - corner[0]), n) / squared;
	return true;
}

/// Weights of the nearest point on the longest edge, for a degenerate face.
void weightsOnEdge(const Vec3d& p, const Vec3d corner[3], double weight[3])
{
	int longest = 0;
	for (int k = 1; k < 3; ++k) {
		if (squaredLength(corner[(k + 1) % 3] - corner[k]) >
			squaredLength(corner[(longest + 1) % 3] - corner[longest]))
			longest = k;
	}
	const int end             = (longest + 1) % 3;
	weight[end]               = shareOnSegment(p, corner[longest], corner[end]);
	weight[longest]           = 1 - weight[end];
	weight[(longest + 2) % 3] = 0;
}

} // namespace

BarycentricPoint barycentricPoint(const MeshView& input, const Surface& surface,
								  const SurfacePoint& point)
{
	BarycentricPoint s;
	s.face                = surface.sourceFace[point.face];
	const Vec3d p         = surface.frame.toCaller(point.position);
	const auto  t         = input.triangle(std::size_t(s.face));
	const Vec3d corner[3] = {input.position(std::size_t(t[0])), input.position(std::size_t(t[1])),
							 input.position(std::size_t(t[2]))};
	double      wb = 0, wc = 0, weight[3];
	if (weightsInPlane(p, corner, wb, wc)) {
		weight[1] = std::min(1.0, std::max(0.0, wb));
		weight[2] = std::min(1.0 - weight[1], std::max(0.0, wc));
		weight[0] = 1 - weight[1] - weight[2];
	}
	else {
		weightsOnEdge(p, corner, weight);
	}
	for (int k = 0; k < 3; ++k)
		s.weight[k] = float(weight[k]);
	return s;
}

} // namespace gpr
