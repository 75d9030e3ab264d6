// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// BoundaryMode::Smooth makes ragged borders smooth, and keeps all other promises.

#include <tests/support/mesh_audit.h>
#include <tests/support/mesh_builders.h>
#include <tests/support/oracles.h>
#include <vcg_extras/core/remesh.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <gtest/gtest.h>

namespace gpr::test {

namespace {

RemeshOptions smoothOptions(double percent, int threads = 2)
{
	RemeshOptions options;
	options.targetPercent = percent;
	options.threads       = threads;
	options.boundary      = BoundaryMode::Smooth;
	options.check         = true;
	return options;
}

/// A disk of radius 30 with a hole, and a rim that is ragged by `teeth` cells. The spike to the
/// right is two cells wide and reaches to x = 88. The bay from the left is a cell wide.
TriangleMesh raggedDisk(int teeth, bool hasSpikeAndBay)
{
	Random              random(7);
	std::vector<double> rim;
	for (int i = 0; i < 90; ++i)
		rim.push_back(30 - (teeth > 0 ? random.below(teeth + 1) : 0));
	return gridWhere(90, 90, [&](int i, int j) {
		const double x = i - 41.5, y = j - 44.5;
		const double r      = std::hypot(x, y);
		const double turn   = std::atan2(y, x) / (2 * 3.14159265358979323846) + 0.5;
		const bool   isBay  = hasSpikeAndBay && j == 44 && x < -15;
		const bool   isHole = std::hypot(x, y - 10) < 5;
		if (hasSpikeAndBay && x > 0 && i < 88 && (j == 44 || j == 45)) return true;
		return r < rim[std::size_t(turn * 89)] && !isBay && !isHole;
	});
}

double wantedEdge(const RemeshResult& r)
{
	return std::sqrt(2 * r.report.cleanedInput.area /
					 (std::sqrt(3.0) * double(r.mesh.vertexNum())));
}

/// Largest distance from a vertex of the result's border to the input's border.
double farthestOffBorder(const TriangleMesh& input, const TriangleMesh& result)
{
	const std::vector<Vec3d> border   = rimSegments(input);
	double                   farthest = 0;
	for (const Vec3d& p : rimSegments(result)) {
		double nearest = HUGE_VAL;
		for (std::size_t s = 0; s < border.size(); s += 2)
			nearest = std::min(nearest, distanceToSegment(p, border[s], border[s + 1]));
		farthest = std::max(farthest, nearest);
	}
	return farthest;
}

bool sameBytes(const RemeshResult& a, const RemeshResult& b)
{
	return a.mesh.triangles == b.mesh.triangles &&
		   a.mesh.positions.size() == b.mesh.positions.size() &&
		   std::memcmp(a.mesh.positions.data(), b.mesh.positions.data(),
					   a.mesh.positions.size() * sizeof(Vec3d)) == 0;
}

TEST(SmoothBorder, RaggedBordersGetGoodTriangles)
{
	const TriangleMesh mesh    = raggedDisk(2, true);
	RemeshOptions      options = smoothOptions(10);
	const RemeshResult r       = remesh(mesh.view(), options);
	ASSERT_EQ(r.status, Status::Ok) << r.message;
	EXPECT_TRUE(isSoundSurface(r.mesh));
	EXPECT_TRUE(hasSameTopology(mesh, r.mesh));
	EXPECT_EQ(r.mesh.vertexNum(), std::size_t(std::lround(0.1 * double(mesh.vertexNum()))));
	options.boundary            = BoundaryMode::Resample;
	const RemeshResult ordinary = remesh(mesh.view(), options);
	ASSERT_EQ(ordinary.status, Status::Ok) << ordinary.message;
	EXPECT_LE(r.report.quality.below30Percent, 0.3);
	EXPECT_GT(ordinary.report.quality.below30Percent, 1);
	EXPECT_GT(r.report.quality.radiusRatioMean, ordinary.report.quality.radiusRatioMean + 0.01);
}

TEST(SmoothBorder, ItsVerticesStayWithinHalfAnEdgeOfTheBorder)
{
	const TriangleMesh mesh = raggedDisk(1, false);
	for (Preset preset : {Preset::Default, Preset::Fast}) {
		for (double share : {2.0, 4.0}) {
			RemeshOptions options = smoothOptions(share);
			options.preset        = preset;
			const RemeshResult r  = remesh(mesh.view(), options);
			ASSERT_EQ(r.status, Status::Ok) << r.message;
			const double far = farthestOffBorder(mesh, r.mesh);
			EXPECT_LT(far, 0.5 * wantedEdge(r)) << share;
			EXPECT_GT(far, 0.05 * wantedEdge(r)) << share;
		}
	}
}

TEST(SmoothBorder, TheReportTellsWhatIsLost)
{
	const TriangleMesh mesh = raggedDisk(0, true);
	const RemeshResult r    = remesh(mesh.view(), smoothOptions(10));
	ASSERT_EQ(r.status, Status::Ok) << r.message;
	const BorderFigures& b = r.report.border;
	EXPECT_TRUE(b.isSmooth());
	const double length = double(factsOf(mesh).borderEdges); // all are sides of squares
	EXPECT_NEAR(b.length, length, 1e-3 * length);
	EXPECT_LT(b.resultLength, 0.85 * b.length);
	ASSERT_FALSE(r.notes.empty());
	EXPECT_NE(r.notes.back().find("The border is"), std::string::npos) << r.notes.back();

	const RemeshResult ordinary = remesh(mesh.view(), RemeshOptions());
	EXPECT_FALSE(ordinary.report.border.isSmooth());
}

TEST(SmoothBorder, ABorderThatIsSmoothStaysAsItIs)
{
	const TriangleMesh mesh = openCylinder(200, 60, 10, 20);
	const RemeshResult r    = remesh(mesh.view(), smoothOptions(5));
	ASSERT_EQ(r.status, Status::Ok) << r.message;
	EXPECT_LT(farthestOffBorder(mesh, r.mesh), 0.08 * wantedEdge(r));
}

TEST(SmoothBorder, AnyNumberOfThreadsGivesTheSameBytes)
{
	const TriangleMesh mesh = raggedDisk(3, true);
	const RemeshResult one  = remesh(mesh.view(), smoothOptions(15, 1));
	ASSERT_EQ(one.status, Status::Ok) << one.message;
	for (int threads : {2, 3, 4})
		EXPECT_TRUE(sameBytes(remesh(mesh.view(), smoothOptions(15, threads)), one)) << threads;
}

TEST(SmoothBorder, ClosedSurfacesComeOutAsByDefault)
{
	for (const TriangleMesh& mesh : {icosphere(4), cube(20)}) {
		RemeshOptions      options = smoothOptions(20);
		const RemeshResult r       = remesh(mesh.view(), options);
		options.boundary           = BoundaryMode::Resample;
		EXPECT_TRUE(sameBytes(remesh(mesh.view(), options), r));
		EXPECT_FALSE(r.report.border.isSmooth());
	}
}

/// Rings, bridges and strips narrower than an edge, and two parts with a common vertex.
TEST(SmoothBorder, NarrowPartsKeepTheTopology)
{
	const auto isInRing = [](int i, int j) {
		const double r = std::hypot(i - 29.5, j - 29.5);
		return r > 20 && r < 22.5;
	};
	const auto isInBridge = [](int i, int j) { return i < 20 || i >= 40 || (j >= 29 && j < 31); };
	const auto isInStrip  = [](int, int j) { return j % 20 < 2; };
	const auto isPinched  = [](int i, int j) { return (i < 30) == (j < 30); };
	for (const auto& keep :
		 {std::function<bool(int, int)>(isInRing), std::function<bool(int, int)>(isInBridge),
		  std::function<bool(int, int)>(isInStrip), std::function<bool(int, int)>(isPinched)}) {
		const TriangleMesh mesh = gridWhere(60, 60, keep);
		for (double share : {3.0, 6.0, 12.0, 40.0}) {
			RemeshOptions options = smoothOptions(share);
			options.check         = false; // sheets this narrow may cross themselves
			const RemeshResult r  = remesh(mesh.view(), options);
			ASSERT_EQ(r.status, Status::Ok) << r.message;
			EXPECT_TRUE(isSoundSurface(r.mesh));
			const SurfaceFacts facts = factsOf(r.mesh);
			EXPECT_EQ(facts.components, r.report.cleanedInput.components);
			EXPECT_EQ(facts.boundaryLoops,
					  factsOf(mesh).boundaryLoops + r.report.cleaned.nonManifoldVertices);
			EXPECT_EQ(facts.euler(), r.report.cleanedInput.eulerCharacteristic);
		}
	}
}

TEST(SmoothBorder, RandomSurfacesKeepTheirTopologyInEveryMode)
{
	for (std::uint32_t seed = 1; seed <= 12; ++seed) {
		SCOPED_TRACE(seed);
		Random             random(seed);
		const TriangleMesh mesh    = randomSurface(random);
		RemeshOptions      options = smoothOptions(25);
		options.check              = false;
		if (seed % 4 == 1) options.preset = Preset::Paper;
		if (seed % 4 == 2) options.preset = Preset::Fast;
		if (seed % 4 == 3) options.adapt = 1;
		const RemeshResult r = remesh(mesh.view(), options);
		ASSERT_EQ(r.status, Status::Ok) << r.message;
		EXPECT_TRUE(isSoundSurface(r.mesh));
		EXPECT_TRUE(hasSameTopology(mesh, r.mesh));
	}
}

TEST(SmoothBorder, AnEdgeLengthIsThatOfWhatIsLeft)
{
	RemeshOptions options = smoothOptions(10);
	options.targetMode    = TargetMode::EdgeLength;
	options.targetEdgeLen = 3;
	const RemeshResult r  = remesh(raggedDisk(2, true).view(), options);
	ASSERT_EQ(r.status, Status::Ok) << r.message;
	EXPECT_NEAR(r.report.quality.meanEdgeLen, 3, 0.1);
}

} // namespace

} // namespace gpr::test
