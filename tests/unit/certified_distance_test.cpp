// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Bounds of the Hausdorff distance against closed forms, and against many points of random meshes.

#include <tests/support/mesh_builders.h>
#include <tests/support/oracles.h>
#include <tests/support/random_source.h>
#include <tests/support/transforms.h>
#include <vcg_extras/core/mesh/measure.h>
#include <vcg_extras/core/surface/certified_distance.h>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace gpr::test {

namespace {

double diagonalOf(const TriangleMesh& mesh)
{
	return measureMesh(mesh.view()).diagonal;
}

MutualBounds boundsBetween(const TriangleMesh& input, const TriangleMesh& result,
						   const CertificateSettings& settings, Workers& workers)
{
	const MeasuredSurface ofInput(input.view(), workers), ofResult(result.view(), ofInput, workers);
	return certifiedDistances(ofInput, ofResult, settings, workers);
}

/// Bounds of the distance from the points of one mesh to another mesh.
DistanceBounds boundsOf(const TriangleMesh& from, const TriangleMesh& to, int threads = 2,
						std::int64_t budget = 4000000)
{
	Workers             workers(threads, nullptr);
	CertificateSettings settings = usualCertificate(diagonalOf(from));
	settings.budget              = budget;
	return boundsBetween(to, from, settings, workers).toInput;
}

/// Expects that the bounds hold the distance and are as close as promised.
void expectTight(const DistanceBounds& b, double distance, double diagonal)
{
	EXPECT_FALSE(b.isBudgetSpent);
	EXPECT_LE(b.lower, distance * (1 + 1e-12));
	EXPECT_GE(b.upper, distance * (1 - 1e-12));
	EXPECT_LE(b.upper, 1.01 * b.lower + 1e-5 * diagonal);
}

Vec3d somewhereOn(const TriangleMesh& mesh, Random& random)
{
	const auto* t = &mesh.triangles[3 * std::size_t(random.below(int(mesh.faceNum())))];
	double      u = random.unit(), v = random.unit();
	if (u + v > 1) {
		u = 1 - u;
		v = 1 - v;
	}
	const Vec3d a = mesh.positions[std::size_t(t[0])];
	return a + (mesh.positions[std::size_t(t[1])] - a) * u +
		   (mesh.positions[std::size_t(t[2])] - a) * v;
}

TriangleMesh tilted(TriangleMesh mesh, double slope)
{
	for (Vec3d& p : mesh.positions)
		p.z = slope * p.x;
	return mesh;
}

} // namespace

TEST(CertifiedDistance, OfParallelPlanesIsTheirGap)
{
	const TriangleMesh ground = grid(17, 19);
	for (const int cells : {1, 7, 60}) {
		const TriangleMesh above = shifted(grid(cells, cells), {0, 0, 0.25});
		expectTight(boundsOf(above, ground), 0.25, 1.5);
		expectTight(boundsOf(ground, above), 0.25, 1.5);
	}
}

/// For planes with a partial overlap, the border is farthest: no cover exists there.
TEST(CertifiedDistance, BeyondABorderIsThatToTheBorder)
{
	const TriangleMesh ground = grid(9, 9), moved = shifted(grid(31, 31), {0.3, 0, 0.4});
	expectTight(boundsOf(moved, ground), 0.5, 1.5);
	expectTight(boundsOf(ground, moved), 0.5, 1.5);
}

TEST(CertifiedDistance, OfARampIsThatOfItsEnd)
{
	expectTight(boundsOf(tilted(grid(40, 40), 0.1), grid(3, 3)), 0.1, 1.5);
	expectTight(boundsOf(grid(3, 3), tilted(grid(40, 40), 0.1)), 0.1 / std::sqrt(1.01), 1.5);
}

