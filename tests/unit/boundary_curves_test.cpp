// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <tests/support/mesh_builders.h>
#include <tests/support/oracles.h>
#include <tests/support/stages.h>
#include <tests/support/transforms.h>
#include <vcg_extras/core/features/boundary_curves.h>
#include <vcg_extras/core/features/crease_lines.h>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <set>

namespace gpr::test {

namespace {

class SampleBoundary : public ::testing::Test {
protected:
	Workers        workers{1, nullptr};
	Surface        surface;
	BoundaryCurves b;

	void sample(const TriangleMesh& mesh, float spacing)
	{
		surface = surfaceOf(mesh, workers);
		b       = sampleBoundary(surface, spacing / 1.04f, spacing, workers);
	}
	std::vector<CurveSample> samplesOf(int curve) const
	{
		std::vector<CurveSample> own;
		for (const CurveSample& s : b.samples) {
			if (s.curve == curve) own.push_back(s);
		}
		return own;
	}
};

TEST_F(SampleBoundary, AClosedSurfaceHasNone)
{
	sample(icosphere(2), 0.1f);
	EXPECT_TRUE(b.curves.empty());
	EXPECT_TRUE(b.samples.empty());
}

TEST_F(SampleBoundary, KeepsTheCornersOfASquare)
{
	for (float spacing : {0.05f, 0.11f, 0.3f, 0.45f}) {
		sample(grid(40, 40), spacing);
		ASSERT_EQ(b.curves.size(), 1u);
		std::set<std::pair<float, float>> corners;
		for (const CurveSample& s : b.samples) {
			const Vec3d p = surface.frame.toCaller(s.point.position);
			if (s.isCorner) corners.insert({float(std::round(p.x)), float(std::round(p.y))});
			EXPECT_NEAR(std::min({p.x, p.y, 1 - p.x, 1 - p.y}), 0, 1e-6) << "on the rim";
		}
		EXPECT_EQ(corners.size(), 4u) << "spacing " << spacing;
		EXPECT_EQ(std::count_if(b.samples.begin(), b.samples.end(),
								[](const CurveSample& s) { return s.isCorner; }),
				  4);
	}
}

/// From 50° on.
TEST_F(SampleBoundary, KeepsTheCornersOfAHexagonButNotOfAnOctagon)
{
	for (int sides : {6, 8}) {
		sample(subdivided(subdivided(cone(sides, 4, 1, 0.01))), 0.1f);
		ASSERT_EQ(b.curves.size(), 1u);
		const auto isCorner = [](const CurveSample& s) { return s.isCorner; };
		EXPECT_EQ(std::count_if(b.samples.begin(), b.samples.end(), isCorner), sides == 6 ? 6 : 0);
	}
}

/// Three lines from pole to pole: with a single edge each, the lines would coincide.
TEST_F(SampleBoundary, LinesBetweenTheSameNodesHaveTwoEdgesAtLeast)
{
	TriangleMesh spindle = uvSphere(24, 3);
	for (Vec3d& p : spindle.positions)
		p.z *= 4;
	surface = surfaceOf(spindle, workers);
	CreaseRules rules;
	rules.mode      = FeatureMode::Lines;
	rules.strongDeg = 60;
	ASSERT_EQ(markCreases(rules, workers, surface).edgeNum, 3 * 24);
	b = sampleBoundary(surface, 4, 4, workers);
	ASSERT_EQ(b.curves.size(), 3u);
	int onLines = 0;
	for (const CurveSample& s : b.samples)
		onLines += !s.isCorner;
	EXPECT_EQ(onLines, 3);
	EXPECT_EQ(b.samples.size(), 5u);
}

TEST_F(SampleBoundary, SpacesEvenlyRoundACylinder)
{
	const float spacing = 0.11f;
	sample(openCylinder(400, 20, 0.5, 1), spacing);
	ASSERT_EQ(b.curves.size(), 2u);
	for (int curve = 0; curve < 2; ++curve) {
		const std::vector<CurveSample> own = samplesOf(curve);
		const double wanted = 3.14159265 * double(surface.frame.scale) / double(spacing);
		EXPECT_NEAR(double(own.size()), wanted, 1);
		double least = HUGE_VAL, most = 0;
		for (std::size_t i = 0; i < own.size(); ++i) {
			EXPECT_FALSE(own[i].isCorner);
			const Vec3f  next = own[(i + 1) % own.size()].point.position;
			const double d    = double(length(next - own[i].point.position));
			least             = std::min(least, d);
			most              = std::max(most, d);
		}
		EXPECT_LT(most / least, 1.03);
	}
}

TEST_F(SampleBoundary, LoopsTooShortKeepThreeVerticesOfTheirOwn)
{
	Random random(2);
	sample(withHoles(grid(40, 40), 3, random), 0.3f);
	ASSERT_EQ(b.curves.size(), 4u);
	for (int curve = 0; curve < 4; ++curve) {
		const std::vector<CurveSample> own = samplesOf(curve);
		ASSERT_GE(own.size(), 3u);
		if (b.curves[curve].length > 1) continue; // the outer rim
		EXPECT_EQ(own.size(), 3u);
		std::set<int> vertices;
		for (const CurveSample& s : own) {
			ASSERT_GE(s.vertex, 0);
			EXPECT_EQ(surface.mesh.position[s.vertex], s.point.position);
			vertices.insert(s.vertex);
		}
		EXPECT_EQ(vertices.size(), 3u);
	}
}

/// A square with two square holes that meet in a point. Both make one loop, which passes the point
/// twice.
TriangleMesh touchingHoles(int below, int above)
{
	return gridWhere(20, 1, [&](int i, int j) {
		const bool isBelow = std::min(i, j) >= 10 - below && std::max(i, j) < 10;
		const bool isAbove = std::min(i, j) >= 10 && std::max(i, j) < 10 + above;
		return !isBelow && !isAbove;
	});
}

TEST_F(SampleBoundary, NeighboursOnALoopThatTouchesItselfLieApart)
{
	for (int below : {1, 2, 4, 8}) {
		for (int above : {1, 2, 4, 8}) {
			for (float spacing : {0.1f, 0.4f, 1.0f}) {
				IndexedMesh cut = loaded(touchingHoles(below, above), workers);
				CleanCounts counts;
				repair(cut, workers, counts); // the point gets a vertex for each of its two fans
				surface = surfaceOf(std::move(cut), workers);
				b       = sampleBoundary(surface, spacing / 1.04f, spacing, workers);
				ASSERT_EQ(b.curves.size(), 2u);
				for (int c = 0; c < 2; ++c) {
					const std::vector<CurveSample> own = samplesOf(c);
					ASSERT_GE(own.size(), 3u);
					for (std::size_t i = 0; i < own.size(); ++i) {
						const CurveSample& next = own[(i + 1) % own.size()];
						EXPECT_GT(length(next.point.position - own[i].point.position), 1e-3f)
							<< below << " and " << above << " squares, spacing " << spacing;
					}
				}
			}
		}
	}
}

TEST_F(SampleBoundary, CurvesAndSamplesAgreeWithTheSurface)
{
	Random random(3);
	sample(withHoles(jitteredGrid(40, 0.3, random), 2, random), 0.07f);
	int onCurves = 0;
	for (std::size_t c = 0; c < b.curves.size(); ++c) {
		const Curve& curve = b.curves[c];
		onCurves += curve.pointNum();
		ASSERT_EQ(int(b.sampleOfPoint[c].size()), curve.pointNum());
		for (int i = 0; i < curve.pointNum(); ++i) {
			const int v = curve.vertex[i], next = curve.vertex[(i + 1) % curve.pointNum()];
			EXPECT_EQ(surface.mesh.position[v], curve.point[i]);
			const int h = surface.mesh.findHalfEdge(v, next);
			ASSERT_GE(h, 0);
			EXPECT_TRUE(surface.mesh.isBorderEdge(h));
			EXPECT_EQ(curve.halfEdge[i], h);
			EXPECT_EQ(b.samples[b.sampleOfPoint[c][i]].curve, int(c));
		}
	}
	int borderVertices = 0;
	for (int v = 0; v < surface.mesh.vertexNum; ++v)
		borderVertices += surface.mesh.isBorderVertex(v);
	EXPECT_EQ(onCurves, borderVertices) << "every border vertex is on one curve";
	for (std::size_t i = 0; i < b.samples.size(); ++i) {
		const CurveSample& s = b.samples[i];
		EXPECT_LT(double(length(b.curves[s.curve].at(s.arc) - s.point.position)), 1e-6);
		if (i > 0 && b.samples[i - 1].curve == s.curve) {
			EXPECT_LT(b.samples[i - 1].arc, s.arc);
		}
	}
}

TEST_F(SampleBoundary, PointsBelongToTheSampleNearestAlongTheCurve)
{
	sample(openCylinder(120, 8, 0.5, 1), 0.13f);
	for (std::size_t c = 0; c < b.curves.size(); ++c) {
		const Curve& curve    = b.curves[c];
		const auto   distance = [&](float x, float y) {
            const float d = std::abs(x - y);
            return std::min(d, curve.length - d);
		};
		for (int i = 0; i < curve.pointNum(); ++i) {
			float best = HUGE_VALF;
			for (const CurveSample& s : samplesOf(int(c)))
				best = std::min(best, distance(s.arc, curve.arc[i]));
			EXPECT_FLOAT_EQ(distance(b.samples[b.sampleOfPoint[c][i]].arc, curve.arc[i]), best);
		}
	}
}

} // namespace

} // namespace gpr::test
