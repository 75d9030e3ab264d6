// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// A result as a folder of tiles: gpremesh remesh --tiles-out.
#include "mesh_files.h"
#include "program_runner.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

namespace gpr_test {

using Json = nlohmann::json;

namespace {

using Point    = std::array<double, 3>;
using Triangle = std::array<Point, 3>;

/// The triangles of a mesh by their positions, each begun at its smallest corner.
std::multiset<Triangle> trianglesOf(const TestMesh& mesh)
{
	std::multiset<Triangle> triangles;
	for (const auto& f : mesh.faces) {
		Triangle t;
		for (std::size_t k = 0; k < 3; ++k)
			t[k] = mesh.points[std::size_t(f[k])];
		std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
		triangles.insert(t);
	}
	return triangles;
}

/// A torus with a colour for each vertex and a number for each face.
std::string paintedTorus(int n)
{
	const TestMesh mesh = torus(n);
	std::string    file =
		"ply\nformat binary_little_endian 1.0\nelement vertex " +
		std::to_string(mesh.points.size()) +
		"\nproperty float x\nproperty float y\nproperty float z\n"
		"property float height\nelement face " +
		std::to_string(mesh.faces.size()) +
		"\nproperty list uchar int vertex_indices\nproperty uchar side\nend_header\n";
	for (const auto& p : mesh.points) {
		for (const double c : p)
			putBinary(file, float(c), true);
		putBinary(file, float(10 * p[0]), true);
	}
	for (const auto& f : mesh.faces) {
		file += char(3);
		for (const int v : f)
			putBinary(file, std::int32_t(v), true);
		file += char(mesh.points[std::size_t(f[0])][0] > 0 ? 1 : 0);
	}
	return file;
}

} // namespace

class ResultTiles : public CliTest {
protected:
	TestMesh mesh(const std::string& file)
	{
		std::string precision;
		return parseWrittenPly(content(file), precision);
	}

	Json index() { return Json::parse(content(path("tiles/tiles.json"))); }

