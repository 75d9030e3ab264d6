// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <tests/support/mesh_builders.h>
#include <tests/support/stages.h>
#include <tests/support/transforms.h>
#include <vcg_extras/core/features/feature_detection.h>
#include <vcg_extras/core/features/feature_strength.h>
#include <vcg_extras/core/remesh.h>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace gpr::test {

namespace {

constexpr double pi = 3.14159265358979323846;

/// A surface and its features with the default thresholds. The support is in mesh units; 0 is the
/// default support, in mean edges.
struct Found {
	Workers      workers{2, nullptr};
	Surface      surface;
	FeatureEdges features;

	explicit Found(const TriangleMesh& mesh, double support = 0,
				   FeatureThresholds thresholds = FeatureThresholds()) :
			surface(surfaceOf(mesh, workers))
	{
		float unit = meanEdgeLength(loaded(mesh, workers), workers);
		if (support > 0) unit = float(support * surface.frame.scale / thresholds.support);
		features = findFeatures(thresholds, unit, workers, surface);
	}

	const HalfEdgeMesh& mesh() const { return surface.mesh; }
	Vec3d               at(int v) const { return surface.frame.toCaller(mesh().position[v]); }
	float               largestVertexStrength() const
	{
		return *std::max_element(features.vertexStrength.begin(), features.vertexStrength.end());
	}
};

bool isInFold(const Vec3d& p)
{
	return std::abs(p.x - 0.5) < 1e-6 && std::abs(p.z) < 1e-6;
}

/// Whether a half-edge lies in the fold of a bentSheet.
bool isInFold(const Found& f, int h)
{
	return isInFold(f.at(f.mesh().origin[h])) && isInFold(f.at(f.mesh().target(h)));
}

class Fold : public ::testing::TestWithParam<int> {};

TEST_P(Fold, StrengthIsTheAngle)
{
	const Found f(bentSheet(20, GetParam() * pi / 180));
	int         foldEdges = 0;
	for (int h = 0; h < f.mesh().halfEdgeNum(); ++h) {
		if (!isInFold(f, h)) continue;
		++foldEdges;
		EXPECT_NEAR(f.features.edgeStrength[h], GetParam(), 0.1);
	}
	EXPECT_EQ(foldEdges, 40) << "20 edges, two halves each";
	EXPECT_NEAR(f.largestVertexStrength(), GetParam(), 0.1) << "nowhere stronger than in the fold";
}

TEST_P(Fold, IsALineOneEdgeWideFromEndToEnd)
{
	const Found f(bentSheet(20, GetParam() * pi / 180));
	const bool  isStrong = GetParam() >= 40;
	for (int h = 0; h < f.mesh().halfEdgeNum(); ++h)
		EXPECT_EQ(f.mesh().isCreaseEdge(h), isStrong && isInFold(f, h)) << h;
	EXPECT_EQ(f.features.figures.edgeNum, isStrong ? 20 : 0);
	EXPECT_EQ(f.features.figures.lineNum, isStrong ? 1 : 0);
	EXPECT_EQ(f.features.figures.cornerNum, isStrong ? 2 : 0) << "its two ends";
}

INSTANTIATE_TEST_SUITE_P(Degrees, Fold, ::testing::Values(5, 15, 30, 45, 60, 90, 120, 150));

/// The same shape and support on meshes of very different density.
TEST(FeatureStrength, DoesNotDependOnTheDensity)
{
	const double support = 0.045; // below its largest
	for (int angleDeg : {30, 90}) {
		const TriangleMesh coarse = bentSheet(24, angleDeg * pi / 180);
		const Found        a(coarse, support), b(subdivided(subdivided(coarse)), support);
		const auto         strengthAt = [](const Found& f, double x) {
            float strongest = 0;
            for (int h = 0; h < f.mesh().halfEdgeNum(); ++h) {
                const Vec3d p = f.at(f.mesh().origin[h]), q = f.at(f.mesh().target(h));
                const bool  here = std::abs(p.x - x) < 1e-6 && std::abs(q.x - x) < 1e-6;
                const bool  flat = std::abs(p.z) < 1e-6 && std::abs(q.z) < 1e-6;
                if (here && flat) strongest = std::max(strongest, f.features.edgeStrength[h]);
            }
            return strongest;
		};
		EXPECT_NEAR(strengthAt(a, 0.5), angleDeg, 0.1);
		EXPECT_NEAR(strengthAt(b, 0.5), angleDeg, 0.1);
		// Beside the fold: felt from less than a support away, alike on both meshes.
		const double beside = 0.5 - 1.0 / 24;
		EXPECT_GT(strengthAt(a, beside), 1);
		EXPECT_NEAR(strengthAt(a, beside), strengthAt(b, beside), 0.02 * angleDeg);
	}
}

/// On a sphere of radius R a half-disk of radius s has the mean normal of the point 4s/3π from its
/// straight side.
TEST(FeatureStrength, OnASphereIsWhatTheRadiusSays)
{
	const double support = 0.15;
	const Found  f(icosphere(5), support);
	const double expected = 2 * 4 * support / (3 * pi) * 180 / pi;
	for (int h = 0; h < f.mesh().halfEdgeNum(); ++h)
		ASSERT_NEAR(f.features.edgeStrength[h], expected, 0.08 * expected);
}

/// The features of a mesh by the facade.
FeatureResult detected(const TriangleMesh& mesh, FeatureThresholds thresholds = FeatureThresholds())
{
	RemeshOptions options;
	options.featureThresholds = thresholds;
	return detectFeatures(mesh.view(), options);
}

class Cube : public ::testing::TestWithParam<int> {};

TEST_P(Cube, ItsTwelveEdgesAndEightCornersAreFound)
{
	const int           n    = GetParam();
	const TriangleMesh  mesh = cube(n);
	const FeatureResult r    = detected(mesh);
	ASSERT_EQ(r.status, Status::Ok) << r.message;
	EXPECT_EQ(r.figures.edgeNum, 12 * n);
	EXPECT_EQ(std::int64_t(r.edges.size()), 12 * n);
	EXPECT_EQ(r.figures.lineNum, 1);
	EXPECT_EQ(r.figures.cornerNum, 8);
	const auto isExtreme = [](double c) { return c < 1e-9 || c > 1 - 1e-9; };
	const auto walls     = [&](int v) {
        const Vec3d& p = mesh.positions[v];
        return isExtreme(p.x) + isExtreme(p.y) + isExtreme(p.z);
	};
	for (std::size_t v = 0; v < mesh.vertexNum(); ++v) {
		EXPECT_EQ(r.vertexFeature[v] != 0, walls(int(v)) >= 2) << v;
		EXPECT_EQ((r.vertexFeature[v] & FeatureCorner) != 0, walls(int(v)) == 3) << v;
	}
	for (const FeatureEdge& e : r.edges)
		EXPECT_GT(e.strength, 70) << "90, less beside a corner, where half-disks go round it";
}

INSTANTIATE_TEST_SUITE_P(ClosestFaceMap, Cube, ::testing::Values(1, 2, 5, 12, 30));

TEST(FeatureMarks, FacesAreMarkedWhereAVertexIs)
{
	const TriangleMesh  mesh   = cube(8);
	const FeatureResult r      = detected(mesh);
	std::int64_t        marked = 0;
	for (std::size_t f = 0; f < mesh.faceNum(); ++f) {
		bool touches = false;
		for (int k = 0; k < 3; ++k)
			touches = touches || r.vertexFeature[mesh.triangles[3 * f + k]] != 0;
		EXPECT_EQ(r.faceMark[f] != 0, touches);
		marked += touches;
	}
	EXPECT_EQ(r.figures.faceNum, marked);
	EXPECT_LT(marked, std::int64_t(mesh.faceNum()));
}

TEST(FeatureMarks, TwoRimsOfAThinPlateStayTwoLines)
{
	const TriangleMesh  mesh     = thinPlate(20, 0.02);
	const FeatureResult r        = detected(mesh);
	std::int64_t        rimEdges = 0;
	for (const FeatureEdge& e : r.edges) {
		const Vec3d a = mesh.positions[e.vertex[0]], b = mesh.positions[e.vertex[1]];
		rimEdges += std::abs(a.z - b.z) < 1e-9;
	}
	EXPECT_EQ(rimEdges, 2 * 4 * 20);
}

TEST(FeatureMarks, AConesTipIsFound)
{
	const TriangleMesh  mesh = cone(24, 12, 0.5, 1);
	const FeatureResult r    = detected(mesh);
	ASSERT_EQ(r.figures.coneApexNum, 1);
	EXPECT_EQ(r.figures.edgeNum, 0) << "its side is round";
	for (std::size_t v = 0; v < mesh.vertexNum(); ++v)
		EXPECT_EQ(r.vertexFeature[v] != 0, length(mesh.positions[v]) < 1e-9) << v;
}

TEST(FeatureMarks, RoundThingsHaveNone)
{
	for (const TriangleMesh& mesh : {icosphere(3), icosphere(5), torus(80, 40), grid(20, 20),
									 openCylinder(40, 20, 0.5, 1), uvSphere(40, 80)}) {
		const FeatureResult r = detected(mesh);
		EXPECT_EQ(r.figures.vertexNum, 0);
		EXPECT_TRUE(r.edges.empty());
	}
}

class Noise : public ::testing::TestWithParam<std::uint32_t> {};

/// Noise of an eighth of an edge turns single faces by 20° and more.
TEST_P(Noise, OfAScanIsNoFeature)
{
	Random       random(GetParam());
	const double edge = 0.07; // mean edge of this sphere
	const Found  f(noisySphere(4, edge / 8, random));
	const float  largest =
		*std::max_element(f.features.edgeStrength.begin(), f.features.edgeStrength.end());
	const EdgeDifferences d =
		edgeDifferences(f.mesh(), f.features.support, const_cast<Workers&>(f.workers));
	EXPECT_GT(*std::max_element(d.dihedral.begin(), d.dihedral.end()), 25)
		<< "noise worth the name";
	EXPECT_LT(largest, 40);
	EXPECT_EQ(f.features.figures.edgeNum, 0);
	EXPECT_EQ(f.features.figures.coneApexNum, 0);
}

TEST_P(Noise, LeavesACubesEdgesInPlace)
{
	Random             random(GetParam());
	TriangleMesh       mesh = cube(20);
	const TriangleMesh flat = mesh;
	for (Vec3d& p : mesh.positions)
		p += Vec3d(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)) * 0.003;
	const FeatureResult r       = detected(mesh);
	std::int64_t        onEdges = 0;
	for (const FeatureEdge& e : r.edges) {
		const Vec3d a = flat.positions[e.vertex[0]], b = flat.positions[e.vertex[1]];
		int         walls = 0;
		for (double c : {a.x + b.x, a.y + b.y, a.z + b.z})
			walls += c < 1e-9 || c > 2 - 1e-9;
		onEdges += walls >= 2;
	}
	EXPECT_EQ(onEdges, 240);
	EXPECT_EQ(r.figures.edgeNum, 240) << "and no others";
}

