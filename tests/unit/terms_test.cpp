// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The terms that move vertices, each by itself.

#include <tests/support/mesh_builders.h>
#include <tests/support/random_source.h>
#include <tests/support/stages.h>
#include <vcg_extras/core/optimization/terms.h>

#include <cmath>
#include <gtest/gtest.h>

namespace gpr::test {

namespace {

// ---- barycentric

TEST(WayToBarycentre, LeadsTowardsTheDenserSide)
{
	const HalfEdgeMesh m      = halfEdgesOf(lattice(4, 4));
	const int          middle = 12; // of five rows of five
	EXPECT_LT(length(wayToBarycentre(m, middle)), 1e-6f);
	Buffer<float> density(std::size_t(m.vertexNum), 1.0f);
	density[middle + 1] = 4;
	const Vec3f way     = wayToBarycentre(m, middle, density);
	EXPECT_GT(way.x, 0.05f);
	EXPECT_LT(std::abs(way.y), 1e-6f);
}

// ---- second-order umbrella

/// A square of side 1 cut into 20 × 20, all diagonals the same way: every inner vertex has six
/// neighbours.
TriangleMesh latticeOfSixes()
{
	constexpr int n = 20;
	TriangleMesh  mesh;
	for (int y = 0; y <= n; ++y) {
		for (int x = 0; x <= n; ++x)
			mesh.positions.push_back({double(x) / n, double(y) / n, 0});
	}
	for (int y = 0; y < n; ++y) {
		for (int x = 0; x < n; ++x) {
			const int a = y * (n + 1) + x, b = a + 1, c = a + n + 1, d = c + 1;
			mesh.triangles.insert(mesh.triangles.end(), {a, b, d, a, d, c});
		}
	}
	return mesh;
}

/// Whether an inner vertex is at least `margin` from the border of a grid of side 1.
bool isDeep(const Vec3f& p, float margin)
{
	return p.x > margin && p.y > margin && p.x < 1 - margin && p.y < 1 - margin;
}

/// The operator is of fourth order: on a regular lattice, the operator vanishes for cubic
/// polynomials.
TEST(SecondOrderUmbrella, VanishesOnRegularLattices)
{
	TriangleMesh sheet = latticeOfSixes();
	for (Vec3d& p : sheet.positions)
		p.z = p.x * p.x * p.x + p.x * p.y - 0.5 * p.y * p.y;
	Workers             workers(1, nullptr);
	const HalfEdgeMesh  m    = halfEdgesOf(sheet);
	const Buffer<Vec3f> step = secondOrderUmbrella(m, workers);
	int                 deep = 0;
	for (int v = 0; v < m.vertexNum; ++v) {
		if (!isDeep(m.position[v], 0.12f)) continue;
		++deep;
		EXPECT_LT(length(step[v]), 1e-5f);
	}
	EXPECT_GT(deep, 100);
}

/// A vertex of a regular lattice displaced by d: U(v) = -d, and d/6 for its six neighbours. So
/// U²(v) = d/6 + d and ν = 7/6, and one step takes v back to its place.
TEST(SecondOrderUmbrella, TakesADisplacedVertexBackAtOnce)
{
	TriangleMesh sheet = latticeOfSixes();
	const Vec3d  by(0.012, -0.02, 0.007);
	int          displaced = 0;
	for (std::size_t v = 0; v < sheet.vertexNum(); ++v) {
		if (length(sheet.positions[v] - Vec3d(0.5, 0.5, 0)) < 1e-9) displaced = int(v);
	}
	sheet.positions[displaced] += by;
	Workers             workers(1, nullptr);
	const Buffer<Vec3f> step = secondOrderUmbrella(halfEdgesOf(sheet), workers);
	EXPECT_LT(length(Vec3d(step[displaced]) - by), 1e-6);
}

// ---- conformal

/// Of the face (p, a, b).
double conformalEnergy(const Vec3d& p, const Vec3d& a, const Vec3d& b)
{
	const double edges = squaredLength(a - p) + squaredLength(b - p) + squaredLength(b - a);
	return edges / (2 * std::sqrt(3.0) * length(cross(a - p, b - p)));
}

ConformalFace conformalFace(const Vec3f& a, const Vec3f& b, const Vec3f& c, float leastArea = 0)
{
	return {Float4(a), Float4(b), Float4(c), leastArea};
}

TEST(ConformalFace, PullsEachCornerDownhill)
{
	Random     random(7);
	const auto point = [&] {
		return Vec3d(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
	};
	for (int i = 0; i < 50; ++i) {
		const Vec3d corner[] = {point(), point(), point()};
		if (length(cross(corner[1] - corner[0], corner[2] - corner[0])) < 0.1)
			continue; // nearly a line: differences say little
		const ConformalFace face =
			conformalFace(Vec3f(corner[0]), Vec3f(corner[1]), Vec3f(corner[2]));
		for (int k = 0; k < 3; ++k) {
			const Vec3d p = corner[k], a = corner[(k + 1) % 3], b = corner[(k + 2) % 3];
			EXPECT_NEAR(double(face.energy) / conformalEnergy(p, a, b), 1, 1e-4);
			EXPECT_NEAR(double(face.squaredEdge[k]), squaredLength(a - p), 1e-5);
			const double step   = 1e-5;
			const auto   change = [&](const Vec3d& by) {
                return (conformalEnergy(p + by, a, b) - conformalEnergy(p - by, a, b)) / (2 * step);
			};
			const Vec3d gradient(change({step, 0, 0}), change({0, step, 0}), change({0, 0, step}));
			const Vec3d force(face.force[k].xyz());
			EXPECT_LT(length(force + gradient), 1e-3 * (1 + length(gradient))) << i;
		}
	}
}

TEST(ConformalFace, OfAnEquilateralTriangleHasTheEnergyOneAndNoForce)
{
	const ConformalFace face = conformalFace({0, 0, 0}, {1, 0, 0}, {0.5f, std::sqrt(0.75f), 0});
	EXPECT_NEAR(face.energy, 1, 1e-6);
	for (const Float4& force : face.force) {
		EXPECT_LT(length(force.xyz()), 1e-6f);
		EXPECT_NEAR(force[3], 4 / (2 * std::sqrt(3.0) * std::sqrt(0.75)), 1e-5);
	}
}

TEST(ConformalFace, OfALineHasAForceWithoutNumbersThatAreNone)
{
	const ConformalFace face = conformalFace({0, 0, 0}, {1, 0, 0}, {2, 0, 0}, 0.02f);
	for (const Float4& force : face.force) {
		for (int lane = 0; lane < 4; ++lane)
			EXPECT_LT(std::abs(force[lane]), 1e4f);
	}
}

} // namespace

} // namespace gpr::test
