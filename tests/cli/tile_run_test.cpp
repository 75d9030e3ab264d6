// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The commands gpremesh remesh --memory and gpremesh tile.
#include "mesh_files.h"
#include "program_runner.h"

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

namespace gpr_test {

using Json = nlohmann::json;

namespace {

/// Puts a mesh beside another mesh.
void append(const TestMesh& more, TestMesh& mesh)
{
	const int first = int(mesh.points.size());
	mesh.points.insert(mesh.points.end(), more.points.begin(), more.points.end());
	for (const auto& f : more.faces)
		mesh.faces.push_back({f[0] + first, f[1] + first, f[2] + first});
}

int mostFacesOfAnEdge(const TestMesh& mesh)
{
	std::map<std::array<int, 2>, int> faceNum;
	int                               most = 0;
	for (const auto& f : mesh.faces) {
		for (std::size_t k = 0; k < 3; ++k) {
			const auto ends = std::minmax(f[k], f[(k + 1) % 3]);
			most            = std::max(most, ++faceNum[{ends.first, ends.second}]);
		}
	}
	return most;
}

/// The walls of n by n by n boxes, each wall cut into cells by cells squares.
TestMesh foam(int n, int cells)
{
	const int                         size = n * cells + 1;
	std::map<std::array<int, 3>, int> number;
	TestMesh                          mesh;
	const auto                        numberOf = [&](const std::array<int, 3>& at) {
        const auto added = number.emplace(at, int(mesh.points.size()));
        if (added.second) mesh.points.push_back({double(at[0]), double(at[1]), double(at[2])});
        return added.first->second;
	};
	for (std::size_t axis = 0; axis < 3; ++axis) {
		for (int wall = 0; wall < size; wall += cells) {
			for (int i = 0; i + 1 < size; ++i) {
				for (int k = 0; k + 1 < size; ++k) {
					const auto corner = [&](int di, int dk) {
						std::array<int, 3> at{};
						at[axis]           = wall;
						at[(axis + 1) % 3] = i + di;
						at[(axis + 2) % 3] = k + dk;
						return numberOf(at);
					};
					mesh.faces.push_back({corner(0, 0), corner(1, 0), corner(1, 1)});
					mesh.faces.push_back({corner(0, 0), corner(1, 1), corner(0, 1)});
				}
			}
		}
	}
	return mesh;
}

} // namespace

class TileRun : public CliTest {
protected:
	static constexpr int tileNum = 5;

	void runStep(std::vector<std::string> words)
	{
		words.insert(words.begin(), "tile");
		const ProgramResult result = run(words, 120);
		EXPECT_EQ(result.exitCode, 0) << words[1] << ": " << result.err;
	}

	void plan(const std::string& input, std::vector<std::string> options)
	{
		std::vector<std::string> words = {"plan", path("run"), input};
		words.insert(words.end(), options.begin(), options.end());
		words.insert(words.end(), {"--tiles", std::to_string(tileNum)});
		runStep(words);
	}

	void part(int unit) { runStep({"part", path("run"), "--unit", std::to_string(unit)}); }

	/// All steps; the result is out.ply.
	TestMesh remeshedInTiles(const std::string& input, const std::vector<std::string>& options)
	{
		plan(input, options);
		runStep({"split", path("run")});
		for (int unit = 0; unit < tileNum; ++unit)
			part(unit);
		runStep({"join", path("run")});
		runStep(
			{"finish", path("run"), path("out.ply"), "--quiet", "--report", path("report.json")});
		std::string precision;
		return parseWrittenPly(content(path("out.ply")), precision);
	}

	Json info(const std::string& file)
	{
		const ProgramResult result = run({"info", file, "--json"});
		EXPECT_EQ(result.exitCode, 0) << result.err;
		return Json::parse(result.out);
	}