INSTANTIATE_TEST_SUITE_P(Seeds, Noise, ::testing::ValuesIn(testSeeds(5)));

TEST(FeatureThresholds, ShortLinesAreDropped)
{
	const TriangleMesh mesh = joined(cube(30), scaled(cube(1), 0.02));
	FeatureThresholds  all;
	all.minLength = 0;
	EXPECT_EQ(detected(mesh, all).figures.lineNum, 2);
	FeatureThresholds longOnes;
	longOnes.minLength = 10;
	EXPECT_EQ(detected(mesh, longOnes).figures.lineNum, 1);
}

/// The fold fades from 60° to nothing: the line goes on to weak edges.
TEST(FeatureThresholds, HysteresisFollowsAFadingFold)
{
	const int    n    = 40;
	TriangleMesh mesh = grid(n, n);
	for (Vec3d& p : mesh.positions) {
		const double slope = std::tan(30 * pi / 180) * p.y;
		p.z                = -slope * std::abs(p.x - 0.5);
	}
	FeatureThresholds t;
	const auto        reach = [&] {
        const FeatureResult r      = detected(mesh, t);
        double              lowest = 1;
        for (const FeatureEdge& e : r.edges)
            lowest = std::min(lowest, mesh.positions[e.vertex[0]].y);
        EXPECT_EQ(r.figures.lineNum, 1);
        return lowest;
	};
	const double toWeak   = reach();
	t.weakDeg             = t.strongDeg;
	const double toStrong = reach();
	EXPECT_NEAR(toWeak, std::tan(10 * pi / 180) / std::tan(30 * pi / 180), 0.06);
	EXPECT_NEAR(toStrong, std::tan(20 * pi / 180) / std::tan(30 * pi / 180), 0.06);
}

