// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// gpremesh remesh with several files, and with a periodic cell.
#include "mesh_files.h"
#include "program_runner.h"

#include <array>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

namespace gpr_test {

using Json   = nlohmann::json;
using Points = std::set<std::array<double, 3>>;

class Pieces : public CliTest {
protected:
	/// A wavy square from x = first on.
	static TestMesh square(double first)
	{
		const int side = 30;
		TestMesh  mesh;
		for (int i = 0; i <= side; ++i) {
			for (int j = 0; j <= side; ++j) {
				const double x = first + double(i) / side, y = double(j) / side;
				mesh.points.push_back({x, y, 0.1 * std::sin(6.2831853 * x)});
			}
		}
		for (int i = 0; i < side; ++i) {
			for (int j = 0; j < side; ++j) {
				const int a = i * (side + 1) + j, b = a + side + 1;
				mesh.faces.push_back({a, b, b + 1});
				mesh.faces.push_back({a, b + 1, a + 1});
			}
		}
		return mesh;
	}

	Points pointsOf(const std::string& file)
	{
		std::string    type;
		const TestMesh mesh = parseWrittenPly(content(path(file)), type);
		return Points(mesh.points.begin(), mesh.points.end());
	}
};

TEST_F(Pieces, FilesHaveTheSameVerticesOnTheirSeam)
{
	const std::string   west   = put("west.ply", binaryPly(square(0), true, false));
	const std::string   east   = put("east.ply", binaryPly(square(1), true, false));
	const ProgramResult result = run({"remesh", west, east, "--out-dir", path("made"), "--vertices",
									  "300", "--report", path("report.json")});
	ASSERT_EQ(result.exitCode, 0) << result.err;
	const Points a = pointsOf("made/west.ply"), b = pointsOf("made/east.ply");
	std::size_t  seamNum = 0;
	for (const auto& p : a) {
		seamNum += b.count(p);
		EXPECT_EQ(b.count(p) == 1, p[0] == 1);
	}
	EXPECT_GT(seamNum, 8u);
	EXPECT_EQ(a.size() + b.size() - seamNum, 300u);
	const Json report = Json::parse(content(path("report.json")));
	EXPECT_EQ(report["files"][0]["vertices"], a.size());
	EXPECT_EQ(report["files"][1]["path"], path("made/east.ply"));
	EXPECT_NE(result.out.find("made/west.ply: "), std::string::npos) << result.out;
}

TEST_F(Pieces, WhatCannotBeMeantIsRefusedBeforeAnyWork)
{
	const std::string west = put("west.ply", binaryPly(square(0), true, false));
	std::filesystem::create_directory(path("other"));
	const std::string same = put("other/west.ply", binaryPly(square(1), true, false));
	EXPECT_EQ(run({"remesh", west}).exitCode, 2);
	EXPECT_EQ(run({"remesh", west, same, west}).exitCode, 2);
	EXPECT_EQ(run({"remesh", west, same, "--out-dir", path("made")}).exitCode, 2);
	EXPECT_EQ(run({"remesh", west, "--out-dir", path("made"), "--sew", "off"}).exitCode, 2);
	EXPECT_EQ(run({"remesh", west, "--out-dir", path("made"), "--tiles-out", "2"}).exitCode, 2);
	const std::string east = put("east.ply", binaryPly(square(1), true, false));
	for (const std::string& report : {east, path("made/east.ply")})
		EXPECT_EQ(
			run({"remesh", west, east, "--out-dir", path("made"), "--report", report}).exitCode, 2);
	EXPECT_FALSE(std::filesystem::exists(path("made")));
}

TEST_F(Pieces, NoResultReplacesAnInput)
{
	namespace fs           = std::filesystem;
	const std::string west = put("west.ply", binaryPly(square(0), true, false));
	const std::string east = put("east.ply", binaryPly(square(1), true, false));
	fs::create_directory(path("made"));
	fs::create_symlink(path("east.ply"), path("made/west.ply"));
	fs::create_directory_symlink(path(""), path("link"));
	const std::string before = content(east);
	for (const std::string& folder : {path(""), path("."), path("made"), path("link")}) {
		expectFailure(run({"remesh", west, east, "--out-dir", folder}), 2,
					  "would replace an input");
	}
	EXPECT_EQ(content(east), before);
	fs::remove(path("made/west.ply"));
	put("made/west.ply", "of an earlier run");
	EXPECT_EQ(run({"remesh", west, east, "--out-dir", path("made"), "--vertices", "300"}).exitCode,
			  0);
}

TEST_F(Pieces, AnInputThatCannotBeReadLeavesNoFolder)
{
	const std::string west = put("west.ply", binaryPly(square(0), true, false));
	EXPECT_EQ(run({"remesh", west, path("none.ply"), "--out-dir", path("made/deep/")}).exitCode, 3);
	EXPECT_FALSE(std::filesystem::exists(path("made")));
	std::filesystem::create_directory(path("there"));
	EXPECT_EQ(run({"remesh", west, path("none.ply"), "--out-dir", path("there")}).exitCode, 3);
	EXPECT_TRUE(std::filesystem::exists(path("there")));
}

TEST_F(Pieces, APeriodicCellHasMatchingBorders)
{
	const std::string   cell = put("cell.ply", binaryPly(square(0), true, false));
	const ProgramResult result =
		run({"remesh", cell, path("out.ply"), "--edge-length", "0.09", "--periodic", "1,1,0"});
	ASSERT_EQ(result.exitCode, 0) << result.err;
	const Points points = pointsOf("out.ply");
	std::size_t  endNum = 0;
	for (const auto& p : points) {
		endNum += p[0] == 1;
		EXPECT_TRUE(p[0] != 1 || points.count({0, p[1], p[2]}) == 1) << p[1];
		EXPECT_TRUE(p[1] != 1 || points.count({p[0], 0, p[2]}) == 1) << p[0];
	}
	EXPECT_GT(endNum, 8u);
	const ProgramResult wrong =
		run({"remesh", cell, path("no.ply"), "--edge-length", "0.09", "--periodic", "1,0.9,0"});
	EXPECT_EQ(wrong.exitCode, 3) << wrong.err;
	EXPECT_NE(wrong.err.find("not periodic along Y"), std::string::npos) << wrong.err;
	EXPECT_EQ(
		run({"remesh", "--periodic", "1,1,0", cell, path("o.ply"), "--percent", "20"}).exitCode, 0);
	EXPECT_EQ(run({"remesh", cell, path("no.ply"), "--periodic", "0,0,0"}).exitCode, 2);
	EXPECT_EQ(run({"remesh", cell, path("no.ply"), "--periodic", "1,1"}).exitCode, 2);
}

} // namespace gpr_test
