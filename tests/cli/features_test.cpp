// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The command gpremesh features.
#include "mesh_files.h"
#include "program_runner.h"

#include <vcg_extras/io/mesh_io.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

namespace gpr_test {

namespace {

using Json  = nlohmann::json;
using Point = std::array<double, 3>;

/// The surface of [0,1]³, n by n cells a side, in the numbering in which its points come up.
TestMesh cube(int n)
{
	TestMesh             mesh;
	std::map<Point, int> numbers;
	const auto           add = [&](const Point& p) {
        const auto [at, fresh] = numbers.emplace(p, int(mesh.points.size()));
        if (fresh) mesh.points.push_back(p);
        return at->second;
	};
	const auto addCell = [&](int axis, int side, int i, int j) {
		const auto at = [&](int a, int b) {
			Point p;
			p[axis]           = side;
			p[(axis + 1) % 3] = double(side ? a : b) / n;
			p[(axis + 2) % 3] = double(side ? b : a) / n;
			return add(p);
		};
		const int a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
		mesh.faces.push_back({a, b, c});
		mesh.faces.push_back({a, c, d});
	};
	for (int side = 0; side < 6; ++side) {
		for (int cell = 0; cell < n * n; ++cell)
			addCell(side / 2, side % 2, cell % n, cell / n);
	}
	return mesh;
}

/// How many coordinates of a point of the cube are at an end: 2 on an edge, 3 at a corner.
int endsOf(const Point& p)
{
	int num = 0;
	for (double c : p)
		num += c == 0 || c == 1;
	return num;
}

struct WrittenVertex {
	Point        point;
	int          flags;
	float        quality;
	std::uint8_t colour[4];
};

template <class T>
T take(const std::string& file, std::size_t& at)
{
	T value;
	std::memcpy(&value, file.data() + at, sizeof value);
	at += sizeof value;
	return value;
}

/// The vertices of a file of gpremesh features. Fails the test if the header or the length of the
/// file is not as expected.
std::vector<WrittenVertex> verticesOf(const std::string& file, const TestMesh& mesh,
									  const std::string& type)
{
	const std::string header =
		"ply\nformat binary_little_endian 1.0\ncomment written by gpremesh\nelement vertex " +
		std::to_string(mesh.points.size()) + "\nproperty " + type + " x\nproperty " + type +
		" y\nproperty " + type +
		" z\nproperty int flags\nproperty float quality\nproperty uchar red\n"
		"property uchar green\nproperty uchar blue\nproperty uchar alpha\nelement face " +
		std::to_string(mesh.faces.size()) +
		"\nproperty list uchar int vertex_indices\nend_header\n";
	EXPECT_EQ(file.substr(0, header.size()), header);
	const std::size_t record = (type == "double" ? 24 : 12) + 12;
	EXPECT_EQ(file.size(), header.size() + record * mesh.points.size() + 13 * mesh.faces.size());
	std::vector<WrittenVertex> vertices(mesh.points.size());
	if (::testing::Test::HasFailure()) return {};
	std::size_t at = header.size();
	for (WrittenVertex& v : vertices) {
		for (double& c : v.point)
			c = type == "double" ? take<double>(file, at) : double(take<float>(file, at));
		v.flags   = take<std::int32_t>(file, at);
		v.quality = take<float>(file, at);
		for (std::uint8_t& c : v.colour)
			c = take<std::uint8_t>(file, at);
	}
	return vertices;
}

} // namespace

class Features : public CliTest {
protected:
	ProgramResult features(const TestMesh& mesh, std::vector<std::string> options = {})
	{
		options.insert(options.begin(), {"features", put("in.ply", binaryPly(mesh, true, true)),
										 path("out.ply"), "--report", path("report.json")});
		return run(options);
	}

