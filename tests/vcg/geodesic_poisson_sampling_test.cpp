// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "support.h"

#include <vcg_extras/complex/algorithms/geodesic_poisson_sampling.h>

#include <algorithm>

using namespace gpr_test;
using namespace vcg::tri;

namespace {

/// The least spacing is (1-ε) r in the sampler's metric, less an allowance for the error of the
/// metric.
const double spacingShare = 0.95 - 0.03;
/// Every vertex lies within r of a sample, with the same allowance.
const double coverageShare = 1.03;

template <class MeshType>
typename GeodesicPoissonSampling<MeshType>::Params ParamsOf(int vertexNum)
{
	typename GeodesicPoissonSampling<MeshType>::Params params;
	params.SetTargetVertexNum(vertexNum);
	return params;
}

template <class S>
class GeodesicPoissonSamplingTest : public ::testing::Test {
};
TYPED_TEST_SUITE(GeodesicPoissonSamplingTest, Scalars);

/// Distance along the unit sphere.
template <class CoordType>
double ArcLength(const CoordType& a, const CoordType& b)
{
	return 2 * std::asin(std::min(1.0, double((a - b).Norm()) / 2));
}

TYPED_TEST(GeodesicPoissonSamplingTest, SamplesLieWhereTheirFaceAndWeightsSay)
{
	using MeshType    = FullMesh<TypeParam>;
	using Sampling    = GeodesicPoissonSampling<MeshType>;
	using SamplePoint = typename Sampling::SamplePoint;
	MeshType m;
	MakeSheet(m);
	std::vector<SamplePoint> samples;
	const auto               result = Sampling::Sample(m, ParamsOf<MeshType>(300), samples);
	ASSERT_TRUE(result.IsOk()) << result.message;
	ASSERT_FALSE(samples.empty());
	for (const auto& s : samples) {
		ASSERT_GE(s.face, &m.face.front());
		ASSERT_LE(s.face, &m.face.back());
		double sum = 0;
		for (int k = 0; k < 3; ++k) {
			EXPECT_GE(s.barycentric[k], -1e-5);
			sum += s.barycentric[k];
		}
		EXPECT_NEAR(sum, 1, 1e-5);
		const auto p = s.face->P(0) * s.barycentric[0] + s.face->P(1) * s.barycentric[1] +
					   s.face->P(2) * s.barycentric[2];
		EXPECT_LT((p - s.position).Norm(), 1e-5 * m.bbox.Diag());
	}
}

TYPED_TEST(GeodesicPoissonSamplingTest, KeepsTheSpacingAndCoversTheSphere)
{
	using MeshType    = FullMesh<TypeParam>;
	using Sampling    = GeodesicPoissonSampling<MeshType>;
	using SamplePoint = typename Sampling::SamplePoint;
	MeshType m;
	MakeSphere(m, 5);
	std::vector<SamplePoint> samples;
	typename Sampling::Stat  stat;
	const int                targetNum = 500;
	const auto result = Sampling::Sample(m, ParamsOf<MeshType>(targetNum), samples, &stat);
	ASSERT_TRUE(result.IsOk()) << result.message;
	EXPECT_GT(samples.size(), 0.85 * targetNum);
	EXPECT_LT(samples.size(), 1.15 * targetNum);
	ASSERT_GT(stat.diskRadius, 0);
	EXPECT_EQ(stat.sampleNum, std::int64_t(samples.size()));

	double minSpacing = 10;
	for (std::size_t i = 0; i < samples.size(); ++i)
		for (std::size_t j = 0; j < i; ++j)
			minSpacing = std::min(minSpacing, ArcLength(samples[i].position, samples[j].position));
	EXPECT_GE(minSpacing, spacingShare * stat.diskRadius);

	double farthest = 0;
	for (const auto& v : m.vert) {
		double nearest = 10;
		for (const auto& s : samples)
			nearest = std::min(nearest, ArcLength(v.cP(), s.position));
		farthest = std::max(farthest, nearest);
	}
	EXPECT_LE(farthest, coverageShare * stat.diskRadius);
}

TYPED_TEST(GeodesicPoissonSamplingTest, APointMeshCarriesTheSamplesAndTheRadius)
{
	using MeshType    = FullMesh<TypeParam>;
	using Sampling    = GeodesicPoissonSampling<MeshType>;
	using SamplePoint = typename Sampling::SamplePoint;
	MeshType m, points;
	MakeSphere(m, 4);
	for (auto& v : m.vert)
		v.C() = vcg::Color4b::Green;
	MakeTorus(points); // to be dropped
	std::vector<SamplePoint> samples;
	typename Sampling::Stat  stat;
	ASSERT_TRUE(Sampling::Sample(m, ParamsOf<MeshType>(200), samples).IsOk());
	ASSERT_TRUE(Sampling::Sample(m, ParamsOf<MeshType>(200), points, &stat).IsOk());

	ASSERT_EQ(points.vert.size(), samples.size());
	EXPECT_EQ(points.VN(), int(samples.size()));
	EXPECT_EQ(points.FN(), 0);
	for (std::size_t i = 0; i < samples.size(); ++i) {
		const auto& v = points.vert[i];
		EXPECT_TRUE(v.cP() == samples[i].position) << "the same run in another form";
		EXPECT_EQ(v.cQ(), TypeParam(stat.diskRadius));
		EXPECT_TRUE(v.cC() == vcg::Color4b(vcg::Color4b::Green));
		EXPECT_NEAR(v.cN().Norm(), 1, 1e-5);
		EXPECT_GT(v.cN() * v.cP(), 0.9) << "on a sphere the normal points away from the middle";
		EXPECT_TRUE(points.bbox.IsIn(v.cP()));
	}
	EXPECT_LT(points.bbox.Diag(), 1.01 * m.bbox.Diag());
}

TYPED_TEST(GeodesicPoissonSamplingTest, DependsOnTheSeedAndNotOnThreads)
{
	using MeshType    = FullMesh<TypeParam>;
	using Sampling    = GeodesicPoissonSampling<MeshType>;
	using SamplePoint = typename Sampling::SamplePoint;
	MeshType m;
	MakeTorus(m);
	std::vector<SamplePoint> a, b, c;
	auto                     params = ParamsOf<MeshType>(400);
	params.threads                  = 1;
	ASSERT_TRUE(Sampling::Sample(m, params, a).IsOk());
	params.threads = 2;
	ASSERT_TRUE(Sampling::Sample(m, params, b).IsOk());
	params.seed = 2;
	ASSERT_TRUE(Sampling::Sample(m, params, c).IsOk());
	const auto same = [](const SamplePoint& p, const SamplePoint& q) {
		return p.position == q.position && p.face == q.face && p.barycentric == q.barycentric;
	};
	EXPECT_TRUE(std::equal(a.begin(), a.end(), b.begin(), b.end(), same));
	EXPECT_FALSE(std::equal(a.begin(), a.end(), c.begin(), c.end(), same));
}

TYPED_TEST(GeodesicPoissonSamplingTest, GapsInTheVectorsChangeNothing)
{
	using MeshType    = FullMesh<TypeParam>;
	using Sampling    = GeodesicPoissonSampling<MeshType>;
	using SamplePoint = typename Sampling::SamplePoint;
	MeshType m;
	MakeSheet(m);
	AddGaps(m);
	std::vector<SamplePoint> samples;
	ASSERT_TRUE(Sampling::Sample(m, ParamsOf<MeshType>(300), samples).IsOk());
	ASSERT_FALSE(samples.empty());
	for (const auto& s : samples) {
		ASSERT_FALSE(s.face->IsD());
		const auto p = s.face->P(0) * s.barycentric[0] + s.face->P(1) * s.barycentric[1] +
					   s.face->P(2) * s.barycentric[2];
		EXPECT_LT((p - s.position).Norm(), 1e-5 * m.bbox.Diag());
	}
}

TYPED_TEST(GeodesicPoissonSamplingTest, AFailureTouchesNothing)
{
	using MeshType    = FullMesh<TypeParam>;
	using Sampling    = GeodesicPoissonSampling<MeshType>;
	using SamplePoint = typename Sampling::SamplePoint;
	MeshType m, points, empty;
	MakeTorus(m);
	MakeSphere(points, 2);
	std::vector<SamplePoint> samples(3);
	const auto               before = SnapshotOf(m), pointsBefore = SnapshotOf(points);

	auto result = Sampling::Sample(m, ParamsOf<MeshType>(400), samples, nullptr, CancelAtOnce);
	EXPECT_EQ(result.status, gpr::Status::Cancelled);
	result = Sampling::Sample(m, ParamsOf<MeshType>(400), points, nullptr, CancelAtOnce);
	EXPECT_EQ(result.status, gpr::Status::Cancelled);
	result = Sampling::Sample(m, ParamsOf<MeshType>(-5), samples);
	EXPECT_EQ(result.status, gpr::Status::BadOptions);
	EXPECT_FALSE(result.message.empty());
	result = Sampling::Sample(empty, ParamsOf<MeshType>(400), points);
	EXPECT_EQ(result.status, gpr::Status::UnusableInput);
	EXPECT_FALSE(result.message.empty());

	EXPECT_EQ(samples.size(), 3u);
	EXPECT_TRUE(SnapshotOf(m) == before);
	EXPECT_TRUE(SnapshotOf(points) == pointsBefore);
}

} // namespace
