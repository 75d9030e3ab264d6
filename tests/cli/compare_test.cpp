// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The command gpremesh compare.
#include "mesh_files.h"
#include "program_runner.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

namespace gpr_test {

using Json = nlohmann::json;

class Compare : public CliTest {
protected:
	ProgramResult compare(const TestMesh& mesh, std::vector<std::string> options)
	{
		options.insert(options.begin(), {"compare", put("in.ply", binaryPly(mesh, true, false))});
		return run(options, 120);
	}

	Json compared(const TestMesh& mesh, std::vector<std::string> options)
	{
		options.push_back("--json");
		const ProgramResult result = compare(mesh, options);
		EXPECT_EQ(result.exitCode, 0) << result.err;
		return result.exitCode == 0 ? Json::parse(result.out) : Json();
	}

	static Json method(const Json& all, const std::string& key)
	{
		for (const Json& m : all["methods"])
			if (m["key"] == key) return m;
		ADD_FAILURE() << "no method " << key;
		return Json();
	}

	/// Whether the program was built with vcglib, and says so plainly if not.
	static bool hasBaselines(const Json& all)
	{
		const Json quadric = method(all, "quadricEdgeCollapse");
		if (!quadric.contains("failure")) return true;
		EXPECT_NE(quadric["failure"].get<std::string>().find("without vcglib"), std::string::npos);
		return false;
	}

	/// tests/page opens the page in a browser.
	static void expectViewer(const std::string& page)
	{
		const bool isBuilt = page.find("built without three.js") == std::string::npos;
		EXPECT_EQ(count(page, "id=\"viewer-data\""), isBuilt ? 1u : 0u);
		EXPECT_EQ(count(page, "three.js authors"), isBuilt ? 1u : 0u);
	}

	static std::size_t count(const std::string& text, const std::string& part)
	{
		std::size_t num = 0;
		for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; ++at)
			++num;
		return num;
	}
};

TEST_F(Compare, OursIsAsNearAsQuadricCollapseAndMoreRegular)
{
	const Json all = compared(torus(64), {"--vertices", "600"});
	if (!hasBaselines(all)) GTEST_SKIP() << "built without vcglib";
	const Json ours = method(all, "default"), quadric = method(all, "quadricEdgeCollapse");
	EXPECT_EQ(ours["vertices"], 600);
	EXPECT_EQ(ours["faces"], quadric["faces"]);
	EXPECT_TRUE(ours["topologyKept"]);
	EXPECT_TRUE(quadric["topologyKept"]);
	for (const char* way : {"toInput", "fromInput"}) {
		const double rms = ours[way]["rms"], theirs = quadric[way]["rms"];
		EXPECT_LT(rms, 1.3 * theirs) << way;
		EXPECT_GT(rms, 0.3 * theirs) << way;
		EXPECT_GT(ours[way]["p999"].get<double>(), rms) << way;
		EXPECT_GE(ours[way]["hausdorff"].get<double>(), ours[way]["p999"].get<double>()) << way;
	}
	EXPECT_GT(ours["quality"]["aspectRatio"]["mean"], 0.9);
	EXPECT_LT(quadric["quality"]["aspectRatio"]["mean"], 0.85);
	EXPECT_GT(quadric["quality"]["aspectRatio"]["mean"], 0.5);
}

// The middle of a face of circumradius R with corners on the unit sphere is R²/2 inside the sphere.
// The fit shares this distance between inside and outside.
TEST_F(Compare, DistancesOfASphereAreThoseOfItsChords)
{
	const Json   all  = compared(sphere(30), {"--vertices", "600"});
	const Json   ours = method(all, "default");
	const double edge = ours["quality"]["meanEdgeLength"], deepest = edge * edge / 6;
	const double rms = ours["toInput"]["rms"], most = ours["toInput"]["hausdorff"];
	EXPECT_GT(rms, 0.15 * deepest);
	EXPECT_LT(rms, deepest);
	EXPECT_GT(most, 0.5 * deepest);
	EXPECT_LT(most, 2 * deepest);
	const double diagonal = all["input"]["diagonal"];
	EXPECT_NEAR(ours["toInput"]["rmsPercent"], 100 * rms / diagonal, 1e-9);
	EXPECT_NEAR(ours["toInput"]["hausdorffPercent"], 100 * most / diagonal, 1e-9);
	const double p999 = ours["toInput"]["p999"];
	EXPECT_NEAR(ours["toInput"]["p999Percent"], 100 * p999 / diagonal, 1e-9);
	EXPECT_LE(p999, most);
	EXPECT_GT(p999, 1.5 * rms);
	const Json& proven = ours["error"];
	EXPECT_LE(double(proven["toInput"]["lower"]), most);
	EXPECT_GE(double(proven["toInput"]["upper"]), most);
	EXPECT_LE(double(proven["toInput"]["upper"]), 1.01 * most + 1e-5 * diagonal);
	EXPECT_GE(double(proven["hausdorff"]["upper"]), double(proven["fromInput"]["upper"]));
}

