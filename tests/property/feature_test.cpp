// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Promises of feature detection for any mesh.

#include <tests/support/mesh_builders.h>
#include <tests/support/transforms.h>
#include <vcg_extras/core/remesh.h>

#include <algorithm>
#include <cstring>
#include <gtest/gtest.h>
#include <set>

namespace gpr::test {

namespace {

FeatureResult run(const TriangleMesh& mesh, int threads = 2)
{
	RemeshOptions options;
	options.threads = threads;
	return detectFeatures(mesh.view(), options);
}

bool sameBytes(const FeatureResult& a, const FeatureResult& b)
{
	if (a.vertexFeature != b.vertexFeature || a.faceMark != b.faceMark) return false;
	if (a.vertexStrength.size() != b.vertexStrength.size() || a.edges.size() != b.edges.size()) {
		return false;
	}
	return std::memcmp(a.vertexStrength.data(), b.vertexStrength.data(),
					   a.vertexStrength.size() * sizeof(float)) == 0 &&
		   std::memcmp(a.edges.data(), b.edges.data(), a.edges.size() * sizeof(FeatureEdge)) == 0;
}

using EdgeSet = std::set<std::pair<int, int>>;

EdgeSet edgesOf(const FeatureResult& r)
{
	EdgeSet edges;
	for (const FeatureEdge& e : r.edges)
		edges.insert(std::minmax(e.vertex[0], e.vertex[1]));
	return edges;
}

/// Shapes with creases, coneApexes, borders, noise and defects.
std::vector<TriangleMesh> shapes()
{
	Random             random(7);
	const TriangleMesh tub = closedCylinder(60, 30, 0.5, 1);
	return {cube(16),
			tub,
			cone(40, 20, 0.5, 1),
			withHoles(bentSheet(40, 1.2), 3, random),
			noisySphere(4, 0.02, random),
			damaged(cube(20), 30, random),
			joined(torus(60, 30), shifted(box(5, 9, 3, {1, 2, 0.3}), {3, 0, 0}))};
}

TEST(FeatureDeterminism, AnyNumberOfThreadsGivesTheSameBytes)
{
	for (const TriangleMesh& mesh : shapes()) {
		const FeatureResult one = run(mesh, 1);
		ASSERT_EQ(one.status, Status::Ok) << one.message;
		for (int threads : {2, 3, 4})
			EXPECT_TRUE(sameBytes(run(mesh, threads), one)) << threads;
	}
}

/// The working frame's scale is a power of two: such a change of unit changes nothing at all.
TEST(FeatureInvariance, UnitsThatArePowersOfTwoChangeNoBit)
{
	for (const TriangleMesh& mesh : shapes()) {
		const FeatureResult one = run(mesh);
		for (double factor : {0x1p-30, 0x1p-1, 0x1p30}) {
			const FeatureResult other = run(scaled(mesh, factor));
			EXPECT_TRUE(sameBytes(other, one)) << factor;
			EXPECT_DOUBLE_EQ(other.figures.support, factor * one.figures.support);
		}
	}
}

/// Creases well above the thresholds; the answer for shapes close to the thresholds may change.
class FeatureMotion : public ::testing::TestWithParam<std::uint32_t> {};

TEST_P(FeatureMotion, TurningShiftingAndAnyUnitKeepTheFeatures)
{
	Random random(GetParam());
	for (const TriangleMesh& mesh : {cube(16), closedCylinder(60, 30, 0.5, 1), bentSheet(40, 1.2),
									 cone(40, 20, 0.5, 1), torus(60, 30)}) {
		const Vec3d        axis(random.between(-1, 1), random.between(-1, 1), 0.5);
		const TriangleMesh moved =
			shifted(scaled(rotated(mesh, axis, random.between(0, 6)), random.between(0.01, 100)),
					{random.between(-5, 5), random.between(-5, 5), random.between(-5, 5)});
		const FeatureResult a = run(mesh), b = run(moved);
		ASSERT_EQ(b.status, Status::Ok) << b.message;
		EXPECT_EQ(edgesOf(a), edgesOf(b));
		EXPECT_EQ(a.vertexFeature, b.vertexFeature);
		// A ray through a vertex passes on one side or the other, which now and then changes a
		// strength.
		std::size_t differ = 0;
		for (std::size_t v = 0; v < a.vertexStrength.size(); ++v)
			differ += std::abs(a.vertexStrength[v] - b.vertexStrength[v]) > 0.5;
		EXPECT_LE(differ, a.vertexStrength.size() / 50);
	}
}

TEST_P(FeatureMotion, NamesOfVerticesAndFacesDoNotMatter)
{
	Random             random(GetParam());
	const TriangleMesh mesh = cube(12), other = shuffled(mesh, random);
	const auto         pointsOf = [](const TriangleMesh& m, const FeatureResult& r) {
        std::vector<std::array<double, 4>> points;
        for (std::size_t v = 0; v < m.vertexNum(); ++v) {
            const Vec3d& p = m.positions[v];
            points.push_back({p.x, p.y, p.z, double(r.vertexFeature[v])});
        }
        std::sort(points.begin(), points.end());
        return points;
	};
	EXPECT_EQ(pointsOf(mesh, run(mesh)), pointsOf(other, run(other)));
}

INSTANTIATE_TEST_SUITE_P(Seeds, FeatureMotion, ::testing::ValuesIn(testSeeds(4)));

class FeatureSoundness : public ::testing::TestWithParam<std::uint32_t> {};

/// For any mesh, sound or damaged: values in range, marks in agreement with each other and with the
/// counts, edges of the mesh, input untouched.
TEST_P(FeatureSoundness, MarksAgreeWithEachOther)
{
	Random random(GetParam());
	for (int round = 0; round < 5; ++round) {
		const TriangleMesh mesh =
			round % 2 == 0 ? randomSurface(random) : damaged(randomSurface(random), 20, random);
		const TriangleMesh  before = mesh;
		const FeatureResult r      = run(mesh);
		ASSERT_EQ(r.status, Status::Ok) << r.message;
		EXPECT_TRUE(mesh.positions == before.positions && mesh.triangles == before.triangles);
		ASSERT_EQ(r.vertexStrength.size(), mesh.vertexNum());
		ASSERT_EQ(r.faceMark.size(), mesh.faceNum());
		for (float s : r.vertexStrength)
			EXPECT_TRUE(s >= 0 && s <= 180) << s;

		EdgeSet ofMesh;
		for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
			const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
			ofMesh.insert(std::minmax(mesh.triangles[i], mesh.triangles[next]));
		}
		std::set<int> onLines;
		for (const FeatureEdge& e : r.edges) {
			EXPECT_TRUE(ofMesh.count(std::minmax(e.vertex[0], e.vertex[1])));
			EXPECT_GE(e.strength, FeatureThresholds().weakDeg);
			onLines.insert(e.vertex, e.vertex + 2);
		}
		std::int64_t marked = 0;
		for (std::size_t v = 0; v < mesh.vertexNum(); ++v) {
			EXPECT_EQ((r.vertexFeature[v] & OnFeatureLine) != 0, onLines.count(int(v)) > 0);
			marked += r.vertexFeature[v] != 0;
		}
		EXPECT_EQ(r.figures.vertexNum, marked);
		EXPECT_EQ(r.figures.edgeNum, std::int64_t(r.edges.size()));
	}
}

INSTANTIATE_TEST_SUITE_P(Seeds, FeatureSoundness, ::testing::ValuesIn(testSeeds(8)));

} // namespace

} // namespace gpr::test
