// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The readers of OBJ, OFF and STL, on files as real programs write.
#include "mesh_files.h"

#include <vcg_extras/io/base/exit_code.h>
#include <vcg_extras/io/formats/mesh_formats.h>
#include <vcg_extras/io/text/number_text.h>
#include <vcg_extras/io/text/text_lines.h>

#include <cctype>
#include <cmath>
#include <gtest/gtest.h>
#include <iterator>
#include <random>

namespace gpr_test {

namespace {

using gpr::app::InputMesh;
using gpr::app::readObj;
using gpr::app::readOff;
using gpr::app::readPly;
using gpr::app::readStl;

std::vector<int> corners(const InputMesh& mesh)
{
	return {mesh.triangles.begin(), mesh.triangles.end()};
}

/// Signed area of the triangles: negative for triangles that face downwards.
double signedArea(const InputMesh& mesh)
{
	double sum = 0;
	for (std::size_t f = 0; f < mesh.faceNum(); ++f) {
		const gpr::Vec3d a = mesh.view().position(std::size_t(mesh.triangles[3 * f]));
		const gpr::Vec3d b = mesh.view().position(std::size_t(mesh.triangles[3 * f + 1]));
		const gpr::Vec3d c = mesh.view().position(std::size_t(mesh.triangles[3 * f + 2]));
		sum += cross(b - a, c - a).z / 2;
	}
	return sum;
}

double unsignedArea(const InputMesh& mesh)
{
	double sum = 0;
	for (std::size_t f = 0; f < mesh.faceNum(); ++f) {
		InputMesh one = mesh;
		one.triangles.assign(mesh.triangles.begin() + long(3 * f),
							 mesh.triangles.begin() + long(3 * f + 3));
		sum += std::abs(signedArea(one));
	}
	return sum;
}

} // namespace

TEST(ObjReader, FacesThatUseTheFirstVertexStay)
{
	const InputMesh mesh = readObj("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 2 4 3\n");
	EXPECT_EQ(corners(mesh), (std::vector<int>{0, 1, 2, 1, 3, 2}));
}

TEST(ObjReader, FormsOfCornersAndLines)
{
	const InputMesh mesh =
		readObj("# comment\r\nv 0 0 0 1.0\r\nv 1 0 0 0.5 0.5 0.5\r\nv 0 1 0\r\n\r\n"
				"vt 0 0\r\nvn 0 0 1\r\ng a b\r\ns off\r\n"
				"f 1/1 2/1 3/1\r\nf 1//1 2//1 3//1\r\nf 1/1/1 2/1/1 3/1/1 # end\r\n"
				"f -3 -2 \\\r\n -1\r\nf 1 2\\\n 3");
	EXPECT_EQ(mesh.vertexNum(), 3u);
	EXPECT_EQ(mesh.faceNum(), 5u);
	for (std::size_t f = 0; f < 5; ++f) {
		EXPECT_EQ(mesh.triangles[3 * f + 2], 2) << f;
	}
}

TEST(ObjReader, TabsAndUnknownKeywords)
{
	const InputMesh mesh = readObj(
		"v\t0\t0\t0\nv 1 0 0\n\tv 0 1 0\nl 1 2\nmg 1\nfoo bar\nf\t1/1\t2/1\t3/1\nf 3\t2 1\n");
	EXPECT_EQ(corners(mesh), (std::vector<int>{0, 1, 2, 2, 1, 0}));
}

TEST(ObjReader, NegativeIndicesCountFromWhereTheyStand)
{
	const InputMesh mesh = readObj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 5 5 5\nf -3 -2 -1\n");
	EXPECT_EQ(corners(mesh), (std::vector<int>{0, 1, 2, 1, 2, 3}));
}

TEST(ObjReader, FacesMayComeBeforeTheirVertices)
{
	EXPECT_EQ(readObj("f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n").faceNum(), 1u);
}

TEST(ObjReader, ConcavePolygonIsNotFolded)
{
	// 3-----2    the corner 4 lies inwards: of all fans, only the fan round 4 covers the polygon
	// |  4  |
	// | / \ |
	// 0     1
	const InputMesh mesh = readObj("v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 1 1 0\nf 1 5 2 3 4\n");
	EXPECT_EQ(mesh.faceNum(), 3u);
	EXPECT_NEAR(signedArea(mesh), 3, 1e-12);
	EXPECT_NEAR(unsignedArea(mesh), 3, 1e-12);
}

TEST(ObjReader, ConvexPolygonIsAFanAroundItsFirstCorner)
{
	const InputMesh mesh = readObj("v 0 0 0\nv 2 0 0\nv 3 1 0\nv 2 2 0\nv 0 2 0\nf 1 2 3 4 5\n");
	EXPECT_EQ(corners(mesh), (std::vector<int>{0, 1, 2, 0, 2, 3, 0, 3, 4}));
}

TEST(ObjReader, CombIsNotFolded)
{
	//  _   _   _      no fan covers this polygon; its area is the teeth's and the bar's
	// | |_| |_| |
	// |_________|
	std::string text, face = "f";
	const int   toothNum = 6;
	int         num      = 0;
	const auto  corner   = [&](double x, double y) {
        text += "v " + digits(x) + " " + digits(y) + " 7\n";
        face += " " + std::to_string(++num);
	};
	corner(0, 0);
	corner(2 * toothNum - 1, 0);
	for (int tooth = toothNum - 1; tooth >= 0; --tooth) {
		if (tooth < toothNum - 1) corner(2 * tooth + 1, 1);
		corner(2 * tooth + 1, 3);
		corner(2 * tooth, 3);
		if (tooth > 0) corner(2 * tooth, 1);
	}
	const InputMesh mesh = readObj(text + face);
	const double    area = 2 * toothNum - 1 + 2 * toothNum;
	EXPECT_EQ(mesh.faceNum(), std::size_t(num - 2));
	EXPECT_NEAR(signedArea(mesh), area, 1e-9);
	EXPECT_NEAR(unsignedArea(mesh), area, 1e-9);
}

TEST(ObjReader, PolygonWithoutAreaIsStillCut)
{
	const InputMesh mesh = readObj("v 0 0 0\nv 1 0 0\nv 2 0 0\nv 1 0 0\nv 0 0 0\nf 1 2 3 4 5\n");
	EXPECT_EQ(mesh.faceNum(), 3u);
}

TEST(ObjReader, LargePolygon)
{
	std::string  text, face = "f";
	const int    num = 400;
	const double pi  = std::acos(-1.0);
	for (int i = 0; i < num; ++i) {
		text += "v " + digits(std::cos(2 * pi * i / num)) + " " +
				digits(std::sin(2 * pi * i / num)) + " 0\n";
		face += " " + std::to_string(i + 1);
	}
	const InputMesh mesh = readObj(text + face);
	EXPECT_EQ(mesh.faceNum(), std::size_t(num - 2));
	EXPECT_NEAR(signedArea(mesh), pi, 1e-3);
}

TEST(OffReader, VariantsOfTheHeader)
{
	const std::string body = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
	for (const std::string header :
		 {"OFF\n3 1 0\n", "OFF 3 1 0\n", "OFF\r\n\r\n# c\r\n3 1 0 # edges\r\n", "OFF\n3 1\n"}) {
		EXPECT_EQ(corners(readOff(header + body)), (std::vector<int>{0, 1, 2})) << header;
	}
	EXPECT_EQ(readOff("COFF\n3 1 0\n0 0 0 255 0 0 255\n1 0 0 1 1 1 1\n0 1 0 9 9 9 9\n3 0 1 2 7\n")
				  .faceNum(),
			  1u);
	EXPECT_EQ(readOff("NOFF\n3 1 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n3 0 1 2\n").vertexNum(),
			  3u);
	EXPECT_EQ(readOff("OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3").faceNum(), 2u);
}

TEST(OffReader, AnnouncedColoursMayBeMissingOrWrong)
{
	EXPECT_EQ(readOff("STCNOFF\n3 1 0\n0 0 0\n1 0 0 -999999999\n0 1 0 9 9\n3 0 1 2\n").faceNum(),
			  1u);
}

TEST(OffReader, LengthsOfFacesAreNotTrusted)
{
	for (const char* length : {"4000000000", "-3", "1000000"}) {
		const std::string file = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n" + std::string(length);
		EXPECT_THROW(readOff(file + " 0 1 2\n"), gpr::app::AppError) << length;
	}
}

TEST(StlReader, EqualCornersAreWelded)
{
	for (const std::string& file : {asciiStl(sphere(5)), binaryStl(sphere(5))}) {
		const InputMesh mesh = readStl(file);
		EXPECT_EQ(mesh.vertexNum(), sphere(5).points.size());
		EXPECT_EQ(mesh.faceNum(), sphere(5).faces.size());
		EXPECT_TRUE(mesh.notes.empty());
	}
}

TEST(StlReader, NegativeZeroIsZeroAndNearIsNotEqual)
{
	TestMesh mesh;
	mesh.points = {{0.0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0, 0, 0}, {0, 1, -0.0}, {-1, 0, 1e-30}};
	mesh.faces  = {{0, 1, 2}, {3, 4, 5}};
	EXPECT_EQ(readStl(binaryStl(mesh)).vertexNum(), 4u);
	mesh.points[3] = {1e-30, 0, 0};
	EXPECT_EQ(readStl(binaryStl(mesh)).vertexNum(), 5u);
}

TEST(StlReader, AttributeBytesAreTold)
{
	std::string file = binaryStl(sphere(2));
	EXPECT_TRUE(gpr::app::readStl(file).attributes.lost.empty());
	file.back() = '\x7c';
	EXPECT_EQ(gpr::app::readStl(file).attributes.lost,
			  std::vector<std::string>{"colours or other data in attribute bytes of facets"});
}

/// Some writers count too few facets, or none until the end.
TEST(StlReader, FacetsBehindTheCountAreTold)
{
	std::string file = binaryStl(sphere(2));
	EXPECT_TRUE(gpr::app::readStl(file).notes.empty());
	const std::size_t num = readStl(file).faceNum();
	file += std::string(49, ' ');
	EXPECT_TRUE(gpr::app::readStl(file).notes.empty());
	file += std::string(51, ' ');
	EXPECT_EQ(
		gpr::app::readStl(file).notes,
		std::vector<std::string>{"The STL file has 100 bytes behind the " + std::to_string(num) +
								 " facets that its header promises; facets there were left out."});
}

TEST(StlReader, SeveralSolidsAndAMissingEnd)
{
	const std::string two = asciiStl(grid(1)) + asciiStl(moved(grid(1), 5, 0, 0));
	EXPECT_EQ(readStl(two).faceNum(), 4u);
	const std::string open = two.substr(0, two.rfind("endsolid"));
	EXPECT_EQ(readStl(open).notes.size(), 1u);
	std::string firstOpen = two;
	firstOpen.replace(two.find("endsolid"), 8, "");
	EXPECT_EQ(readStl(firstOpen).faceNum(), 4u);
	EXPECT_EQ(readStl(firstOpen).notes.size(), 1u);
}

TEST(StlReader, LinesEndWhereTheyLike)
{
	const InputMesh whole = readStl(asciiStl(sphere(5)));
	for (const std::string end : {"\r\n", "\n\n\t", " \n"}) {
		std::string text;
		for (const char c : asciiStl(sphere(5)))
			text += c == '\n' ? end : std::string(1, c);
		EXPECT_EQ(readStl(text).floats, whole.floats);
		EXPECT_EQ(readStl(text).triangles, whole.triangles);
		EXPECT_TRUE(readStl(text).notes.empty());
	}
	const std::string broken = "solid\nfacet\nouter\nloop\nvertex\n0\n0\n0\nvertex 1\n0 0\n"
							   "vertex\n0 1 0 endloop endfacet endsolid";
	EXPECT_EQ(readStl(broken).faceNum(), 1u);
}

TEST(StlReader, DamagedFacetsAreRefused)
{
	for (const std::string word : {"facet", "vertex", "endfacet"}) {
		std::string       text = asciiStl(grid(1));
		const std::size_t at   = text.find(word);
		ASSERT_NE(at, text.npos);
		text.replace(at, word.size(), "x");
		EXPECT_THROW(readStl(text), gpr::app::AppError) << word;
	}
}

TEST(StlReader, NamesLikeKeywords)
{
	const std::string body = asciiStl(grid(1)), name = " Solid endloop Facet vertex endsolid\n";
	const std::size_t begin = body.find('\n') + 1, end = body.rfind("endsolid");
	EXPECT_EQ(
		readStl("solid" + name + body.substr(begin, end - begin) + "endsolid" + name).faceNum(),
		2u);
}

TEST(StlReader, CornersThatAreNoNumbersStayApart)
{
	TestMesh     mesh   = sphere(3);
	const double nan    = std::nan("");
	const auto   num    = mesh.points.size();
	mesh.points[0]      = {nan, 0, 0};
	mesh.points[1]      = {0, nan, nan};
	const InputMesh got = readStl(binaryStl(mesh));
	EXPECT_EQ(got.vertexNum(), num);
	EXPECT_EQ(got.faceNum(), mesh.faces.size());
}

TEST(StlReader, KeywordsInCapitals)
{
	std::string text = asciiStl(grid(1));
	for (char& c : text)
		c = char(std::toupper(static_cast<unsigned char>(c)));
	EXPECT_EQ(readStl(text).faceNum(), 2u);
}

TEST(AllReaders, NotANumberIsReadAsThat)
{
	const std::string ply = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty "
							"float y\nproperty float "
							"z\nelement face 2\nproperty list uchar int vertex_index\nend_header\n";
	const std::string stl = "solid\nfacet normal nan nan nan\nouter loop\n";
	for (const std::string word : {"nan", "NaN", "-nan", "-nan(ind)", "inf", "-Infinity"}) {
		SCOPED_TRACE(word);
		const std::string points[] = {"0 0 0\n", "1 0 " + word + "\n", "0 1 0\n", "1 1 0\n"};
		const std::string all      = points[0] + points[1] + points[2] + points[3];
		std::string       obj;
		for (const std::string& p : points)
			obj += "v " + p;
		for (const InputMesh& mesh :
			 {readObj(obj + "f 1 2 3\nf 1 3 4\n"),
			  readOff("OFF 4 2 0\n" + all + "3 0 1 2\n3 0 2 3"),
			  readPly(ply + all + "3 0 1 2\n3 0 2 3\n"),
			  readStl(stl + "vertex " + points[0] + "vertex " + points[1] + "vertex " + points[2] +
					  "endloop\nendfacet\nendsolid\n")}) {
			ASSERT_GE(mesh.vertexNum(), 3u);
			EXPECT_TRUE(std::isnan(mesh.view().position(1).z));
			EXPECT_EQ(mesh.view().position(1).x, 1);
			EXPECT_EQ(mesh.view().position(2).y, 1);
		}
	}
}

TEST(AllReaders, NumbersWithATailAreRefused)
{
	// A stream would accept the begin of such a word as a number.
	for (const std::string word : {"1.5x", "1,5", "0x10", "1-1", "--1", "1e", "e5"}) {
		SCOPED_TRACE(word);
		EXPECT_THROW(readObj("v 0 0 0\nv 1 0 0\nv 0 1 " + word + "\nf 1 2 3\n"),
					 gpr::app::AppError);
		EXPECT_THROW(readObj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 " + word + "\n"),
					 gpr::app::AppError);
		EXPECT_THROW(readOff("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 " + word + "\n3 0 1 2\n"),
					 gpr::app::AppError);
		EXPECT_THROW(readStl("solid\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
							 "vertex 0 1 " +
							 word + "\nendloop\nendfacet\nendsolid\n"),
					 gpr::app::AppError);
		EXPECT_THROW(readPly("ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int "
							 "vertex_index\nelement vertex 3\nproperty float x\nproperty float "
							 "y\nproperty float z\nend_header\n3 0 1 2\n0 0 0\n1 0 0\n0 1 " +
							 word + "\n"),
					 gpr::app::AppError);
	}
}

TEST(AllReaders, DamagedBytesAreReadOrRefusedWithoutHarm)
{
	// Under the sanitizers this loop also shows reads beyond the end.
	using Reader                                 = InputMesh (*)(std::string_view);
	const std::pair<Reader, std::string> files[] = {{readObj, objWithNegativeIndices(sphere(2))},
													{readObj, obj(torus(4))},
													{readOff, off(sphere(2))},
													{readStl, asciiStl(grid(2))},
													{readStl, binaryStl(grid(2))}};
	std::mt19937                         random(7);
	for (int round = 0; round < 2000; ++round) {
		const auto& [read, whole] = files[round % std::size(files)];
		std::vector<char> damaged(whole.begin(), whole.end());
		for (int i = 0; i < 3; ++i)
			damaged[random() % damaged.size()] = char(random());
		damaged.resize(damaged.size() - (round % 2 ? random() % damaged.size() : 0));
		damaged.shrink_to_fit();
		try {
			const InputMesh mesh = read({damaged.data(), damaged.size()});
			for (const std::int32_t i : mesh.triangles) {
				ASSERT_GE(i, 0) << round;
				ASSERT_LT(std::size_t(i), mesh.vertexNum()) << round;
			}
		}
		catch (const gpr::app::AppError& error) {
			EXPECT_EQ(error.code, gpr::app::ExitCode::BadInput);
		}
	}
}

/// Threads read a file of several megabytes in pieces: vertex i is (i, 0, 1), and corners count
/// from the end, so each corner depends on the number of vertices before.
TEST(ObjReader, PiecesOfALargeFileFitTogether)
{
	const int   num = 120000;
	std::string text;
	for (int i = 0; i < num; ++i) {
		text += "v " + std::to_string(i) + " 0 1\n";
		if (i < 3) continue;
		text += i % 7 == 0 ? "f -1 -2 \\\n -3\n" : i % 5 == 0 ? "f -1 -2 -3 -4\n" : "f -1 -2 -3\n";
	}
	const InputMesh mesh = readObj(text);
	ASSERT_EQ(mesh.vertexNum(), std::size_t(num));
	std::vector<int> expected;
	for (int i = 3; i < num; ++i) {
		if (i % 7 != 0 && i % 5 == 0) continue; // these come behind the triangles
		for (int k = 0; k < 3; ++k)
			expected.push_back(i - k);
	}
	ASSERT_GT(mesh.triangles.size(), expected.size());
	for (std::size_t i = 0; i < expected.size(); ++i)
		ASSERT_EQ(mesh.triangles[i], expected[i]) << i;
	for (int i = 0; i < num; ++i)
		ASSERT_EQ(mesh.view().position(std::size_t(i)).x, i);
}

TEST(ObjReader, TheFirstBadLineOfALargeFileIsNamed)
{
	std::string text;
	for (int i = 0; i < 300000; ++i)
		text += i == 150000 || i == 250000 ? "v 1 x 0\n" : "v 1 0 0\n";
	try {
		readObj(text);
		FAIL() << "accepted";
	}
	catch (const gpr::app::AppError& error) {
		EXPECT_NE(std::string(error.what()).find("line 150001:"), std::string::npos)
			<< error.what();
	}
}

TEST(ObjReader, TellsWhetherThereIsMoreThanTheMesh)
{
	const std::string mesh = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
	for (const auto& [text, expected] :
		 std::vector<std::pair<std::string, bool>>{{mesh, false},
												   {"s off\n" + mesh, false},
												   {"o a\n" + mesh, true},
												   {"g a\n" + mesh, true},
												   {mesh + "vt 0 0\n", true},
												   {mesh + "vn 0 0 1\n", true},
												   {"usemtl a\n" + mesh, true},
												   {mesh + "v 0 0 0 1 0 0\n", true}}) {
		bool holdsMore = !expected;
		gpr::app::readObj(text, holdsMore);
		EXPECT_EQ(holdsMore, expected) << text;
	}
}

TEST(OffReader, PiecesOfALargeFileFitTogether)
{
	const int   num  = 200000;
	std::string text = "OFF\n" + std::to_string(num) + " " + std::to_string(num - 2) + " 0\n\n";
	for (int i = 0; i < num; ++i)
		text += std::to_string(i) + " 0 1" + (i % 3 == 0 ? " # and more\n\n" : "\n");
	for (int i = 2; i < num; ++i)
		text += "3 " + std::to_string(i - 2) + " " + std::to_string(i - 1) + " " +
				std::to_string(i) + "\n";
	const InputMesh mesh = readOff(text);
	ASSERT_EQ(mesh.vertexNum(), std::size_t(num));
	ASSERT_EQ(mesh.faceNum(), std::size_t(num - 2));
	for (int i = 0; i < num; ++i)
		ASSERT_EQ(mesh.view().position(std::size_t(i)).x, i);
	for (int i = 2; i < num; ++i)
		ASSERT_EQ(mesh.triangles[3 * std::size_t(i) - 4], i);
}

/// Threads fill one table side by side, yet vertices come in the order of their first corners.
TEST(StlReader, VerticesOfALargeFileAreInTheOrderOfTheirFirstUse)
{
	TestMesh large = sphere(150);
	for (int round = 0; round < 5; ++round) {
		const InputMesh mesh = readStl(binaryStl(large));
		ASSERT_EQ(mesh.vertexNum(), large.points.size());
		int next = 0;
		for (const std::int32_t i : mesh.triangles) {
			ASSERT_LE(i, next);
			if (i == next) ++next;
		}
		ASSERT_EQ(std::size_t(next), mesh.vertexNum());
	}
}

TEST(TextLines, PiecesEndAtLinesThatDoNotGoOn)
{
	std::string text;
	for (int i = 0; i < 100000; ++i)
		text += i % 2 ? "second part of line " + std::to_string(i) + "\n" : "first part \\ \r\n";
	std::string together;
	const auto  pieces = gpr::app::linePieces(text, true);
	EXPECT_GT(pieces.size(), 1u);
	for (const std::string_view piece : pieces) {
		EXPECT_EQ(piece.substr(0, 5), "first");
		EXPECT_EQ(piece.back(), '\n');
		together += piece;
	}
	EXPECT_EQ(together, text);
}

TEST(TextPrecision, DoubleOnlyWhereFloatDoesNotDo)
{
	EXPECT_FALSE(readObj(obj(sphere(5))).doublePrecision);
	EXPECT_TRUE(readObj(obj(moved(sphere(5), 500000, 0, 0))).doublePrecision);
	EXPECT_TRUE(readStl(asciiStl(moved(sphere(5), 500000, 0, 0))).doublePrecision);
}

TEST(TextNumbers, CLocaleAndEdgeCases)
{
	double value = 0;
	EXPECT_TRUE(gpr::app::parseNumber("+1.5e3", value));
	EXPECT_EQ(value, 1500);
	EXPECT_TRUE(gpr::app::parseNumber("1e-999", value));
	EXPECT_EQ(value, 0);
	EXPECT_TRUE(gpr::app::parseNumber("-1e999", value));
	EXPECT_TRUE(std::isinf(value));
	EXPECT_TRUE(gpr::app::parseNumber("nan", value));
	EXPECT_TRUE(std::isnan(value));
	for (const char* word : {"", "1,5", "1.5x", "--1", "+-1", "0x10", "e5"}) {
		EXPECT_FALSE(gpr::app::parseNumber(word, value)) << word;
	}
	std::int64_t number = 0;
	EXPECT_FALSE(gpr::app::parseInteger("1.0", number));
	EXPECT_FALSE(gpr::app::parseInteger("99999999999999999999", number));
	EXPECT_TRUE(gpr::app::parseInteger("-7", number));
	EXPECT_EQ(number, -7);
}

} // namespace gpr_test
