// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "support.h"

#include <vcg_extras/complex/algorithms/attribute_transfer.h>
#include <vcg_extras/complex/algorithms/geodesic_poisson_remeshing.h>
#include <vcg_extras/complex/algorithms/mesh_conversion.h>

using namespace gpr_test;
using namespace vcg::tri;
using gpr_detail::AttributesAtPoints;
using gpr_detail::FlatMesh;

namespace {

template <class S>
class MeshConversion : public ::testing::Test {
};
TYPED_TEST_SUITE(MeshConversion, Scalars);

/// Two triangles of a unit square.
template <class MeshType>
void MakeSquare(MeshType& m)
{
	typedef typename MeshType::CoordType CoordType;
	for (const CoordType& p :
		 {CoordType(0, 0, 0), CoordType(1, 0, 0), CoordType(1, 1, 0), CoordType(0, 1, 0)})
		Allocator<MeshType>::AddVertex(m, p);
	Allocator<MeshType>::AddFace(m, 0, 1, 2);
	Allocator<MeshType>::AddFace(m, 0, 2, 3);
}

TYPED_TEST(MeshConversion, ViewsACompactMeshInPlace)
{
	using MeshType = FullMesh<TypeParam>;
	MeshType m;
	MakeSquare(m);
	const FlatMesh<MeshType> flat(m);
	const gpr::MeshView      view = flat.View();
	EXPECT_EQ(view.positions, static_cast<const void*>(&m.vert[0].P()));
	EXPECT_EQ(view.doublePrecision, sizeof(TypeParam) == sizeof(double));
	ASSERT_EQ(view.vertexNum, 4u);
	ASSERT_EQ(view.faceNum, 2u);
	for (std::size_t v = 0; v < 4; ++v) {
		EXPECT_EQ(view.position(v).x, double(m.vert[v].P()[0]));
		EXPECT_EQ(view.position(v).y, double(m.vert[v].P()[1]));
	}
	EXPECT_EQ(gpr::triangleMeshOf(view).triangles, (std::vector<std::int32_t>{0, 1, 2, 0, 2, 3}));
	EXPECT_EQ(flat.Face(1), &m.face[1]);
}

TYPED_TEST(MeshConversion, LeavesOutDeletedElements)
{
	using MeshType = FullMesh<TypeParam>;
	MeshType m;
	MakeSquare(m);
	AddGaps(m);
	const FlatMesh<MeshType> flat(m);
	const gpr::MeshView      view = flat.View();
	ASSERT_EQ(view.vertexNum, 4u);
	ASSERT_EQ(view.faceNum, 2u);
	for (std::size_t f = 0; f < 2; ++f) {
		ASSERT_FALSE(flat.Face(std::int32_t(f))->IsD());
		for (int k = 0; k < 3; ++k) {
			const auto&      p = flat.Face(std::int32_t(f))->cP(k);
			const gpr::Vec3d q = view.position(std::size_t(view.vertexOf(3 * f + k)));
			EXPECT_TRUE(double(p[0]) == q.x && double(p[1]) == q.y && double(p[2]) == q.z);
		}
	}
}

TYPED_TEST(MeshConversion, FindsSelectedEdges)
{
	using MeshType = FullMesh<TypeParam>;
	MeshType m;
	MakeSquare(m);
	AddGaps(m);
	const std::vector<std::uint8_t> others = {0, 0, 1, 0, 0, 0};
	EXPECT_TRUE(vcg::tri::gpr_detail::SelectedEdges(m, others.data()).empty())
		<< "none is selected";
	int live = 0;
	for (auto& f : m.face) {
		if (!f.IsD() && live++ == 1) f.SetFaceEdgeS(1);
	}
	EXPECT_EQ(vcg::tri::gpr_detail::SelectedEdges(m, nullptr),
			  std::vector<std::uint8_t>({0, 0, 0, 0, 1, 0}));
	EXPECT_EQ(vcg::tri::gpr_detail::SelectedEdges(m, others.data()),
			  std::vector<std::uint8_t>({0, 0, 1, 0, 1, 0}));
}

TYPED_TEST(MeshConversion, DeletedFacesAloneKeepThePositionsInPlace)
{
	using MeshType = FullMesh<TypeParam>;
	MeshType m;
	MakeSquare(m);
	Allocator<MeshType>::DeleteFace(m, m.face[0]);
	const FlatMesh<MeshType> flat(m);
	EXPECT_EQ(flat.View().positions, static_cast<const void*>(&m.vert[0].P()));
	ASSERT_EQ(flat.View().faceNum, 1u);
	EXPECT_EQ(flat.Face(0), &m.face[1]);
}

TYPED_TEST(MeshConversion, MarksCornersThatAreNoVertices)
{
	using MeshType = FullMesh<TypeParam>;
	MeshType m, other;
	MakeSquare(m);
	MakeSquare(other);
	Allocator<MeshType>::AddVertices(m, 1);
	m.face[0].V(0) = nullptr;
	m.face[0].V(1) = &other.vert[0];
	m.face[0].V(2) = &m.vert[4];
	Allocator<MeshType>::DeleteVertex(m, m.vert[4]);
	const FlatMesh<MeshType> flat(m);
	for (int k = 0; k < 3; ++k)
		EXPECT_EQ(flat.View().vertexOf(k), -1);
	EXPECT_EQ(flat.View().vertexOf(3), 0);
}

TYPED_TEST(MeshConversion, TakesAnEmptyMesh)
{
	using MeshType = FullMesh<TypeParam>;
	MeshType                 m;
	const FlatMesh<MeshType> flat(m);
	EXPECT_EQ(flat.View().vertexNum, 0u);
	EXPECT_EQ(flat.View().faceNum, 0u);
}

TYPED_TEST(MeshConversion, CarriesAttributesByTheirWeights)
{
	using MeshType = FullMesh<TypeParam>;
	MeshType m, to;
	MakeSquare(m);
	for (auto& v : m.vert) {
		v.Q() = 3 * v.P()[0] - v.P()[1];
		v.C() = vcg::Color4b(255, 77, 1, 254);
	}
	const std::vector<gpr::BarycentricPoint> surfacePoints = {{0, {0.2f, 0.3f, 0.5f}},
															  {1, {0.1f, 0.1f, 0.8f}}};
	const FlatMesh<MeshType>                 flat(m);
	AttributesAtPoints<MeshType>             attributes;
	attributes.ReadVertices(m, to, surfacePoints, [&](std::int32_t f) { return flat.Face(f); });
	Allocator<MeshType>::AddVertices(to, 2);
	attributes.Write(to);
	EXPECT_NEAR(to.vert[0].Q(), 3 * 0.8 - 0.5, 1e-6);
	EXPECT_NEAR(to.vert[1].Q(), 3 * 0.1 - 0.9, 1e-6);
	for (const auto& v : to.vert)
		EXPECT_TRUE(v.cC() == vcg::Color4b(255, 77, 1, 254)) << "a constant colour has changed";
}

TYPED_TEST(MeshConversion, CarriesOptionalComponentsOnlyWhereBothHaveThemEnabled)
{
	typedef OcfMesh<TypeParam> MeshType;
	MeshType                   m, to;
	MakeSquare(m);
	m.vert.EnableQuality();
	m.vert.EnableColor();
	to.vert.EnableQuality();
	for (auto& v : m.vert)
		v.Q() = 7;
	const std::vector<gpr::BarycentricPoint> surfacePoints(3, gpr::BarycentricPoint{0, {1, 0, 0}});
	const FlatMesh<MeshType>                 flat(m);
	AttributesAtPoints<MeshType>             attributes;
	attributes.ReadVertices(m, to, surfacePoints, [&](std::int32_t f) { return flat.Face(f); });
	Allocator<MeshType>::AddVertices(to, 3);
	attributes.Write(to);
	EXPECT_FALSE(HasPerVertexColor(to));
	for (const auto& v : to.vert)
		EXPECT_EQ(v.cQ(), 7);
}

TYPED_TEST(MeshConversion, ReplacedElementsKeepNothingOld)
{
	typedef OcfMesh<TypeParam> MeshType;
	MeshType                   m;
	MakeSquare(m);
	m.vert.EnableQuality();
	m.face.EnableFFAdjacency();
	UpdateTopology<MeshType>::FaceFace(m);
	auto attribute = Allocator<MeshType>::template GetPerVertexAttribute<int>(m, "number");
	for (auto& v : m.vert) {
		v.Q() = 9;
		v.SetS();
		attribute[v] = 5;
	}
	m.C() = vcg::Color4b::Red;

	for (const std::size_t vertNum : {3u, 40u}) {
		gpr_detail::ReplaceElements(m, vertNum, vertNum - 2);
		ASSERT_EQ(m.vert.size(), vertNum);
		ASSERT_EQ(m.face.size(), vertNum - 2);
		EXPECT_EQ(m.VN(), int(vertNum));
		EXPECT_EQ(m.FN(), int(vertNum) - 2);
		EXPECT_TRUE(m.C() == vcg::Color4b(vcg::Color4b::Red));
		for (auto& v : m.vert) {
			EXPECT_EQ(v.Q(), 0);
			EXPECT_FALSE(v.IsS());
			EXPECT_EQ(attribute[v], 0);
			v.Q()        = 9;
			attribute[v] = 5;
		}
		for (auto& f : m.face)
			EXPECT_EQ(f.cFFp(0), nullptr);
	}
	Allocator<MeshType>::DeletePerVertexAttribute(m, "number"); // vcglib never frees attributes
}

std::vector<int> reported;
bool             Report(const int percent, const char*)
{
	reported.push_back(percent);
	return percent < 50;
}

TEST(Progress, IsPassedOnInPercentAndItsAnswerBack)
{
	EXPECT_FALSE(gpr_detail::ProgressOf(nullptr));
	reported.clear();
	const gpr::ProgressCallback progress = gpr_detail::ProgressOf(Report);
	EXPECT_TRUE(progress(0.25, "a"));
	EXPECT_FALSE(progress(0.5, "b"));
	EXPECT_FALSE(progress(1.5, "c"));
	EXPECT_TRUE(progress(-1, "d"));
	EXPECT_EQ(reported, (std::vector<int>{25, 50, 100, 0}));
}

} // namespace
