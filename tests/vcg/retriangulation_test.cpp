// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "poisson_samples.h"
#include "support.h"

#include <vcg_extras/complex/algorithms/retriangulation.h>

#include <algorithm>
#include <random>

using namespace gpr_test;
using namespace vcg::tri;

namespace {

template <class S>
class RetriangulationTest : public ::testing::Test {
};
TYPED_TEST_SUITE(RetriangulationTest, Scalars);

/// The largest distance from a point of `from` to the nearest point of `to`.
template <class CoordType>
double LargestDistance(const std::vector<CoordType>& from, const std::vector<CoordType>& to)
{
	double largest = 0;
	for (const CoordType& p : from) {
		double nearest = std::numeric_limits<double>::infinity();
		for (const CoordType& q : to)
			nearest = std::min(nearest, double((p - q).Norm()));
		largest = std::max(largest, nearest);
	}
	return largest;
}

template <class MeshType>
std::vector<typename MeshType::CoordType> PositionsOf(const MeshType& m)
{
	std::vector<typename MeshType::CoordType> positions;
	for (const auto& v : m.vert)
		positions.push_back(v.cP());
	return positions;
}

template <class MeshType>
void ExpectVerticesAreTheSamples(const MeshType&                                  m,
								 const std::vector<typename MeshType::CoordType>& samples,
								 double                                           tolerance)
{
	EXPECT_EQ(m.vert.size(), samples.size());
	EXPECT_LE(LargestDistance(PositionsOf(m), samples), tolerance);
	EXPECT_LE(LargestDistance(samples, PositionsOf(m)), tolerance);
}

TYPED_TEST(RetriangulationTest, TheVerticesAreTheSamples)
{
	using MeshType      = FullMesh<TypeParam>;
	using Retriangulate = Retriangulation<MeshType>;
	for (const auto make : {MakeTorus<MeshType>, MakeSheet<MeshType>}) {
		MeshType m, out;
		make(m);
		const auto                   samples = PoissonSamples(m, 350);
		typename Retriangulate::Stat stat;
		const auto                   result = Retriangulate::Do(m, samples, out, {}, &stat);
		ASSERT_TRUE(result.IsOk()) << result.message;
		EXPECT_EQ(stat.leftoverVertexNum, 0);
		ExpectVerticesAreTheSamples(out, samples, 1e-5 * m.bbox.Diag());
		ExpectSound(out);
		EXPECT_EQ(TopologyOf(out), TopologyOf(m));
	}
}

TYPED_TEST(RetriangulationTest, SamplesMayComeFromAnywhereAndLieOffTheSurface)
{
	using MeshType      = FullMesh<TypeParam>;
	using Retriangulate = Retriangulation<MeshType>;
	using CoordType     = typename MeshType::CoordType;
	MeshType m, out;
	MakeSphere(m, 5);
	// Spread by the golden angle, on a sphere 1 % too large.
	std::vector<CoordType> samples;
	const int              sampleNum = 400;
	for (int i = 0; i < sampleNum; ++i) {
		const double z = 1 - (2 * i + 1.0) / sampleNum, r = std::sqrt(1 - z * z);
		const double a = i * M_PI * (3 - std::sqrt(5.0));
		samples.push_back(CoordType(TypeParam(1.01 * r * std::cos(a)),
									TypeParam(1.01 * r * std::sin(a)), TypeParam(1.01 * z)));
	}
	typename Retriangulate::Stat stat;
	const auto                   result = Retriangulate::Do(m, samples, out, {}, &stat);
	ASSERT_TRUE(result.IsOk()) << result.message;
	EXPECT_EQ(stat.samplesMoved, sampleNum);
	EXPECT_NEAR(stat.largestSampleMove, 0.01, 0.003);
	ExpectVerticesAreTheSamples(out, samples, 1.01 * stat.largestSampleMove);
	ExpectSound(out);
	EXPECT_EQ(TopologyOf(out), TopologyOf(m));
}

TYPED_TEST(RetriangulationTest, TakesTheSamplesFromTheVerticesOfAMesh)
{
	using MeshType      = FullMesh<TypeParam>;
	using Retriangulate = Retriangulation<MeshType>;
	MeshType m, points, a, b;
	MakeTorus(m);
	const auto samples = PoissonSamples(m, 300);
	for (const auto& p : samples)
		Allocator<MeshType>::AddVertex(points, p);
	Allocator<MeshType>::AddVertex(points, samples[0] * 2);
	Allocator<MeshType>::DeleteVertex(points, points.vert.back());
	ASSERT_TRUE(Retriangulate::Do(m, samples, a).IsOk());
	ASSERT_TRUE(Retriangulate::Do(m, points, b).IsOk());
	EXPECT_EQ(PositionsOf(a), PositionsOf(b));
	EXPECT_EQ(a.FN(), b.FN());
}

TYPED_TEST(RetriangulationTest, WorksInPlaceAndCarriesAttributes)
{
	using MeshType      = FullMesh<TypeParam>;
	using Retriangulate = Retriangulation<MeshType>;
	MeshType m;
	MakeTorus(m);
	for (auto& v : m.vert)
		v.Q() = v.P()[0];
	const auto samples = PoissonSamples(m, 350);
	ASSERT_TRUE(Retriangulate::Do(m, samples, m).IsOk());
	ExpectVerticesAreTheSamples(m, samples, 1e-4);
	for (const auto& v : m.vert)
		EXPECT_NEAR(v.cQ(), v.cP()[0], 1e-4);
}

TYPED_TEST(RetriangulationTest, AFailureTouchesNothing)
{
	using MeshType      = FullMesh<TypeParam>;
	using Retriangulate = Retriangulation<MeshType>;
	using CoordType     = typename MeshType::CoordType;
	MeshType m, out;
	MakeTorus(m);
	MakeSphere(out, 2);
	const auto before = SnapshotOf(m), outBefore = SnapshotOf(out);
	const auto samples = PoissonSamples(m, 350);

	EXPECT_EQ(Retriangulate::Do(m, samples, out, {}, nullptr, CancelAtOnce).status,
			  gpr::Status::Cancelled);
	const auto result = Retriangulate::Do(m, std::vector<CoordType>(), out);
	EXPECT_FALSE(result.IsOk());
	EXPECT_FALSE(result.message.empty());
	EXPECT_TRUE(SnapshotOf(m) == before);
	EXPECT_TRUE(SnapshotOf(out) == outBefore);
}

} // namespace
