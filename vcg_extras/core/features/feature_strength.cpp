// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "feature_strength.h"

#include <vcg_extras/core/base/angle.h>
#include <vcg_extras/core/surface/surface_ray.h>

#include <algorithm>

namespace gpr {

namespace {

/// A support is a few edges long, so that a ray crosses about ten faces. Among needles a ray could
/// cross any number.
constexpr int maxCrossings = 256;

/// Six rays in the middle of sectors of 30°. The number is even: a ray at right angles would run
/// straight into the apex of every symmetric triangle, and rounding would decide on which side it
/// passes.
constexpr Vec2f rays[] = {{0.96592583f, 0.25881905f},  {0.70710678f, 0.70710678f},
						  {0.25881905f, 0.96592583f},  {-0.25881905f, 0.96592583f},
						  {-0.70710678f, 0.70710678f}, {-0.96592583f, 0.25881905f}};

constexpr int rayNum = int(sizeof(rays) / sizeof(rays[0]));

/// The rays of a half-disk. Rays are followed together as long as they cross the same faces, which
/// halves the work.
class RayFan {
public:
	RayFan(const HalfEdgeMesh& mesh, float support) : m_(mesh), support_(support) {}

	/// The mean normal of the half-disk on the side of half-edge h; not normalised, zero if the
	/// half-disk has no area.
	Vec3f meanNormal(int h)
	{
		sum_ = Vec3f();
		for (float& d : distance_)
			d = 0;
		pending_[0] = {UnfoldedFace(m_, h), 0, rayNum, 0};
		pendingNum_ = 1;
		while (pendingNum_ > 0)
			follow(pending_[--pendingNum_]);
		return sum_;
	}
	std::int64_t cappedNum() const { return cappedNum_; }

private:
	/// Neighbouring rays that enter the same face.
	struct Bundle {
		UnfoldedFace face;
		int          first, end;
		int          crossings;
	};

	const HalfEdgeMesh& m_;
	float               support_;
	Vec3f               sum_;
	float               distance_[rayNum]; ///< length of each ray so far
	Bundle              pending_[rayNum];  ///< bundles only part, so there are never more than rays
	int                 pendingNum_ = 0;
	std::int64_t        cappedNum_  = 0;

	void follow(Bundle b)
	{
		UnfoldedFace& f = b.face;
		while (f.unfoldApex(m_)) {
			int parting = b.first;
			while (parting < b.end && f.apexIsLeftOf(rays[parting]))
				++parting;
			const float weight =
				advance(f.b2, f.c2, b.first, parting) + advance(f.c2, f.a2, parting, b.end);
			if (f.doubleArea > 0) sum_ += f.cross * (weight / f.doubleArea);
			if (++b.crossings == maxCrossings) {
				cappedNum_ += b.end - b.first;
				return;
			}
			if (parting < b.end) branch(b, parting);
			b.end = parting;
			if (!dropArrived(b) || !f.goOver(true, m_)) return;
		}
	}

	/// Extends rays to the edge p -> q or to the end of the support. Returns the weight of the new
	/// stretches.
	float advance(Vec2f p, Vec2f q, int first, int end)
	{
		float weight = 0;
		for (int i = first; i < end; ++i) {
			const float from = distance_[i];
			const float to   = std::min(crossingOf(rays[i], p, q, from), support_);
			weight += to * to - from * from;
			distance_[i] = to;
		}
		return weight;
	}

	/// Keeps the rays from `first` on for later; they leave the face over c -> a.
	void branch(const Bundle& b, int first)
	{
		Bundle& other = pending_[pendingNum_];
		other         = b;
		other.first   = first;
		if (dropArrived(other) && other.face.goOver(false, m_)) ++pendingNum_;
	}

	/// Drops rays that have reached the support. Only rays at the two ends of a bundle can have
	/// arrived before the rest: the way to a straight edge is longest there. False if no ray is
	/// left.
	bool dropArrived(Bundle& b) const
	{
		while (b.first < b.end && distance_[b.first] >= support_)
			++b.first;
		while (b.first < b.end && distance_[b.end - 1] >= support_)
			--b.end;
		return b.first < b.end;
	}
};

} // namespace

float angleDegBetween(const Vec3f& a, const Vec3f& b)
{
	constexpr float degrees = 57.29577951f;
	return degrees * angleBetween(a, b);
}

EdgeDifferences edgeDifferences(const HalfEdgeMesh& m, float support, Workers& workers)
{
	const std::size_t halfEdgeNum = m.halfEdgeNum();
	EdgeDifferences   d;
	Buffer<Vec3f>     sideNormal(halfEdgeNum);
	d.cappedRayNum =
		workers.sum<std::int64_t>(halfEdgeNum, [&](std::size_t begin, std::size_t end) {
			RayFan fan(m, support);
			for (std::size_t h = begin; h < end; ++h) {
				if (m.opposite[h] >= 0) sideNormal[h] = fan.meanNormal(int(h));
			}
			return fan.cappedNum();
		});
	d.supported.reset(halfEdgeNum);
	d.dihedral.reset(halfEdgeNum);
	workers.forEach(halfEdgeNum, [&](int h) {
		const int other = m.opposite[h];
		d.supported[h] = d.dihedral[h] = 0;
		if (other < 0) return;
		// The same order of the two sides gives both halves the same bits.
		const int first = std::min(h, other), second = std::max(h, other);
		d.supported[h] = angleDegBetween(sideNormal[first], sideNormal[second]);
		d.dihedral[h]  = angleDegBetween(m.faceCross(first / 3), m.faceCross(second / 3));
	});
	return d;
}

} // namespace gpr