	void remesh(const std::string& in, const std::string& out, std::vector<std::string> more)
	{
		more.insert(more.begin(), {"remesh", in, out, "--quiet"});
		const ProgramResult result = run(more, 120);
		ASSERT_EQ(result.exitCode, 0) << result.err;
	}
};

TEST_F(ResultTiles, TogetherAreTheResult)
{
	const std::string in = put("torus.ply", binaryPly(torus(100), true, true));
	remesh(in, path("whole.ply"), {"--vertices", "2000"});
	remesh(in, path("tiles"), {"--vertices", "2000", "--tiles-out", "7"});
	std::multiset<Triangle> all;
	std::set<Point>         points;
	const Json              json = index();
	ASSERT_EQ(json["tiles"].size(), 7u);
	for (const Json& tile : json["tiles"]) {
		const TestMesh part = mesh(path("tiles/" + tile["file"].get<std::string>()));
		EXPECT_EQ(part.points.size(), tile["vertices"].get<std::size_t>());
		EXPECT_EQ(part.faces.size(), tile["faces"].get<std::size_t>());
		EXPECT_NEAR(double(part.faces.size()), 4000 / 7.0, 2);
		all.merge(trianglesOf(part));
		for (std::size_t k = 0; k < 3; ++k) {
			const auto before = [k](const Point& a, const Point& b) { return a[k] < b[k]; };
			const auto ends   = std::minmax_element(part.points.begin(), part.points.end(), before);
			EXPECT_EQ((*ends.first)[k], tile["low"][k].get<double>());
			EXPECT_EQ((*ends.second)[k], tile["high"][k].get<double>());
		}
		points.insert(part.points.begin(), part.points.end());
	}
	EXPECT_EQ(all, trianglesOf(mesh(path("whole.ply"))));
	EXPECT_EQ(points.size(), 2000u); // common vertices of tiles are the same, bit for bit
	EXPECT_EQ(json["vertices"], 2000);
	EXPECT_EQ(json["faces"], 4000);
}

/// Tiles of a result can be sewn again.
TEST_F(ResultTiles, AreOneSurfaceAgainAsAnInput)
{
	const std::string in = put("torus.ply", binaryPly(torus(60), true, false));
	remesh(in, path("tiles"), {"--vertices", "1200", "--tiles-out", "3"});
	ASSERT_EQ(run({"tile", "plan", path("run"), path("tiles/tile0.ply"), path("tiles/tile1.ply"),
				   path("tiles/tile2.ply"), "--vertices", "300", "--tiles", "2"})
				  .exitCode,
			  0);
	for (const std::vector<std::string>& step : {std::vector<std::string>{"split"},
												 {"part", "--unit", "0"},
												 {"part", "--unit", "1"},
												 {"join"}}) {
		std::vector<std::string> words = {"tile", step[0], path("run")};
		words.insert(words.end(), step.begin() + 1, step.end());
		ASSERT_EQ(run(words, 120).exitCode, 0) << step[0];
	}
	ASSERT_EQ(run({"tile", "finish", path("run"), path("out.ply"), "--quiet"}, 120).exitCode, 0);
	const Json facts = Json::parse(run({"info", path("out.ply"), "--json"}).out);
	EXPECT_EQ(facts["input"]["boundaryLoops"], 0);
	EXPECT_EQ(facts["input"]["components"], 1);
	EXPECT_EQ(facts["input"]["vertices"], 300);
	ASSERT_EQ(run({"tile", "finish", path("run"), path("tiles"), "--tiles-out", "2"}, 120).exitCode,
			  0);
	EXPECT_EQ(index()["vertices"], 300);
}

TEST_F(ResultTiles, HaveTheAttributesOfTheResult)
{
	const std::string in = put("in.ply", paintedTorus(80));
	remesh(in, path("tiles"), {"--vertices", "900", "--tiles-out", "4"});
	for (int tile = 0; tile < 4; ++tile) {
		const std::string file      = content(path("tiles/tile" + std::to_string(tile) + ".ply"));
		const Json        json      = index()["tiles"][std::size_t(tile)];
		const std::size_t vertexNum = json["vertices"], faceNum = json["faces"];
		const std::size_t vertexBytes = 16, faceBytes = 14;
		const char* const body = file.data() + file.find("end_header\n") + 11;
		ASSERT_EQ(std::size_t(file.data() + file.size() - body),
				  vertexNum * vertexBytes + faceNum * faceBytes);
		std::vector<float> x;
		for (std::size_t v = 0; v < vertexNum; ++v) {
			float record[4];
			std::memcpy(record, body + v * vertexBytes, sizeof record);
			EXPECT_NEAR(record[3], 10 * record[0], 0.2);
			x.push_back(record[0]);
		}
		for (std::size_t f = 0; f < faceNum; ++f) {
			const char* const at = body + vertexNum * vertexBytes + f * faceBytes;
			std::int32_t      corner[3];
			std::memcpy(corner, at + 1, sizeof corner);
			const float middle = (x[std::size_t(corner[0])] + x[std::size_t(corner[1])] +
								  x[std::size_t(corner[2])]) /
								 3;
			if (std::abs(middle) > 0.1) {
				EXPECT_EQ(int(at[13]), middle > 0 ? 1 : 0);
			}
		}
	}
}

TEST_F(ResultTiles, NoTileIsEmpty)
{
	const std::string in = put("sphere.ply", binaryPly(sphere(10), true, false));
	remesh(in, path("tiles"), {"--vertices", "50", "--tiles-out", "500"});
	std::size_t faceNum = 0;
	const Json  json    = index();
	for (const Json& tile : json["tiles"]) {
		EXPECT_GT(tile["faces"], 0);
		faceNum += tile["faces"].get<std::size_t>();
	}
	EXPECT_EQ(faceNum, 96u);
}

TEST_F(ResultTiles, ReplaceOlderTilesAndNothingElse)
{
	const std::string in = put("sphere.ply", binaryPly(sphere(12), true, false));
	remesh(in, path("tiles"), {"--vertices", "200", "--tiles-out", "5"});
	remesh(in, path("tiles") + "/", {"--vertices", "100", "--tiles-out", "2"});
	EXPECT_EQ(index()["tiles"].size(), 2u);
	EXPECT_FALSE(exists(path("tiles/tile2.ply")));

	put("tiles/letter.txt", "mine");
	expectFailure(run({"remesh", in, path("tiles"), "--tiles-out", "2"}), 1, "something else");
	EXPECT_EQ(content(path("tiles/letter.txt")), "mine");
	EXPECT_EQ(index()["vertices"], 100);
	const std::string file = put("file", "x");
	expectFailure(run({"remesh", in, file, "--tiles-out", "2"}), 1, "something else");
	expectFailure(run({"remesh", in, path("none/tiles"), "--tiles-out", "2"}), 1, "cannot write");
	for (const std::string& name : files())
		EXPECT_EQ(name.find(".part"), std::string::npos) << name;
}

/// Without tiles.json, or with other names, files are not files of older tiles.
TEST_F(ResultTiles, DoNotReplaceMeshesOfTheUser)
{
	const std::string mesh = binaryPly(sphere(12), true, false);
	std::filesystem::create_directory(path("survey"));
	const std::string in = put("survey/tile0.ply", mesh);
	expectFailure(run({"remesh", in, path("survey"), "--tiles-out", "2"}), 2, "lies in the folder");
	const std::string other = put("sphere.ply", mesh);
	expectFailure(run({"remesh", other, path("survey"), "--tiles-out", "2"}), 1, "something else");
	remesh(other, path("tiles"), {"--vertices", "200", "--tiles-out", "2"});
	expectFailure(run({"remesh", other, path("tiles"), "--tiles-out", "2", "--report",
					   path("tiles/report.json")}),
				  2, "lies in the folder");
	put("tiles/tile_of_mine.ply", mesh);
	expectFailure(run({"remesh", other, path("tiles"), "--tiles-out", "2"}), 1, "something else");
	EXPECT_TRUE(content(in) == mesh);
	EXPECT_TRUE(content(path("tiles/tile_of_mine.ply")) == mesh);
}

TEST_F(ResultTiles, HaveNoNameOfAMesh)
{
	const std::string in = put("sphere.ply", binaryPly(sphere(12), true, false));
	expectFailure(run({"remesh", in, path("x.obj"), "--tiles-out", "2"}), 2, "is a folder");
	expectFailure(run({"tile", "finish", path("run"), path("x.obj"), "--tiles-out", "2"}), 2,
				  "is a folder");
	expectFailure(run({"tile", "finish", path("run"), path("tiles")}), 2, "extension");
	EXPECT_FALSE(exists(path("x.obj")));
}

} // namespace gpr_test
