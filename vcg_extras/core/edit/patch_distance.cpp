// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch_distance.h"

#include <vcg_extras/core/base/box.h>
#include <vcg_extras/core/base/triangle.h>
#include <vcg_extras/core/mesh/face_plane.h>

#include <algorithm>
#include <utility>

namespace gpr {

namespace {

/// Measures distances of points from triangles. Fast for three reasons: the last nearest triangle
/// is tried first; most points lie over this triangle and near enough, which its plane tells; and
/// most other triangles are passed over because of their boxes.
class NearestTriangle {
public:
	explicit NearestTriangle(const Triangles& triangles) : triangle_(triangles)
	{
		box_.reserve(triangles.size());
		plane_.reserve(triangles.size());
		for (const std::array<Vec3f, 3>& t : triangles) {
			box_.push_back(Box<float>::ofPoints(t));
			plane_.emplace_back(Corners{t[0], t[1], t[2]});
		}
	}

	/// Squared distance from the nearest triangle, or at most `enough` if a triangle is near
	/// enough.
	float squaredDistance(const Vec3f& p, float enough)
	{
		++work_;
		if (triangle_.empty()) return HUGE_VALF;
		if (plane_[last_].isNearOver(p, enough)) return enough;
		float nearest = squaredFrom(last_, p);
		for (std::size_t i = 0; i < triangle_.size() && nearest > enough; ++i) {
			++work_;
			if (box_[i].squaredDistance(p) >= nearest) continue;
			const float squared = squaredFrom(i, p);
			if (squared >= nearest) continue;
			nearest = squared;
			last_   = i;
		}
		return nearest;
	}

	/// The number of triangles looked at.
	std::int64_t work() const { return work_; }

private:
	const Triangles&        triangle_;
	std::vector<Box<float>> box_;   ///< per triangle
	std::vector<FacePlane>  plane_; ///< per triangle
	std::size_t             last_ = 0;
	std::int64_t            work_ = 0;

	float squaredFrom(std::size_t i, const Vec3f& p) const
	{
		const std::array<Vec3f, 3>& t = triangle_[i];
		return squaredLength(nearestOnTriangle(p, t[0], t[1], t[2]) - p);
	}
};

} // namespace

Assignment::Assignment(const Surface& surface, const ClosestFaceMap& map,
					   std::vector<int> mapFace) :
		surface_(surface),
		map_(map), mapFace_(std::move(mapFace))
{
}

void Assignment::transfer(int from, const std::array<Vec3f, 3>& triangle, const HalfEdgeMesh& m,
						  const std::vector<int>& faces)
{
	const Vec3f      centre = (triangle[0] + triangle[1] + triangle[2]) * (1 / 3.0f);
	const int        to     = *std::min_element(faces.begin(), faces.end(), [&](int f, int g) {
        return squaredLength(m.faceCentre(f) - centre) < squaredLength(m.faceCentre(g) - centre);
    });
	std::vector<int> all;
	const auto       found = further_.find(from);
	if (found != further_.end()) {
		all = std::move(found->second);
		further_.erase(found);
	}
	if (mapFaceOf(from) >= 0) all.push_back(mapFaceOf(from));
	std::vector<int>& taken = further_[to];
	taken.insert(taken.end(), all.begin(), all.end());
}

Triangles trianglesOf(const HalfEdgeMesh& m, const std::vector<int>& faces)
{
	Triangles triangles;
	triangles.reserve(faces.size());
	for (int f : faces) {
		const auto [a, b, c] = m.corners(f);
		triangles.push_back({a, b, c});
	}
	return triangles;
}

PatchDistance::PatchDistance(const Assignment& assignment, std::vector<int> faces,
							 const Triangles& triangles, float enough, float guarded) :
		assignment_(assignment),
		faces_(std::move(faces)), squaredEnough_(enough * enough),
		squaredGuarded_(std::max(squaredEnough_, guarded * guarded)), farthest_(squaredEnough_)
{
	NearestTriangle near(triangles);
	for (int f : faces_) {
		assignment_.forEach(f, [&](const Vec3f& p) {
			const float squared = near.squaredDistance(p, surelyNear());
			farthest_           = std::max(farthest_, squared);
			fourthPowers_ += guardedPower(squared);
			return true;
		});
	}
	work_ = near.work();
}

/// A squared distance below which the exact value does not matter: the vertex is neither the
/// farthest nor guarded. This holds for nearly all vertices, and makes the measurement fast.
float PatchDistance::surelyNear() const
{
	return std::max(squaredEnough_, std::min(farthest_, squaredGuarded_));
}

double PatchDistance::guardedPower(float squared) const
{
	if (!(squaredGuarded_ < HUGE_VALF)) return 0;
	const double counted = std::max(squared, squaredGuarded_);
	return counted * counted;
}

bool PatchDistance::isKeptBy(const Triangles& triangles) const
{
	// Sums of the same numbers in another order differ by rounding.
	constexpr double rounding      = 1e-5;
	const double     allowedPowers = (1 + rounding) * fourthPowers_;
	double           powers        = 0;
	NearestTriangle  near(triangles);
	const auto       isKept = [&](const Vec3f& p) {
        const float squared = near.squaredDistance(p, surelyNear());
        powers += guardedPower(squared);
        return squared <= farthest_ && powers <= allowedPowers;
	};
	return std::all_of(faces_.begin(), faces_.end(),
					   [&](int f) { return assignment_.forEach(f, isKept); });
}

} // namespace gpr