	/// The same topology, and as many vertices.
	void expectAsWithoutTiles(const std::string& input, const std::string& vertexNum,
							  std::vector<std::string> options = {})
	{
		options.insert(options.end(), {"--vertices", vertexNum});
		remeshedInTiles(input, options);
		options.insert(options.begin(), {"remesh", input, path("whole.ply")});
		const ProgramResult whole = run(options);
		ASSERT_EQ(whole.exitCode, 0) << whole.err;
		const Json tiled    = info(path("out.ply"))["input"],
				   expected = info(path("whole.ply"))["input"];
		for (const char* key : {"vertices", "components", "boundaryLoops", "eulerCharacteristic"})
			EXPECT_EQ(tiled[key], expected[key]) << key;
	}

	Json report() { return Json::parse(content(path("report.json"))); }
};

TEST_F(TileRun, KeepsTopologyCountAndShape)
{
	const std::string in   = put("torus.ply", binaryPly(torus(160), true, false));
	const TestMesh    mesh = remeshedInTiles(in, {"--vertices", "1500"});
	EXPECT_EQ(mesh.points.size(), 1500u);
	const Json facts = info(path("out.ply"));
	EXPECT_EQ(facts["input"]["eulerCharacteristic"], 0);
	EXPECT_EQ(facts["input"]["boundaryLoops"], 0);
	EXPECT_EQ(facts["input"]["components"], 1);
	EXPECT_GT(facts["quality"]["angles"]["min"], 30);
	EXPECT_GT(facts["quality"]["radiusRatio"]["mean"], 0.97);
	for (const auto& p : mesh.points)
		EXPECT_NEAR(std::hypot(std::hypot(p[0], p[1]) - 1, p[2]), 0.4, 0.007);
}

/// The seams show nowhere: the same figures as without tiles.
TEST_F(TileRun, IsAsRegularAndNearAsWithoutTiles)
{
	const std::string in = put("torus.ply", binaryPly(torus(160), true, false));
	remeshedInTiles(in, {"--vertices", "1500"});
	const Json tiled = info(path("out.ply"));
	ASSERT_EQ(run({"remesh", in, path("whole.ply"), "--vertices", "1500"}).exitCode, 0);
	const Json whole = info(path("whole.ply"));
	EXPECT_NEAR(tiled["quality"]["radiusRatio"]["mean"].get<double>(),
				whole["quality"]["radiusRatio"]["mean"].get<double>(), 0.006);
	EXPECT_NEAR(tiled["input"]["area"].get<double>(), whole["input"]["area"].get<double>(),
				0.003 * whole["input"]["area"].get<double>());
}

TEST_F(TileRun, TheOrderOfStepsAndThreadsAndRepeatsDoNotMatter)
{
	const std::string in = put("torus.ply", binaryPly(torus(120), true, false));
	remeshedInTiles(in, {"--vertices", "900"});
	const std::string first = content(path("out.ply"));
	std::filesystem::remove_all(path("run"));
	plan(in, {"--vertices", "900"});
	plan(in, {"--vertices", "900"});
	runStep({"split", path("run")});
	for (int unit : {3, 0, 4, 3, 1, 2})
		part(unit);
	std::filesystem::remove(path("run/part2.json")); // as after a kill
	part(2);
	runStep({"join", path("run")});
	runStep({"finish", path("run"), path("again.ply"), "--quiet"});
	EXPECT_EQ(first, content(path("again.ply")));
}

TEST_F(TileRun, OneCommandDoesAllStepsWithinItsMemory)
{
	const std::string              in     = put("torus.ply", binaryPly(torus(400), true, false));
	const std::vector<std::string> words  = {"remesh",     in,         path("out.ply"),
											 "--vertices", "3000",     "--memory",
											 "45M",        "--report", path("report.json")};
	const ProgramResult            result = run(words, 300);
	ASSERT_EQ(result.exitCode, 0) << result.err;
	EXPECT_NE(result.out.find("condensed in"), std::string::npos) << result.out;
	EXPECT_EQ(result.err.find("In 5 tiles: about "), 0u) << result.err;
	EXPECT_NE(result.err.find(" of disk in '" + path("out.ply.tiles") + "'."), std::string::npos)
		<< result.err;
	EXPECT_EQ(report()["result"]["vertices"], 3000);
	EXPECT_EQ(report()["result"]["eulerCharacteristic"], 0);
	EXPECT_FALSE(exists(path("out.ply.tiles"))) << "cleared at the end";
}

/// With little memory the condensed surface has fewer vertices for each vertex of the result.
TEST_F(TileRun, WhereMemoryIsShortLessDenseTilesServe)
{
	const std::string in             = put("torus.ply", binaryPly(torus(400), true, false));
	const auto        joinedVertices = [&](const std::string& memory) {
        std::filesystem::remove_all(path("run"));
        runStep(
				   {"plan", path("run"), in, "--vertices", "20000", "--memory", memory, "--tiles", "3"});
        runStep({"split", path("run")});
        for (int unit = 0; unit < 3; ++unit)
            part(unit);
        runStep({"join", path("run")});
        runStep(
				   {"finish", path("run"), path("out.ply"), "--quiet", "--report", path("report.json")});
        EXPECT_EQ(report()["result"]["vertices"], 20000);
        return info(path("run/joined.ply"))["input"]["vertices"].get<double>();
	};
	const auto isTold = [&] {
		return report()["notes"].dump().find("The memory allows a condensed surface") !=
			   std::string::npos;
	};
	// Four for each vertex of the result, and some more at the seams.
	const double usual = joinedVertices("1G");
	EXPECT_NEAR(usual, 86000, 5000);
	EXPECT_FALSE(isTold());
	EXPECT_NEAR(joinedVertices("45M"), usual - 18600, 2000);
	EXPECT_TRUE(isTold());
	EXPECT_GT(info(path("out.ply"))["quality"]["angles"]["min"], 30);
}

/// Coordinates of a map, which floats resolve to a quarter of a metre.
TEST_F(TileRun, CoordinatesFarFromTheOriginLoseNothing)
{
	const TestMesh here = torus(160);
	const TestMesh far  = moved(here, 600000, 5100000, 300);
	remeshedInTiles(put("here.ply", binaryPly(here, true, true)), {"--vertices", "1500"});
	const Json expected = info(path("out.ply"));
	std::filesystem::remove_all(path("run"));
	const TestMesh mesh =
		remeshedInTiles(put("far.ply", binaryPly(far, true, true)), {"--vertices", "1500"});
	EXPECT_EQ(report()["result"]["precision"], "double");
	const Json facts = info(path("out.ply"));
	EXPECT_EQ(facts["input"]["vertices"], 1500);
	EXPECT_EQ(facts["input"]["eulerCharacteristic"], 0);
	// As much as between two seeds.
	EXPECT_NEAR(facts["input"]["area"], expected["input"]["area"], 4e-3);
	EXPECT_GT(facts["quality"]["angles"]["min"], 30);
	for (const auto& p : mesh.points)
		EXPECT_NEAR(std::hypot(std::hypot(p[0] - 600000, p[1] - 5100000) - 1, p[2] - 300), 0.4,
					0.007);
}

TEST_F(TileRun, WithEnoughMemoryThereAreNoTiles)
{
	const std::string in = put("torus.ply", binaryPly(torus(60), true, false));
	ASSERT_EQ(run({"remesh", in, path("a.ply"), "--memory", "1G"}).exitCode, 0);
	ASSERT_EQ(run({"remesh", in, path("b.ply")}).exitCode, 0);
	EXPECT_EQ(content(path("a.ply")), content(path("b.ply")));
}

TEST_F(TileRun, AKilledRunGoesOnWhereItWas)
{
	const std::string              in    = put("torus.ply", binaryPly(torus(400), true, false));
	const std::vector<std::string> words = {"remesh", in,         path("out.ply"), "--vertices",
											"3000",   "--memory", "45M",           "--quiet"};
	ASSERT_EQ(run(words, 300).exitCode, 0);
	const std::string whole = content(path("out.ply"));
	std::filesystem::remove(path("out.ply"));
	for (int i = 0; i < 3; ++i) {
		runAndSignal(words, SIGKILL);
		if (exists(path("out.ply"))) {
			EXPECT_EQ(whole, content(path("out.ply")));
		}
	}
	ASSERT_EQ(run(words, 300).exitCode, 0);
	EXPECT_EQ(whole, content(path("out.ply")));
}

/// Only the files of the run leave its folder at the end.
TEST_F(TileRun, FilesOfTheUserStayInItsFolder)
{
	const std::string mesh = binaryPly(torus(400), true, false);
	std::filesystem::create_directory(path("run"));
	put("run/letter.txt", "mine");
	const std::string   in     = put("run/torus.ply", mesh);
	const ProgramResult result = run({"remesh", in, path("run/out.ply"), "--vertices", "3000",
									  "--memory", "45M", "--scratch", path("run"), "--quiet"},
									 300);
	ASSERT_EQ(result.exitCode, 0) << result.err;
	EXPECT_EQ(content(path("run/letter.txt")), "mine");
	EXPECT_TRUE(content(in) == mesh);
	EXPECT_EQ(info(path("run/out.ply"))["input"]["vertices"], 3000);
	const std::filesystem::directory_iterator left(path("run"));
	EXPECT_EQ(std::distance(begin(left), end(left)), 3);
}

TEST_F(TileRun, NoFileOfTheUserHasANameOfItsFiles)
{
	const std::string mesh = binaryPly(torus(400), true, false);
	const std::string in   = put("torus.ply", mesh);
	std::filesystem::create_directory(path("run"));
	const std::string part = put("run/part0.ply", mesh);
	expectFailure(run({"tile", "plan", path("run"), in}), 2, "holds 'part0.ply'");
	expectFailure(run({"tile", "plan", path("run"), part}), 2, "a name of the run's own files");
	expectFailure(run({"remesh", in, path("run/joined.ply"), "--vertices", "3000", "--memory",
					   "45M", "--scratch", path("run")}),
				  2, "a name of the run's own files");
	EXPECT_TRUE(content(part) == mesh);
	std::filesystem::remove(part);
	plan(in, {"--vertices", "3000"});
	expectFailure(
		run({"tile", "finish", path("run"), path("out.ply"), "--report", path("run/plan.json")}), 2,
		"a name of the run's own files");
}

TEST_F(TileRun, AnOpenSurfaceKeepsItsBorder)
{
	const std::string in   = put("square.ply", binaryPly(grid(150), true, true));
	const TestMesh    mesh = remeshedInTiles(in, {"--vertices", "1000"});
	EXPECT_EQ(mesh.points.size(), 1000u);
	const Json facts = info(path("out.ply"));
	EXPECT_EQ(facts["input"]["boundaryLoops"], 1);
	EXPECT_EQ(facts["input"]["eulerCharacteristic"], 1);
	EXPECT_NEAR(facts["input"]["area"], 1, 1e-9);
	EXPECT_EQ(report()["result"]["precision"], "double");
}

/// The polyline of the border must not change in the last bits, where triangles of the result are
/// hardly larger than triangles of the input.
TEST_F(TileRun, AMatchedBorderHasTheBitsOfARunWithoutTiles)
{
	TestMesh mesh = grid(100);
	for (auto& p : mesh.points)
		p[2] = 0.1 * std::sin(7 * p[0]) * std::cos(5 * p[1]);
	const auto borderOf = [](const TestMesh& of) {
		std::vector<std::array<double, 3>> border;
		for (const auto& p : of.points)
			if (p[0] == 0 || p[0] == 1 || p[1] == 0 || p[1] == 1) border.push_back(p);
		std::sort(border.begin(), border.end());
		return border;
	};
	const std::string              in      = put("square.ply", binaryPly(mesh, true, false));
	const std::vector<std::string> options = {"--edge-length", "0.024", "--boundary", "match"};
	const TestMesh                 tiled   = remeshedInTiles(in, options);
	std::vector<std::string>       words   = {"remesh", in, path("whole.ply"), "--quiet"};
	words.insert(words.end(), options.begin(), options.end());
	ASSERT_EQ(run(words).exitCode, 0);
	std::string    precision;
	const TestMesh whole = parseWrittenPly(content(path("whole.ply")), precision);
	EXPECT_GT(borderOf(whole).size(), 150u);
	EXPECT_TRUE(borderOf(tiled) == borderOf(whole));
}

TEST_F(TileRun, PiecesWhoseBordersCoincideAreOneSurface)
{
	const auto [left, right] = halvesOfGrid(120);
	const std::string a      = put("left.ply", binaryPly(left, true, false));
	const std::string b      = put("right.ply", binaryPly(right, true, false));
	runStep({"plan", path("run"), a, b, "--vertices", "800", "--tiles", "3"});
	runStep({"split", path("run")});
	for (int unit = 0; unit < 3; ++unit)
		part(unit);
	runStep({"join", path("run")});
	runStep({"finish", path("run"), path("out.ply"), "--quiet"});
	const Json facts = info(path("out.ply"));
	EXPECT_EQ(facts["input"]["components"], 1);
	EXPECT_EQ(facts["input"]["boundaryLoops"], 1);
	EXPECT_EQ(facts["input"]["vertices"], 800);
}

/// Coordinates so coarse that many faces are degenerate, as in huge scans in single precision. Such
/// faces stay unchanged at the border of a tile.
TEST_F(TileRun, FacesWithoutAreaAtTheBorderOfATileAreNoHindrance)
{
	TestMesh mesh = torus(160);
	for (auto& point : mesh.points) {
		for (double& c : point)
			c = std::round(64 * c) / 64;
	}
	remeshedInTiles(put("coarse.ply", binaryPly(mesh, true, false)), {"--vertices", "1500"});
	for (int unit = 0; unit < tileNum; ++unit) {
		const Json part = Json::parse(content(path("run/part" + std::to_string(unit) + ".json")));
		EXPECT_TRUE(part["condensed"].get<bool>()) << unit << ": " << part["note"];
	}
	const Json facts = info(path("out.ply"));
	EXPECT_EQ(facts["input"]["vertices"], 1500);
	EXPECT_EQ(facts["input"]["eulerCharacteristic"], 0);
	EXPECT_EQ(facts["input"]["components"], 1);
	EXPECT_EQ(facts["input"]["boundaryLoops"], 0);
	EXPECT_GT(facts["quality"]["angles"]["min"], 30);
}

/// A sheet that stands on another sheet: the edges of the junction have three faces.
TEST_F(TileRun, EdgesWithThreeFacesAreCutAsWithoutTiles)
{
	TestMesh          mesh = grid(60);
	const TestMesh    fin  = grid(60);
	std::vector<int>  number;
	const std::size_t flat = mesh.points.size();
	for (const auto& p : fin.points) {
		int there = -1;
		for (std::size_t v = 0; v < flat && p[1] == 0; ++v) {
			if (std::abs(mesh.points[v][0] - 0.5) < 1e-9 &&
				std::abs(mesh.points[v][1] - p[0]) < 1e-9)
				there = int(v);
		}
		if (there < 0) {
			there = int(mesh.points.size());
			mesh.points.push_back({0.5, p[0], p[1]});
		}
		number.push_back(there);
	}
	for (const auto& f : fin.faces)
		mesh.faces.push_back(
			{number[std::size_t(f[0])], number[std::size_t(f[1])], number[std::size_t(f[2])]});
	const std::string in = put("fin.ply", binaryPly(mesh, true, false));
	expectAsWithoutTiles(in, "900");
}

/// A Möbius band, which no orientation of its tiles fits.
TEST_F(TileRun, AMoebiusBandOverSeveralTilesIsAsWithoutTiles)
{
	constexpr int around = 300, across = 24;
	TestMesh      mesh;
	for (int i = 0; i < around; ++i) {
		for (int k = 0; k <= across; ++k) {
			const double u = 2 * 3.14159265358979 * i / around, v = 0.4 * (2.0 * k / across - 1);
			const double r = 1 + v * std::cos(u / 2);
			mesh.points.push_back({r * std::cos(u), r * std::sin(u), v * std::sin(u / 2)});
		}
	}
	const auto number = [](int i, int k) {
		// Once around, the two borders have changed places.
		return i < around ? i * (across + 1) + k : across - k;
	};
	for (int i = 0; i < around; ++i) {
		for (int k = 0; k < across; ++k) {
			mesh.faces.push_back({number(i, k), number(i + 1, k), number(i + 1, k + 1)});
			mesh.faces.push_back({number(i, k), number(i + 1, k + 1), number(i, k + 1)});
		}
	}
	expectAsWithoutTiles(put("band.ply", binaryPly(mesh, true, false)), "600");
}

/// Components smaller than the triangles of the result, wherever the seams lie.
TEST_F(TileRun, TinyPiecesAreAsWithoutTiles)
{
	TestMesh mesh = torus(120);
	for (int i = 0; i < 60; ++i) {
		TestMesh piece = sphere(1 + i % 5);
		for (auto& p : piece.points) {
			for (double& c : p)
				c *= 0.01;
		}
		append(moved(piece, 0.05 * i - 1.5, 0.5 * std::sin(double(i)), 0.6), mesh);
	}
	expectAsWithoutTiles(put("pieces.ply", binaryPly(mesh, true, false)), "1500");
}

/// Faces that are repeated, also at the seams of the tiles and with long edges there.
TEST_F(TileRun, RepeatedFacesLeaveNoHoles)
{
	TestMesh mesh = torus(60);
	for (std::size_t f = 0; f < 7200; f += 7) {
		const auto [a, b, c] = mesh.faces[f];
		mesh.faces.push_back({b, c, a});
	}
	expectAsWithoutTiles(put("repeated.ply", binaryPly(mesh, true, false)), "2200");
}

/// Faces without common vertices: all faces of a mesh, and again each face with a number that is
/// one below a multiple of `step`.
TestMesh soupOf(const TestMesh& mesh, std::size_t step)
{
	TestMesh soup;
	for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
		for (std::size_t again = 0; again < (f % step == step - 1 ? 2u : 1u); ++again) {
			const int first = int(soup.points.size());
			for (std::size_t k = 0; k < 3; ++k)
				soup.points.push_back(mesh.points[std::size_t(mesh.faces[f][(k + again) % 3])]);
			soup.faces.push_back({first, first + 1, first + 2});
		}
	}
	return soup;
}