/// The icosahedron in the unit sphere: the middles of its faces are farthest.
TEST(CertifiedDistance, OfASphereAndAPolyhedron)
{
	const TriangleMesh   sphere = icosphere(6), solid = icosphere(0);
	const double         inradius = std::sqrt((5 + 2 * std::sqrt(5.0)) / 15);
	const DistanceBounds there = boundsOf(solid, sphere), back = boundsOf(sphere, solid);
	EXPECT_NEAR(there.lower, 1 - inradius, 0.003);
	EXPECT_NEAR(there.upper, 1 - inradius, 0.003);
	EXPECT_LE(there.upper, 1.01 * there.lower + 1e-5 * 3.5);
	EXPECT_NEAR(back.lower, 1 - inradius, 0.003);
	EXPECT_LE(back.upper, 1.01 * back.lower + 1e-5 * 3.5);
}

TEST(CertifiedDistance, OfOffsetMeshesIsTheOffset)
{
	for (const double radius : {1.001, 1.05, 1.5}) {
		// From a vertex straight to the vertex below; the faces are nearer.
		const DistanceBounds b = boundsOf(icosphere(4, radius), icosphere(4));
		expectTight(b, radius - 1, 3.5 * radius);
		const DistanceBounds coarse = boundsOf(icosphere(3, radius), icosphere(5));
		EXPECT_FALSE(coarse.isBudgetSpent);
		EXPECT_GE(coarse.upper, radius - 1);
		EXPECT_LE(coarse.upper, 1.01 * coarse.lower + 1e-5 * 3.5 * radius);
	}
}

TEST(CertifiedDistance, OfTheSameSurfaceIsNothing)
{
	Random random(5);
	for (const TriangleMesh& mesh : {noisySphere(4, 0.1, random), cube(12), torus(40, 20)}) {
		expectTight(boundsOf(mesh, mesh), 0, diagonalOf(mesh));
		expectTight(boundsOf(subdivided(mesh), mesh), 0, diagonalOf(mesh));
		expectTight(boundsOf(mesh, subdivided(mesh)), 0, diagonalOf(mesh));
		expectTight(boundsOf(mesh, soupOf(mesh, 0, random)), 0, diagonalOf(mesh));
	}
	expectTight(boundsOf(cube(9), cube(12)), 0, 2);
}

TEST(CertifiedDistance, HoldsWhatManyPointsShow)
{
	for (const std::uint32_t seed : testSeeds(60)) {
		SCOPED_TRACE("seed " + std::to_string(seed));
		Random             random(seed);
		const TriangleMesh a = randomSurface(random);
		TriangleMesh       b = random.chance(0.5) ? a : randomSurface(random);
		for (Vec3d& p : b.positions)
			p += Vec3d(random.between(-0.05, 0.05), random.between(-0.05, 0.05),
					   random.between(-0.05, 0.05));
		if (random.chance(0.3)) b = soupOf(b, 0, random);
		const DistanceBounds bounds = boundsOf(a, b);
		EXPECT_FALSE(bounds.isBudgetSpent);
		EXPECT_LE(bounds.upper, 1.01 * bounds.lower + 1e-5 * diagonalOf(a));
		double seen = 0;
		for (int i = 0; i < 2000; ++i)
			seen = std::max(seen, distanceToMesh(b, somewhereOn(a, random)));
		EXPECT_LE(seen, bounds.upper);
	}
}

/// The farthest point is known: the tip of a spike, or a plane's corner.
TEST(CertifiedDistance, LowerIsNoMoreThanTheTruth)
{
	for (const std::uint32_t seed : testSeeds(40)) {
		Random       random(seed);
		TriangleMesh rough = jitteredGrid(12, 0.3, random);
		for (Vec3d& p : rough.positions)
			p.z = random.between(-0.05, 0.05);
		const double height                        = random.between(0.1, 0.6);
		rough.positions[std::size_t(6 * 13 + 6)].z = height;
		const double       side                    = diagonalOf(rough);
		const TriangleMesh plane = shifted(grid(2, 2, 3 * side, 3 * side), {-side, -side, 0});
		expectTight(boundsOf(rough, plane), height, side);
	}
}

