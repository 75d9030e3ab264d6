// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Runs in tiles of files other than binary PLY files.
#include "mesh_files.h"
#include "program_runner.h"

#include <cmath>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

namespace gpr_test {

using Json = nlohmann::json;

namespace {

/// The vertices of faces, in the order of their first use.
TestMesh inOrderOfUse(const TestMesh& mesh)
{
	TestMesh           ordered;
	std::map<int, int> number;
	for (auto f : mesh.faces) {
		for (int& v : f) {
			const auto at = number.emplace(v, int(number.size()));
			if (at.second) ordered.points.push_back(mesh.points[std::size_t(v)]);
			v = at.first->second;
		}
		ordered.faces.push_back(f);
	}
	return ordered;
}

/// A coloured mesh of squares, with PLY and OBJ files of the same order.
struct SquareMesh {
	std::vector<std::array<double, 3>> points;
	std::vector<std::array<int, 4>>    faces;

	explicit SquareMesh(int n)
	{
		const TestMesh mesh = grid(n);
		points              = mesh.points;
		for (auto& p : points)
			p[2] = 0.2 * p[0] * p[1];
		for (std::size_t f = 0; f < mesh.faces.size(); f += 2) {
			const auto &a = mesh.faces[f], &b = mesh.faces[f + 1];
			faces.push_back({a[0], a[1], a[2], b[2]});
		}
	}

	static int colour(const std::array<double, 3>& p, int k) { return int(40 + 200 * p[k % 2]); }

	std::string ply() const
	{
		std::string file = "ply\nformat binary_little_endian 1.0\nelement vertex " +
						   std::to_string(points.size()) +
						   "\nproperty float x\nproperty float y\nproperty float z\n"
						   "property uchar red\nproperty uchar green\nproperty uchar blue\n"
						   "element face " +
						   std::to_string(faces.size()) +
						   "\nproperty list uchar int vertex_indices\nend_header\n";
		for (const auto& p : points) {
			for (double c : p)
				putBinary(file, float(c), true);
			for (int k = 0; k < 3; ++k)
				putBinary(file, std::uint8_t(colour(p, k)), true);
		}
		for (const auto& f : faces) {
			file += char(4);
			for (int v : f)
				putBinary(file, std::int32_t(v), true);
		}
		return file;
	}

	/// With all kinds of lines of OBJ files.
	std::string obj() const
	{
		std::string file = "# squares\r\nmtllib none.mtl\r\nvt 0 0\r\nvn 0 0 1\r\n";
		for (const auto& p : points) {
			file += "v " + digits(p[0]) + " \\\r\n" + digits(p[1]) + " " + digits(p[2]);
			for (int k = 0; k < 3; ++k)
				file += " " + digits(colour(p, k) / 255.0);
			file += " # a vertex\r\n";
		}
		const int num = int(points.size());
		for (std::size_t f = 0; f < faces.size(); ++f) {
			file += "f";
			for (int v : faces[f])
				file += f % 2 ? " " + std::to_string(v - num) + "//1"
							  : " " + std::to_string(v + 1) + "/1/1";
			file += "\r\n";
		}
		return file + "f 1 2\r\n"; // no face
	}
};

} // namespace

class TileInputs : public CliTest {
protected:
	static constexpr int tileNum = 3;

	ProgramResult plan(const std::string& input)
	{
		return run({"tile", "plan", path("run"), input, "--vertices", "400", "--tiles",
					std::to_string(tileNum)},
				   60);
	}

	void step(std::vector<std::string> words)
	{
		words.insert(words.begin(), "tile");
		const ProgramResult result = run(words, 60);
		EXPECT_EQ(result.exitCode, 0) << words[1] << ": " << result.err;
	}

	/// The bytes of the result of all steps.
	std::string remeshed(const std::string& input)
	{
		std::filesystem::remove_all(path("run"));
		const ProgramResult planned = plan(input);
		EXPECT_EQ(planned.exitCode, 0) << planned.err;
		step({"split", path("run")});
		for (int unit = 0; unit < tileNum; ++unit)
			step({"part", path("run"), "--unit", std::to_string(unit)});
		step({"join", path("run")});
		step({"finish", path("run"), path("out.ply"), "--quiet", "--report", path("report.json")});
		return content(path("out.ply"));
	}

