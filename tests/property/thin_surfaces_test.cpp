// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Whole runs on tubes and walls thinner than the triangles of the result are wide: the result does
// not intersect itself and has the exact count.

#include <tests/support/mesh_audit.h>
#include <tests/support/mesh_builders.h>
#include <tests/support/stages.h>
#include <tests/support/transforms.h>
#include <vcg_extras/core/mesh/face_contact.h>
#include <vcg_extras/core/remesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>

namespace gpr::test {

namespace {

/// A closed curve with random waves.
struct RandomLoop {
	double amplitude[3], phase[3];

	explicit RandomLoop(Random& random)
	{
		for (int i = 0; i < 3; ++i) {
			amplitude[i] = random.between(0.05, 0.25);
			phase[i]     = random.between(0, 2 * pi);
		}
	}

	Vec3d at(double t) const
	{
		const double r = 1 + amplitude[0] * std::sin(2 * t + phase[0]);
		return {r * std::cos(t), r * std::sin(t),
				amplitude[1] * std::sin(3 * t + phase[1]) + amplitude[2] * std::sin(t + phase[2])};
	}
};

/// The torus bent along a loop: its thickness stays.
TriangleMesh tubeAlong(const RandomLoop& loop, double radius)
{
	TriangleMesh tube = torus(160, 14, 1, radius);
	for (Vec3d& p : tube.positions) {
		const double t    = std::atan2(p.y, p.x);
		const Vec3d  way  = normalized(loop.at(t + 1e-4) - loop.at(t - 1e-4));
		const Vec3d  side = normalized(cross(way, Vec3d(0, 0, 1))), up = cross(side, way);
		p = loop.at(t) + side * (std::hypot(p.x, p.y) - 1) + up * p.z;
	}
	return tube;
}

/// A pipe along a random loop.
TriangleMesh randomPipe(Random& random)
{
	const RandomLoop loop(random);
	const double     radius = random.between(0.03, 0.06);
	return joined(tubeAlong(loop, radius), insideOut(tubeAlong(loop, 0.8 * radius)));
}

/// A thin plate, bent about an axis.
TriangleMesh randomBentPlate(Random& random)
{
	TriangleMesh plate = thinPlate(40, random.between(0.002, 0.006));
	const double bend  = random.between(0.5, 1.5);
	for (Vec3d& p : plate.positions) {
		const double angle = bend * p.x, r = 1 / bend + p.z;
		p = {r * std::sin(angle), p.y, r * std::cos(angle)};
	}
	return plate;
}

std::size_t contactNum(const TriangleMesh& mesh)
{
	Workers workers(2, nullptr);
	return findTouchingPairs(halfEdgesOf(mesh), workers).size();
}

RemeshOptions optionsFor(int vertexNum, bool guard)
{
	RemeshOptions options;
	options.targetMode      = TargetMode::VertexNum;
	options.targetVertexNum = vertexNum;
	options.threads         = 2;
	options.guard           = guard;
	return options;
}

/// Returns the number of contacts in a run without the guard.
std::size_t expectNoContacts(const TriangleMesh& mesh, int vertexNum, double adapt,
							 const TriangleMesh& repaired)
{
	RemeshOptions options = optionsFor(vertexNum, true);
	options.adapt         = adapt;
	const RemeshResult r  = remesh(mesh.view(), options);
	EXPECT_EQ(r.status, Status::Ok) << r.message;
	if (r.status != Status::Ok) return 0;
	EXPECT_EQ(int(r.mesh.vertexNum()), vertexNum);
	EXPECT_EQ(contactNum(r.mesh), 0u);
	EXPECT_TRUE(isSoundSurface(r.mesh));
	EXPECT_TRUE(hasSameTopology(repaired, r.mesh));
	const GuardedFigures& figures = r.report.audit.guarded;
	EXPECT_TRUE(figures.isTested);
	EXPECT_EQ(figures.pairNum, 0);
	EXPECT_TRUE(figures.vertexNum == 0 || figures.foundPairNum > 0);
	return std::size_t(figures.foundPairNum);
}

} // namespace

TEST(ThinSurfaces, DoNotIntersectThemselves)
{
	std::size_t found = 0;
	for (const std::uint32_t seed : {1u, 2u, 3u, 4u}) {
		Random             random(seed);
		const TriangleMesh pipe = randomPipe(random), plate = randomBentPlate(random);
		ASSERT_EQ(contactNum(pipe) + contactNum(plate), 0u);
		SCOPED_TRACE(seed);
		for (const double adapt : {0.0, 1.0}) {
			found += expectNoContacts(pipe, 150, adapt, pipe);
			found += expectNoContacts(plate, 120, adapt, plate);
		}
	}
	EXPECT_GT(found, 0u) << "or nothing here needs the guard";
}

/// Two spheres with a common vertex.
TriangleMesh spheresAtAVertex()
{
	TriangleMesh sphere = icosphere(4);
	const Vec3d  at     = sphere.positions[0];
	const int    num    = int(sphere.positions.size());
	TriangleMesh both   = sphere;
	for (const Vec3d& p : sphere.positions)
		both.positions.push_back(at + at - p);
	for (std::size_t c = 0; c < sphere.triangles.size(); c += 3) {
		const auto other = [&](std::size_t k) {
			const std::int32_t v = sphere.triangles[c + k];
			return v == 0 ? 0 : v + num;
		};
		both.triangles.insert(both.triangles.end(), {other(0), other(2), other(1)});
	}
	return both;
}

TEST(ThinSurfaces, ThatMeetAtAVertexDoNotIntersectThemselves)
{
	const TriangleMesh spheres = spheresAtAVertex();
	std::int64_t       found   = 0;
	for (const int vertexNum : {40, 200, 500, 1500}) {
		SCOPED_TRACE(vertexNum);
		const RemeshResult r = remesh(spheres.view(), optionsFor(vertexNum, true));
		ASSERT_EQ(r.status, Status::Ok) << r.message;
		EXPECT_EQ(int(r.mesh.vertexNum()), vertexNum);
		EXPECT_EQ(contactNum(r.mesh), 0u);
		EXPECT_EQ(r.report.audit.guarded.pairNum, 0);
		EXPECT_EQ(r.report.audit.guarded.inputFaceNum, 0);
		found += r.report.audit.guarded.foundPairNum;
	}
	EXPECT_GT(found, 0) << "or nothing here needs the guard";
}

/// A wavy sheet with random pairs of holes that meet at corners.
TriangleMesh sheetWithPairsOfHoles(Random& random)
{
	constexpr int                   n = 80, apart = 4;
	std::vector<std::array<int, 2>> corners; // cells of the first holes
	for (int i = 0; i < 60; ++i) {
		const std::array<int, 2> at = {2 + random.below(n - 5), 2 + random.below(n - 5)};
		const bool isFree = std::none_of(corners.begin(), corners.end(), [&](const auto& c) {
			return std::abs(c[0] - at[0]) < apart && std::abs(c[1] - at[1]) < apart;
		});
		if (isFree) corners.push_back(at);
	}
	TriangleMesh sheet = gridWhere(n, 8, [&](int i, int j) {
		return std::none_of(corners.begin(), corners.end(), [&](const auto& c) {
			return (i == c[0] && j == c[1]) || (i == c[0] + 1 && j == c[1] + 1);
		});
	});
	for (Vec3d& p : sheet.positions)
		p.z = 0.1 * std::sin(2 * p.x) * std::cos(1.7 * p.y);
	return sheet;
}

TEST(ThinSurfaces, WithHolesThatMeetAtCornersDoNotIntersectThemselves)
{
	RemeshOptions options = optionsFor(0, true);
	options.targetMode    = TargetMode::Percent;
	std::int64_t found    = 0;
	for (const std::uint32_t seed : {1u, 2u, 3u}) {
		Random             random(seed);
		const TriangleMesh sheet = sheetWithPairsOfHoles(random);
		for (const double percent : {1.0, 10.0}) {
			SCOPED_TRACE(percent);
			options.targetPercent = percent;
			const RemeshResult r  = remesh(sheet.view(), options);
			ASSERT_EQ(r.status, Status::Ok) << r.message;
			EXPECT_EQ(contactNum(r.mesh), 0u);
			EXPECT_EQ(r.report.audit.guarded.inputFaceNum, 0);
			found += r.report.audit.guarded.foundPairNum;
		}
	}
	EXPECT_GT(found, 0) << "or nothing here needs the guard";
}

TEST(ThinSurfaces, AreLeftAsTheyAreWithoutTheGuard)
{
	Random                random(1);
	const TriangleMesh    pipe    = randomPipe(random);
	const RemeshResult    r       = remesh(pipe.view(), optionsFor(150, false));
	const GuardedFigures& figures = r.report.audit.guarded;
	ASSERT_EQ(r.status, Status::Ok);
	EXPECT_FALSE(figures.isTested);
	EXPECT_EQ(figures.vertexNum, 0);
	EXPECT_GT(contactNum(r.mesh), 0u);
}

/// CAD programs leave such slits at ends of strips without width. The whole surface is made anew.
TEST(ThinSurfaces, WithAHoleThatHasNoAreaAreNotWithheld)
{
	Random             random(1);
	const TriangleMesh pipe = randomPipe(random);
	expectNoContacts(withSlit(pipe, 700), 150, 0, pipe);
}

/// Faces with corners in a line, as after a split of an edge in only one of its faces.
TriangleMesh withFlatFaces(TriangleMesh mesh, int num, Random& random)
{
	for (int i = 0; i < num; ++i)
		mesh = withFlatFace(mesh, std::size_t(random.below(int(mesh.triangles.size()))));
	return mesh;
}

/// With so many vertices the patches made anew lose few vertices of the input.
TEST(ThinSurfaces, WithFacesThatHaveNoAreaAreNotWithheld)
{
	const TriangleMesh pipe = joined(torus(30, 8, 1, 0.05), insideOut(torus(30, 8, 1, 0.04)));
	for (const std::uint32_t seed : testSeeds(6)) {
		SCOPED_TRACE("seed " + std::to_string(seed));
		Random             random(seed);
		const TriangleMesh mesh = withFlatFaces(pipe, 8, random);
		const RemeshResult r    = remesh(mesh.view(), optionsFor(438, true));
		ASSERT_EQ(r.status, Status::Ok) << r.message;
		EXPECT_TRUE(isSoundSurface(r.mesh));
		EXPECT_TRUE(hasSameTopology(pipe, r.mesh));
		EXPECT_EQ(r.mesh.vertexNum(), 438u);
		EXPECT_GT(r.report.audit.guarded.vertexNum, 0) << "or nothing here needs the guard";
	}
}

/// Two bulbs joined by a tube.
TriangleMesh dumbbell(double tubeRadius, double bulbRadius, double length)
{
	TriangleMesh mesh = closedCylinder(48, 200, 1, 4);
	for (Vec3d& p : mesh.positions) {
		const double way = std::max(0.0, std::abs(p.z - 2) - 0.4); // from the end of the tube
		const double r   = tubeRadius + bulbRadius * (1 - std::exp(-way * way));
		p                = {p.x * r, p.y * r, (p.z - 2) * length};
	}
	return mesh;
}

/// A dumbbell in another: the walls of the tubes are nearer to each other than an edge.
TriangleMesh dumbbells()
{
	return joined(dumbbell(0.02, 0.7, 1), insideOut(dumbbell(0.016, 0.28, 0.9)));
}

/// Only faces near the intersections are made anew; the other faces keep their triangles.
TEST(ThinSurfaces, LeaveWhatIsFarFromThemAsItIs)
{
	const TriangleMesh mesh    = dumbbells();
	const RemeshResult guarded = remesh(mesh.view(), optionsFor(600, true));
	const RemeshResult plain   = remesh(mesh.view(), optionsFor(600, false));
	ASSERT_EQ(guarded.status, Status::Ok) << guarded.message;
	ASSERT_EQ(plain.status, Status::Ok) << plain.message;
	EXPECT_GT(contactNum(plain.mesh), 0u);
	EXPECT_EQ(contactNum(guarded.mesh), 0u);
	EXPECT_EQ(guarded.mesh.vertexNum(), 600u);
	EXPECT_LT(guarded.report.audit.guarded.vertexNum, 150);
	EXPECT_GT(guarded.report.quality.radiusRatioMean, plain.report.quality.radiusRatioMean - 0.06);
	const auto  isFar = [](const Vec3d& p) { return std::abs(p.z) > 1.6; };
	std::size_t num   = 0;
	for (const Vec3d& p : plain.mesh.positions) {
		if (!isFar(p)) continue;
		++num;
		EXPECT_NE(std::find(guarded.mesh.positions.begin(), guarded.mesh.positions.end(), p),
				  guarded.mesh.positions.end());
	}
	EXPECT_GT(num, 100u);
}

TEST(ThinSurfaces, HaveTheSameBytesWithAnyNumberOfThreads)
{
	const TriangleMesh mesh    = dumbbells();
	RemeshOptions      options = optionsFor(600, true);
	const RemeshResult two     = remesh(mesh.view(), options);
	options.threads            = 1;
	const RemeshResult one     = remesh(mesh.view(), options);
	ASSERT_GT(one.report.audit.guarded.vertexNum, 0);
	EXPECT_EQ(one.mesh.positions, two.mesh.positions);
	EXPECT_EQ(one.mesh.triangles, two.mesh.triangles);
}

/// Only the component with self-intersections is made anew.
TEST(ThinSurfaces, LeaveOtherComponentsRegular)
{
	Random             random(1);
	const TriangleMesh pipe = randomPipe(random);
	const TriangleMesh both = joined(pipe, shifted(icosphere(4, 0.5), {5, 0, 0}));
	const RemeshResult r    = remesh(both.view(), optionsFor(600, true));
	ASSERT_EQ(r.status, Status::Ok) << r.message;
	EXPECT_EQ(contactNum(r.mesh), 0u);
	const std::int64_t madeNum = r.report.audit.guarded.vertexNum;
	ASSERT_GT(r.report.audit.guarded.foundPairNum, 0);
	std::int64_t ofPipe = 0;
	for (const Vec3d& p : r.mesh.positions)
		ofPipe += p.x < 3;
	EXPECT_GT(madeNum, 0);
	EXPECT_LE(madeNum, ofPipe);
	EXPECT_GT(std::int64_t(r.mesh.vertexNum()), ofPipe);
	EXPECT_EQ(int(r.mesh.vertexNum()), 600);
}

/// Specks just below a sphere lie above its wide triangles. Only the sphere near the specks is made
/// anew, together with the specks.
TEST(ThinSurfaces, AreNotMadeAnewWholeForSpecks)
{
	TriangleMesh mesh = icosphere(5);
	Random       random(1);
	for (int i = 0; i < 24; ++i) {
		const Vec3d at(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
		mesh = joined(mesh, shifted(icosphere(1, 0.003), normalized(at) * 0.9965));
	}
	ASSERT_EQ(contactNum(mesh), 0u);
	for (const bool guard : {false, true}) {
		const RemeshResult r = remesh(mesh.view(), optionsFor(400, guard));
		ASSERT_EQ(r.status, Status::Ok) << r.message;
		EXPECT_EQ(contactNum(r.mesh) == 0, guard);
		EXPECT_EQ(int(r.mesh.vertexNum()), 400);
		EXPECT_TRUE(hasSameTopology(mesh, r.mesh));
		EXPECT_LT(r.report.audit.guarded.vertexNum, 200);
	}
}

TEST(ThinSurfaces, OfAnInputThatIntersectsItselfAreNotRefused)
{
	const TriangleMesh both = joined(icosphere(4), shifted(icosphere(4), {1.2, 0.1, 0.05}));
	const RemeshResult r    = remesh(both.view(), optionsFor(300, true));
	ASSERT_EQ(r.status, Status::Ok) << r.message;
	EXPECT_GT(r.report.audit.guarded.inputFaceNum, 0);
	EXPECT_EQ(r.report.audit.guarded.vertexNum, 0) << "all pairs are the input's own";
}

/// The points on the input lie near the vertices, so attributes can be carried over.
TEST(ThinSurfaces, VerticesKnowWhereOnTheInputTheyLie)
{
	Random             random(2);
	const TriangleMesh pipe = randomPipe(random);
	const RemeshResult r    = remesh(pipe.view(), optionsFor(150, true));
	ASSERT_EQ(r.status, Status::Ok) << r.message;
	ASSERT_GT(r.report.audit.guarded.vertexNum, 0);
	ASSERT_EQ(r.surfacePoints.size(), r.mesh.vertexNum());
	for (std::size_t v = 0; v < r.surfacePoints.size(); ++v) {
		const BarycentricPoint& at = r.surfacePoints[v];
		Vec3d                   p;
		for (int k = 0; k < 3; ++k) {
			const std::size_t c = std::size_t(pipe.triangles[std::size_t(3 * at.face + k)]);
			p += pipe.positions[c] * double(at.weight[k]);
		}
		EXPECT_LE(length(p - r.mesh.positions[v]), 1e-4 + r.report.largestFitDistance);
	}
}

} // namespace gpr::test