TEST_F(TileRun, ASoupOfRepeatedFacesIsAsWithoutTiles)
{
	expectAsWithoutTiles(put("soup.ply", binaryPly(soupOf(torus(60), 7), true, false)), "2200");
}

/// With a single common vertex the engine no longer joins all, but sews the triangles; all tiles
/// but one are soups.
TEST_F(TileRun, TilesThatAreSoupsFitToATileThatIsNone)
{
	const TestMesh whole = torus(60);
	TestMesh       mesh  = soupOf(whole, 1000000);
	const int      first = whole.faces[0][0];
	for (std::size_t f = 1; f < whole.faces.size(); ++f) {
		for (std::size_t k = 0; k < 3; ++k)
			if (whole.faces[f][k] == first) mesh.faces[f][k] = mesh.faces[0][0];
	}
	expectAsWithoutTiles(put("nearly.ply", binaryPly(mesh, true, false)), "2200");
}

/// Boxes side by side with common walls: three or four faces at the edges of the walls. The surface
/// does not tell which of these faces stay joined after a cut; the choice depends on the tiles.
TEST_F(TileRun, FoamLosesNoWall)
{
	const std::string in   = put("foam.ply", binaryPly(foam(3, 8), true, false));
	const TestMesh    mesh = remeshedInTiles(in, {"--vertices", "1500"});
	EXPECT_EQ(mesh.points.size(), 1500u);
	EXPECT_LE(mostFacesOfAnEdge(mesh), 2);
	const Json   facts = info(path("out.ply"))["input"];
	const double walls = 3 * 4 * 24 * 24;
	EXPECT_NEAR(facts["area"].get<double>(), walls, 0.005 * walls);
}

