// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The remeshing filter, called as by MeshLab.

#include "host.h"
#include "mesh_bridge.h"

#include <vcg_extras/core/remesh.h>

#include <QRegularExpression>
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <stdexcept>
#include <vcg/complex/algorithms/clean.h>
#include <vcg/complex/algorithms/update/selection.h>

namespace {

using namespace plugin_test;

RichParameterList withCount(Document& document, int vertexNum)
{
	RichParameterList list = defaults(document);
	list.setValue("TargetVertexNum", IntValue(vertexNum));
	return list;
}

TEST(Filter, HostFindsAllAndTheirTexts)
{
	for (gpr_filter::Filter filter :
		 {gpr_filter::RemeshFilter, gpr_filter::SamplingFilter, gpr_filter::RetriangulateFilter,
		  gpr_filter::FeatureFilter, gpr_filter::CompareFilter}) {
		QAction* const action = actionOf(filter);
		ASSERT_NE(action, nullptr) << filter;
		EXPECT_EQ(action->parent(), dynamic_cast<QObject*>(&plugin()));
		EXPECT_EQ(plugin().ID(action), int(filter));
		EXPECT_EQ(plugin().getPreConditions(action), MeshModel::MM_FACENUMBER);
		const QString info = plugin().filterInfo(action);
		EXPECT_TRUE(info.contains("Fast Edge-based geodesic Poisson Disk Remeshing"));
	}
}

TEST(Filter, ClassAndPostCondition)
{
	QAction* const remeshing = actionOf(gpr_filter::RemeshFilter);
	EXPECT_EQ(plugin().getClass(remeshing), PluginInterface::Remeshing);
	EXPECT_EQ(plugin().postCondition(remeshing), MeshModel::MM_GEOMETRY_AND_TOPOLOGY_CHANGE);
	QAction* const sampling = actionOf(gpr_filter::SamplingFilter);
	EXPECT_EQ(plugin().getClass(sampling), PluginInterface::Sampling);
	EXPECT_EQ(plugin().postCondition(sampling), MeshModel::MM_NONE);
	QAction* const retriangulation = actionOf(gpr_filter::RetriangulateFilter);
	EXPECT_EQ(plugin().getClass(retriangulation), PluginInterface::Remeshing);
	EXPECT_EQ(plugin().postCondition(retriangulation), MeshModel::MM_GEOMETRY_AND_TOPOLOGY_CHANGE);
	QAction* const comparison = actionOf(gpr_filter::CompareFilter);
	EXPECT_EQ(plugin().getClass(comparison),
			  PluginInterface::Remeshing | PluginInterface::MeshCreation);
	EXPECT_EQ(plugin().postCondition(comparison), MeshModel::MM_NONE);
	QAction* const features = actionOf(gpr_filter::FeatureFilter);
	EXPECT_EQ(plugin().getClass(features), PluginInterface::Selection | PluginInterface::Quality);
	EXPECT_EQ(plugin().postCondition(features),
			  MeshModel::MM_VERTQUALITY | MeshModel::MM_VERTFLAGSELECT);
}

TEST(Filter, RemeshesInPlace)
{
	Document   document;
	MeshModel& ball = addBall(document);
	ASSERT_TRUE(apply(document, withCount(document, 700))) << document.logText().toStdString();
	EXPECT_EQ(document.layerNum(), 1);
	EXPECT_EQ(ball.cm.vn, 700);
	EXPECT_EQ(ball.cm.fn, 2 * 700 - 4); // a ball: V - E + F = 2
	expectSoundMesh(ball.cm);
	for (const CVertexO& v : ball.cm.vert) {
		ASSERT_GT(v.cN() * v.cP() / v.cN().Norm(), 0.9) << "a vertex normal is stale";
	}
	const auto expected = document.logText().indexOf("Expected: about ");
	EXPECT_GE(expected, 0);
	EXPECT_GT(document.logText().indexOf("to 700 vertices"), expected);
	EXPECT_TRUE(document.logText().contains("% of the diagonal) off the surface"));
}

/// Root mean square, p99.9 and largest of both directions.
TEST(Filter, LogHasTheDistancesThatTheCheckMeasures)
{
	const QRegularExpression ofOneWay(
		"Distance from the (result to the input|input to the result): "
		"RMS 0\\.\\d+ \\(0\\.\\d+ % of the diagonal\\), "
		"p99\\.9 0\\.\\d+ \\(0\\.\\d+ % of the diagonal\\), "
		"largest 0\\.\\d+ \\(0\\.\\d+ % of the diagonal\\)");
	for (const bool check : {false, true}) {
		Document          document;
		RichParameterList list = (addBall(document), withCount(document, 700));
		list.setValue("Check", BoolValue(check));
		ASSERT_TRUE(apply(document, list)) << document.logText().toStdString();
		const QString log   = document.logText();
		int           lines = 0;
		for (auto match = ofOneWay.globalMatch(log); match.hasNext(); match.next())
			++lines;
		EXPECT_EQ(lines, check ? 2 : 0) << log.toStdString();
		EXPECT_EQ(log.contains("99.9 % of the surface is nearer than p99.9"), check);
	}
}

/// Cuts a mesh in two: left and right faces get separate vertices.
void cutInTwo(CMeshO& mesh)
{
	const auto isLeft = [&](CFaceO& f) {
		const Scalarm middle = (f.P(0)[0] + f.P(1)[0] + f.P(2)[0]) / 3;
		return middle < mesh.bbox.Center()[0];
	};
	std::vector<int> sides(mesh.vert.size(), 0), copyOf(mesh.vert.size(), -1);
	for (CFaceO& f : mesh.face) {
		for (int k = 0; k < 3; ++k)
			sides[vcg::tri::Index(mesh, f.V(k))] |= isLeft(f) ? 1 : 2;
	}
	int added = int(mesh.vert.size());
	for (std::size_t v = 0; v < sides.size(); ++v) {
		if (sides[v] == 3) copyOf[v] = added++;
	}
	vcg::tri::Allocator<CMeshO>::AddVertices(mesh, std::size_t(added) - sides.size());
	for (std::size_t v = 0; v < sides.size(); ++v) {
		if (copyOf[v] >= 0) mesh.vert[std::size_t(copyOf[v])].P() = mesh.vert[v].P();
	}
	for (CFaceO& f : mesh.face) {
		if (!isLeft(f)) continue;
		for (int k = 0; k < 3; ++k) {
			const int copy = copyOf[vcg::tri::Index(mesh, f.V(k))];
			if (copy >= 0) f.V(k) = &mesh.vert[std::size_t(copy)];
		}
	}
}

TEST(Filter, SewsSeamsUnlessOneSaysNo)
{
	for (const bool sews : {true, false}) {
		Document   document;
		MeshModel& sheet = addSheet(document);
		cutInTwo(sheet.cm);
		RichParameterList list = withCount(document, 300);
		list.setValue("SewSeams", BoolValue(sews));
		ASSERT_TRUE(apply(document, list)) << document.logText().toStdString();
		EXPECT_EQ(document.logText().contains("edges of seams sewn"), sews);
		sheet.updateDataMask(MeshModel::MM_FACEFACETOPO);
		EXPECT_EQ(vcg::tri::Clean<CMeshO>::CountConnectedComponents(sheet.cm), sews ? 1 : 2);
	}
}

TEST(Filter, MoreVerticesThanBefore)
{
	Document   document;
	MeshModel& sheet = addSheet(document);
	ASSERT_TRUE(apply(document, withCount(document, 5202))) << document.logText().toStdString();
	EXPECT_EQ(sheet.cm.vn, 5202);
	expectSoundMesh(sheet.cm);
}

TEST(Filter, SameBitsAsTheEngine)
{
	Document   document;
	MeshModel& ball = addBall(document);

	gpr::RemeshOptions options;
	options.targetMode                 = gpr::TargetMode::VertexNum;
	options.targetVertexNum            = 500;
	options.seed                       = 7;
	const gpr_filter::LayerCopy copy   = gpr_filter::copyLayer(ball.cm, {});
	const gpr::RemeshResult     wanted = gpr::remesh(copy.view(), options);
	ASSERT_EQ(wanted.status, gpr::Status::Ok) << wanted.message;

	RichParameterList list = withCount(document, 500);
	list.setValue("Seed", IntValue(7));
	list.setValue("Threads", IntValue(1));
	ASSERT_TRUE(apply(document, list));
	const gpr_filter::LayerCopy got = gpr_filter::copyLayer(ball.cm, {});
	EXPECT_EQ(got.triangles, wanted.mesh.triangles);
	ASSERT_EQ(got.positions.size(), wanted.mesh.positions.size());
	for (std::size_t v = 0; v < got.positions.size(); ++v) {
		ASSERT_TRUE(got.positions[v] == gpr::Vec3<Scalarm>(wanted.mesh.positions[v])) << v;
	}
}

TEST(Filter, ColourAndQualityAreCarriedOver)
{
	Document   document;
	MeshModel& ball = addBall(document);
	ASSERT_TRUE(apply(document, withCount(document, 900)));
	ASSERT_TRUE(ball.hasDataMask(MeshModel::MM_VERTCOLOR | MeshModel::MM_VERTQUALITY));
	for (const CVertexO& v : ball.cm.vert) {
		for (int k = 0; k < 3; ++k) {
			ASSERT_NEAR(v.cC()[k], 128 + 100 * v.cP()[k], 2);
		}
		ASSERT_EQ(v.cC()[3], 255);
		ASSERT_NEAR(v.cQ(), v.cP()[2], 0.01);
	}
}

TEST(Filter, StaleDataIsGone)
{
	Document   document;
	MeshModel& ball = addBall(document);
	using Allocator = vcg::tri::Allocator<CMeshO>;
	struct Unknown {
		int a, b;
	};
	Allocator::AddPerVertexAttribute<Unknown>(ball.cm, "number");
	Allocator::AddPerFaceAttribute<Unknown>(ball.cm, "weight");
	Allocator::AddEdges(ball.cm, 1);
	ball.cm.edge[0].V(0) = &ball.cm.vert[0];
	ball.cm.edge[0].V(1) = &ball.cm.vert[1];
	ball.cm.textures.push_back("wood.png");
	ball.cm.face.EnableMark(); // as some filters do, behind the mask's back
	ball.updateDataMask(MeshModel::MM_FACEFACETOPO | MeshModel::MM_VERTFACETOPO |
						MeshModel::MM_VERTCURV);
	for (CFaceO& f : ball.cm.face) {
		f.SetS();
		f.SetF(1);
	}
	ball.cm.sfn            = ball.cm.fn;
	RichParameterList list = withCount(document, 600);
	list.setValue("Selected", BoolValue(false));
	ASSERT_TRUE(apply(document, list));

	expectSoundMesh(ball.cm);
	EXPECT_FALSE(ball.cm.face.IsFFAdjacencyEnabled() || ball.cm.face.IsVFAdjacencyEnabled());
	EXPECT_FALSE(hasCurvature(ball.cm) || ball.hasDataMask(MeshModel::MM_VERTCURV));
	EXPECT_TRUE(ball.cm.vert_attr.empty() && ball.cm.face_attr.empty());
	EXPECT_TRUE(ball.cm.edge.empty() && ball.cm.textures.empty());
	EXPECT_TRUE(document.logText().contains("number, weight, curvature"));
	// The host recomputes topology for the next filter.
	ball.updateDataMask(MeshModel::MM_FACEFACETOPO | MeshModel::MM_FACEMARK);
	EXPECT_EQ(vcg::tri::Clean<CMeshO>::CountNonManifoldEdgeFF(ball.cm), 0);
}

TEST(Filter, WhatFacesWedgesAndUsersHaveIsCarriedOver)
{
	for (const bool newLayer : {false, true}) {
		Document   document;
		MeshModel& sheet = addSheet(document);
		CMeshO&    mesh  = sheet.cm;
		sheet.updateDataMask(MeshModel::MM_WEDGTEXCOORD | MeshModel::MM_VERTTEXCOORD |
							 MeshModel::MM_FACECOLOR | MeshModel::MM_FACEQUALITY |
							 MeshModel::MM_VERTRADIUS);
		using Allocator = vcg::tri::Allocator<CMeshO>;
		auto height     = Allocator::AddPerVertexAttribute<float>(mesh, "height");
		auto number     = Allocator::AddPerFaceAttribute<int>(mesh, "number");
		for (CVertexO& v : mesh.vert) {
			v.R() = height[v] = v.P()[0];
			v.T().U()         = v.P()[1];
		}
		const auto isRight = [](const CFaceO& f) { return vcg::Barycenter(f)[0] > 0.5; };
		const auto chart   = [](const Point3m& p, bool right) {
            return right ? vcg::Point2f(1 - p[1] / 2, p[0] / 2) : vcg::Point2f(p[0] / 2, p[1] / 2);
		};
		for (CFaceO& f : mesh.face) {
			number[f] = isRight(f) ? 7 : 3;
			f.Q()     = Scalarm(number[f]);
			f.C()     = isRight(f) ? vcg::Color4b::Red : vcg::Color4b::Blue;
			for (int k = 0; k < 3; ++k)
				f.WT(k).P() = chart(f.P(k), isRight(f));
		}
		mesh.textures.push_back("wood.png");
		RichParameterList list = withCount(document, 400);
		list.setValue("NewLayer", BoolValue(newLayer));
		ASSERT_TRUE(apply(document, list)) << document.logText().toStdString();

		MeshModel& result = *document->mm();
		EXPECT_EQ(&result != &sheet, newLayer);
		EXPECT_EQ(result.cm.vn, 400);
		expectSoundMesh(result.cm);
		ASSERT_TRUE(result.hasDataMask(MeshModel::MM_WEDGTEXCOORD));
		ASSERT_TRUE(result.hasDataMask(MeshModel::MM_FACECOLOR));
		EXPECT_EQ(result.cm.textures.size(), 1u);
		height = Allocator::FindPerVertexAttribute<float>(result.cm, "height");
		number = Allocator::FindPerFaceAttribute<int>(result.cm, "number");
		ASSERT_TRUE(Allocator::IsValidHandle(result.cm, height));
		ASSERT_TRUE(Allocator::IsValidHandle(result.cm, number));
		for (CVertexO& v : result.cm.vert) {
			ASSERT_NEAR(v.R(), v.P()[0], 1e-3);
			ASSERT_NEAR(height[v], v.P()[0], 1e-3);
			ASSERT_NEAR(v.T().U(), v.P()[1], 1e-3);
		}
		for (CFaceO& f : result.cm.face) {
			ASSERT_EQ(number[f], isRight(f) ? 7 : 3);
			ASSERT_EQ(f.Q(), Scalarm(number[f]));
			ASSERT_EQ(f.C(), vcg::Color4b(isRight(f) ? vcg::Color4b::Red : vcg::Color4b::Blue));
			for (int k = 0; k < 3; ++k)
				ASSERT_LT(vcg::Distance(f.WT(k).P(), chart(f.P(k), isRight(f))), 1e-3);
		}
	}
}

/// A disk in the middle of the sheet, which is flat: no line without regions.
bool isInDisk(const CFaceO& f)
{
	return vcg::SquaredDistance(vcg::Barycenter(f), Point3m(Scalarm(.5), Scalarm(.5), 0)) <
		   Scalarm(.09);
}

/// Gives the sheet regions by its texture index, face colour and face quality.
void markDisk(MeshModel& sheet)
{
	sheet.updateDataMask(MeshModel::MM_WEDGTEXCOORD | MeshModel::MM_FACECOLOR |
						 MeshModel::MM_FACEQUALITY);
	sheet.cm.textures.push_back("wood.png");
	sheet.cm.textures.push_back("wood.png");
	for (CFaceO& f : sheet.cm.face) {
		const bool inside = isInDisk(f);
		f.Q()             = inside ? 7 : -3;
		f.C()             = inside ? vcg::Color4b::Red : vcg::Color4b::Blue;
		for (int k = 0; k < 3; ++k) {
			f.WT(k).U() = float(f.P(k)[0]);
			f.WT(k).V() = float(f.P(k)[1]);
			f.WT(k).N() = 0;
		}
	}
}

/// The area of the red faces, the faces of quality 7.
double redArea(const CMeshO& mesh)
{
	double area = 0;
	for (const CFaceO& f : mesh.face) {
		const bool isRed = f.cC() == vcg::Color4b(vcg::Color4b::Red);
		EXPECT_EQ(f.cQ(), Scalarm(isRed ? 7 : -3));
		if (isRed) area += double(vcg::DoubleArea(f)) / 2;
	}
	return area;
}

std::vector<double> coordinates(const CMeshO& mesh)
{
	std::vector<double> all;
	for (const CVertexO& v : mesh.vert) {
		for (int k = 0; k < 3; ++k)
			all.push_back(double(v.cP()[k]));
	}
	return all;
}

TEST(Filter, RegionsByColourOrQualityAreFollowed)
{
	std::vector<double> without;
	for (const int source : {0, 2, 3}) {
		Document   document;
		MeshModel& sheet = addSheet(document);
		markDisk(sheet);
		const double      wanted = redArea(sheet.cm);
		RichParameterList list   = withCount(document, 300);
		list.setValue("Regions", EnumValue(source));
		ASSERT_TRUE(apply(document, list)) << document.logText().toStdString();
		EXPECT_EQ(sheet.cm.vn, 300);
		const double              area = redArea(sheet.cm);
		const std::vector<double> made = coordinates(sheet.cm);
		if (source == 0) {
			without = made;
			continue;
		}
		EXPECT_NEAR(area / wanted, 1, 0.002) << source;
		EXPECT_NE(made, without) << source;
	}
}

TEST(Filter, RegionsByTextureKeepTheirIndex)
{
	Document   document;
	MeshModel& sheet = addSheet(document);
	markDisk(sheet);
	for (CFaceO& f : sheet.cm.face) {
		for (int k = 0; k < 3; ++k)
			f.WT(k).N() = isInDisk(f) ? 1 : 0;
	}
	RichParameterList list = withCount(document, 300);
	list.setValue("Regions", EnumValue(1));
	const double wanted = redArea(sheet.cm);
	ASSERT_TRUE(apply(document, list)) << document.logText().toStdString();
	double area = 0;
	for (const CFaceO& f : sheet.cm.face) {
		const bool isRed = f.cC() == vcg::Color4b(vcg::Color4b::Red);
		for (int k = 0; k < 3; ++k)
			ASSERT_EQ(f.cWT(k).N(), isRed ? 1 : 0);
		if (f.cWT(0).N() == 1) area += double(vcg::DoubleArea(f)) / 2;
	}
	EXPECT_NEAR(area / wanted, 1, 0.002);
}

TEST(Filter, RegionsThatALayerDoesNotTellAreRefused)
{
	for (const int source : {1, 2, 3}) {
		Document document;
		addSheet(document);
		const Snapshot    before(document);
		RichParameterList list = withCount(document, 300);
		list.setValue("Regions", EnumValue(source));
		EXPECT_FALSE(apply(document, list));
		EXPECT_TRUE(document.logText().contains("which the layer does not have"));
		EXPECT_TRUE(before == Snapshot(document));
	}
	Document   document;
	MeshModel& sheet = addSheet(document);
	markDisk(sheet);
	sheet.cm.face[7].Q()   = Scalarm(.5);
	RichParameterList list = withCount(document, 300);
	list.setValue("Regions", EnumValue(3));
	EXPECT_FALSE(apply(document, list));
	EXPECT_TRUE(document.logText().contains("no whole number"));
}

/// Mean edge length of the faces on the left and on the right.
std::pair<double, double> edgesOfHalves(const CMeshO& mesh)
{
	double sum[2] = {0, 0};
	int    num[2] = {0, 0};
	for (const CFaceO& f : mesh.face) {
		const int side = vcg::Barycenter(f)[0] > 0.5;
		for (int k = 0; k < 3; ++k) {
			sum[side] += double(vcg::Distance(f.cP(k), f.cP((k + 1) % 3)));
			++num[side];
		}
	}
	return {sum[0] / num[0], sum[1] / num[1]};
}

TEST(Filter, VertexQualityIsASize)
{
	for (const int use : {1, 2}) {
		Document   document;
		MeshModel& sheet = addSheet(document);
		sheet.updateDataMask(MeshModel::MM_VERTQUALITY);
		for (CVertexO& v : sheet.cm.vert)
			v.Q() = Scalarm(0.04) + Scalarm(0.04) * v.P()[0];
		RichParameterList list = withCount(document, 200);
		list.setValue("QualitySizes", EnumValue(use));
		ASSERT_TRUE(apply(document, list)) << document.logText().toStdString();
		const auto [left, right] = edgesOfHalves(sheet.cm);
		EXPECT_NEAR(right / left, 0.07 / 0.05, 0.1);
		if (use == 1)
			EXPECT_NEAR(left, 0.05, 0.004) << "exact: " << sheet.cm.vn;
		else
			EXPECT_EQ(sheet.cm.vn, 200);
	}
}

TEST(Filter, ExactSizesAndAnotherSizeAreRefused)
{
	Document   document;
	MeshModel& sheet = addSheet(document);
	sheet.updateDataMask(MeshModel::MM_VERTQUALITY);
	for (CVertexO& v : sheet.cm.vert)
		v.Q() = Scalarm(0.05);
	std::vector<RichParameterList> lists(5, withCount(document, 200));
	lists[0].setValue("TargetFaceNum", IntValue(300));
	lists[1].setValue("TargetPerc", FloatValue(10));
	lists[2].setValue("TargetLen", AbsPercValue(Scalarm(0.1)));
	lists[3].setValue("MaxError", AbsPercValue(Scalarm(0.01)));
	lists[4].setValue("Detail", EnumValue(1));
	for (RichParameterList& list : lists) {
		list.setValue("QualitySizes", EnumValue(1));
		const Snapshot before(document);
		EXPECT_FALSE(apply(document, list));
		EXPECT_TRUE(document.logText().contains("Give either exact sizes"));
		EXPECT_TRUE(before == Snapshot(document));
	}
}

TEST(Filter, VertexQualityThatIsNoSizeIsRefused)
{
	Document          document;
	MeshModel&        sheet = addSheet(document);
	RichParameterList list  = withCount(document, 200);
	list.setValue("QualitySizes", EnumValue(1));
	sheet.clearDataMask(MeshModel::MM_VERTQUALITY);
	EXPECT_FALSE(apply(document, list));
	EXPECT_TRUE(document.logText().contains("Sizes shall come from the quality"));
	sheet.updateDataMask(MeshModel::MM_VERTQUALITY);
	for (CVertexO& v : sheet.cm.vert)
		v.Q() = 0;
	EXPECT_FALSE(apply(document, list));
	EXPECT_TRUE(document.logText().contains("not above 0"));
}

/// Vertices on a side of the sheet, by the coordinate along the side.
std::vector<Scalarm> alongSide(const CMeshO& mesh, Scalarm x)
{
	std::vector<Scalarm> along;
	for (const CVertexO& v : mesh.vert)
		if (v.cP()[0] == x) along.push_back(v.cP()[1]);
	std::sort(along.begin(), along.end());
	return along;
}

TEST(Filter, SidesOfAPeriodicSheetMatch)
{
	Document          document;
	MeshModel&        sheet = addSheet(document);
	RichParameterList list  = withCount(document, 200);
	list.setValue("PeriodX", AbsPercValue(1));
	ASSERT_TRUE(apply(document, list)) << document.logText().toStdString();
	EXPECT_GT(alongSide(sheet.cm, 0).size(), 5u);
	EXPECT_EQ(alongSide(sheet.cm, 0), alongSide(sheet.cm, 1));
	list.setValue("PeriodX", AbsPercValue(Scalarm(.75)));
	EXPECT_FALSE(apply(document, list));
}

/// Two sheets cut each other: four faces at each common edge.
TEST(Filter, JunctionsAreKept)
{
	Document   document;
	MeshModel& sheet = addSheet(document);
	const int  half  = sheet.cm.vn;
	auto       added = vcg::tri::Allocator<CMeshO>::AddVertices(sheet.cm, std::size_t(half));
	for (int v = 0; v < half; ++v, ++added) {
		const Point3m p = sheet.cm.vert[std::size_t(v)].P();
		added->P()      = Point3m(Scalarm(.5), p[1], p[0] - Scalarm(.5));
	}
	const int faceNum = sheet.cm.fn;
	for (int f = 0; f < faceNum; ++f) {
		const auto corner = [&](int k) {
			return int(vcg::tri::Index(sheet.cm, sheet.cm.face[std::size_t(f)].V(k)));
		};
		const int a = corner(0), b = corner(1), c = corner(2);
		vcg::tri::Allocator<CMeshO>::AddFace(sheet.cm, std::size_t(a + half), std::size_t(b + half),
											 std::size_t(c + half));
	}
	vcg::tri::Clean<CMeshO>::RemoveDuplicateVertex(sheet.cm);
	vcg::tri::Allocator<CMeshO>::CompactEveryVector(sheet.cm);
	gpr_filter::updateBoxAndNormals(sheet);
	const auto crossing = [&] {
		sheet.updateDataMask(MeshModel::MM_FACEFACETOPO);
		const int num = vcg::tri::Clean<CMeshO>::CountNonManifoldEdgeFF(sheet.cm);
		sheet.clearDataMask(MeshModel::MM_FACEFACETOPO);
		return num;
	};
	ASSERT_EQ(crossing(), 50);
	RichParameterList list = withCount(document, 500);
	list.setValue("Junctions", EnumValue(1));
	ASSERT_TRUE(apply(document, list)) << document.logText().toStdString();
	EXPECT_EQ(sheet.cm.vn, 500);
	EXPECT_GT(crossing(), 5);
}

TEST(Filter, TheSelectionIsRemeshedAndTheRestIsLeftAlone)
{
	Document             document;
	MeshModel&           ball   = addBall(document);
	const auto           isRest = [](const CFaceO& f) { return vcg::Barycenter(f)[0] < 0.05; };
	std::vector<Point3m> rest;
	for (CFaceO& f : ball.cm.face) {
		if (!isRest(f)) f.SetS();
		for (int k = 0; k < 3 && isRest(f); ++k)
			rest.push_back(f.P(k));
	}
	ball.cm.sfn            = ball.cm.fn - int(rest.size() / 3);
	RichParameterList list = withCount(document, 900);
	list.setValue("Selected", BoolValue(true));
	ASSERT_TRUE(apply(document, list)) << document.logText().toStdString();

	ASSERT_EQ(std::size_t(ball.cm.fn), std::size_t(ball.cm.sfn) + rest.size() / 3);
	for (std::size_t c = 0; c < rest.size(); ++c)
		ASSERT_EQ(ball.cm.face[c / 3].P(int(c % 3)), rest[c]);
	vcg::tri::UpdateSelection<CMeshO>::FaceClear(ball.cm);
	ball.cm.sfn = 0;
	expectSoundMesh(ball.cm);
	ball.updateDataMask(MeshModel::MM_FACEFACETOPO);
	EXPECT_EQ(vcg::tri::Clean<CMeshO>::CountNonManifoldEdgeFF(ball.cm), 0);
	EXPECT_EQ(vcg::tri::Clean<CMeshO>::CountHoles(ball.cm), 0);
}

/// A selection may be left over from another filter.
TEST(Filter, SelectedFacesAreNotRemeshedAloneUnasked)
{
	Document   document;
	MeshModel& ball      = addBall(document);
	const int  vertexNum = ball.cm.vn;
	ball.cm.face[5].SetS();
	ball.cm.sfn = 1;
	EXPECT_FALSE(defaults(document).getBool("Selected"));
	EXPECT_EQ(defaults(document).getInt("TargetVertexNum"), (vertexNum + 5) / 10);
	ASSERT_TRUE(apply(document, defaults(document))) << document.logText().toStdString();
	EXPECT_EQ(ball.cm.vn, (vertexNum + 5) / 10);
	EXPECT_EQ(ball.cm.sfn, 0);
	EXPECT_TRUE(document.logText().contains("Faces are selected, but the whole layer"));
}

TEST(Filter, SelectedWithoutASelectionIsRefused)
{
	Document document;
	addBall(document);
	const Snapshot    before(document);
	RichParameterList list = withCount(document, 500);
	list.setValue("Selected", BoolValue(true));
	EXPECT_FALSE(apply(document, list));
	EXPECT_TRUE(document.logText().contains("no face is selected"));
	EXPECT_TRUE(before == Snapshot(document));
}

TEST(Filter, WarnsOfATransformThatScalesUnevenly)
{
	Document   document;
	MeshModel& sheet = addSheet(document);
	ASSERT_TRUE(apply(document, withCount(document, 400)));
	sheet.cm.Tr.SetScale(2, 2, 2);
	ASSERT_TRUE(apply(document, withCount(document, 300)));
	EXPECT_FALSE(document.logText().contains("scales unevenly"));
	sheet.cm.Tr.SetScale(2, 2, 3);
	ASSERT_TRUE(apply(document, withCount(document, 200)));
	EXPECT_TRUE(document.logText().contains("scales unevenly"));
	EXPECT_EQ(sheet.cm.Tr[2][2], 3);
}

TEST(Filter, DeletedElementsAreSkipped)
{
	Document   document;
	MeshModel& sheet = addSheet(document);
	// Deletes the row of faces along one side, and the vertices of these faces alone.
	for (CFaceO& f : sheet.cm.face) {
		if (vcg::Barycenter(f)[0] < 0.02) vcg::tri::Allocator<CMeshO>::DeleteFace(sheet.cm, f);
	}
	vcg::tri::Clean<CMeshO>::RemoveUnreferencedVertex(sheet.cm);
	ASSERT_LT(std::size_t(sheet.cm.vn), sheet.cm.vert.size());
	ASSERT_TRUE(apply(document, withCount(document, 400))) << document.logText().toStdString();
	EXPECT_EQ(sheet.cm.vn, 400);
	expectSoundMesh(sheet.cm);
	EXPECT_GT(sheet.cm.bbox.min[0], 0.015f);
}

TEST(Filter, NewLayerLeavesTheOldOne)
{
	Document   document;
	MeshModel& ball = addBall(document);
	ball.cm.Tr.SetTranslate(1, 2, 3);
	const int         mask   = ball.dataMask();
	const auto        before = gpr_filter::copyLayer(ball.cm, {});
	RichParameterList list   = withCount(document, 500);
	list.setValue("NewLayer", BoolValue(true));
	ASSERT_TRUE(apply(document, list));

	ASSERT_EQ(document.layerNum(), 2);
	MeshModel& added = document.layer(1);
	EXPECT_EQ(document->mm(), &added);
	EXPECT_EQ(added.label().toStdString(), "ball_remeshed");
	EXPECT_EQ(added.cm.vn, 500);
	EXPECT_TRUE(added.cm.Tr == ball.cm.Tr);
	EXPECT_TRUE(added.hasDataMask(MeshModel::MM_VERTCOLOR | MeshModel::MM_VERTQUALITY));
	expectSoundMesh(added.cm);
	EXPECT_TRUE(before.sameGeometry(gpr_filter::copyLayer(ball.cm, {})));
	EXPECT_EQ(mask, ball.dataMask());
}

TEST(Filter, TooFewVerticesIsRefusedAndNothingChanges)
{
	Document document;
	addBall(document);
	const Snapshot before(document);
	EXPECT_FALSE(apply(document, withCount(document, 1)));
	EXPECT_FALSE(errorText().isEmpty());
	EXPECT_TRUE(document.logText().contains("number is 4.")) << "the smallest count is not named";
	EXPECT_TRUE(before == Snapshot(document));
}

TEST(Filter, BadParametersAreRefusedAndNothingChanges)
{
	Document document;
	addBall(document);
	const Snapshot    before(document);
	RichParameterList list = defaults(document);
	list.setValue("TargetPerc", FloatValue(10));
	list.setValue("TargetLen", AbsPercValue(0.1f));
	EXPECT_FALSE(apply(document, list));
	EXPECT_FALSE(errorText().isEmpty());
	RichParameterList wrongType;
	wrongType.addParam(RichString("TargetVertexNum", "many"));
	EXPECT_FALSE(apply(document, wrongType));
	EXPECT_TRUE(document.logText().contains("TargetVertexNum"));
	EXPECT_TRUE(before == Snapshot(document));
}

/// meshlabserver does not let such a script through; other hosts do.
TEST(Filter, MissingParametersTakeTheirDefaults)
{
	Document          document;
	MeshModel&        ball   = addBall(document);
	const int         before = ball.cm.vn;
	RichParameterList list;
	list.addParam(RichInt("RelaxIter", 1));
	ASSERT_TRUE(apply(document, list)) << document.logText().toStdString();
	EXPECT_EQ(ball.cm.vn, std::lround(0.1 * before));
	ASSERT_TRUE(apply(document, gpr_filter::FeatureFilter, RichParameterList()));
	ASSERT_TRUE(apply(document, gpr_filter::SamplingFilter, RichParameterList()));
	EXPECT_EQ(document.layerNum(), 2);
}

TEST(Filter, NoLayerNoFaces)
{
	Document document;
	addBall(document);
	const RichParameterList list = defaults(document);
	Document                empty;
	EXPECT_FALSE(apply(empty, list));
	EXPECT_FALSE(errorText().isEmpty());
	empty->addNewMesh("", "nothing");
	EXPECT_FALSE(apply(empty, list));
	EXPECT_FALSE(errorText().isEmpty());
	EXPECT_FALSE(defaults(empty).isEmpty());
}

TEST(Filter, NestedRunIsRefusedAndTheOuterOneEndsWell)
{
	Document                document;
	MeshModel&              ball  = addBall(document);
	const RichParameterList list  = withCount(document, 500);
	int                     calls = 0, nestedSuccesses = 0;
	QString                 sentence;
	DuringRun               nest([&](int) {
        ++calls;
        nestedSuccesses += apply(document, list) ? 1 : 0;
        sentence = errorText();
        return true;
    });
	EXPECT_TRUE(apply(document, list, nest.callback()));
	ASSERT_GT(calls, 0) << "the engine never told its progress";
	EXPECT_EQ(nestedSuccesses, 0);
	EXPECT_TRUE(sentence.contains("running"));
	EXPECT_EQ(ball.cm.vn, 500);
	// And the guard is open again.
	EXPECT_TRUE(apply(document, withCount(document, 400)));
}

TEST(Filter, LayerChangedMeanwhileIsLeftAlone)
{
	Document   document;
	MeshModel& ball = addBall(document);
	DuringRun  move([&](int) {
        ball.cm.vert[0].P()[0] += 0.001f;
        return true;
    });
	EXPECT_FALSE(apply(document, withCount(document, 500), move.callback()));
	EXPECT_TRUE(errorText().contains("changed"));
	EXPECT_GT(ball.cm.vn, 5000);
}

TEST(Filter, LayerRemovedMeanwhile)
{
	Document document;
	addSheet(document);
	MeshModel* ball    = &addBall(document);
	bool       removed = false;
	DuringRun  remove([&](int) {
        if (!removed) removeLayer(*document, ball);
        removed = true;
        return true;
    });
	EXPECT_FALSE(apply(document, withCount(document, 500), remove.callback()));
	EXPECT_TRUE(removed);
	EXPECT_EQ(document.layerNum(), 1);
}

TEST(Filter, CancelledRunChangesNothing)
{
	Document document;
	addBall(document);
	const Snapshot before(document);
	DuringRun      cancel([](int) { return false; });
	EXPECT_FALSE(apply(document, withCount(document, 500), cancel.callback()));
	EXPECT_FALSE(errorText().isEmpty());
	EXPECT_TRUE(before == Snapshot(document));
}

TEST(Filter, NoExceptionLeaves)
{
	Document document;
	addBall(document);
	const Snapshot before(document);
	const auto     throwers = {
			+[](int) -> bool { throw std::runtime_error("100 %s of %n trouble"); },
			+[](int) -> bool { throw std::bad_alloc(); },
			+[](int) -> bool { throw 42; },
    };
	for (const auto& thrower : throwers) {
		DuringRun trouble(thrower);
		bool      done = true;
		EXPECT_NO_THROW(done = apply(document, withCount(document, 500), trouble.callback()));
		EXPECT_FALSE(done);
		EXPECT_FALSE(errorText().isEmpty());
	}
	EXPECT_TRUE(before == Snapshot(document));
	EXPECT_TRUE(apply(document, withCount(document, 500)));
}

TEST(Filter, ProgressGrowsAndStaysInRange)
{
	Document document;
	addBall(document);
	int       last  = -1;
	bool      sound = true;
	DuringRun watch([&](int percent) {
		sound = sound && percent >= last && percent >= 0 && percent <= 100;
		last  = percent;
		return true;
	});
	ASSERT_TRUE(apply(document, withCount(document, 500), watch.callback()));
	EXPECT_TRUE(sound);
	EXPECT_GE(last, 0);
}

bool liesInTheMiddle(const CVertexO& v)
{
	return std::abs(v.cP()[0] - 0.5f) < 1e-5f;
}

/// Length of the edges along x = 0.5, each once.
double lengthInTheMiddle(const CMeshO& mesh)
{
	double halves = 0;
	for (const CFaceO& f : mesh.face) {
		for (int k = 0; k < 3; ++k) {
			if (liesInTheMiddle(*f.cV(k)) && liesInTheMiddle(*f.cV((k + 1) % 3)))
				halves += double(vcg::Distance(f.cP(k), f.cP((k + 1) % 3)));
		}
	}
	return 0.5 * halves;
}

TEST(Filter, SelectedEdgesBecomeEdgesOfTheResult)
{
	constexpr int     selected = 3; // of auto, lines, off, selected
	Document          document;
	MeshModel&        layer = addSheet(document);
	RichParameterList list  = defaults(document);
	list.setValue("TargetVertexNum", IntValue(300));
	list.setValue("NewLayer", BoolValue(true));
	ASSERT_TRUE(apply(document, list)) << errorText().toStdString();
	EXPECT_LT(lengthInTheMiddle(document.layer(1).cm), 0.5) << "or the test tells nothing";

	document->setCurrentMesh(layer.id());
	list.setValue("Features", EnumValue(selected));
	EXPECT_FALSE(apply(document, list));
	EXPECT_TRUE(errorText().contains("no edge is selected"));
	for (CFaceO& f : layer.cm.face) {
		for (int k = 0; k < 3; ++k) {
			if (liesInTheMiddle(*f.cV(k)) && liesInTheMiddle(*f.cV((k + 1) % 3))) f.SetFaceEdgeS(k);
		}
	}
	ASSERT_TRUE(apply(document, list)) << errorText().toStdString();
	EXPECT_NEAR(lengthInTheMiddle(document.layer(2).cm), 1, 1e-4);
}

} // namespace
