// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The two properties of a Poisson-disk sampling: no two samples are too near to each other, and no
// place is too far from all samples.

#include <tests/support/mesh_builders.h>
#include <tests/support/oracles.h>
#include <tests/support/stages.h>
#include <tests/support/transforms.h>
#include <vcg_extras/core/mesh/face_quality.h>
#include <vcg_extras/core/remesh.h>
#include <vcg_extras/core/sampling/front_sampling.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>

namespace gpr::test {

namespace {

/// Share by which float rounding may miss the promised (1 - spacingSlack) r, or r.
constexpr double rounding = 1e-3;

struct Shape {
	std::string  name;
	TriangleMesh mesh;
};

std::ostream& operator<<(std::ostream& out, const Shape& shape)
{
	return out << shape.name;
}

/// Shapes on which the chord between neighbours tells their distance on the surface to a few
/// percent.
std::vector<Shape> gentleShapes()
{
	Random random(1);
	return {{"sphere", icosphere(4)},
			{"fineSphere", icosphere(5)},
			{"torus", torus(90, 46)},
			{"uvSphere", uvSphere(40, 70)},
			{"grid", grid(60, 60)},
			{"coarseGrid", grid(13, 13)},
			{"jitteredGrid", jitteredGrid(50, 0.3, random)},
			{"squareFrame", squareFrame(48, 20)},
			{"cylinder", openCylinder(60, 60, 0.5, 1.5)}};
}

SamplingResult sample(const TriangleMesh& mesh, double percent, std::uint32_t seed, int threads = 2)
{
	RemeshOptions options;
	options.targetPercent = percent;
	options.seed          = seed;
	options.threads       = threads;
	return samplePoissonDisks(mesh.view(), options);
}

class GentleShapes : public ::testing::TestWithParam<Shape> {
protected:
	/// Calls check(result) for several targets and seeds; `percent` is capped for large meshes.
	void forEachSampling(const std::function<void(const SamplingResult&)>& check)
	{
		for (double percent : {3.0, 10.0, 40.0, 100.0, 200.0}) {
			if (percent * double(GetParam().mesh.vertexNum()) > 6e5) continue;
			for (std::uint32_t seed : testSeeds(2)) {
				SCOPED_TRACE(std::to_string(percent) + " %, seed " + std::to_string(seed));
				const SamplingResult s = sample(GetParam().mesh, percent, seed);
				ASSERT_EQ(s.status, Status::Ok) << s.message;
				ASSERT_GE(s.points.size(), 3u);
				check(s);
			}
		}
	}
};

TEST_P(GentleShapes, NoTwoSamplesAreNearerThanPromised)
{
	forEachSampling([](const SamplingResult& s) {
		const double least = (1 - spacingSlack) * s.diskRadius * (1 - rounding);
		EXPECT_EQ(pairsNearerThan(s.points, least), 0)
			<< "nearest pair at " << nearestPair(s.points).distance / s.diskRadius << " r";
	});
}

TEST_P(GentleShapes, EveryVertexOfTheInputIsCovered)
{
	forEachSampling([&](const SamplingResult& s) {
		double farthest = 0;
		for (const Vec3d& p : GetParam().mesh.positions)
			farthest = std::max(farthest, distanceToNearest(s.points, p));
		EXPECT_LE(farthest, s.diskRadius * (1 + rounding));
		EXPECT_GT(farthest, 0.4 * s.diskRadius) << "r is no larger than it has to be";
	});
}

TEST_P(GentleShapes, SamplesLieOnTheSurfaceWhereTheirSurfacePointsSay)
{
	const TriangleMesh& mesh = GetParam().mesh;
	forEachSampling([&](const SamplingResult& s) {
		ASSERT_EQ(s.surfacePoints.size(), s.points.size());
		for (std::size_t i = 0; i < s.points.size(); ++i) {
			const BarycentricPoint& a = s.surfacePoints[i];
			ASSERT_TRUE(a.face >= 0 && a.face < int(mesh.faceNum()));
			Vec3d p;
			for (int k = 0; k < 3; ++k)
				p += mesh.positions[mesh.triangles[3 * a.face + k]] * double(a.weight[k]);
			ASSERT_LT(length(p - s.points[i]), 1e-5);
		}
	});
}

INSTANTIATE_TEST_SUITE_P(, GentleShapes, ::testing::ValuesIn(gentleShapes()),
						 [](const auto& shape) { return std::string(shape.param.name); });

/// Flat coordinates of a point of bentSheet: the fold straightened out.
Vec3d unfolded(const Vec3d& p)
{
	const double beyond = std::hypot(p.x - 0.5, p.z);
	// Points of the flat part are off by rounding.
	constexpr double rounded = 1e-6;
	return p.x > 0.5 || p.z > rounded ? Vec3d(0.5 + beyond, p.y, 0) : Vec3d(p.x, p.y, 0);
}

/// Across a fold the chord is shorter than the way on the surface. On the sheet laid flat, every
/// vertex is covered up to the error of unfolding over triangles.
TEST(Sampling, CoversAFoldedSheetMeasuredFlat)
{
	constexpr double unfoldingError = 0.03;
	for (double angle : {0.5, 1.5, 2.5}) {
		const TriangleMesh   sheet = bentSheet(50, angle);
		const SamplingResult s     = sample(sheet, 20, 1);
		ASSERT_EQ(s.status, Status::Ok);
		std::vector<Vec3d> flat;
		for (const Vec3d& p : s.points)
			flat.push_back(unfolded(p));
		for (const Vec3d& p : sheet.positions) {
			ASSERT_LE(distanceToNearest(flat, unfolded(p)), s.diskRadius * (1 + unfoldingError))
				<< "angle " << angle;
		}
		EXPECT_LE(pairsNearerThan(flat, 0.9 * s.diskRadius), int(flat.size()) / 500);
	}
}

/// The other sheet is near through space and far on the surface: only the latter counts.
TEST(Sampling, DoesNotLeakFromSheetToSheet)
{
	const double gap = 0.02;
	for (double percent : {2.0, 10.0, 50.0}) {
		const TriangleMesh   sheets = twoSheets(40, gap);
		const SamplingResult s      = sample(sheets, percent, 1);
		ASSERT_EQ(s.status, Status::Ok);
		ASSERT_GT(s.diskRadius, gap) << "else nothing is tested";
		for (bool upper : {false, true}) {
			std::vector<Vec3d> own;
			for (const Vec3d& p : s.points) {
				if ((p.z > gap / 2) == upper) own.push_back(p);
			}
			for (const Vec3d& p : sheets.positions) {
				if ((p.z > gap / 2) == upper) {
					ASSERT_LE(distanceToNearest(own, p), s.diskRadius * (1 + rounding));
				}
			}
			EXPECT_EQ(pairsNearerThan(own, (1 - spacingSlack) * s.diskRadius * (1 - rounding)), 0);
		}
	}
}

TEST(Sampling, CoversBothSidesOfAThinPlate)
{
	const double         thickness = 0.01;
	const TriangleMesh   plate     = thinPlate(40, thickness);
	const SamplingResult s         = sample(plate, 10, 1);
	ASSERT_EQ(s.status, Status::Ok);
	ASSERT_GT(s.diskRadius, 3 * thickness);
	// Away from the rim, a side can only be covered by its own samples or round the rim.
	for (const Vec3d& p : plate.positions) {
		const double toRim = std::min({p.x, p.y, 1 - p.x, 1 - p.y});
		if (toRim < s.diskRadius) continue;
		std::vector<Vec3d> own;
		for (const Vec3d& q : s.points) {
			if (std::abs(q.z - p.z) < thickness / 2) own.push_back(q);
		}
		ASSERT_LE(distanceToNearest(own, p), s.diskRadius * (1 + rounding));
	}
}

/// On coarse input disks hold a handful of vertices, and a pair may slip through: few, and not far.
TEST(Sampling, FewPairsSlipThroughOnCoarseInput)
{
	int pairs = 0, samples = 0;
	for (const TriangleMesh& mesh : {torus(30, 14), torus(40, 18), torus(60, 28), icosphere(2)}) {
		for (double percent : {50.0, 100.0, 200.0}) {
			for (std::uint32_t seed : testSeeds(3)) {
				const SamplingResult s = sample(mesh, percent, seed);
				ASSERT_EQ(s.status, Status::Ok);
				samples += int(s.points.size());
				pairs +=
					pairsNearerThan(s.points, (1 - spacingSlack) * s.diskRadius * (1 - rounding));
				EXPECT_GT(nearestPair(s.points).distance, 0.6 * s.diskRadius);
			}
		}
	}
	EXPECT_LE(pairs, samples / 1000);
}

/// Closed surfaces with a few hundred samples or more: no correction is made, so a band.
TEST(Sampling, TheNumberLandsNearTheTarget)
{
	for (const TriangleMesh& mesh : {icosphere(4), torus(90, 46), cube(25)}) {
		for (double percent : {10.0, 50.0, 200.0}) {
			const SamplingResult s     = sample(mesh, percent, 1);
			const double         asked = percent / 100 * double(mesh.vertexNum());
			EXPECT_NEAR(double(s.points.size()) / asked, 0.95, 0.09) << percent << " %";
		}
	}
}

TEST(Sampling, ANumberFarFromTheTargetIsTold)
{
	RemeshOptions options;
	options.targetMode      = TargetMode::VertexNum;
	options.targetVertexNum = 100;
	TriangleMesh spheres    = icosphere(2);
	for (int i = 1; i < 32; ++i)
		spheres = joined(spheres, shifted(icosphere(2), {3.0 * i, 0, 0}));
	const SamplingResult few = samplePoissonDisks(spheres.view(), options);
	ASSERT_EQ(few.notes.size(), 1u);
	EXPECT_EQ(few.notes[0],
			  "The sampling has " + std::to_string(few.points.size()) + " points instead of 100.");
	options.targetVertexNum = 1000;
	EXPECT_TRUE(samplePoissonDisks(icosphere(4).view(), options).notes.empty());
}

/// Feature lines leave gaps beside the other samples; the disk radius is corrected for the gaps.
TEST(Sampling, TheNumberLandsNearTheTargetBesideFeatureLines)
{
	for (const TriangleMesh& mesh : {lPrism(20), closedCylinder(100, 60, 0.5, 1)}) {
		for (double percent : {3.0, 10.0, 30.0}) {
			const SamplingResult s     = sample(mesh, percent, 1);
			const double         asked = percent / 100 * double(mesh.vertexNum());
			EXPECT_GT(s.report.boundarySampleNum, 30) << "else nothing is tested";
			EXPECT_NEAR(double(s.points.size()) / asked, 1, 0.04) << percent << " %";
		}
	}
}

TEST(Sampling, DoesNotDependOnThreads)
{
	const TriangleMesh   mesh = torus(90, 46);
	const SamplingResult one  = sample(mesh, 30, 7, 1);
	for (int threads = 2; threads <= 4; ++threads) {
		const SamplingResult several = sample(mesh, 30, 7, threads);
		EXPECT_TRUE(several.points == one.points) << threads << " threads";
	}
	EXPECT_FALSE(sample(mesh, 30, 8, 1).points == one.points) << "another seed";
}

double meanEdgeLength(const HalfEdgeMesh& m)
{
	double sum = 0;
	for (int h = 0; h < m.halfEdgeNum(); ++h)
		sum += double(length(m.position[m.target(h)] - m.position[m.origin[h]]));
	return sum / m.halfEdgeNum();
}

/// The nearest samples of all vertices after the stage itself, in working units.
TEST(SampleFront, KnowsTheNearestSampleOfEveryVertex)
{
	Workers              workers(2, nullptr);
	const Surface        surface   = surfaceOf(icosphere(5), workers);
	const float          r         = 0.05f;
	const OctreeBlocks   partition = cutIntoBlocks(surface, 12 * r, workers);
	const BoundaryCurves boundary  = sampleBoundary(surface, r, r, workers);
	const Sampling       s         = sampleFront(surface, boundary, partition, r, 1, workers);
	EXPECT_FALSE(s.capped);
	EXPECT_EQ(s.boundarySampleNum, 0);
	// Random border edges leave about 0.75.
	const double perArea = double(s.samples.size()) / surfaceArea(surface.mesh, workers);
	EXPECT_GT(perArea * double(r) * r, 1) << "nearly all are intersections";
	std::vector<Vec3d> places;
	for (const Sample& sample : s.samples)
		places.push_back(Vec3d(sample.point.position));
	for (int v = 0; v < surface.mesh.vertexNum; ++v) {
		const NearestField::Nearest n = s.nearest[v];
		const Vec3d                 p = Vec3d(surface.mesh.position[v]);
		ASSERT_TRUE(n.sample >= 0 && n.sample < int(places.size()));
		ASSERT_LE(n.distance, r);
		ASSERT_NEAR(double(n.distance), length(places[n.sample] - p), 0.01 * double(r));
		ASSERT_LE(double(n.distance), distanceToNearest(places, p) + 0.01 * double(r));
	}
}

/// Across folds and among needles, a vertex may be outside of all disks although a sample is too
/// near for a new sample: the vertex belongs to the near sample.
TEST(SampleFront, CoversEveryVertexAmongBumpsAndNeedles)
{
	Workers workers(2, nullptr);
	Random  random(1);
	for (const TriangleMesh& mesh :
		 {noisySphere(5, 0.2, random), noisySphere(5, 0.5, random), openCylinder(6, 400, 0.5, 1)}) {
		const Surface surface = surfaceOf(mesh, workers);
		for (float r : {0.03f, 0.08f}) {
			const BoundaryCurves boundary  = sampleBoundary(surface, r, r, workers);
			const OctreeBlocks   partition = cutIntoBlocks(surface, 12 * r, workers);
			const Sampling       s = sampleFront(surface, boundary, partition, r, 1, workers);
			for (int v = 0; v < surface.mesh.vertexNum; ++v) {
				ASSERT_GE(s.nearest[v].sample, 0);
				ASSERT_LE(s.nearest[v].distance, r);
			}
		}
	}
}

/// With edges as long as disks are wide, a near sample need not own a corner of the face.
TEST(SampleFront, KeepsTheSpacingAmongFacesAsLargeAsDisks)
{
	Workers workers(2, nullptr);
	for (const TriangleMesh& mesh : {torus(30, 14), uvSphere(20, 30), uvSphere(12, 60)}) {
		const Surface      surface   = surfaceOf(mesh, workers);
		const float        r         = float(meanEdgeLength(surface.mesh));
		const OctreeBlocks partition = cutIntoBlocks(surface, 12 * r, workers);
		for (std::uint32_t seed = 1; seed <= 6; ++seed) {
			const Sampling s = sampleFront(surface, BoundaryCurves(), partition, r, seed, workers);
			std::vector<Vec3d> places;
			for (const Sample& sample : s.samples)
				places.push_back(Vec3d(sample.point.position));
			EXPECT_EQ(pairsNearerThan(places, 0.949 * double(r)), 0) << seed;
		}
	}
}

/// Among faces about as large as the disks, a near sample is most easily overlooked.
TEST(Sampling, KeepsTheSpacingOnCoarseInput)
{
	struct Case {
		TriangleMesh  mesh;
		double        percent;
		std::uint32_t seed;
	};
	for (const Case& c : {Case{torus(30, 14), 100, 1}, Case{torus(40, 18), 30, 3},
						  Case{bentSheet(60, 1.5), 200, 8}}) {
		RemeshOptions options;
		options.targetPercent  = c.percent;
		options.seed           = c.seed;
		const SamplingResult s = samplePoissonDisks(c.mesh.view(), options);
		EXPECT_GE(nearestPair(s.points).distance, 0.949 * s.diskRadius) << c.percent << " %";
	}
}

/// Noise makes the surface larger than its shape, and would leave a third of the samples missing.
TEST(Sampling, OfANoisySurfaceHasNearlyAllSamples)
{
	for (const std::uint32_t seed : {1u, 2u, 3u}) {
		Random             random(seed);
		const TriangleMesh mesh = noisySphere(6, 0.01, random);
		RemeshOptions      options;
		options.targetMode      = TargetMode::VertexNum;
		options.targetVertexNum = 1000;
		options.seed            = seed;
		const RemeshResult r    = remesh(mesh.view(), options);
		ASSERT_EQ(r.status, Status::Ok) << r.message;
		EXPECT_GT(r.report.sampleNum, 920);
		EXPECT_GT(r.report.quality.radiusRatioMean, 0.955);
	}
}

} // namespace

} // namespace gpr::test