/// With few and with many vertices: tiles that are condensed, and tiles that stay.
TEST_F(TileRun, JunctionsAreKeptAsWithoutTiles)
{
	const std::string in = put("foam.ply", binaryPly(foam(2, 8), true, false));
	for (const char* vertexNum : {"150", "700"}) {
		std::filesystem::remove_all(path("run"));
		expectAsWithoutTiles(in, vertexNum, {"--junctions", "keep"});
		std::string precision;
		EXPECT_EQ(mostFacesOfAnEdge(parseWrittenPly(content(path("out.ply")), precision)), 4)
			<< vertexNum;
	}
}

TEST_F(TileRun, AShareTooSmallForTheTopologyIsRaised)
{
	const std::string in   = put("torus.ply", binaryPly(torus(60), true, false));
	const TestMesh    mesh = remeshedInTiles(in, {"--percent", "0.03"}); // a single vertex
	EXPECT_GE(mesh.points.size(), 7u);
	EXPECT_LE(mesh.points.size(), 40u);
}

/// Huge triangles beside small triangles, and seams through both.
TEST_F(TileRun, LongEdgesOfSeamsLeaveNoNeedles)
{
	TestMesh mesh = grid(100);
	for (auto& p : mesh.points)
		p[0] = p[0] * p[0] * p[0]; // cells up to three times as long, and much shorter cells
	const std::string in = put("graded.ply", binaryPly(mesh, true, false));
	remeshedInTiles(in, {"--vertices", "3000"});
	const Json facts = info(path("out.ply"));
	EXPECT_GT(facts["quality"]["angles"]["min"], 25);
	EXPECT_EQ(facts["input"]["boundaryLoops"], 1);
}