TEST_F(Compare, JsonTellsEveryFigureOfEveryMethod)
{
	const Json all = compared(sphere(16), {"--percent", "20", "--runs", "2", "--isotropic"});
	EXPECT_EQ(all["runs"], 2);
	EXPECT_EQ(all["input"]["faces"], sphere(16).faces.size());
	EXPECT_GT(all["input"]["quality"]["aspectRatio"]["mean"], 0.5);
	ASSERT_EQ(all["methods"].size(), 4u);
	if (!hasBaselines(all)) GTEST_SKIP() << "built without vcglib";
	for (const Json& m : all["methods"]) {
		SCOPED_TRACE(m["key"]);
		ASSERT_FALSE(m.contains("failure")) << m["failure"];
		for (const char* key : {"name", "vertices", "faces", "components", "boundaryLoops",
								"nonManifoldEdges", "topologyKept", "quality"}) {
			EXPECT_TRUE(m.contains(key)) << key;
		}
		for (const char* key : {"rms", "rmsPercent", "mean", "p999", "p999Percent", "hausdorff",
								"hausdorffPercent"}) {
			EXPECT_GT(m["toInput"][key].get<double>(), 0) << key;
			EXPECT_GT(m["fromInput"][key].get<double>(), 0) << key;
		}
		EXPECT_GE(m["toInput"]["samples"], 200000);
		EXPECT_EQ(m["fromInput"]["vertices"], sphere(16).points.size());
		EXPECT_EQ(m["seconds"]["runs"].size(), 2u);
		EXPECT_GT(m["seconds"]["median"].get<double>(), 0);
		EXPECT_EQ(m["processorSeconds"]["runs"].size(), 2u);
	}
}

TEST_F(Compare, TableFitsATerminal)
{
	const ProgramResult result = compare(grid(30), {"--percent", "20", "--isotropic"});
	ASSERT_EQ(result.exitCode, 0) << result.err;
	for (const char* word : {"gpremesh", "paper", "QEC", "isotropic", "E_RMS",
							 "p99.9, result to input", "p99.9, input to result", "Hausdorff",
							 "aspect ratio", "2r/R", "worst angle", "topology"}) {
		EXPECT_NE(result.out.find(word), std::string::npos) << word;
	}
	std::istringstream lines(result.out.substr(result.out.find('\n') + 1)); // the path comes first
	for (std::string line; std::getline(lines, line);)
		EXPECT_LE(line.size(), 120u) << line;
}

TEST_F(Compare, PageHoldsItsPictures)
{
	const ProgramResult result =
		compare(torus(40), {"--percent", "20", "--html", path("new/page"), "--json"});
	ASSERT_EQ(result.exitCode, 0) << result.err;
	const std::string page = content(path("new/page/index.html"));
	EXPECT_EQ(page.find("<!DOCTYPE html>"), 0u);
	EXPECT_EQ(page.rfind("</html>\n"), page.size() - 8);
	EXPECT_NE(page.find("Hausdorff"), std::string::npos);
	EXPECT_NE(page.find("<td>p99.9, result to input</td>"), std::string::npos);
	EXPECT_NE(page.find("<td>p99.9, input to result</td>"), std::string::npos);
	EXPECT_NE(page.find("99.9 % of the points are nearer than p99.9"), std::string::npos);
	EXPECT_EQ(count(page, "src=\"") + count(page, "href="), count(page, "src=\"data:image/png"));
	EXPECT_EQ(count(page, "<link") + count(page, "@import") + count(page, "import("), 0u);
	expectViewer(page);
	const auto files = std::filesystem::directory_iterator(path("new/page"));
	EXPECT_EQ(std::distance(begin(files), end(files)), 1);
	if (page.find("no pictures") != std::string::npos) GTEST_SKIP() << "f3d is not installed";
	std::size_t made = 0;
	const Json  all  = Json::parse(result.out);
	for (const Json& m : all["methods"])
		made += m.contains("failure") ? 0 : 1;
	EXPECT_EQ(count(page, "src=\"data:image/png;base64,iVBORw0KGgo"), 2 * (made + 1));
}