TEST(DetectFeatures, GivesEveryCopyOfAVertexItsMark)
{
	Random              random(3);
	const TriangleMesh  whole = cube(6), soup = soupOf(whole, 0, random);
	const FeatureResult a = detected(whole), b = detected(soup);
	ASSERT_EQ(b.status, Status::Ok) << b.message;
	for (std::size_t i = 0; i < whole.triangles.size(); ++i) {
		EXPECT_EQ(b.vertexFeature[soup.triangles[i]], a.vertexFeature[whole.triangles[i]]);
		EXPECT_NEAR(b.vertexStrength[soup.triangles[i]], a.vertexStrength[whole.triangles[i]], 0.5);
	}
}

TEST(DetectFeatures, RefusesWhatItCannotUse)
{
	EXPECT_EQ(detected(TriangleMesh()).status, Status::UnusableInput);
	FeatureThresholds bad;
	bad.weakDeg = 50;
	EXPECT_EQ(detected(cube(2), bad).status, Status::BadOptions);
	RemeshOptions       options;
	const FeatureResult stopped =
		detectFeatures(cube(30).view(), options, [](double, const char*) { return false; });
	EXPECT_TRUE(stopped.status == Status::Cancelled || stopped.status == Status::Ok);
}

} // namespace

} // namespace gpr::test