TEST_F(TileRun, AttributesComeThrough)
{
	const TestMesh mesh = torus(100);
	std::string    file = "ply\nformat binary_little_endian 1.0\nelement vertex " +
					   std::to_string(mesh.points.size()) +
					   "\nproperty float x\nproperty float y\nproperty float z\n"
					   "property uchar red\nproperty uchar green\nproperty uchar blue\n"
					   "property float height\nelement face " +
					   std::to_string(mesh.faces.size()) +
					   "\nproperty list uchar int vertex_indices\nend_header\n";
	for (const auto& p : mesh.points) {
		for (double c : p)
			putBinary(file, float(c), true);
		for (int k = 0; k < 3; ++k)
			putBinary(file, std::uint8_t(100 + 50 * p[0]), true);
		putBinary(file, float(p[2]), true);
	}
	for (const auto& f : mesh.faces) {
		file += char(3);
		for (int v : f)
			putBinary(file, std::int32_t(v), true);
	}
	remeshedInTiles(put("in.ply", file), {"--vertices", "700"});
	const std::string out = content(path("out.ply"));
	EXPECT_NE(out.find("property uchar red"), std::string::npos);
	EXPECT_NE(out.find("property float height"), std::string::npos);
	const std::size_t body  = out.find("end_header\n") + 11;
	const std::size_t bytes = 12 + 3 + 4;
	for (std::size_t v = 0; v < 700; ++v) {
		float             p[3], height;
		const char* const at = out.data() + body + v * bytes;
		std::memcpy(p, at, 12);
		std::memcpy(&height, at + 15, 4);
		EXPECT_NEAR(height, p[2], 0.03);
		EXPECT_NEAR(std::uint8_t(at[12]), 100 + 50 * p[0], 4);
	}
}