TEST(CertifiedDistance, AnOffsetCostsFewDigits)
{
	const Vec3d          far(1e6, -2e6, 3e6);
	const DistanceBounds b =
		boundsOf(shifted(grid(9, 9), far + Vec3d(0, 0, 1e-3)), shifted(grid(4, 4), far));
	EXPECT_NEAR(b.lower, 1e-3, 1e-6);
	EXPECT_NEAR(b.upper, 1e-3, 3e-5);
	EXPECT_LE(b.lower, 1e-3 + 1e-9);
	EXPECT_GE(b.upper, 1e-3 - 1e-9);
}

TEST(CertifiedDistance, TakesAnySetOfFaces)
{
	TriangleMesh wild = grid(3, 3);
	wild.positions.push_back({0.5, 0.5, 9});
	wild.positions.push_back({std::numeric_limits<double>::quiet_NaN(), 0, 0});
	// Three faces at an edge, a face with a corner that is not finite, a face with a corner twice.
	wild.triangles.insert(wild.triangles.end(), {0, 5, 16, 0, 1, 17, 1, 1, 2});
	expectTight(boundsOf(wild, grid(5, 5)), 9, 9.2);
	EXPECT_LE(boundsOf(shifted(grid(5, 5), {0, 0, 0.2}), wild).upper, 1.02 * 0.2);
	EXPECT_EQ(boundsOf(wild, TriangleMesh()).upper, 0);
	EXPECT_EQ(boundsOf(TriangleMesh(), wild).upper, 0);
	for (const TriangleMesh& mesh : {finsOnEdge(5), fansSharingVertex(4), kleinBottle(12, 9)})
		expectTight(boundsOf(mesh, mesh), 0, diagonalOf(mesh));
}

TEST(CertifiedDistance, SameBitsForAnyNumberOfThreads)
{
	Random               random(7);
	const TriangleMesh   a = noisySphere(5, 0.1, random), b = torus(90, 40);
	const DistanceBounds one = boundsOf(a, b, 1);
	for (const int threads : {2, 3}) {
		const DistanceBounds more = boundsOf(a, b, threads);
		EXPECT_EQ(one.lower, more.lower);
		EXPECT_EQ(one.upper, more.upper);
	}
}

/// The budget bounds the work; the bounds hold, are wider, and say so.
TEST(CertifiedDistance, SaysWhereTheBudgetIsSpent)
{
	Random               random(8);
	const TriangleMesh   a = noisySphere(3, 0.3, random), b = icosphere(1);
	const DistanceBounds full = boundsOf(a, b);
	ASSERT_FALSE(full.isBudgetSpent);
	double width = HUGE_VAL;
	for (const std::int64_t budget : {0, 10}) {
		const DistanceBounds spent = boundsOf(b, a, 2, budget);
		EXPECT_TRUE(spent.isBudgetSpent);
		const DistanceBounds enough = boundsOf(b, a);
		EXPECT_FALSE(enough.isBudgetSpent);
		EXPECT_LE(spent.lower, enough.upper);
		EXPECT_GE(spent.upper, enough.lower);
		EXPECT_GT(spent.upper, 1.01 * spent.lower + 1e-5 * diagonalOf(b));
		EXPECT_LE(spent.upper - spent.lower, width);
		width = spent.upper - spent.lower;
	}
}

TEST(CertifiedDistance, BothWaysGiveTheHausdorffDistance)
{
	Workers            workers(2, nullptr);
	const TriangleMesh whole = grid(20, 20), part = grid(10, 20, 0.5, 1);
	const MutualBounds b = boundsBetween(whole, part, usualCertificate(1.4), workers);
	EXPECT_LE(b.toInput.upper, 2e-5);
	expectTight(b.fromInput, 0.5, 1.4);
	EXPECT_EQ(b.hausdorff().upper, b.fromInput.upper);
	EXPECT_EQ(b.hausdorff().lower, b.fromInput.lower);
	EXPECT_EQ(b.times(2).hausdorff().upper, 2 * b.fromInput.upper);
}

