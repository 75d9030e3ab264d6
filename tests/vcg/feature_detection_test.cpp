// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "support.h"

#include <vcg_extras/complex/algorithms/feature_detection.h>

using namespace gpr_test;
using namespace vcg::tri;

namespace {

template <class S>
class FeatureDetectionTest : public ::testing::Test {
};
TYPED_TEST_SUITE(FeatureDetectionTest, Scalars);

/// A square sheet of 21 by 21 vertices, folded along x = 1 by 90°.
template <class MeshType>
void MakeFold(MeshType& m)
{
	typedef typename MeshType::ScalarType ScalarType;
	vcg::tri::Grid(m, 21, 21, 2.0f, 2.0f);
	for (auto& v : m.vert)
		if (v.P()[0] > 1) {
			v.P()[2] = v.P()[0] - ScalarType(1);
			v.P()[0] = 1;
		}
	vcg::tri::UpdateBounding<MeshType>::Box(m);
}

template <class VertexType>
bool IsInFold(const VertexType& v)
{
	return std::abs(v.cP()[0] - 1) < 1e-5 && std::abs(v.cP()[2]) < 1e-5;
}

TYPED_TEST(FeatureDetectionTest, FindsAFold)
{
	using MeshType  = FullMesh<TypeParam>;
	using Detection = FeatureDetection<MeshType>;
	MeshType m;
	MakeFold(m);
	const auto                   before = SnapshotOf(m);
	typename Detection::Features features;
	typename Detection::Stat     stat;
	const auto                   result = Detection::Detect(m, features, {}, &stat);
	ASSERT_TRUE(result.IsOk()) << result.message;
	EXPECT_TRUE(SnapshotOf(m) == before);
	EXPECT_EQ(stat.edgeNum, 20);
	ASSERT_EQ(features.edges.size(), 20u);
	for (const auto& e : features.edges) {
		EXPECT_TRUE(IsInFold(*e.v[0]) && IsInFold(*e.v[1]));
		EXPECT_NEAR(e.strength, 90, 0.1);
	}
	for (std::size_t v = 0; v < m.vert.size(); ++v)
		EXPECT_EQ(features.vertexFeature[v] != 0, IsInFold(m.vert[v]));
}

TYPED_TEST(FeatureDetectionTest, WritesQualityAndSelection)
{
	using MeshType  = FullMesh<TypeParam>;
	using Detection = FeatureDetection<MeshType>;
	MeshType m;
	MakeFold(m);
	for (auto& f : m.face)
		f.SetS();
	typename Detection::Features features;
	ASSERT_TRUE(Detection::Detect(m, features).IsOk());
	Detection::WriteQuality(features, m);
	Detection::Select(features, m);
	int faces = 0;
	for (const auto& v : m.vert) {
		EXPECT_EQ(v.IsS(), IsInFold(v));
		EXPECT_TRUE(!IsInFold(v) || std::abs(v.cQ() - 90) < 0.1) << v.cQ();
	}
	for (const auto& f : m.face) {
		EXPECT_EQ(f.IsS(), f.cV(0)->IsS() || f.cV(1)->IsS() || f.cV(2)->IsS());
		faces += f.IsS();
	}
	EXPECT_EQ(faces, 80) << "two rows of 20 squares";
}

TYPED_TEST(FeatureDetectionTest, DeletedElementsAreLeftOut)
{
	using MeshType  = FullMesh<TypeParam>;
	using Detection = FeatureDetection<MeshType>;
	MeshType m;
	MakeFold(m);
	AddGaps(m);
	typename Detection::Features features;
	typename Detection::Stat     stat;
	ASSERT_TRUE(Detection::Detect(m, features, {}, &stat).IsOk());
	EXPECT_EQ(stat.edgeNum, 20);
	ASSERT_EQ(features.vertexFeature.size(), m.vert.size());
	for (std::size_t v = 0; v < m.vert.size(); ++v)
		EXPECT_EQ(features.vertexFeature[v] != 0, !m.vert[v].IsD() && IsInFold(m.vert[v]));
	for (const auto& e : features.edges)
		EXPECT_TRUE(IsInFold(*e.v[0]) && IsInFold(*e.v[1]));
}

TYPED_TEST(FeatureDetectionTest, ThresholdsCount)
{
	using MeshType  = FullMesh<TypeParam>;
	using Detection = FeatureDetection<MeshType>;
	MeshType m;
	MakeFold(m);
	typename Detection::Features features;
	typename Detection::Params   params;
	typename Detection::Stat     stat;
	params.strongAngleDeg = 100;
	ASSERT_TRUE(Detection::Detect(m, features, params, &stat).IsOk());
	EXPECT_EQ(stat.edgeNum, 0);
	params             = {};
	params.minLenRatio = 100;
	ASSERT_TRUE(Detection::Detect(m, features, params, &stat).IsOk());
	EXPECT_EQ(stat.edgeNum, 0);
	params              = {};
	params.weakAngleDeg = 41;
	EXPECT_EQ(Detection::Detect(m, features, params).status, gpr::Status::BadOptions);
}

TYPED_TEST(FeatureDetectionTest, TakesAMinimalMeshAndCanBeCancelled)
{
	using MeshType  = BareMesh<TypeParam>;
	using Detection = FeatureDetection<MeshType>;
	MeshType m;
	MakeFold(m);
	typename Detection::Features features;
	EXPECT_TRUE(Detection::Detect(m, features).IsOk());
	EXPECT_EQ(features.edges.size(), 20u);
	EXPECT_EQ(Detection::Detect(m, features, {}, nullptr, CancelAtOnce).status,
			  gpr::Status::Cancelled);
	EXPECT_EQ(features.edges.size(), 20u) << "as it was";
}

} // namespace