TEST_F(TileRun, DamagedFilesAreToldNotUsed)
{
	const std::string in = put("torus.ply", binaryPly(torus(100), true, false));
	plan(in, {"--vertices", "700"});
	runStep({"split", path("run")});
	for (int unit = 0; unit < tileNum; ++unit)
		part(unit);
	for (const char* name : {"run/part2.ply", "run/part2.names"}) {
		const std::string good = content(path(name));
		std::string       bad  = good;
		bad[bad.size() / 2]    = char(bad[bad.size() / 2] ^ 8);
		put(name, bad);
		expectFailure(run({"tile", "join", path("run")}), 3, "differs from the written file");
		put(name, good);
	}
	std::filesystem::remove(path("run/part1.json"));
	put("run/tile1.ply", content(path("run/tile1.ply")).substr(0, 500));
	expectFailure(run({"tile", "part", path("run"), "--unit", "1"}), 3,
				  "differs from the written file");
	put("run/split.json", "{");
	expectFailure(run({"tile", "part", path("run"), "--unit", "1"}), 3, "damaged");
}

/// The same numbers of vertices and faces, but other properties.
TEST_F(TileRun, APieceThatWasReplacedByAnotherIsRefused)
{
	const auto [left, right] = halvesOfGrid(20);
	const std::string a      = put("left.ply", binaryPly(left, true, false));
	const std::string b      = put("right.ply", binaryPly(right, true, false));
	runStep({"plan", path("run"), a, b, "--vertices", "50", "--tiles", "2"});
	put("right.ply", binaryPly(right, true, true)); // in doubles
	expectFailure(run({"tile", "split", path("run")}), 3, "has changed since the plan was made");
}

