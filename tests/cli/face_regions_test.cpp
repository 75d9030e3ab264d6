// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Regions in files: groups, materials, solids and labels, in and out.
#include "file_folder.h"
#include "mesh_files.h"

#include <vcg_extras/io/base/exit_code.h>
#include <vcg_extras/io/formats/mesh_formats.h>
#include <vcg_extras/io/mesh/attribute_carry.h>
#include <vcg_extras/io/mesh_io.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <gtest/gtest.h>
#include <map>
#include <set>
#include <sstream>

namespace gpr_test {

namespace {

using namespace gpr;
using namespace gpr::app;

class RegionsInFiles : public FileFolder {
protected:
	RegionsInFiles() : FileFolder("regions") {}

	static InputMesh read(const std::string& file, const std::string& regions = {})
	{
		WantedAttributes wanted;
		wanted.carried = true;
		wanted.regions = regions;
		return readMesh(file, wanted);
	}

	InputMesh remeshed(const std::string& from, const std::string& to)
	{
		InputMesh     input   = read(from);
		const auto    texture = takeTexture(input.attributes, input.view(), true);
		RemeshOptions options;
		options.targetMode           = TargetMode::VertexNum;
		options.targetVertexNum      = 200;
		options.surfacePointsOfFaces = true;
		const RemeshResult result    = remesh(input.view(), options);
		EXPECT_EQ(result.status, Status::Ok) << result.message;
		MeshAttributes carried =
			carryAttributes(input.attributes, input.view(), texture.get(), result);
		writeMesh(result.mesh, false, carried, to, RunLimit());
		lost = carried.lost;
		return read(to);
	}

