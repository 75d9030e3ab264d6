// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "remeshing_params.h"
#include "support.h"

#include <algorithm>
#include <chrono>
#include <functional>
#include <thread>
#include <vcg/complex/algorithms/point_sampling.h>

using namespace gpr_test;
using namespace vcg::tri;

namespace {

template <class S>
class GeodesicPoissonRemeshingTest : public ::testing::Test {
};
TYPED_TEST_SUITE(GeodesicPoissonRemeshingTest, Scalars);

template <class MeshType>
void ExpectSameMesh(const MeshType& a, const MeshType& b)
{
	ASSERT_EQ(a.vert.size(), b.vert.size());
	ASSERT_EQ(a.face.size(), b.face.size());
	for (std::size_t v = 0; v < a.vert.size(); ++v)
		ASSERT_TRUE(a.vert[v].cP() == b.vert[v].cP()) << "vertex " << v;
	for (std::size_t f = 0; f < a.face.size(); ++f)
		for (int k = 0; k < 3; ++k)
			ASSERT_EQ(Index(a, a.face[f].cV(k)), Index(b, b.face[f].cV(k))) << "face " << f;
}

/// One-sided distance by vcglib's Metro-like sampling, from the vertices and faces of a to b.
struct Distance {
	double rms, max;
};
template <class MeshType>
Distance DistanceFrom(MeshType& a, MeshType& b)
{
	UpdateBounding<MeshType>::Box(b);
	UpdateNormal<MeshType>::PerVertexNormalizedPerFaceNormalized(a);
	HausdorffSampler<MeshType> sampler(&b);
	sampler.dist_upper_bound = b.bbox.Diag();
	SurfaceSampling<MeshType, HausdorffSampler<MeshType>>::AllVertex(a, sampler);
	SurfaceSampling<MeshType, HausdorffSampler<MeshType>>::FaceSubdivision(a, sampler, 40000,
																		   false);
	return {sampler.getRMSDist(), sampler.getMaxDist()};
}

TYPED_TEST(GeodesicPoissonRemeshingTest, MeetsTheCountAndKeepsTheTopology)
{
	using MeshType    = FullMesh<TypeParam>;
	using Remeshing   = GeodesicPoissonRemeshing<MeshType>;
	const auto sphere = [](MeshType& m) { MakeSphere(m, 4); };
	for (const std::function<void(MeshType&)>& make :
		 {std::function<void(MeshType&)>(sphere),
		  std::function<void(MeshType&)>(MakeTorus<MeshType>),
		  std::function<void(MeshType&)>(MakeSheet<MeshType>)})
		for (const int vertexNum : {200, 501, 3000}) {
			MeshType m, out;
			make(m);
			const auto before = SnapshotOf(m);
			const auto result = Remeshing::Do(m, out, ParamsOf<MeshType>(vertexNum));
			ASSERT_TRUE(result.IsOk()) << result.message;
			EXPECT_TRUE(SnapshotOf(m) == before) << "the input was touched";
			EXPECT_EQ(out.VN(), vertexNum);
			ExpectSound(out);
			EXPECT_EQ(TopologyOf(out), TopologyOf(m));
		}
}

TYPED_TEST(GeodesicPoissonRemeshingTest, KeepsComponentsApart)
{
	using MeshType  = FullMesh<TypeParam>;
	using Remeshing = GeodesicPoissonRemeshing<MeshType>;
	MeshType m, other, out;
	MakeTorus(m);
	MakeSphere(other, 4);
	Append<MeshType, MeshType>::Mesh(m, other);
	const auto result = Remeshing::Do(m, out, ParamsOf<MeshType>(800));
	ASSERT_TRUE(result.IsOk()) << result.message;
	EXPECT_EQ(out.VN(), 800);
	ExpectSound(out);
	EXPECT_EQ(TopologyOf(out), TopologyOf(m));
	EXPECT_EQ(TopologyOf(out).componentNum, 2);
}

TYPED_TEST(GeodesicPoissonRemeshingTest, InPlaceGivesTheSameMesh)
{
	using MeshType  = FullMesh<TypeParam>;
	using Remeshing = GeodesicPoissonRemeshing<MeshType>;
	// A third of the vertices, and half as many again: with and without room in the containers.
	for (const int vertexNum : {1500, 7000}) {
		MeshType m, out;
		MakeTorus(m);
		ASSERT_TRUE(Remeshing::Do(m, out, ParamsOf<MeshType>(vertexNum)).IsOk());
		ASSERT_TRUE(Remeshing::Do(m, ParamsOf<MeshType>(vertexNum)).IsOk());
		ExpectSameMesh(m, out);
	}
}

TYPED_TEST(GeodesicPoissonRemeshingTest, NormalsBoxAndAdjacencyAreTrue)
{
	using MeshType  = FullMesh<TypeParam>;
	using Remeshing = GeodesicPoissonRemeshing<MeshType>;
	MeshType m;
	MakeSphere(m, 4);
	m.bbox.Offset(5);
	ASSERT_TRUE(Remeshing::Do(m, ParamsOf<MeshType>(600)).IsOk());
	EXPECT_TRUE(Clean<MeshType>::IsFFAdjacencyConsistent(m));
	typename MeshType::BoxType box;
	for (auto& v : m.vert) {
		box.Add(v.P());
		EXPECT_GT(v.N() * v.P(), 0.98) << "on a unit sphere";
		ASSERT_NE(v.VFp(), nullptr);
		EXPECT_EQ(v.VFp()->V(v.VFi()), &v);
	}
	EXPECT_TRUE(box == m.bbox);
	for (const auto& f : m.face)
		EXPECT_NEAR(f.cN().Norm(), 1, 1e-5);
}

TYPED_TEST(GeodesicPoissonRemeshingTest, CarriesColourAndQualityOver)
{
	using MeshType  = FullMesh<TypeParam>;
	using Remeshing = GeodesicPoissonRemeshing<MeshType>;
	MeshType m;
	MakeSheet(m);
	for (auto& v : m.vert) {
		v.Q() = 2 * v.P()[0] - v.P()[1];
		v.C() = vcg::Color4b((unsigned char) (80 * v.P()[0]), 200, 3, 255);
	}
	ASSERT_TRUE(Remeshing::Do(m, ParamsOf<MeshType>(600)).IsOk());
	// Functions linear on every face are carried exactly to vertices that the fit then moves a
	// little; colours are cut to whole numbers.
	for (const auto& v : m.vert) {
		EXPECT_NEAR(v.cQ(), 2 * v.cP()[0] - v.cP()[1], 5e-3);
		EXPECT_NEAR(v.cC()[0], 80 * v.cP()[0], 2);
		EXPECT_EQ(v.cC()[1], 200);
		EXPECT_EQ(v.cC()[2], 3);
		EXPECT_EQ(v.cC()[3], 255);
	}
}

TYPED_TEST(GeodesicPoissonRemeshingTest, GapsInTheVectorsAreNoVertices)
{
	using MeshType  = FullMesh<TypeParam>;
	using Remeshing = GeodesicPoissonRemeshing<MeshType>;
	MeshType m, compact, a, b;
	MakeTorus(m);
	AddGaps(m);
	Append<MeshType, MeshType>::MeshCopy(compact, m);
	ASSERT_EQ(compact.VN(), int(compact.vert.size()));
	ASSERT_LT(m.VN(), int(m.vert.size()));
	typename Remeshing::Params params;
	params.SetTargetPerc(20);
	ASSERT_TRUE(Remeshing::Do(m, a, params).IsOk());
	ASSERT_TRUE(Remeshing::Do(compact, b, params).IsOk());
	ExpectSameMesh(a, b);
	ASSERT_TRUE(Remeshing::Do(m, params).IsOk());
	ExpectSameMesh(m, b);
}

TYPED_TEST(GeodesicPoissonRemeshingTest, RepairIsCounted)
{
	using MeshType  = FullMesh<TypeParam>;
	using Remeshing = GeodesicPoissonRemeshing<MeshType>;
	using CoordType = typename MeshType::CoordType;
	MeshType m, out;
	MakeTorus(m);
	// A fin: an edge of three faces. And a vertex in no face.
	Allocator<MeshType>::AddVertex(m, m.vert[0].P() * TypeParam(1.3));
	Allocator<MeshType>::AddFace(m, m.face[0].V(0), m.face[0].V(1), &m.vert.back());
	Allocator<MeshType>::AddVertex(m, CoordType(9, 9, 9));
	typename Remeshing::Stat stat;
	const auto               result = Remeshing::Do(m, out, ParamsOf<MeshType>(600), &stat);
	ASSERT_TRUE(result.IsOk()) << result.message;
	EXPECT_GT(stat.cleaned.nonManifoldEdges, 0);
	EXPECT_EQ(stat.cleaned.unreferencedVertices, 1);
	EXPECT_TRUE(stat.audit.passed);
	ExpectSound(out);
}

int  callNum = 0;
bool CancelInTheMidst(const int, const char*)
{
	// The engine reports by the clock; after this pause the engine reports again as soon as
	// possible.
	std::this_thread::sleep_for(std::chrono::milliseconds(100));
	return ++callNum < 3;
}

TYPED_TEST(GeodesicPoissonRemeshingTest, AFailureTouchesNothing)
{
	using MeshType  = FullMesh<TypeParam>;
	using Remeshing = GeodesicPoissonRemeshing<MeshType>;
	MeshType m, out, empty;
	MakeTorus(m);
	MakeSphere(out, 3);
	const auto               before = SnapshotOf(m), outBefore = SnapshotOf(out);
	typename Remeshing::Stat stat;
	GeodesicPoissonResult    result;

	for (vcg::CallBackPos* cb : {CancelAtOnce, CancelInTheMidst}) {
		callNum = 0;
		result  = Remeshing::Do(m, ParamsOf<MeshType>(500), &stat, cb);
		EXPECT_EQ(result.status, gpr::Status::Cancelled);
		EXPECT_FALSE(result.message.empty());
		callNum = 0;
		result  = Remeshing::Do(m, out, ParamsOf<MeshType>(500), nullptr, cb);
		EXPECT_EQ(result.status, gpr::Status::Cancelled);
	}

	result = Remeshing::Do(m, ParamsOf<MeshType>(0));
	EXPECT_EQ(result.status, gpr::Status::BadOptions);
	auto params          = ParamsOf<MeshType>(500);
	params.umbrellaSteps = -1;
	result               = Remeshing::Do(m, out, params);
	EXPECT_EQ(result.status, gpr::Status::BadOptions);

	result = Remeshing::Do(m, ParamsOf<MeshType>(4)); // a torus needs at least seven
	EXPECT_EQ(result.status, gpr::Status::CountTooSmall);
	EXPECT_GE(result.smallestVertexNum, 7);

	EXPECT_TRUE(SnapshotOf(m) == before);
	result = Remeshing::Do(empty, out, ParamsOf<MeshType>(500));
	EXPECT_EQ(result.status, gpr::Status::UnusableInput);
	EXPECT_FALSE(result.message.empty());
	EXPECT_TRUE(SnapshotOf(out) == outBefore);

	m.face[3].V(1)    = nullptr;
	const auto broken = SnapshotOf(m);
	result            = Remeshing::Do(m, ParamsOf<MeshType>(500));
	EXPECT_EQ(result.status, gpr::Status::UnusableInput);
	EXPECT_TRUE(SnapshotOf(m) == broken);
}

int  lastPercent = -1;
bool WatchProgress(const int percent, const char* phrase)
{
	EXPECT_GE(percent, lastPercent);
	EXPECT_LE(percent, 100);
	EXPECT_TRUE(phrase != nullptr && *phrase != 0);
	lastPercent = percent;
	return true;
}

TYPED_TEST(GeodesicPoissonRemeshingTest, ProgressRisesAndChangesNothing)
{
	using MeshType  = FullMesh<TypeParam>;
	using Remeshing = GeodesicPoissonRemeshing<MeshType>;
	MeshType m, a, b;
	MakeTorus(m);
	lastPercent = -1;
	ASSERT_TRUE(Remeshing::Do(m, a, ParamsOf<MeshType>(500), nullptr, WatchProgress).IsOk());
	EXPECT_GE(lastPercent, 0);
	ASSERT_TRUE(Remeshing::Do(m, b, ParamsOf<MeshType>(500)).IsOk());
	ExpectSameMesh(a, b);
}

TYPED_TEST(GeodesicPoissonRemeshingTest, LiesCloseToTheSurface)
{
	using MeshType  = FullMesh<TypeParam>;
	using Remeshing = GeodesicPoissonRemeshing<MeshType>;
	MeshType m, out;
	MakeSphere(m, 5);
	typename Remeshing::Stat stat;
	ASSERT_TRUE(Remeshing::Do(m, out, ParamsOf<MeshType>(1000), &stat).IsOk());
	// A chord of length L sags by L²/8 on a unit sphere, a face by L²/6 in its middle.
	const double len = stat.quality.meanEdgeLen;
	EXPECT_NEAR(len, 0.12, 0.02);
	const Distance there = DistanceFrom(out, m), back = DistanceFrom(m, out);
	for (const Distance& d : {there, back}) {
		EXPECT_LT(d.max, 1.8 * len * len / 6);
		EXPECT_LT(d.rms, 1.0 * len * len / 6);
		EXPECT_GT(d.rms, 0.1 * len * len / 6) << "the measure measures nothing";
	}
}

TEST(GeodesicPoissonRemeshingOfEitherScalar, IsOfEqualQuality)
{
	FullMesh<float>  f;
	FullMesh<double> d;
	MakeTorus(f);
	MakeTorus(d);
	ASSERT_TRUE(
		GeodesicPoissonRemeshing<FullMesh<float>>::Do(f, ParamsOf<FullMesh<float>>(700)).IsOk());
	ASSERT_TRUE(
		GeodesicPoissonRemeshing<FullMesh<double>>::Do(d, ParamsOf<FullMesh<double>>(700)).IsOk());
	EXPECT_GT(MeanRadiusRatio(f), 0.96);
	EXPECT_GT(MeanRadiusRatio(d), 0.96);
	EXPECT_NEAR(MeanRadiusRatio(f), MeanRadiusRatio(d), 0.01);
	EXPECT_NEAR(Stat<FullMesh<float>>::ComputeMeshArea(f),
				Stat<FullMesh<double>>::ComputeMeshArea(d), 0.1);
}

} // namespace