TEST_F(TileRun, WhatCannotBeIsRefusedWithASentence)
{
	const std::string in = put("torus.ply", binaryPly(torus(100), true, false));
	expectFailure(run({"tile", "split", path("run")}), 2, "holds no plan");
	expectFailure(run({"tile", "plan", path("run"), in, "--max-error", "0.1%"}), 2, "--max-error");
	expectFailure(run({"tile", "plan", path("run"), in, "--edge-length", "1%"}), 2, "percent");
	expectFailure(run({"tile", "plan", path("run"), in, "--boundary", "keep"}), 2,
				  "--boundary keep");
	expectFailure(run({"tile", "plan", path("run"), in, "--drop-components-below", "9"}), 2,
				  "--drop-components-below");
	expectFailure(run({"tile", "plan", path("run"), in, "--vertices", "900000", "--memory", "40M"}),
				  4, "Ask for at most");
	expectFailure(run({"tile", "plan", path("run"), in, "--vertices", "700", "--memory", "5M"}), 4,
				  "at least 0.03 GB of memory, and --memory allows 0.005 GB.");
	const std::string text = put("text.stl", asciiStl(torus(20)));
	expectFailure(run({"tile", "plan", path("run"), text}), 3, "cannot be read in tiles");
	plan(in, {"--vertices", "700"});
	expectFailure(run({"tile", "plan", path("run"), in, "--vertices", "701", "--tiles", "5"}), 2,
				  "another plan");
	expectFailure(run({"tile", "part", path("run"), "--unit", "0"}), 2, "split");
	runStep({"split", path("run")});
	expectFailure(run({"tile", "part", path("run"), "--unit", "5"}), 2, "from 0 to 4");
	expectFailure(run({"tile", "join", path("run")}), 2, "Part 0");
	expectFailure(run({"tile", "finish", path("run"), path("out.ply")}), 2, "joined");
	put("torus.ply", binaryPly(torus(101), true, false));
	std::filesystem::remove(path("run/split.json"));
	expectFailure(run({"tile", "split", path("run")}), 3, "has changed");
}

} // namespace gpr_test