TEST_F(Compare, PageWithoutF3dSaysSo)
{
	const std::string before = std::getenv("PATH");
	::setenv("PATH", path("nothing").c_str(), 1);
	const ProgramResult result = compare(sphere(12), {"--percent", "30", "--html", path("page")});
	::setenv("PATH", before.c_str(), 1);
	ASSERT_EQ(result.exitCode, 0) << result.err;
	const std::string page = content(path("page/index.html"));
	EXPECT_NE(page.find("f3d is not installed"), std::string::npos);
	EXPECT_EQ(count(page, "<img"), 0u);
	EXPECT_NE(result.out.find("f3d is not installed"), std::string::npos);
}

TEST_F(Compare, DirtyInputIsCompared)
{
	TestMesh mesh = sphere(20);
	mesh.points.push_back({0, 0, 3});
	const int tip = int(mesh.points.size()) - 1;
	mesh.faces.push_back({mesh.faces[0][0], mesh.faces[0][1], tip}); // a fin on an edge
	mesh.faces.push_back({tip, tip, mesh.faces[0][0]});
	const Json all = compared(mesh, {"--vertices", "300"});
	EXPECT_EQ(all["input"]["nonManifoldEdges"], 1);
	EXPECT_TRUE(method(all, "default")["topologyKept"]);
	EXPECT_EQ(method(all, "default")["nonManifoldEdges"], 0);
}

/// The measures of section 3.1 of the paper, beside Quadric Edge Collapse.
TEST_F(Compare, TakesDensityFeaturesAndPresets)
{
	const TestMesh mesh     = sphere(16);
	const auto     compared = [&](std::vector<std::string> options) {
        options.insert(options.end(), {"--vertices", "300"});
        return Compare::compared(mesh, options);
	};
	const Json even = compared({});
	EXPECT_EQ(even["options"], "--vertices 300");
	for (const std::vector<std::string>& options : std::vector<std::vector<std::string>>{
			 {"--lambda", "2"}, {"--adapt", "1"}, {"--preset", "fast"}, {"--seed", "7"}}) {
		const Json other = compared(options);
		const Json ours  = method(other, "default");
		EXPECT_EQ(ours["vertices"], 300);
		EXPECT_NE(ours["toInput"]["rms"], method(even, "default")["toInput"]["rms"]) << options[0];
		EXPECT_NE(other["notes"].dump().find(options[0] + " " + options[1]), std::string::npos);
	}
	// The paper's preset is not run twice.
	EXPECT_EQ(even["methods"].size(), 3u);
	EXPECT_EQ(compared({"--preset", "paper"})["methods"].size(), 2u);
}

TEST_F(Compare, MistakesAreTold)
{
	const TestMesh mesh = sphere(8);
	expectFailure(run({"compare"}), 2);
	expectFailure(compare(mesh, {"--vertices", "50", "--percent", "10"}), 2, "only one");
	expectFailure(compare(mesh, {"--runs", "0"}), 2, "--runs");
	expectFailure(compare(mesh, {"--time-limit", "3"}), 2);
	expectFailure(compare(mesh, {"--selected"}), 2);
	expectFailure(compare(mesh, {"--vertices", "2", "--html", path("new/page")}), 4, "smallest");
	EXPECT_FALSE(exists(path("new"))) << "a run that fails leaves no folder";
	expectFailure(compare(mesh, {"--html", put("file", "")}), 1, "folder");
	expectFailure(run({"compare", put("bad.ply", "no mesh")}), 3);
}

} // namespace gpr_test
