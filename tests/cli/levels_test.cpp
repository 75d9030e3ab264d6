// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The command gpremesh levels, and symmetric results.
#include "mesh_files.h"
#include "program_runner.h"

#include <vcg_extras/io/formats/glb_container.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <set>

namespace gpr_test {

using Json = nlohmann::json;

class Levels : public CliTest {
protected:
	TestMesh written(const std::string& name)
	{
		std::string type;
		return parseWrittenPly(content(path(name)), type);
	}
};

TEST_F(Levels, EachLevelIsThatOfASingleRunAndTellsItsError)
{
	const std::string   in   = put("in.ply", binaryPly(sphere(40), true, false));
	const ProgramResult made = run({"levels", in, path("out_{level}.ply"), "--vertices",
									"300,200,100", "--report", path("report.json"), "--seed", "3"});
	ASSERT_EQ(made.exitCode, 0) << made.err;
	const Json levels = Json::parse(content(path("report.json")))["levels"];
	ASSERT_EQ(levels.size(), 3u);
	double before = 0;
	for (int i = 0; i < 3; ++i) {
		const std::string name = "out_" + std::to_string(i + 1) + ".ply";
		const int         num  = 300 - 100 * i;
		EXPECT_EQ(levels[i]["result"]["vertices"], num);
		EXPECT_EQ(levels[i]["result"]["file"], path(name));
		const double error = levels[i]["error"]["hausdorff"]["upper"];
		EXPECT_GT(error, before);
		before = error;
		ASSERT_EQ(run({"remesh", in, path("single.ply"), "--vertices", std::to_string(num),
					   "--seed", "3"})
					  .exitCode,
				  0);
		EXPECT_EQ(content(path(name)), content(path("single.ply")));
	}
}

/// Each level gets the attributes of the input, not the remains of the level before.
TEST_F(Levels, ValuesOfVerticesComeToEachLevel)
{
	const TestMesh mesh = sphere(30);
	std::string    file = "ply\nformat ascii 1.0\nelement vertex " +
					   std::to_string(mesh.points.size()) +
					   "\nproperty float x\nproperty float y\nproperty float z\nproperty float "
					   "quality\nelement face " +
					   std::to_string(mesh.faces.size()) +
					   "\nproperty list uchar int vertex_indices\nend_header\n";
	for (const auto& p : mesh.points)
		file += std::to_string(p[0]) + " " + std::to_string(p[1]) + " " + std::to_string(p[2]) +
				" " + std::to_string(p[0] + 5) + "\n";
	for (const auto& f : mesh.faces)
		file += "3 " + std::to_string(f[0]) + " " + std::to_string(f[1]) + " " +
				std::to_string(f[2]) + "\n";
	const std::string in = put("in.ply", file);
	ASSERT_EQ(run({"levels", in, path("out_{level}.ply"), "--vertices", "200,150"}).exitCode, 0);
	ASSERT_EQ(run({"remesh", in, path("single.ply"), "--vertices", "150"}).exitCode, 0);
	EXPECT_EQ(content(path("out_2.ply")), content(path("single.ply")));
}

/// A node with levels by MSFT_lod: programs without this extension read the finest level.
TEST_F(Levels, ComeIntoOneBinaryGltfFile)
{
	const std::string   in   = put("in.ply", binaryPly(sphere(40), true, false));
	const ProgramResult made = run({"levels", in, path("all.glb"), "--vertices", "300,200,100",
									"--report", path("report.json")});
	ASSERT_EQ(made.exitCode, 0) << made.err;
	const std::string        file   = content(path("all.glb"));
	const gpr::app::GltfJson json   = gpr::app::glbChunksOf(file).json;
	const Json               levels = Json::parse(content(path("report.json")))["levels"];
	EXPECT_EQ(json["scenes"][0]["nodes"], Json({0}));
	EXPECT_EQ(json["nodes"][0]["extensions"]["MSFT_lod"]["ids"], Json({1, 2}));
	EXPECT_EQ(json["extensionsUsed"], Json({"MSFT_lod"}));
	ASSERT_EQ(json["nodes"].size(), 3u);
	for (int i = 0; i < 3; ++i) {
		const auto&       node     = json["nodes"][i];
		const auto&       triangle = json["meshes"][int(node["mesh"])]["primitives"][0];
		const std::size_t position = triangle["attributes"]["POSITION"];
		EXPECT_EQ(json["accessors"][position]["count"], 300 - 100 * i);
		EXPECT_EQ(node["extras"]["largestError"], levels[i]["error"]["hausdorff"]["upper"]);
	}
	ASSERT_EQ(run({"remesh", path("all.glb"), path("again.ply"), "--vertices", "50"}).exitCode, 0);
	const ProgramResult info = run({"info", path("all.glb")});
	EXPECT_NE(info.out.find("300"), std::string::npos) << "the finest level: " << info.out;
	ASSERT_EQ(run({"levels", in, path("out_{level}.glb"), "--vertices", "300,200"}).exitCode, 0);
	EXPECT_EQ(gpr::app::glbChunksOf(content(path("out_2.glb"))).json["nodes"].size(), 1u);
}

/// The root of the file has the most vertices, whatever the order of the sizes.
TEST_F(Levels, OfOneFileComeFromFineToCoarse)
{
	const std::string in = put("in.ply", binaryPly(sphere(40), true, false));
	for (const char* name : {"sorted.glb", "unsorted.glb"}) {
		const std::string sizes = name[0] == 's' ? "300,200,100" : "100,300,200";
		ASSERT_EQ(run({"levels", in, path(name), "--vertices", sizes, "--report", path("r.json")})
					  .exitCode,
				  0);
		const Json levels = Json::parse(content(path("r.json")))["levels"];
		for (int i = 0; i < 3; ++i)
			EXPECT_EQ(levels[i]["result"]["vertices"], 300 - 100 * i);
	}
	EXPECT_EQ(content(path("unsorted.glb")), content(path("sorted.glb")));
	ASSERT_EQ(run({"levels", in, path("l{level}_{level}.ply"), "--vertices", "100,300"}).exitCode,
			  0);
	EXPECT_EQ(written("l1_1.ply").points.size(), 100u) << "files keep the order of the sizes";
	EXPECT_EQ(written("l2_2.ply").points.size(), 300u);
}

/// A flat square with the size and the group of each vertex, and with two regions.
std::string squareWithValues()
{
	const TestMesh mesh = grid(20);
	std::string    file = "ply\nformat ascii 1.0\nelement vertex " +
					   std::to_string(mesh.points.size()) +
					   "\nproperty float x\nproperty float y\nproperty float z\nproperty float "
					   "size\nproperty float "
					   "group\nelement face " +
					   std::to_string(mesh.faces.size()) +
					   "\nproperty list uchar int vertex_indices\nproperty int part\nend_header\n";
	for (const auto& p : mesh.points)
		file += digits(p[0]) + " " + digits(p[1]) + " 0 " + digits(0.05 + 0.1 * p[0]) + " " +
				digits(10 * p[1]) + "\n";
	for (const auto& f : mesh.faces)
		file += "3 " + std::to_string(f[0]) + " " + std::to_string(f[1]) + " " +
				std::to_string(f[2]) + (mesh.points[std::size_t(f[0])][1] < 0.5 ? " 1\n" : " 2\n");
	return file;
}

TEST_F(Levels, HaveTheOptionsForValuesAndPeriods)
{
	const std::string in = put("in.ply", squareWithValues());
	for (const std::vector<std::string>& options :
		 std::vector<std::vector<std::string>>{{"--sizes", "size"},
											   {"--regions", "part"},
											   {"--transfer", "nearest"},
											   {"--periodic", "1,1,0"}}) {
		std::vector<std::string> levels = {"levels", in, path("out_{level}.ply"), "--vertices",
										   "150,100"};
		std::vector<std::string> single = {"remesh", in, path("single.ply"), "--vertices", "100"};
		const std::vector<std::string> plain = single;
		for (std::vector<std::string>* words : {&levels, &single})
			words->insert(words->end(), options.begin(), options.end());
		const ProgramResult made = run(levels);
		ASSERT_EQ(made.exitCode, 0) << options[0] << " " << made.err;
		ASSERT_EQ(run(single).exitCode, 0) << options[0];
		EXPECT_EQ(content(path("out_2.ply")), content(path("single.ply"))) << options[0];
		ASSERT_EQ(run(plain).exitCode, 0);
		EXPECT_NE(content(path("out_2.ply")), content(path("single.ply"))) << options[0];
	}
}

TEST_F(Levels, LossesOfOneBinaryGltfFileAreTold)
{
	std::string         file = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\n"
							   "property float y\nproperty float z\nproperty float heat\nelement face 4\n"
							   "property list uchar int vertex_indices\nend_header\n"
							   "0 0 0 1\n1 0 0 2\n0 1 0 3\n0 0 1 4\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
	const ProgramResult made =
		run({"levels", put("in.ply", file), path("out.glb"), "--vertices", "200,100"});
	ASSERT_EQ(made.exitCode, 0) << made.err;
	EXPECT_NE(made.out.find("Not carried over: 'heat' of vertices."), std::string::npos)
		<< made.out;
}

TEST_F(Levels, MistakesAreUsage)
{
	const std::string in  = put("in.ply", binaryPly(sphere(20), true, false));
	const std::string out = path("out_{level}.ply");
	for (const std::vector<std::string>& words :
		 std::vector<std::vector<std::string>>{{path("out.ply"), "--percent", "10"},
											   {out},
											   {out, "--percent", "10,0"},
											   {out, "--percent", "20000"},
											   {out, "--vertices", "100.5"},
											   {out, "--vertices", "100", "--faces", "300"}}) {
		std::vector<std::string> all = {"levels", in};
		all.insert(all.end(), words.begin(), words.end());
		EXPECT_EQ(run(all).exitCode, 2) << words.back();
	}
}

TEST_F(Levels, SymmetricFilesHaveEachVertexTwice)
{
	const std::string in = put("in.ply", binaryPly(sphere(40), true, false));
	ASSERT_EQ(run({"remesh", in, path("out.ply"), "--vertices", "301", "--symmetry", "z",
				   "--report", path("report.json")})
				  .exitCode,
			  0);
	const TestMesh mesh = written("out.ply");
	EXPECT_EQ(mesh.points.size(), 301u);
	EXPECT_EQ(Json::parse(content(path("report.json")))["options"]["symmetry"], "z");
	std::set<std::array<double, 3>> places;
	double                          low = 1e9, high = -1e9;
	for (const auto& p : mesh.points) {
		places.insert({p[0], p[1], p[2]});
		low  = std::min(low, double(p[2]));
		high = std::max(high, double(p[2]));
	}
	for (const auto& p : mesh.points)
		EXPECT_EQ(places.count({p[0], p[1], low + high - p[2]}), 1u);
}

TEST_F(Levels, SymmetryIsRefusedWithTheLargestMismatch)
{
	TestMesh mesh = sphere(30);
	for (auto& p : mesh.points)
		p[0] += 0.3f * p[1] * p[1];
	const ProgramResult refused = run({"remesh", put("in.ply", binaryPly(mesh, true, false)),
									   path("out.ply"), "--symmetry", "x"});
	EXPECT_EQ(refused.exitCode, 3);
	EXPECT_NE(refused.err.find("% of the diagonal"), std::string::npos) << refused.err;
	EXPECT_EQ(run({"remesh", path("in.ply"), path("out.ply"), "--symmetry", "x", "--memory", "1G"})
				  .exitCode,
			  2);
}

} // namespace gpr_test