	Json report(const std::string& name = "report.json") const
	{
		return Json::parse(content(path(name)));
	}
};

TEST_F(Features, HelpHasTheTablesRowsAndNoOthers)
{
	const ProgramResult help = run({"features", "--help"});
	EXPECT_EQ(help.exitCode, 0);
	for (const char* option : {"--feature-support", "--feature-strong", "--feature-weak",
							   "--feature-length", "--threads", "--report", "--quiet"}) {
		EXPECT_NE(help.out.find(option), std::string::npos) << option;
	}
	for (const char* option : {"--vertices", "--relax", "--lambda"})
		EXPECT_EQ(help.out.find(option), std::string::npos) << option;
}

TEST_F(Features, EdgesOfACubeAreSelectedAndItsPlanesAreFlat)
{
	const int           n      = 24;
	const TestMesh      mesh   = cube(n);
	const ProgramResult result = features(mesh);
	ASSERT_EQ(result.exitCode, 0) << result.err;
	const std::vector<WrittenVertex> vertices =
		verticesOf(content(path("out.ply")), mesh, "double");
	ASSERT_EQ(vertices.size(), mesh.points.size());
	const double support = report()["support"];
	for (std::size_t v = 0; v < vertices.size(); ++v) {
		const WrittenVertex& w = vertices[v];
		EXPECT_EQ(w.point, mesh.points[v]);
		const int ends = endsOf(w.point);
		EXPECT_EQ(w.flags, ends >= 2 ? 0x20 : 0) << v;
		EXPECT_EQ(w.colour[3], 255);
		double fromEdges = 1;
		for (double c : w.point) {
			if (c > 0 && c < 1) fromEdges = std::min({fromEdges, c, 1 - c});
		}
		if (ends == 1 && fromEdges > support + 1.5 / n) {
			EXPECT_LT(w.quality, 0.1) << v;
		}
		if (ends == 2 && fromEdges > support) {
			EXPECT_NEAR(w.quality, 90, 0.5) << v;
		}
	}
}

TEST_F(Features, MarkedOnesStandOutFromTheColoursOfStrength)
{
	const TestMesh mesh = cube(24);
	ASSERT_EQ(features(mesh).exitCode, 0);
	std::map<int, std::set<std::array<int, 3>>> colours; // by ends
	for (const WrittenVertex& w : verticesOf(content(path("out.ply")), mesh, "double"))
		colours[endsOf(w.point)].insert({w.colour[0], w.colour[1], w.colour[2]});
	EXPECT_EQ(colours[2].size(), 1u);
	EXPECT_EQ(colours[3].size(), 1u);
	EXPECT_NE(colours[2], colours[3]);
	EXPECT_GT(colours[1].size(), 3u);
	for (int marked : {2, 3})
		EXPECT_EQ(colours[1].count(*colours[marked].begin()), 0u) << marked;
}

TEST_F(Features, ReportHasThresholdsAndCounts)
{
	const int           n      = 24;
	const ProgramResult result = features(cube(n), {"--feature-weak", "25"});
	ASSERT_EQ(result.exitCode, 0) << result.err;
	const Json all = report();
	EXPECT_EQ(all["program"]["name"], "gpremesh");
	EXPECT_EQ(all["input"]["vertices"], 6 * n * n + 2);
	EXPECT_EQ(all["output"], path("out.ply"));
	EXPECT_EQ(all["thresholds"]["weakDegrees"], 25);
	EXPECT_EQ(all["thresholds"]["strongDegrees"], 40);
	EXPECT_EQ(all["features"]["edges"], 12 * n);
	EXPECT_EQ(all["features"]["vertices"], 12 * (n - 1) + 8);
	EXPECT_EQ(all["features"]["lines"], 1);
	EXPECT_EQ(all["features"]["corners"], 8);
	EXPECT_EQ(all["features"]["coneApexes"], 0);
	EXPECT_GT(all["minLength"], 0);
	EXPECT_NE(result.out.find("288 edges in 1 lines, 8 corners"), std::string::npos) << result.out;
}

TEST_F(Features, ReportKeepsTheKeysOfEarlierVersions)
{
	ASSERT_EQ(features(cube(12)).exitCode, 0);
	const Json all = report();
	EXPECT_EQ(all["features"]["tips"], all["features"]["coneApexes"]);
	EXPECT_EQ(all["leastLength"], all["minLength"]);
	EXPECT_EQ(all["thresholds"]["leastLength"], all["thresholds"]["minLength"]);
}

TEST_F(Features, ThresholdsAreObeyed)
{
	ASSERT_EQ(features(cube(12), {"--feature-strong", "100"}).exitCode, 0);
	EXPECT_EQ(report()["features"]["edges"], 0);
	EXPECT_EQ(report()["features"]["vertices"], 0);
	ASSERT_EQ(features(sphere(12)).exitCode, 0);
	EXPECT_EQ(report()["features"]["vertices"], 0);
}

TEST_F(Features, SelectionCanBeRemeshedByTheRegion)
{
	ASSERT_EQ(features(cube(24)).exitCode, 0);
	const ProgramResult remeshed =
		run({"remesh", path("out.ply"), path("again.ply"), "--vertices", "500", "--feature-region",
			 "selection", "--features", "off"});
	EXPECT_EQ(remeshed.exitCode, 0) << remeshed.err;
}

/// Two triangles with a value of their own for all that a PLY file holds.
TEST_F(Features, AttributesOfTheInputStay)
{
	const std::string in = put(
		"in.ply",
		"ply\nformat ascii 1.0\ncomment TextureFile oak.png\nelement vertex 4\nproperty float x\n"
		"property float y\nproperty float z\nproperty uchar red\nproperty float heat\n"
		"property int flags\nelement face 2\nproperty list uchar int vertex_indices\n"
		"property int label\nproperty list uchar float texcoord\nend_header\n"
		"0 0 0 1 0.5 32\n1 0 0 2 1.5 0\n1 1 0 3 2.5 0\n0 1 0 4 3.5 0\n"
		"3 0 1 2 7 6 0 0 1 0 1 1\n3 0 2 3 9 6 0 0 1 1 0 1\n");
	const ProgramResult done = run({"features", in, path("out.ply"), "--report", path("r.json")});
	ASSERT_EQ(done.exitCode, 0) << done.err;
	gpr::app::WantedAttributes wanted;
	wanted.carried                       = true;
	const gpr::app::InputMesh       mesh = gpr::app::readMesh(path("out.ply"), wanted);
	const gpr::app::MeshAttributes& a    = mesh.attributes;
	ASSERT_NE(a.ofVertex("heat"), nullptr);
	EXPECT_EQ(a.ofVertex("heat")->values, (std::vector<double>{0.5, 1.5, 2.5, 3.5}));
	ASSERT_EQ(a.ofFaces.size(), 1u);
	EXPECT_EQ(a.ofFaces[0].values, (std::vector<double>{7, 9}));
	EXPECT_EQ(a.texture.uv, (std::vector<float>{0, 0, 1, 0, 1, 1, 0, 0, 1, 1, 0, 1}));
	EXPECT_EQ(a.images, std::vector<std::string>{"oak.png"});
	EXPECT_EQ(report("r.json")["notes"].back(),
			  "Not carried over: the selection of vertices, 'red' of vertices.");
}

/// The border of regions is no crease.
TEST_F(Features, LabelsDoNotMatter)
{
	std::string text = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\n"
					   "property float y\nproperty float z\nelement face 2\n"
					   "property list uchar int vertex_indices\nproperty int label\nend_header\n"
					   "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2 7\n3 0 2 3 9\n";
	ASSERT_EQ(run({"features", put("in.ply", text), path("out.ply"), "--report", path("r.json")})
				  .exitCode,
			  0);
	EXPECT_EQ(report("r.json")["features"]["edges"], 0);
}

TEST_F(Features, FloatsStayFloats)
{
	const TestMesh mesh = cube(8);
	const auto     done =
		run({"features", put("in.ply", binaryPly(mesh, true, false)), path("out.ply"), "--quiet"});
	ASSERT_EQ(done.exitCode, 0) << done.err;
	EXPECT_EQ(done.out + done.err, "");
	EXPECT_EQ(verticesOf(content(path("out.ply")), mesh, "float").size(), mesh.points.size());
}

TEST_F(Features, WhatCannotBeDoneIsTold)
{
	const std::string in = put("in.ply", asciiPly(cube(4))), before = content(in);
	expectFailure(run({"features", in}), 2);
	expectFailure(run({"features", in, path("out.obj")}), 2, "quality and colour");
	expectFailure(run({"features", in, path("out.ply"), "--report", in}), 2, "--report");
	expectFailure(run({"features", in, path("out.ply"), "--feature-strong", "0"}), 2, "strong");
	expectFailure(run({"features", in, path("out.ply"), "--feature-weak", "50"}), 2);
	expectFailure(run({"features", in, path("out.ply"), "--vertices", "9"}), 2);
	expectFailure(run({"features", path("nowhere.ply"), path("out.ply")}), 3, "nowhere.ply");
	TestMesh flat = cube(1);
	for (Point& p : flat.points)
		p = {0, 0, 0};
	expectFailure(run({"features", put("flat.ply", asciiPly(flat)), path("out.ply")}), 3);
	EXPECT_EQ(content(in), before);
	EXPECT_FALSE(exists(path("out.ply")));
}

} // namespace gpr_test
