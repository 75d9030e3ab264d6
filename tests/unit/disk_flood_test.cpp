// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <tests/support/mesh_builders.h>
#include <tests/support/oracles.h>
#include <tests/support/stages.h>
#include <tests/support/transforms.h>
#include <vcg_extras/core/surface/disk_flood.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>

namespace gpr::test {

namespace {

using Distance = std::function<double(const Vec3d&, const Vec3d&)>;

/// A surface with a field on which nothing has been flooded yet.
class Flooded {
public:
	Workers      workers{1, nullptr};
	Surface      surface;
	NearestField field;

	explicit Flooded(const TriangleMesh& mesh) : surface(surfaceOf(mesh, workers))
	{
		field.nearest =
			Buffer<NearestField::Nearest>(std::size_t(surface.mesh.vertexNum), {HUGE_VALF, -1});
		field.mark = Buffer<NearestField::Mark>(std::size_t(surface.mesh.vertexNum), {0, 0});
	}

	float working(double callerLength) const { return float(callerLength * surface.frame.scale); }
	Vec3d place(int v) const { return surface.frame.toCaller(surface.mesh.position[v]); }
	int   vertexNearest(const Vec3d& p) const
	{
		int best = 0;
		for (int v = 1; v < surface.mesh.vertexNum; ++v) {
			if (length(place(v) - p) < length(place(best) - p)) best = v;
		}
		return best;
	}
	Sample sampleAt(int v) const
	{
		const int face = surface.mesh.outgoing[v] / 3;
		return {{surface.mesh.position[v], face}, surface.mesh.faceNormal(face)};
	}
	double distanceAt(int v) const
	{
		return double(field.nearest[v].distance) / surface.frame.scale;
	}

