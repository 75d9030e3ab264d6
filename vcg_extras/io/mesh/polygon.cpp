// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "polygon.h"

#include <numeric>

namespace gpr::app {

namespace {

/// Looking for ears takes up to n³ steps.
constexpr std::size_t maxClippedCorners = 500;

/// Twice the area vector of a polygon (Newell); also for corners outside of a common plane.
Vec3d areaVector(const std::vector<Vec3d>& corners)
{
	Vec3d sum;
	for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
		sum += cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
	}
	return sum;
}

/// Twice the area of a triangle seen along the normal, below 0 for a turned triangle.
double signedArea(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& normal)
{
	return dot(cross(b - a, c - a), normal);
}

/// The corners left, and the data to judge each corner.
struct Remainder {
	const std::vector<Vec3d>& points;
	Vec3d                     normal;
	std::vector<std::size_t>  corners;

	std::size_t before(std::size_t i) const { return (i + corners.size() - 1) % corners.size(); }
	std::size_t after(std::size_t i) const { return (i + 1) % corners.size(); }

	/// Whether the triangle at this corner lies inwards and holds no other corner.
	bool isEar(std::size_t i) const
	{
		const Vec3d a = at(before(i)), b = at(i), c = at(after(i));
		if (!(signedArea(a, b, c, normal) > 0)) return false;
		for (std::size_t k = after(after(i)); k != before(i); k = after(k)) {
			const Vec3d p       = at(k);
			const bool  touches = p == a || p == b || p == c;
			if (!touches && signedArea(a, b, p, normal) >= 0 && signedArea(b, c, p, normal) >= 0 &&
				signedArea(c, a, p, normal) >= 0) {
				return false;
			}
		}
		return true;
	}

	/// From the second corner on, so that a convex polygon becomes a fan around the first corner.
	std::size_t findEar() const
	{
		for (std::size_t i = 1; i <= corners.size(); ++i) {
			if (isEar(i % corners.size())) return i % corners.size();
		}
		return 1;
	}

private:
	const Vec3d& at(std::size_t i) const { return points[corners[i]]; }
};

} // namespace

void cutPolygon(const std::vector<Vec3d>& corners, std::vector<std::size_t>& triangles)
{
	Remainder rest{corners, areaVector(corners), std::vector<std::size_t>(corners.size())};
	std::iota(rest.corners.begin(), rest.corners.end(), std::size_t(0));
	triangles.clear();
	while (rest.corners.size() >= 3) {
		const bool        search = rest.corners.size() > 3 && corners.size() <= maxClippedCorners;
		const std::size_t ear    = search ? rest.findEar() : 1;
		for (const std::size_t i : {rest.before(ear), ear, rest.after(ear)}) {
			triangles.push_back(rest.corners[i]);
		}
		rest.corners.erase(rest.corners.begin() + std::ptrdiff_t(ear));
	}
}

} // namespace gpr::app
