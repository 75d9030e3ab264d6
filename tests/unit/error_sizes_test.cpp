// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <tests/support/mesh_builders.h>
#include <tests/support/random_source.h>
#include <tests/support/stages.h>
#include <vcg_extras/core/input/split_long_edges.h>
#include <vcg_extras/core/mesh/measure.h>
#include <vcg_extras/core/sampling/error_sizes.h>
#include <vcg_extras/core/sampling/size_grading.h>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace gpr::test {

namespace {

constexpr float largest = 1.1f, slope = 0.15f;

class ErrorSizesTest : public ::testing::Test {
protected:
	Workers workers{2, nullptr};

	/// Edges over `even`, which is given in the mesh's unit.
	Buffer<float> sizes(const Surface& of, double even, int threads = 2,
						const Buffer<char>& lines = {})
	{
		Workers     own(threads, nullptr);
		Surface     surface  = copyOf(of, own);
		const float evenEdge = float(even * surface.frame.scale);
		ErrorSizes  found    = sizesByError(surface, lines, evenEdge, {largest, slope}, own);
		epsilon              = found.epsilon / evenEdge;
		for (float& edge : found.edge)
			edge /= evenEdge;
		return std::move(found.edge);
	}
	float epsilon = 0; ///< of the last search, over `even`
};

Vec3d placeOf(const Surface& surface, int v)
{
	return surface.frame.toCaller(surface.mesh.position[v]);
}

/// A sheet, flat up to x = 0.5, with an arch behind a break.
TriangleMesh sheetWithArch(int n)
{
	TriangleMesh mesh = grid(n, n);
	for (Vec3d& p : mesh.positions)
		p.z = p.x > 0.5 ? 0.3 * std::sin(2 * pi * (p.x - 0.5)) : 0;
	return mesh;
}

TEST_F(ErrorSizesTest, AreThoseOfEachSideOfAFeatureLine)
{
	const Surface       surface = surfaceOf(sheetWithArch(80), workers);
	const Buffer<float> across  = sizes(surface, 0.05);
	const Buffer<char>  lines   = edgesThatTurn(surface, 30);
	const Buffer<float> beside  = sizes(surface, 0.05, 2, lines);
	const Buffer<float> again   = sizes(surface, 0.05, 1, lines);
	float               least   = largest;
	for (int v = 0; v < surface.mesh.vertexNum; ++v) {
		EXPECT_EQ(beside[v], again[v]);
		const double x        = placeOf(surface, v).x;
		const bool   isOnLine = std::abs(x - 0.5) < 1e-6;
		EXPECT_TRUE(!isOnLine || beside[v] > 1.4f * across[v]);
		if (x > 0.7 && x < 0.8) least = std::min(least, beside[v]);
		EXPECT_TRUE(x >= 0.45 || beside[v] > 0.95f * largest);
	}
	EXPECT_LT(least, 0.95f * largest);
}

TEST_F(ErrorSizesTest, AreTheLargestOnAPlane)
{
	const Surface flat = surfaceOf(grid(60, 60), workers);
	for (float size : sizes(flat, 0.06))
		EXPECT_EQ(size, largest);
}

/// Rounding of coordinates is no reason for small triangles, even on an otherwise flat surface.
TEST_F(ErrorSizesTest, AreTheLargestWhereAPlaneHasAStepOfRounding)
{
	TriangleMesh plane = grid(60, 60);
	for (Vec3d& p : plane.positions)
		p.z = p.x > 0.5 ? 1e-6 : 0;
	for (float size : sizes(surfaceOf(plane, workers), 0.06))
		EXPECT_EQ(size, largest);
}

/// Two planes with a common edge: the bend is narrower than any triangle.
TEST_F(ErrorSizesTest, AreSmallAtARidgeAndTheLargestFarFromIt)
{
	const Surface       roof = surfaceOf(bentSheet(80, 1.2), workers);
	const Buffer<float> size = sizes(roof, 0.05);
	for (int v = 0; v < roof.mesh.vertexNum; ++v) {
		const double fromRidge = std::abs(placeOf(roof, v).x - 0.5);
		if (fromRidge < 1e-6) {
			EXPECT_LT(size[v], 0.75f);
		}
		if (fromRidge > 0.3) {
			EXPECT_EQ(size[v], largest);
		}
	}
}

/// The other side of a thin plate is near, but linked to this side only round the rim.
TEST_F(ErrorSizesTest, OfAThinPlateAreSmallAtItsRimOnly)
{
	const Surface       plate = surfaceOf(thinPlate(60, 0.01), workers);
	const Buffer<float> size  = sizes(plate, 0.06);
	for (int v = 0; v < plate.mesh.vertexNum; ++v) {
		const Vec3d  p       = placeOf(plate, v);
		const double fromRim = std::min({p.x, p.y, 1 - p.x, 1 - p.y});
		if (fromRim < 1e-6) {
			EXPECT_LT(size[v], 0.9f);
		}
		if (fromRim > 0.4) {
			EXPECT_EQ(size[v], largest);
		}
	}
}

TEST_F(ErrorSizesTest, MakeAsManyTrianglesAsEvenOnes)
{
	TriangleMesh egg = icosphere(6);
	for (Vec3d& p : egg.positions)
		p.z *= 3;
	const Surface       surface = surfaceOf(egg, workers);
	const Buffer<float> size    = sizes(surface, 0.25);
	double              more = 0, area = 0;
	for (int v = 0; v < surface.mesh.vertexNum; ++v) {
		double ring = 0;
		forEachFaceRound(surface.mesh, v, [&](int, const Float4& a, const Float4& b) {
			ring += double(length(cross(a, b)));
		});
		area += ring;
		more += ring / double(size[v] * size[v]);
	}
	EXPECT_NEAR(more / area, 1, 0.03);
}

TEST_F(ErrorSizesTest, GrowNoFasterThanTheirSlope)
{
	const Surface       roof = surfaceOf(bentSheet(80, 1.2), workers);
	const Buffer<float> size = sizes(roof, 0.05);
	const float         even = float(0.05 * roof.frame.scale);
	const HalfEdgeMesh& m    = roof.mesh;
	for (int h = 0; h < m.halfEdgeNum(); ++h) {
		const int   a = m.origin[h], b = m.target(h);
		const float most = slope * length(m.position[a] - m.position[b]) / even;
		EXPECT_LE(size[b] - size[a], most + 0.002f * largest);
	}
}

/// Edges across the circle of a disk are cut at the circle: long edges show as much of a ridge as
/// short edges.
TEST_F(ErrorSizesTest, AreTheSameHoweverLongTheEdgesAre)
{
	const TriangleMesh  coarse = bentSheet(20, 1.2); // as long as edges of the result
	const Surface       few    = surfaceOf(coarse, workers);
	const Surface       many   = surfaceOf(subdivided(subdivided(coarse)), workers);
	const Buffer<float> a = sizes(few, 0.05), b = sizes(many, 0.05);
	const auto          atRidge = [](const Surface& surface, const Buffer<float>& size) {
        float least = largest;
        for (int v = 0; v < surface.mesh.vertexNum; ++v)
            least = std::min(least, size[v]);
        return least;
	};
	EXPECT_NEAR(atRidge(few, a), atRidge(many, b), 0.1);
}

/// The noise of a scan is no reason for small triangles, not even if a ridge needs few vertices.
TEST_F(ErrorSizesTest, LeaveNoiseAlone)
{
	for (const double noise : {0.05, 0.1, 0.2}) {
		Random       random(3);
		TriangleMesh roof = bentSheet(100, 1.2);
		const double even = 0.04;
		for (Vec3d& p : roof.positions)
			p.z += noise * even * (2 * random.unit() - 1);
		const Surface       surface = surfaceOf(roof, workers);
		const Buffer<float> size    = sizes(surface, even);
		int                 farNum = 0, smallNum = 0;
		for (int v = 0; v < surface.mesh.vertexNum; ++v) {
			if (std::abs(placeOf(surface, v).x - 0.5) < 0.2) continue;
			++farNum;
			smallNum += size[v] < 0.99f * largest;
		}
		EXPECT_LT(smallNum, 0.02 * farNum) << "noise " << noise;
	}
}

TEST_F(ErrorSizesTest, AreTheSameBitsForAnyNumberOfThreads)
{
	const Surface       ring = surfaceOf(torus(300, 120, 1, 0.2), workers);
	const Buffer<float> one  = sizes(ring, 0.15, 1);
	for (int threads : {2, 3}) {
		const Buffer<float> more = sizes(ring, 0.15, threads);
		EXPECT_TRUE(std::equal(one.begin(), one.end(), more.begin()));
	}
}

TEST(SizeGrading, LowersARampRoundASmallSize)
{
	Workers          workers(2, nullptr);
	const Surface    flat = surfaceOf(grid(40, 40), workers);
	Buffer<float>    size(flat.mesh.vertexNum, 1.0f);
	const int        middle = flat.mesh.vertexNum / 2;
	std::vector<int> small{middle};
	size[middle] = 0.1f;
	gradeSizes(flat.mesh, 2.0f, workers, small, size);
	std::vector<int> lowered;
	for (int v = 0; v < flat.mesh.vertexNum; ++v) {
		const float straight = length(flat.mesh.position[v] - flat.mesh.position[middle]);
		EXPECT_GE(size[v], std::min(1.0f, 0.1f + 2 * straight) - 0.002f);
		// Along the edges of a grid a way is at most so much longer.
		EXPECT_LE(size[v], std::min(1.0f, 0.1f + 2 * 1.5f * straight) + 0.002f);
		if (size[v] < 1) lowered.push_back(v);
	}
	std::sort(small.begin(), small.end());
	EXPECT_EQ(small, lowered);
}

/// Sizes lowered edge by edge until nothing changes.
void gradeSlowly(const HalfEdgeMesh& m, float steepest, Buffer<float>& size)
{
	for (bool changed = true; changed;) {
		changed = false;
		for (int h = 0; h < m.halfEdgeNum(); ++h) {
			const int   a = m.origin[h], b = m.target(h);
			const float bound = size[a] + steepest * length(m.position[b] - m.position[a]);
			if (!(bound < size[b])) continue;
			size[b] = bound;
			changed = true;
		}
	}
}

TEST(SizeGrading, EndsWhereTheSlowWayEndsBitForBit)
{
	// Many times as many vertices as the grading takes together.
	Workers             one(1, nullptr);
	const Surface       ring = surfaceOf(torus(300, 120, 1, 0.2), one);
	const HalfEdgeMesh& m    = ring.mesh;
	Buffer<float>       expected(m.vertexNum, 1.0f);
	std::vector<int>    seeds;
	for (int v = 0; v < m.vertexNum; v += 1777) {
		expected[v] = 0.05f + 0.1f * float(v % 7);
		seeds.push_back(v);
	}
	Buffer<float> start(m.vertexNum);
	std::copy(expected.begin(), expected.end(), start.begin());
	gradeSlowly(m, 0.5f, expected);
	std::vector<int> loweredByOne;
	for (int threads : {1, 2, 3}) {
		Workers       workers(threads, nullptr);
		Buffer<float> size(m.vertexNum);
		std::copy(start.begin(), start.end(), size.begin());
		std::vector<int> small = seeds;
		gradeSizes(m, 0.5f, workers, small, size);
		EXPECT_TRUE(std::equal(expected.begin(), expected.end(), size.begin()));
		if (threads == 1) loweredByOne = small;
		EXPECT_EQ(small, loweredByOne);
	}
}

} // namespace

} // namespace gpr::test