	/// Floods from the vertex nearest to p and holds every distance within r against the closed
	/// form.
	void expectDistances(const Vec3d& p, double r, const Distance& closedForm, double tolerance)
	{
		expectDistances(p, r, closedForm, tolerance, {surface.mesh, surface.normal});
	}
	void expectDistances(const Vec3d& p, double r, const Distance& closedForm, double tolerance,
						 const FloodGround& ground)
	{
		const int from = vertexNearest(p);
		DiskFlood flood(ground, field, working(r));
		flood.run(0, sampleAt(from));
		int inside = 0;
		for (int v = 0; v < surface.mesh.vertexNum; ++v) {
			const double d = closedForm(place(from), place(v));
			if (d < r * (1 - 2 * tolerance)) {
				++inside;
				ASSERT_EQ(field.nearest[v].sample, 0) << "at " << d;
				ASSERT_NEAR(distanceAt(v), d, tolerance * r);
			}
			else if (d > r * (1 + 2 * tolerance)) {
				ASSERT_TRUE(field.nearest[v].sample < 0 || distanceAt(v) > r) << "at " << d;
			}
		}
		EXPECT_GT(inside, 30) << "else nothing was tested";
	}
};

double onPlane(const Vec3d& a, const Vec3d& b)
{
	return length(a - b);
}

/// Only the packing of the normals in 32 bits makes errors.
TEST(DiskFlood, OnAPlaneIsTrueToThePackedNormals)
{
	Random random(1);
	for (const TriangleMesh& mesh : {grid(40, 40), jitteredGrid(40, 0.3, random)})
		Flooded(mesh).expectDistances({0.4, 0.45, 0}, 0.3, onPlane, 3e-4);
}

/// At right and obtuse angles, the triangle on the straight way is settled after the vertex at its
/// end; the vertex has to be visited again.
TEST(DiskFlood, UnfoldingFindsTheStraightWayAtObtuseAngles)
{
	Random random(1);
	for (const TriangleMesh& mesh : {grid(40, 40), jitteredGrid(40, 0.3, random)}) {
		Flooded      f(mesh);
		const Sample from = f.sampleAt(f.vertexNearest({0.4, 0.45, 0}));
		DiskFlood    flood(FloodGround{f.surface.mesh, f.surface.normal, nullptr, false}, f.field,
						   f.working(0.3));
		flood.run(0, from);
		const Vec3d start = f.surface.frame.toCaller(from.point.position);
		int         seen  = 0;
		for (int v = 0; v < f.surface.mesh.vertexNum; ++v) {
			const double d = length(f.place(v) - start);
			if (!(d > 0 && d < 0.27)) continue;
			ASSERT_NEAR(f.distanceAt(v) / d, 1, 2e-3) << "at " << d;
			++seen;
		}
		EXPECT_GT(seen, 200);
	}
}

TEST(DiskFlood, OnAPlaneDistancesGoRoundNoCorner)
{
	// The hole lies in the way: the vertex behind is as far as the way round, or little farther.
	Flooded   f(squareFrame(60, 20));
	DiskFlood flood(f.surface, f.field, f.working(0.9));
	flood.run(0, f.sampleAt(f.vertexNearest({0.2, 0.5, 0})));
	const int behind = f.vertexNearest({0.8, 0.5, 0});
	// The flat metric measures by chord as long as normals agree: never above the way round.
	EXPECT_GE(f.distanceAt(behind), 0.6 - 1e-6);
	EXPECT_LE(f.distanceAt(behind), 2 * std::hypot(0.14, 0.17) + 1.0 / 3 + 0.02);
}

TEST(DiskFlood, OnASphereFlatDisksAreTrueToAThousandth)
{
	Flooded(icosphere(5)).expectDistances({0.3, 0.4, 0.87}, 0.3, onSphere, 0.002);
	Flooded(icosphere(5)).expectDistances({0, 0, 1}, 0.55, onSphere, 0.003);
}

TEST(DiskFlood, OnASphereBentDisksAreTrueToTwoPercent)
{
	Flooded(icosphere(5)).expectDistances({0.3, 0.4, 0.87}, 1.2, onSphere, 0.02);
	Flooded(icosphere(5)).expectDistances({0, 0, 1}, 2.0, onSphere, 0.02);
}

TEST(DiskFlood, OnACylinderIsTheUnrolledDistance)
{
	const auto unrolled = [](const Vec3d& a, const Vec3d& b) { return onCylinder(a, b, 0.5); };
	const TriangleMesh cylinder = openCylinder(120, 120, 0.5, 2);
	Flooded(cylinder).expectDistances({0.5, 0, 1}, 0.25, unrolled, 0.005); // flat metric
	Flooded(cylinder).expectDistances({0.5, 0, 1}, 0.9, unrolled, 0.02);   // unfolding
}

TEST(DiskFlood, OverAFoldIsTheDistanceOnTheSheetLaidFlat)
{
	const auto flat = [](const Vec3d& p) {
		const double beyond = std::hypot(p.x - 0.5, p.z);
		return p.x > 0.5 || p.z > 0 ? Vec3d(0.5 + beyond, p.y, 0) : p;
	};
	const auto onSheet = [&](const Vec3d& a, const Vec3d& b) { return length(flat(a) - flat(b)); };
	for (double angle : {1.0, 2.0, 2.8})
		Flooded(bentSheet(60, angle)).expectDistances({0.4, 0.5, 0}, 0.35, onSheet, 0.03);
}

TEST(DiskFlood, DoesNotReachTheOtherSideOfAThinPlate)
{
	Flooded   f(thinPlate(60, 0.002));
	DiskFlood flood(f.surface, f.field, f.working(0.2));
	flood.run(0, f.sampleAt(f.vertexNearest({0.5, 0.5, 0.002})));
	int above = 0;
	for (int v = 0; v < f.surface.mesh.vertexNum; ++v) {
		const bool below = f.place(v).z < 0.001;
		above += !below && f.field.nearest[v].sample == 0;
		if (below) {
			EXPECT_LT(f.field.nearest[v].sample, 0);
		}
	}
	EXPECT_GT(above, 300);
}

/// The half-plane of Poincaré: lengths at height y are divided by y.
double onHyperbolicPlane(const Vec3d& a, const Vec3d& b)
{
	const Vec3d way = b - a;
	return std::acosh(1 + dot(way, way) / (2 * a.y * b.y));
}

/// Ways under a stretch bend towards places of small stretch: only a front with later corrections
/// comes near the closed form.
TEST(DiskFlood, UnderAStretchIsTheDistanceOfTheHyperbolicPlane)
{
	TriangleMesh mesh = grid(80, 60);
	for (Vec3d& p : mesh.positions)
		p.y = 0.25 + 0.75 * p.y;
	Flooded       f(mesh);
	Buffer<float> stretch(std::size_t(f.surface.mesh.vertexNum));
	for (int v = 0; v < f.surface.mesh.vertexNum; ++v)
		stretch[v] = float(1 / f.place(v).y);
	f.expectDistances({0.5, 0.5, 0}, 0.4, onHyperbolicPlane, 0.01,
					  {f.surface.mesh, f.surface.normal, &stretch, false});
}

/// The stretch 1 gives the same bits as no stretch.
TEST(DiskFlood, AStretchOfOneChangesNothing)
{
	const TriangleMesh sphere = icosphere(4);
	Flooded            plain(sphere), stretched(sphere);
	Buffer<float>      one(std::size_t(plain.surface.mesh.vertexNum));
	one.fill(1);
	const int from = plain.vertexNearest({0.3, 0.4, 0.8});
	DiskFlood without({plain.surface.mesh, plain.surface.normal, nullptr, false}, plain.field,
					  plain.working(0.7));
	DiskFlood with({stretched.surface.mesh, stretched.surface.normal, &one, false}, stretched.field,
				   stretched.working(0.7));
	without.run(0, plain.sampleAt(from));
	with.run(0, stretched.sampleAt(from));
	for (int v = 0; v < plain.surface.mesh.vertexNum; ++v)
		ASSERT_EQ(plain.field.nearest[v].distance, stretched.field.nearest[v].distance) << v;
}

TEST(DiskFlood, TakesAVertexOnlyFromASampleFartherAway)
{
	Flooded   f(grid(60, 60));
	DiskFlood flood(f.surface, f.field, f.working(0.3));
	const int a = f.vertexNearest({0.4, 0.5, 0}), b = f.vertexNearest({0.65, 0.5, 0});
	flood.run(0, f.sampleAt(a));
	EXPECT_TRUE(flood.metSamples().empty() || flood.metSamples() == std::vector<int>{0});
	flood.run(1, f.sampleAt(b));
	EXPECT_TRUE(std::count(flood.metSamples().begin(), flood.metSamples().end(), 0)) << "met";
	for (int v = 0; v < f.surface.mesh.vertexNum; ++v) {
		const double toA = length(f.place(v) - f.place(a)), toB = length(f.place(v) - f.place(b));
		if (std::min(toA, toB) > 0.29 || std::abs(toA - toB) < 1e-4) continue;
		ASSERT_EQ(f.field.nearest[v].sample, toA < toB ? 0 : 1);
	}
}

TEST(DiskFlood, DoesNotMeetSamplesOutOfReach)
{
	Flooded   f(grid(60, 60));
	DiskFlood flood(f.surface, f.field, f.working(0.1));
	flood.run(0, f.sampleAt(f.vertexNearest({0.2, 0.5, 0})));
	flood.run(1, f.sampleAt(f.vertexNearest({0.8, 0.5, 0})));
	EXPECT_FALSE(std::count(flood.metSamples().begin(), flood.metSamples().end(), 0));
}

/// d(a, b) = d(b, a), bent or not.
TEST(DiskFlood, IsSymmetric)
{
	const TriangleMesh sphere = icosphere(5);
	Random             random(3);
	for (int i = 0; i < 10; ++i) {
		Flooded   there(sphere), back(sphere);
		const int a = random.below(there.surface.mesh.vertexNum);
		DiskFlood floodThere(there.surface, there.field, there.working(1.5));
		floodThere.run(0, there.sampleAt(a));
		std::vector<int> inside;
		for (int v = 0; v < there.surface.mesh.vertexNum; ++v) {
			if (v != a && there.distanceAt(v) < 1.4) inside.push_back(v);
		}
		const int b = inside[std::size_t(random.below(int(inside.size())))];
		DiskFlood floodBack(back.surface, back.field, back.working(1.5));
		floodBack.run(0, back.sampleAt(b));
		EXPECT_NEAR(there.distanceAt(b), back.distanceAt(a), 0.02 * there.distanceAt(b) + 0.002);
	}
}

TEST(UnfoldedDistance, IsTheStraightLineInThePlane)
{
	Random random(2);
	int    crossed = 0;
	for (int i = 0; i < 2000; ++i) {
		// v at 0, b on the axis, a above, the source below.
		const Vec3d       v, b(random.between(0.2, 2), 0, 0);
		const Vec3d       a(random.between(-1, 2), random.between(0.1, 2), 0);
		const Vec3d       s(random.between(-1, 2), random.between(-2, -0.1), 0);
		const UnfoldedWay way = unfold(float(length(s - v)), float(length(s - b)), float(length(b)),
									   float(length(a)), float(length(a - b)));
		const double      x   = s.x + (a.x - s.x) * -s.y / (a.y - s.y);
		if (x > 0.01 && x < b.x - 0.01) {
			++crossed;
			ASSERT_NEAR(double(way.distance), length(a - s), 1e-4);
			ASSERT_NEAR(double(way.share), x / b.x, 1e-4);
			ASSERT_NEAR(double(way.toCrossing), length(Vec3d(x, 0, 0) - s), 1e-4);
		}
		else if (x < -0.01 || x > b.x + 0.01) {
			ASSERT_EQ(way.distance, HUGE_VALF) << "the line leaves the edge";
		}
	}
	EXPECT_GT(crossed, 300);
}

} // namespace

} // namespace gpr::test