	std::vector<std::string> lost;
};

/// Area by the name of the region.
std::map<std::string, double> areasOf(const InputMesh& mesh)
{
	std::map<std::string, double> areas;
	const MeshView                view = mesh.view();
	for (std::size_t f = 0; f < view.faceNum; ++f) {
		const auto  t = view.triangle(f);
		const Vec3d a = view.position(std::size_t(t[0])), b = view.position(std::size_t(t[1])),
					c = view.position(std::size_t(t[2]));
		areas[mesh.regions.nameOf(mesh.regions.label[f])] += length(cross(b - a, c - a)) / 2;
	}
	return areas;
}

/// A square as OBJ text, with `left` and `right` as lines before the faces of either half, parted
/// at x = 0.4.
std::string halvesObj(const std::string& left, const std::string& right)
{
	const TestMesh    mesh = grid(20);
	std::stringstream text, of[2];
	for (const auto& p : mesh.points)
		text << "v " << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
	for (const auto& f : mesh.faces) {
		double middle = 0;
		for (const int v : f)
			middle += mesh.points[std::size_t(v)][0] / 3;
		of[middle > 0.4] << "f " << f[0] + 1 << ' ' << f[1] + 1 << ' ' << f[2] + 1 << '\n';
	}
	return text.str() + left + of[0].str() + right + of[1].str();
}

void expectHalves(const InputMesh& mesh, const std::string& left, const std::string& right)
{
	const auto areas = areasOf(mesh);
	ASSERT_EQ(areas.size(), 2u);
	EXPECT_NEAR(areas.at(left), 0.4, 1e-5);
	EXPECT_NEAR(areas.at(right), 0.6, 1e-5);
}

TEST_F(RegionsInFiles, GroupsAndObjectsOfObjComeOutAgain)
{
	const std::string in = put("in.obj", halvesObj("o plate\ng inlet\n", "g outlet wall\n"));
	expectHalves(remeshed(in, path("out.obj")), "plate inlet", "plate outlet wall");
	EXPECT_TRUE(lost.empty());
	const std::string out = contentOf(path("out.obj"));
	EXPECT_NE(out.find("o plate\n"), out.npos);
	EXPECT_NE(out.find("g outlet wall\n"), out.npos);
}

TEST_F(RegionsInFiles, MaterialsOfObjWithoutATextureAreRegions)
{
	const std::string in = put("in.obj", halvesObj("usemtl red\n", "usemtl blue\n"));
	expectHalves(remeshed(in, path("out.obj")), "red", "blue");
}

TEST_F(RegionsInFiles, NamesGoThroughPlyAndStlAndBack)
{
	const std::string in = put("in.obj", halvesObj("g in let\n", "g wall\n"));
	expectHalves(remeshed(in, path("out.ply")), "in let", "wall");
	expectHalves(remeshed(path("out.ply"), path("out.stl")), "in let", "wall");
	EXPECT_TRUE(lost.empty());
	EXPECT_EQ(contentOf(path("out.stl")).substr(0, 13), "solid in let\n");
	expectHalves(remeshed(path("out.stl"), path("again.obj")), "in let", "wall");
}

/// Beside texture coordinates materials are numbers of the texture.
TEST_F(RegionsInFiles, MaterialsBesideATextureGoThroughPlyAndBack)
{
	std::string text = halvesObj("usemtl old oak\n", "usemtl ash\n");
	for (std::size_t at = text.find("f "); at != text.npos; at = text.find("f ", at + 1)) {
		for (std::size_t end = text.find_first_of(" \n", at + 2);;) {
			text.insert(end, "/1");
			if (text[end + 2] == '\n') break;
			end = text.find_first_of(" \n", end + 3);
		}
	}
	const std::string in = put("in.obj", "mtllib wood.mtl\nvt 0.5 0.25\n" + text);
	EXPECT_TRUE(read(in).attributes.hasTexture());
	expectHalves(remeshed(in, path("out.ply")), "old oak", "ash");
	EXPECT_EQ(lost, std::vector<std::string>{"the name of the file of materials"});
	expectHalves(remeshed(path("out.ply"), path("again.obj")), "old oak", "ash");
	EXPECT_NE(contentOf(path("again.obj")).find("usemtl old oak\n"), std::string::npos);
	expectHalves(remeshed(path("out.ply"), path("out.glb")), "old oak", "ash");
}

TEST_F(RegionsInFiles, NamesThatNoHeaderHoldsAreTold)
{
	const std::string left = "g " + std::string(300'000, 'a') + "\n";
	const std::string in = put("in.obj", halvesObj(left, "g " + std::string(300'000, 'b') + "\n"));
	EXPECT_EQ(areasOf(remeshed(in, path("out.ply"))).size(), 2u);
	EXPECT_EQ(lost, std::vector<std::string>(
						{"the names of regions, which are too many for the header"}));
}

TEST_F(RegionsInFiles, OneSolidIsNoRegionAndItsNameIsTold)
{
	const std::string facet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
							  "vertex 0 1 0\nendloop\nendfacet\n";
	const InputMesh   mesh  = read(put("in.stl", "solid a b\n" + facet + "endsolid a b\n"));
	EXPECT_TRUE(mesh.regions.label.empty());
	EXPECT_EQ(mesh.attributes.lost, std::vector<std::string>{"the name of the solid"});
}

TEST_F(RegionsInFiles, SolidsWithoutANameAreApartAndThoseOfOneNameAreNot)
{
	const auto facet = [](const char* z) {
		const std::string end = std::string(z) + "\n";
		return "facet normal 0 0 1\nouter loop\nvertex 0 0 " + end + "vertex 1 0 " + end +
			   "vertex 0 1 " + end + "endloop\nendfacet\n";
	};
	const InputMesh mesh =
		read(put("in.stl", "solid\n" + facet("0") + "endsolid\nsolid\n" + facet("1") +
							   "endsolid\nsolid x\n" + facet("2") + "endsolid\nsolid x\n" +
							   facet("3") + "endsolid x\n"));
	EXPECT_EQ(mesh.regions.label, (std::vector<std::int32_t>{0, 1, 2, 2}));
}

std::string labelledPly(const std::string& property, const std::string& labels)
{
	return "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
		   "property float z\nelement face 2\nproperty list uchar int vertex_indices\nproperty " +
		   property + "\nend_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2 " + labels;
}

TEST_F(RegionsInFiles, PropertiesOfPlyAreTakenByTheirName)
{
	const std::string label = put("a.ply", labelledPly("int label", "5\n3 0 2 3 9\n"));
	EXPECT_EQ(read(label).regions.label, (std::vector<std::int32_t>{5, 9}));
	EXPECT_TRUE(read(label, "off").regions.label.empty());
	const std::string other = put("b.ply", labelledPly("float patch", "5\n3 0 2 3 9\n"));
	EXPECT_TRUE(read(other).regions.label.empty());
	EXPECT_EQ(read(other, "patch").regions.label, (std::vector<std::int32_t>{5, 9}));
	EXPECT_THROW(read(other, "label"), AppError);
	const std::string real = put("c.ply", labelledPly("float label", "5.5\n3 0 2 3 9\n"));
	EXPECT_TRUE(read(real).regions.label.empty());
	EXPECT_THROW(read(real, "label"), AppError);
}

/// A square whose vertices have a colour by `redAt`, remeshed.
std::set<double> redsOf(const std::function<int(double)>& redAt, Transfer transfer)
{
	const TestMesh    mesh = grid(30);
	std::stringstream text;
	text << "ply\nformat ascii 1.0\nelement vertex " << mesh.points.size()
		 << "\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\n"
			"property uchar green\nproperty uchar blue\nelement face "
		 << mesh.faces.size() << "\nproperty list uchar int vertex_indices\nend_header\n";
	for (const auto& p : mesh.points)
		text << p[0] << ' ' << p[1] << ' ' << p[2] << ' ' << redAt(p[0]) << " 7 8\n";
	for (const auto& f : mesh.faces)
		text << "3 " << f[0] << ' ' << f[1] << ' ' << f[2] << '\n';
	InputMesh        input = readPly(text.str());
	WantedAttributes wanted;
	wanted.carried = true;
	readPlyAttributes(text.str(), wanted, input);
	RemeshOptions options;
	options.targetMode          = TargetMode::VertexNum;
	options.targetVertexNum     = 250;
	const RemeshResult   result = remesh(input.view(), options);
	const MeshAttributes carried =
		carryAttributes(input.attributes, input.view(), nullptr, result, transfer);
	const std::vector<double>& reds = carried.ofVertices[0].values;
	return {reds.begin(), reds.end()};
}

TEST(Transfer, APaletteIsNotBlendedAndAGradientIs)
{
	const auto palette  = [](double x) { return x < 0.5 ? 10 : 200; };
	const auto gradient = [](double x) { return int(10 + 190 * x); };
	EXPECT_EQ(redsOf(palette, Transfer::Auto), (std::set<double>{10, 200}));
	EXPECT_GT(redsOf(palette, Transfer::Mean).size(), 2u);
	const std::set<double> blended = redsOf(gradient, Transfer::Auto);
	EXPECT_GT(blended.size(), 40u);
	EXPECT_LE(redsOf(gradient, Transfer::Nearest).size(), 31u);
}

} // namespace

} // namespace gpr_test