	std::string notes() { return Json::parse(content(path("report.json")))["notes"].dump(); }
};

TEST_F(TileInputs, EachFormatGivesTheBytesThatABinaryPlyFileGives)
{
	const TestMesh    mesh  = inOrderOfUse(torus(60));
	const std::string bytes = remeshed(put("in.ply", binaryPly(mesh, true, false)));
	EXPECT_EQ(bytes, remeshed(put("in.obj", obj(mesh))));
	EXPECT_NE(notes().find("Not carried through tiles from an OBJ file: normals, materials."),
			  std::string::npos)
		<< notes();
	EXPECT_EQ(bytes, remeshed(put("back.obj", objWithNegativeIndices(mesh))));
	EXPECT_EQ(bytes, remeshed(put("in.off", off(mesh))));
	EXPECT_EQ(bytes, remeshed(put("text.ply", asciiPly(mesh))));
	EXPECT_EQ(bytes, remeshed(put("big.ply", binaryPly(mesh, false, false))));
	EXPECT_EQ(bytes, remeshed(put("in.stl", binaryStl(mesh))));
	std::string coloured = binaryStl(mesh);
	coloured.back()      = '\x7c';
	EXPECT_EQ(bytes, remeshed(put("in.stl", coloured + std::string(50, ' '))));
	EXPECT_NE(notes().find("has 50 bytes behind"), std::string::npos) << notes();
	EXPECT_NE(notes().find("an STL file: colours or other data"), std::string::npos) << notes();
}

TEST_F(TileInputs, CoordinatesStayDoublesWhereFloatsWouldNotDo)
{
	const TestMesh mesh = inOrderOfUse(moved(torus(60), 400000, 5000000, 0));
	const auto     far  = remeshed(put("in.ply", binaryPly(mesh, true, true)));
	EXPECT_NE(far.find("property double x"), std::string::npos);
	EXPECT_EQ(far, remeshed(put("in.obj", obj(mesh))));
	EXPECT_EQ(far, remeshed(put("in.off", off(mesh))));
}

TEST_F(TileInputs, PolygonsColoursAndAllFormsOfObjLinesComeThrough)
{
	const SquareMesh  mesh(50);
	const std::string bytes = remeshed(put("in.ply", mesh.ply()));
	EXPECT_NE(bytes.find("property uchar red"), std::string::npos);
	EXPECT_EQ(bytes, remeshed(put("in.obj", mesh.obj())));
	EXPECT_NE(notes().find("1 faces with fewer than three corners were left out."),
			  std::string::npos)
		<< notes();
}

/// Corners of STL files at the same place are one vertex, with either sign of zero.
TEST_F(TileInputs, CornersOfStlFilesAreComparedAsByTheOrdinaryReader)
{
	TestMesh mesh = grid(30);
	for (auto& p : mesh.points)
		p[0] -= 0.5; // some are 0
	std::string       file  = binaryStl(inOrderOfUse(mesh));
	const std::size_t first = 84, facet = 50;
	for (std::size_t f = 0; f < mesh.faces.size(); f += 2) {
		for (std::size_t c = 0; c < 3; ++c) {
			char* const at = &file[first + facet * f + 12 + 12 * c];
			float       x;
			std::memcpy(&x, at, 4);
			x = x == 0 ? -x : x;
			std::memcpy(at, &x, 4);
		}
	}
	const std::string in = put("in.stl", file + "bytes behind the end");
	ASSERT_EQ(plan(in).exitCode, 0);
	const ProgramResult whole = run({"info", in, "--json"});
	const Json          facts = Json::parse(whole.out)["input"];
	const ProgramResult made  = run({"info", path("run/input0.ply"), "--json"});
	const Json          found = Json::parse(made.out)["input"];
	EXPECT_EQ(facts["vertices"], 31 * 31);
	for (const char* key : {"vertices", "faces", "components", "boundaryLoops", "area", "diagonal"})
		EXPECT_EQ(facts[key], found[key]) << key;
}

TEST_F(TileInputs, PropertiesOfAsciiPlyFilesStay)
{
	const std::string text     = "ply\r\nformat ascii 1.0\r\ncomment TextureFile a.png\r\n"
								 "element camera 1\r\nproperty list uchar float values\r\n"
								 "element vertex 3\r\nproperty uchar red\r\nproperty int x\r\n"
								 "property float y\r\nproperty float z\r\nproperty float quality\r\n"
								 "element face 1\r\nproperty list uchar short vertex_index\r\n"
								 "property list uchar float texcoord\r\nproperty char flags\r\n"
								 "element more 1\r\nproperty int what\r\nend_header\r\n"
								 "2 1 2\r\n1 1.5 0 0 inf # a comment 7\r\n300 1 0 nan .5\r\n0\n0 1e0 1 "
								 "-1\r\n3 0 1 2 6 0 0 1 0 1 1 -7\r\nrubbish\r\n";
	std::string       expected = "ply\nformat binary_little_endian 1.0\ncomment TextureFile a.png\n"
								 "element vertex 3\nproperty uchar red\nproperty double x\n"
								 "property double y\nproperty double z\nproperty float quality\n"
								 "element face 1\nproperty list uchar int vertex_index\n"
								 "property list uchar float texcoord\nproperty char flags\nend_header\n";
	const double      vertices[3][5] = {
			 {1, 1.5, 0, 0, INFINITY}, {255, 1, 0, NAN, .5}, {0, 0, 1, 1, -1}};
	for (const auto& v : vertices) {
		expected += char(std::uint8_t(v[0]));
		for (int k = 1; k < 4; ++k)
			putBinary(expected, v[k], true);
		putBinary(expected, float(v[4]), true);
	}
	expected += char(3);
	for (std::int32_t v : {0, 1, 2})
		putBinary(expected, v, true);
	expected += char(6);
	for (float t : {0, 0, 1, 0, 1, 1})
		putBinary(expected, t, true);
	expected += char(-7);
	ASSERT_EQ(plan(put("in.ply", text)).exitCode, 0);
	EXPECT_EQ(content(path("run/input0.ply")), expected);
}

TEST_F(TileInputs, DamageIsToldWithItsLine)
{
	const auto refused = [&](const std::string& name, const std::string& file, const char* words) {
		expectFailure(plan(put(name, file)), 3, words);
		EXPECT_FALSE(exists(path("run/input0.ply"))) << name;
		EXPECT_FALSE(exists(path("run/input0.json"))) << name;
	};
	refused("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1\nf 1 2 3\n", "line 3");
	refused("b.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n\nf 1 2 \\\n 3x\n", "line 5");
	refused("c.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", "names a vertex that does not exist");
	refused("d.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -1 -2 -4\n",
			"names a vertex that does not exist");
	refused("e.obj", "v 0 0 0\nv 1 0 0\n", "no faces");
	refused("f.obj", "", "no faces");
	refused("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 x\n3 0 1 2\n", "line 5");
	refused("b.off", "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "ends too early");
	std::string text = asciiPly(torus(4));
	refused("a.ply", text.substr(0, text.size() - 20), "ends too early");
	const std::size_t body = text.find("end_header");
	text.replace(text.find('\n', body) + 1, 1, "x");
	refused("b.ply", text, "line 10");
	const std::string stl = binaryStl(torus(8));
	refused("a.stl", stl.substr(0, stl.size() - 1), "ends too early");
	refused("b.stl", asciiStl(torus(4)), "cannot be read in tiles");
	refused("a.glb", "glTF", "cannot be read in tiles");
}

TEST_F(TileInputs, WhatWasConvertedIsTestedAndNotConvertedAgain)
{
	const std::string good = obj(torus(40));
	const std::string in   = put("in.obj", good);
	ASSERT_EQ(plan(in).exitCode, 0);
	const std::string made   = content(path("run/input0.ply"));
	const auto        before = std::filesystem::last_write_time(path("run/input0.ply"));
	ASSERT_EQ(plan(in).exitCode, 0);
	EXPECT_EQ(before, std::filesystem::last_write_time(path("run/input0.ply")));

	std::filesystem::remove(path("run/input0.json")); // as after a kill
	ASSERT_EQ(plan(in).exitCode, 0);
	EXPECT_EQ(made, content(path("run/input0.ply")));

	std::string other = good;
	other[other.find("v ") + 2] ^= 1;
	put("in.obj", other);
	expectFailure(plan(in), 3, "has changed");
	put("in.obj", good);
	expectFailure(plan(put("other.obj", good)), 2, "another plan");
	put("run/input0.ply", made.substr(0, made.size() - 1) + '\x7f');
	expectFailure(plan(in), 3, "differs from the written file");
}

TEST_F(TileInputs, SeveralFilesOfSeveralFormatsAreOneSurface)
{
	const auto [left, right] = halvesOfGrid(60);
	const std::string a      = put("left.obj", obj(left));
	const std::string b      = put("right.ply", binaryPly(right, true, false));
	step({"plan", path("run"), a, b, "--vertices", "400", "--tiles", "2"});
	step({"split", path("run")});
	for (int unit = 0; unit < 2; ++unit)
		step({"part", path("run"), "--unit", std::to_string(unit)});
	step({"join", path("run")});
	step({"finish", path("run"), path("out.ply"), "--quiet"});
	const Json facts = Json::parse(run({"info", path("out.ply"), "--json"}).out)["input"];
	EXPECT_EQ(facts["components"], 1);
	EXPECT_EQ(facts["boundaryLoops"], 1);
	EXPECT_EQ(facts["vertices"], 400);
}

/// A run of one command, with memory for the tiles alone.
class LargeTileInputs : public TileInputs {
protected:
	std::vector<std::string> command(const std::string& input)
	{
		return {"remesh",   input, path("out.ply"), "--vertices",        "2000",
				"--memory", "45M", "--report",      path("report.json"), "--quiet"};
	}

	/// The bytes of the result.
	std::string result(const std::string& input)
	{
		const ProgramResult done = run(command(input), 300);
		EXPECT_EQ(done.exitCode, 0) << done.err;
		EXPECT_FALSE(exists(path("out.ply.tiles"))) << "cleared at the end";
		return content(path("out.ply"));
	}

	double peakMegabytes()
	{
		return Json::parse(content(path("report.json")))["peakMemoryBytes"].get<double>() * 1e-6;
	}
};

TEST_F(LargeTileInputs, AreRemeshedWithinTheMemory)
{
	if (GPREMESH_IS_SANITIZED) GTEST_SKIP() << "A sanitizer takes memory of its own.";
	const TestMesh mesh = inOrderOfUse(torus(500));
	ASSERT_EQ(run({"remesh", put("in.ply", binaryPly(mesh, true, false)), path("out.ply"),
				   "--vertices", "2000", "--report", path("report.json")},
				  120)
				  .exitCode,
			  0);
	const double ofWholeMesh = peakMegabytes();
	const auto   bytes       = result(path("in.ply"));
	const double ofTiles     = peakMegabytes();
	for (const std::string& in : {put("in.obj", obj(mesh)), put("in.stl", binaryStl(mesh)),
								  put("text.ply", asciiPly(mesh))}) {
		EXPECT_EQ(bytes, result(in)) << in;
		EXPECT_LT(peakMegabytes(), ofTiles + 30) << in;
		EXPECT_LT(peakMegabytes(), ofWholeMesh) << in;
	}
}

TEST_F(LargeTileInputs, AKilledRunGoesOnWhereItWas)
{
	const std::string in    = put("in.obj", obj(inOrderOfUse(torus(400))));
	const std::string whole = result(in);
	std::filesystem::remove(path("out.ply"));
	for (int i = 0; i < 3; ++i)
		runAndSignal(command(in), SIGKILL);
	EXPECT_EQ(whole, result(in));
}

/// The converted input is no longer there when the run goes on behind the split.
TEST_F(LargeTileInputs, GoOnBehindTheSplitOnlyWithTheSameInputAndOptions)
{
	const std::string good  = obj(inOrderOfUse(torus(400)));
	const std::string in    = put("in.obj", good);
	const std::string whole = result(in), folder = path("out.ply.tiles");
	step({"plan", folder, in, "--vertices", "2000", "--memory", "45M"});
	step({"split", folder});
	std::filesystem::remove(folder + "/input0.ply");
	std::string other = good;
	other[other.find("v ") + 2] ^= 1;
	put("in.obj", other);
	expectFailure(run(command(in), 60), 3, "has changed");
	put("in.obj", good);
	std::vector<std::string> more = command(in);
	more[4]                       = "2001";
	expectFailure(run(more, 60), 2, "another plan");
	EXPECT_EQ(whole, result(in));
}

} // namespace gpr_test