/// As a certificate for an error bound that the distance just keeps.
TEST(CertifiedDistance, ProvesAWantedBoundHoweverClose)
{
	Workers      workers(2, nullptr);
	Random       random(1);
	TriangleMesh rough = grid(12, 12), fine = grid(17, 17);
	for (TriangleMesh* mesh : {&rough, &fine}) {
		for (Vec3d& p : mesh->positions)
			p.z = random.between(0, 0.2);
	}
	const auto boundsWith = [&](double relative, double wanted) {
		CertificateSettings settings;
		settings.relative = relative;
		settings.absolute = 1e-6;
		settings.wanted   = wanted;
		return boundsBetween(fine, rough, settings, workers).fromInput;
	};
	const double distance = boundsWith(1e-3, 0).upper, wanted = 1.0005 * distance;
	ASSERT_GT(boundsWith(0.2, 0).upper, wanted) << "the usual bound is too wide";
	EXPECT_LE(boundsWith(0.2, wanted).upper, wanted);
	// A bound that the distance does not keep changes nothing.
	EXPECT_EQ(boundsWith(0.2, 0.5 * distance).upper, boundsWith(0.2, 0).upper);
}

/// A bump in a plane: the places are in triangles of the bump, none nearer than the limit.
TEST(PlacesBeyond, AreTheTrianglesThatAreTooFar)
{
	TriangleMesh bump = grid(30, 30);
	for (Vec3d& p : bump.positions)
		p.z = std::max(0.0, 0.1 - length(p - Vec3d(0.7, 0.4, 0)));
	Workers                     workers(2, nullptr);
	const MeasuredSurface       from(bump.view(), workers), to(grid(4, 4).view(), from, workers);
	const std::vector<FarPlace> places = placesBeyond(from, to, 0.05, workers);
	ASSERT_FALSE(places.empty());
	double area = 0;
	for (const FarPlace& p : places) {
		EXPECT_GT(p.distance, 0.05);
		EXPECT_NEAR(p.position.z, p.distance, 1e-9);
		EXPECT_LT(length(p.position - Vec3d(0.7, 0.4, p.position.z)), 0.051);
		area += p.area;
	}
	EXPECT_GT(area, 3.14 * 0.05 * 0.05);
	EXPECT_TRUE(placesBeyond(from, to, 0.11, workers).empty());
}

TEST(PlacesBeyond, AreOnlyThoseInTheRegions)
{
	TriangleMesh bumps = grid(40, 40);
	for (Vec3d& p : bumps.positions) {
		const double near =
			std::min(length(p - Vec3d(0.2, 0.2, 0)), length(p - Vec3d(0.8, 0.7, 0)));
		p.z = 5 + std::max(0.0, 0.1 - near); // the origin of the tree is elsewhere
	}
	Workers               workers(2, nullptr);
	const MeasuredSurface from(bumps.view(), workers);
	const MeasuredSurface to(shifted(grid(4, 4), {0, 0, 5}).view(), from, workers);
	const auto            all = placesBeyond(from, to, 0.05, workers);
	const auto some = placesBeyond(from, to, 0.05, workers, {{{0.1, 0.1, 4}, {0.3, 0.3, 6}}});
	EXPECT_EQ(2 * some.size(), all.size());
	for (const FarPlace& p : some)
		EXPECT_LT(p.position.x, 0.5);
}

/// A large triangle over a thin peak, which lies between the corners and middles of the triangle.
TEST(PlacesBeyond, AreFoundBetweenThePointsThatAreLookedAtFirst)
{
	TriangleMesh peak = grid(60, 60);
	for (Vec3d& p : peak.positions)
		p.z = -std::max(0.0, 0.1 - 2 * length(p - Vec3d(0.55, 0.15, 0)));
	Workers                     workers(2, nullptr);
	const MeasuredSurface       from(grid(3, 3).view(), workers), to(peak.view(), from, workers);
	const std::vector<FarPlace> places = placesBeyond(from, to, 0.03, workers);
	ASSERT_FALSE(places.empty());
	for (const FarPlace& p : places) {
		EXPECT_GT(p.distance, 0.03);
		EXPECT_LT(length(p.position - Vec3d(0.55, 0.15, 0)), 0.05);
	}
	EXPECT_TRUE(placesBeyond(from, to, 0.06, workers).empty());
}

} // namespace gpr::test
