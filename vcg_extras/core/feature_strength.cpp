// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "feature_strength.h"

#include "surface_ray.h"

namespace gpr {

namespace {

constexpr int mostCrossings = 256;

/// Six rays in the middle of sectors of 30°. An even number: a ray at right angles would run
/// straight into the apex of every symmetric triangle, where rounding decides which way it goes.
constexpr RayDirection rays[] = {{0.96592583f, 0.25881905f},  {0.70710678f, 0.70710678f},
								 {0.25881905f, 0.96592583f},  {-0.25881905f, 0.96592583f},
								 {-0.70710678f, 0.70710678f}, {-0.96592583f, 0.25881905f}};

/// Not normalised; zero where the half-disk has no area.
Vec3f meanNormalOfHalfDisk(const HalfEdgeMesh& m, int h, float support, std::int64_t& capped)
{
	Vec3f      sum;
	const auto add = [&sum](const Vec3f& cross, float doubleArea, float from, float to, int) {
		if (doubleArea > 0) sum += cross * ((to * to - from * from) / doubleArea);
	};
	for (const RayDirection& ray : rays) {
		const RayEnd end = traceRay(m, h, ray, support, mostCrossings, add);
		capped += end == RayEnd::Capped;
	}
	return sum;
}

} // namespace

float angleDegBetween(const Vec3f& a, const Vec3f& b)
{
	constexpr float degrees = 57.29577951f;
	return degrees * std::atan2(length(cross(a, b)), dot(a, b));
}

EdgeDifferences edgeDifferences(const HalfEdgeMesh& m, float support, Workers& workers)
{
	const std::size_t halfEdgeNum = m.halfEdgeNum();
	EdgeDifferences   d;
	Buffer<Vec3f>     sideNormal(halfEdgeNum);
	d.cappedRayNum =
		workers.sum<std::int64_t>(halfEdgeNum, [&](std::size_t begin, std::size_t end) {
			std::int64_t capped = 0;
			for (std::size_t h = begin; h < end; ++h) {
				if (m.opposite[h] < 0) continue;
				sideNormal[h] = meanNormalOfHalfDisk(m, int(h), support, capped);
			}
			return capped;
		});
	d.supported.reset(halfEdgeNum);
	d.dihedral.reset(halfEdgeNum);
	workers.forRange(halfEdgeNum, [&](std::size_t begin, std::size_t end) {
		for (std::size_t h = begin; h < end; ++h) {
			const int other = m.opposite[h];
			d.supported[h] = d.dihedral[h] = 0;
			if (other < 0) continue;
			// The same order of the two sides gives both halves the same bits.
			const int first = std::min(int(h), other), second = std::max(int(h), other);
			d.supported[h] = angleDegBetween(sideNormal[first], sideNormal[second]);
			d.dihedral[h]  = angleDegBetween(m.faceCross(first / 3), m.faceCross(second / 3));
		}
	});
	return d;
}

} // namespace gpr
