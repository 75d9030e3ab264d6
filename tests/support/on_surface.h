// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GPR_TESTS_SUPPORT_ON_SURFACE_H
#define GPR_TESTS_SUPPORT_ON_SURFACE_H

#include "mesh_audit.h"
#include "oracles.h"
#include "random_source.h"
#include "stages.h"

#include <vcg_extras/core/mesh/measure.h>
#include <vcg_extras/core/mesh/mesh_edit.h>

#include <cmath>
#include <gtest/gtest.h>

namespace gpr::test {

/// A surface and a result with the same vertices.
struct OnSurface {
	Workers        workers{2, nullptr};
	Surface        surface;
	BoundaryCurves boundary;
	ResultMesh     result;

	explicit OnSurface(const TriangleMesh& mesh) : surface(surfaceOf(mesh, workers))
	{
		result        = resultOf(surface, boundary);
		const float r = result.idealEdge / 1.04f;
		boundary      = sampleBoundary(surface, r, result.idealEdge, workers);
		result        = resultOf(surface, boundary);
	}

	HalfEdgeMesh& m() { return result.mesh; }
	double        meanShape() { return measureQuality(meshOf(m()).view()).radiusRatioMean; }
	double        minAngleDeg() { return measureQuality(meshOf(m()).view()).minAngleDeg; }

	void expectSound()
	{
		EXPECT_TRUE(isSoundTable(m()));
		EXPECT_TRUE(isSoundSurface(meshOf(m())));
		ASSERT_EQ(int(result.vertex.size()), m().vertexNum);
	}
	/// Every vertex lies in the face of its surface point, at the place of its surface point.
	void expectOnSurface()
	{
		const HalfEdgeMesh& s = surface.mesh;
		for (int v = 0; v < m().vertexNum; ++v) {
			const SurfacePoint& a = result.vertex[v].point;
			ASSERT_EQ(a.position, m().position[v]) << "vertex " << v;
			ASSERT_TRUE(a.face >= 0 && a.face < s.faceNum);
			const auto corner = [&](int k) { return Vec3d(s.position[s.origin[3 * a.face + k]]); };
			ASSERT_LT(distanceToTriangle(Vec3d(a.position), corner(0), corner(1), corner(2)), 1e-5);
		}
	}
};

/// run(on, workers) makes the same triangles and places with any number of threads.
template <class Run>
void expectSameForAnyThreads(const TriangleMesh& mesh, const Run& run)
{
	TriangleMesh first;
	for (int threads = 1; threads <= 4; ++threads) {
		OnSurface on(mesh);
		Workers   workers(threads, nullptr);
		run(on, workers);
		const TriangleMesh result = meshOf(on.m());
		if (threads == 1) first = result;
		EXPECT_EQ(result.triangles, first.triangles) << threads << " threads";
		EXPECT_TRUE(result.positions == first.positions) << threads << " threads";
	}
}

/// Twice the signed area in the plane z = 0.
inline double turn(const Vec3f& a, const Vec3f& b, const Vec3f& c)
{
	return (double(b.x) - double(a.x)) * (double(c.y) - double(a.y)) -
		   (double(b.y) - double(a.y)) * (double(c.x) - double(a.x));
}

/// Flips random inner edges if both triangles stay positive: a triangulation far from Delaunay.
inline void scramble(HalfEdgeMesh& m, Random& random)
{
	for (int i = 0; i < 6 * m.halfEdgeNum(); ++i) {
		const int h = random.below(m.halfEdgeNum());
		if (!canFlip(m, h)) continue;
		const Vec3f a = m.position[m.origin[h]], b = m.position[m.target(h)];
		const Vec3f c = m.position[m.apex(h)], d = m.position[m.apex(m.opposite[h])];
		if (turn(a, d, c) > 1e-6 && turn(d, b, c) > 1e-6) flip(m, h);
	}
}

/// The angle at the corner p of a triangle.
inline double angleAt(const Vec3f& p, const Vec3f& a, const Vec3f& b)
{
	const Vec3d u = Vec3d(a) - Vec3d(p), v = Vec3d(b) - Vec3d(p);
	return std::atan2(length(cross(u, v)), dot(u, v));
}

/// Inner edges whose opposite angles add up to more than 180°.
inline int edgesNotDelaunay(const HalfEdgeMesh& m)
{
	int n = 0;
	for (int h = 0; h < m.halfEdgeNum(); ++h) {
		const int g = m.opposite[h];
		if (g < h) continue;
		const Vec3f a = m.position[m.origin[h]], b = m.position[m.target(h)];
		n += angleAt(m.position[m.apex(h)], a, b) + angleAt(m.position[m.apex(g)], a, b) >
			 3.14159265 + 1e-3;
	}
	return n;
}

} // namespace gpr::test

#endif
