// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_MESH_FACE_PLANE_H
#define VCG_EXTRAS_CORE_MESH_FACE_PLANE_H

#include "half_edge_mesh.h"

#include <vcg_extras/core/base/triangle.h>

#include <algorithm>

namespace gpr {

/// A point in the plane of a triangle, as weights of its corners.
struct Foot {
	float weight[3];

	bool isInside() const { return weight[0] > 0 && weight[1] > 0 && weight[2] > 0; }
	/// The corners with the least and with the largest weight.
	int lightest() const { return int(std::min_element(weight, weight + 3) - weight); }
	int heaviest() const { return int(std::max_element(weight, weight + 3) - weight); }
};

/// A triangle and its plane, for many points. The corner weights at the foot of a point are linear
/// functions of the point, so that each point takes a few multiplications. A degenerate triangle
/// has no foot inside.
class FacePlane {
public:
	FacePlane(const HalfEdgeMesh& m, int face) : FacePlane(m.corners(face)) {}
	explicit FacePlane(const Corners& corner) : corner_(corner), cross_(corner_.cross())
	{
		const float squared = squaredLength(cross_);
		inverse_            = squared > 0 ? 1 / squared : 0.0f;
		second_             = cross(corner_.c - corner_.a, cross_) * inverse_;
		third_              = cross(cross_, corner_.b - corner_.a) * inverse_;
	}

	/// The unit normal times twice the area.
	const Vec3f& areaNormal() const { return cross_; }
	bool         looksAlong(const Vec3f& normal) const { return dot(cross_, normal) > 0; }

	/// The foot of p: the nearest point of the plane.
	Foot footOf(const Vec3f& p) const
	{
		const Vec3f from   = p - corner_.a;
		const float second = dot(from, second_), third = dot(from, third_);
		return {{1 - second - third, second, third}};
	}
	/// The nearest point of the triangle to p.
	Foot nearestFoot(const Vec3f& p) const
	{
		const Foot inPlane = footOf(p);
		return inPlane.isInside() && inverse_ > 0 ? inPlane : footOnEdges(p);
	}

	Vec3f pointAt(const Foot& foot) const
	{
		return corner_.a * foot.weight[0] + corner_.b * foot.weight[1] + corner_.c * foot.weight[2];
	}
	float squaredDistance(const Vec3f& p, const Foot& foot) const
	{
		return squaredLength(pointAt(foot) - p);
	}
	/// Squared distance of p from the plane.
	float squaredHeight(const Vec3f& p) const
	{
		const float height = dot(p - corner_.a, cross_);
		return height * height * inverse_;
	}

	/// Whether p lies over the triangle and no farther off. False for some nearer points beside it.
	bool isNearOver(const Vec3f& p, float squared) const
	{
		return squaredHeight(p) <= squared && footOf(p).isInside();
	}

private:
	Corners corner_;
	Vec3f   cross_;
	Vec3f   second_, third_; ///< gradients of the weights of the second and third corner
	float   inverse_;        ///< 1 over the squared length of cross_; 0 if degenerate

	/// The nearest point on the edges. Needs all three edges, as the triangle may be obtuse.
	Foot footOnEdges(const Vec3f& p) const;
};

} // namespace gpr

#endif
