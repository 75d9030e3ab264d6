// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <tests/support/mesh_builders.h>
#include <tests/support/split_edges.h>
#include <tests/support/stages.h>
#include <vcg_extras/core/base/failure.h>
#include <vcg_extras/core/features/boundary_curves.h>
#include <vcg_extras/core/sampling/sizing.h>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace gpr::test {

namespace {

class SizingTest : public ::testing::Test {
protected:
	Workers       workers{2, nullptr};
	RemeshOptions options;
	Buffer<char>  isFeature, lines;

	Sizing sizing(const Surface& of, float radius)
	{
		Surface surface = copyOf(of, workers);
		return makeSizing({options, radius, radius, lines, isFeature, {}, {}}, surface, workers);
	}
};

/// In units of the input, with the sign of the normals.
TEST_F(SizingTest, MeanCurvatureOfASphereIsOneOverItsRadius)
{
	for (int passes : {0, 5}) {
		const Surface       ball = surfaceOf(icosphere(4, 2.0), workers);
		const Buffer<float> h    = meanCurvature(ball, passes, workers);
		for (float value : h)
			EXPECT_NEAR(value * ball.frame.scale, 0.5, 0.015);
	}
	TriangleMesh hollow = icosphere(4, 2.0);
	for (std::size_t f = 0; f < hollow.faceNum(); ++f)
		std::swap(hollow.triangles[3 * f], hollow.triangles[3 * f + 1]);
	const Surface       inside = surfaceOf(hollow, workers);
	const Buffer<float> h      = meanCurvature(inside, 0, workers);
	for (float value : h)
		EXPECT_NEAR(value * inside.frame.scale, -0.5, 0.015);
}

TEST_F(SizingTest, MeanCurvatureOfATorusFollowsItsFormula)
{
	const Surface       ring = surfaceOf(torus(160, 80, 1, 0.4), workers);
	const Buffer<float> h    = meanCurvature(ring, 0, workers);
	for (int v = 0; v < ring.mesh.vertexNum; ++v) {
		const Vec3d  p        = ring.frame.toCaller(ring.mesh.position[v]);
		const double fromAxis = std::hypot(p.x, p.y);
		const double expected = (2 * fromAxis - 1) / (0.8 * fromAxis);
		EXPECT_NEAR(h[v] * ring.frame.scale, expected, 0.03);
	}
}

TEST_F(SizingTest, MeanCurvatureOfAPlaneIsNothingEvenAmongSlivers)
{
	const Surface flat = surfaceOf(grid(200, 3, 1, 1), workers);
	for (float value : meanCurvature(flat, 2, workers))
		EXPECT_NEAR(value, 0, 1e-4);
}

TEST_F(SizingTest, NothingWantedIsNothingGiven)
{
	options.adapt           = 0;
	const TriangleMesh mesh = icosphere(2);
	const Sizing       none = sizing(surfaceOf(mesh, workers), 0.1f);
	EXPECT_TRUE(none.size.empty());
	EXPECT_EQ(none.radiusFactor, 1);
}

/// On a sphere all sizes are equal: the largest is 1, and the radius is the same as without a
/// density.
TEST_F(SizingTest, EvenCurvatureChangesNothing)
{
	options.lambda          = 3;
	const TriangleMesh mesh = icosphere(4);
	const Sizing       even = sizing(surfaceOf(mesh, workers), 0.1f);
	for (float size : even.size)
		EXPECT_NEAR(size, 1, 0.02);
	EXPECT_NEAR(even.radiusFactor, 1, 0.02);
}

TEST_F(SizingTest, SizesGrowNoFasterThanTheirSlopeAndNoWiderThanTheStretch)
{
	options.lambda           = 100;
	const TriangleMesh mesh  = bentSheet(60, 1.5);
	const Surface      bent  = surfaceOf(mesh, workers);
	const float        r     = 0.05f;
	const Sizing       s     = sizing(bent, r);
	const float        rMax  = r * float(s.radiusFactor);
	float              least = 1;
	for (int h = 0; h < bent.mesh.halfEdgeNum(); ++h) {
		const int   a = bent.mesh.origin[h], b = bent.mesh.target(h);
		const float d = length(bent.mesh.position[a] - bent.mesh.position[b]);
		EXPECT_LE(s.size[b] - s.size[a], 0.151f * d / rMax * 1.35f + 2e-3f);
		least = std::min(least, s.size[a]);
	}
	EXPECT_GE(least, 1 / 4.001f);
	EXPECT_LT(least, 0.5f);
}

/// Hollows and bumps need small triangles alike.
TEST_F(SizingTest, TheSideThatIsOutsideChangesNothing)
{
	options.lambda            = 1;
	const TriangleMesh ring   = torus(80, 40);
	TriangleMesh       hollow = ring;
	for (std::size_t f = 0; f < hollow.faceNum(); ++f)
		std::swap(hollow.triangles[3 * f], hollow.triangles[3 * f + 1]);
	const Surface a = surfaceOf(ring, workers), b = surfaceOf(hollow, workers);
	const Sizing  outside = sizing(a, 0.1f), inside = sizing(b, 0.1f);
	EXPECT_NEAR(inside.radiusFactor, outside.radiusFactor, 1e-4);
	for (int v = 0; v < a.mesh.vertexNum; ++v) {
		ASSERT_TRUE(a.mesh.position[v] == b.mesh.position[v]);
		ASSERT_NEAR(inside.size[v], outside.size[v], 1e-3);
	}
}

TEST_F(SizingTest, SizesByTheErrorAreSmallAtABendUnlessItIsAFeatureLine)
{
	const TriangleMesh mesh = bentSheet(60, 1.5);
	const Surface      bent = surfaceOf(mesh, workers);
	options.adapt           = 1;
	const Sizing s          = sizing(bent, 0.06f);
	EXPECT_LT(*std::min_element(s.size.begin(), s.size.end()), 0.6f);
	EXPECT_EQ(*std::max_element(s.size.begin(), s.size.end()), 1.0f);
	EXPECT_GT(s.radiusFactor, 1.01);
	EXPECT_LT(s.radiusFactor, 1.31);
	options.adapt = 0.1;
	EXPECT_LT(sizing(bent, 0.06f).radiusFactor, s.radiusFactor - 0.1);
	lines                    = edgesThatTurn(bent, 30);
	const Sizing besideLines = sizing(bent, 0.06f);
	for (float size : besideLines.size)
		EXPECT_EQ(size, 1.0f);
}

/// A kept border is finer than the wanted result: disks there follow the spacing of the border.
TEST_F(SizingTest, DisksAtAKeptBorderGoWithItsSpacing)
{
	options.boundary        = BoundaryMode::Keep;
	const TriangleMesh mesh = grid(80, 80);
	Surface            flat = surfaceOf(mesh, workers);
	std::vector<int>   kept;
	for (int v = 0; v < flat.mesh.vertexNum; ++v) {
		if (flat.mesh.isBorderVertex(v)) kept.push_back(v);
	}
	const float r = 0.01f, spacing = float(flat.frame.scale) / 80;
	for (double adapt : {0.0, 1.0}) {
		options.adapt  = adapt;
		const Sizing s = makeSizing({options, r, r, lines, isFeature, kept, {}}, flat, workers);
		for (int v : kept)
			EXPECT_NEAR(borderSpacing * s.size[v] * r * float(s.radiusFactor) / spacing, 1, 0.05f);
	}
}

TEST_F(SizingTest, PrintedEquationsClampHollowsAndCountThem)
{
	TriangleMesh hollow = icosphere(3);
	for (std::size_t f = 0; f < hollow.faceNum(); ++f)
		std::swap(hollow.triangles[3 * f], hollow.triangles[3 * f + 1]);
	options.preset = Preset::Paper;
	options.lambda = 5; // 1 + λH = -4
	const Sizing s = sizing(surfaceOf(hollow, workers), 0.1f);
	EXPECT_EQ(s.clampedNum, std::int64_t(hollow.vertexNum()));
	options.lambda = 0.5;
	EXPECT_EQ(sizing(surfaceOf(hollow, workers), 0.1f).clampedNum, 0);
}

TEST_F(SizingTest, LongEdgesAreSplitByTheirLocalSize)
{
	IndexedMesh   mesh = loaded(grid(8, 8), workers);
	Buffer<float> size(mesh.vertexNum);
	for (int v = 0; v < mesh.vertexNum; ++v)
		size[v] = mesh.frame.toCaller(mesh.position[v]).x < 0.5 ? 1.0f : 0.2f;
	const float unit = float(mesh.frame.scale);
	mesh.size        = std::move(size);
	splitLongEdges(mesh, 0.2f * unit, 1000000, workers);
	for (int h = 0; h < 3 * mesh.faceNum; ++h) {
		const Vec3f  a    = mesh.position[mesh.triangle[h]];
		const Vec3f  b    = mesh.position[mesh.triangle[nextInFace(h)]];
		const double x    = std::min(mesh.frame.toCaller(a).x, mesh.frame.toCaller(b).x);
		const double most = x >= 0.5 ? 0.04 : 0.2;
		EXPECT_LE(length(a - b) / unit, most * 1.001);
	}
}

} // namespace

} // namespace gpr::test
