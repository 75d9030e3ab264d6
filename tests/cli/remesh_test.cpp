// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The commands gpremesh remesh and gpremesh info.
#include "mesh_files.h"
#include "program_runner.h"
#include "surface_check.h"

#include <vcg_extras/io/formats/mesh_formats.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <fcntl.h>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <sys/stat.h>
#include <tuple>
#include <unistd.h>

namespace gpr_test {

using Json = nlohmann::json;

class Remesh : public CliTest {
protected:
	/// Remeshes the content of a file into out.ply and returns the parsed result.
	TestMesh remeshed(const std::string& name, const std::string& fileContent,
					  std::vector<std::string> options, std::string* precision = nullptr)
	{
		options.insert(options.begin(), {"remesh", put(name, fileContent), path("out.ply")});
		options.insert(options.end(), {"--report", path("report.json")});
		const ProgramResult result = run(options);
		EXPECT_EQ(result.exitCode, 0) << result.err;
		std::string type;
		if (result.exitCode != 0) return {};
		const TestMesh mesh = parseWrittenPly(content(path("out.ply")), type);
		if (precision != nullptr) *precision = type;
		return mesh;
	}

	Json report() { return Json::parse(content(path("report.json"))); }

	Json info(const std::string& file)
	{
		const ProgramResult result = run({"info", file, "--json"});
		EXPECT_EQ(result.exitCode, 0) << result.err;
		return Json::parse(result.out);
	}

	/// The largest distance of the points from the unit sphere around a centre.
	static double offSphere(const TestMesh& mesh, double x, double y, double z)
	{
		double worst = 0;
		for (const auto& p : mesh.points) {
			worst = std::max(worst, std::abs(std::hypot(p[0] - x, p[1] - y, p[2] - z) - 1));
		}
		return worst;
	}
};

TEST_F(Remesh, EveryInputFormatGivesASphere)
{
	const TestMesh                                         in    = sphere(24);
	const std::vector<std::pair<std::string, std::string>> files = {
		{"ascii.ply", asciiPly(in)},
		{"little.ply", binaryPly(in, true, false)},
		{"big.ply", binaryPly(in, false, false)},
		{"double.PLY", binaryPly(in, true, true)},
		{"plain.obj", obj(in)},
		{"negative.Obj", objWithNegativeIndices(in)},
		{"plain.off", off(in)},
		{"ascii.stl", asciiStl(in)},
		{"binary.STL", binaryStl(in)},
	};
	for (const auto& [name, fileContent] : files) {
		SCOPED_TRACE(name);
		const TestMesh out = remeshed(name, fileContent, {"--vertices", "400"});
		EXPECT_EQ(out.points.size(), 400u);
		expectManifold(out);
		EXPECT_EQ(eulerCharacteristic(out), 2);
		EXPECT_EQ(boundaryEdgeNum(out), 0);
		EXPECT_LT(offSphere(out, 0, 0, 0), 0.01);
		EXPECT_EQ(report()["input"]["vertices"], in.points.size());
		EXPECT_EQ(report()["input"]["faces"], in.faces.size());
	}
}

/// An ASCII PLY file whose faces with x above 0 are selected.
std::string halfSelectedPly(const TestMesh& mesh)
{
	std::string text = "ply\nformat ascii 1.0\nelement vertex " +
					   std::to_string(mesh.points.size()) +
					   "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
					   std::to_string(mesh.faces.size()) +
					   "\nproperty list uchar int vertex_indices\nproperty uchar selected\n"
					   "end_header\n";
	for (const auto& p : mesh.points)
		text += digits(p[0]) + " " + digits(p[1]) + " " + digits(p[2]) + "\n";
	for (const auto& f : mesh.faces) {
		double x = 0;
		for (const int v : f)
			x += mesh.points[std::size_t(v)][0];
		text += "3 " + std::to_string(f[0]) + " " + std::to_string(f[1]) + " " +
				std::to_string(f[2]) + (x > 0 ? " 1\n" : " 0\n");
	}
	return text;
}

TEST_F(Remesh, OnlyTheSelectedFaces)
{
	const TestMesh in = sphere(24);
	const TestMesh out =
		remeshed("half.ply", halfSelectedPly(in), {"--selected", "--vertices", "500"});
	expectManifold(out);
	EXPECT_EQ(eulerCharacteristic(out), 2);
	std::size_t next = 0;
	for (const auto& f : in.faces) {
		double x = 0;
		for (const int v : f)
			x += in.points[std::size_t(v)][0];
		if (x > 0) continue;
		for (std::size_t k = 0; k < 3; ++k)
			ASSERT_EQ(out.points[std::size_t(out.faces[next][k])], in.points[std::size_t(f[k])]);
		++next;
	}
	EXPECT_GT(next, 1000u);
	EXPECT_LT(out.faces.size(), in.faces.size());
	expectFailure(run({"remesh", put("none.ply", asciiPly(in)), path("out.ply"), "--selected"}), 3,
				  "selected");
}

TEST_F(Remesh, SameMeshFromEveryExactFormat)
{
	// Coordinates with all digits: how they were stored must not matter.
	const TestMesh in   = torus(40);
	const TestMesh want = remeshed("a.ply", binaryPly(in, true, false), {"--percent", "20"});
	for (const auto& [name, fileContent] :
		 std::vector<std::pair<std::string, std::string>>{{"b.ply", binaryPly(in, false, false)},
														  {"c.ply", asciiPly(in)},
														  {"d.obj", obj(in)},
														  {"e.off", off(in)}}) {
		SCOPED_TRACE(name);
		const TestMesh got = remeshed(name, fileContent, {"--percent", "20"});
		EXPECT_EQ(got.points, want.points);
		EXPECT_EQ(got.faces, want.faces);
	}
}

TEST_F(Remesh, EveryOutputFormatHoldsTheResult)
{
	const std::string in = put("in.ply", binaryPly(torus(40), true, false));
	for (const char* name : {"out.ply", "out.obj", "out.off", "out.stl", "UPPER.OBJ"}) {
		SCOPED_TRACE(name);
		const ProgramResult result =
			run({"remesh", in, path(name), "--report", path("report.json")});
		ASSERT_EQ(result.exitCode, 0) << result.err;
		const Json written = info(path(name))["input"], want = report()["result"];
		for (const char* key :
			 {"vertices", "faces", "components", "boundaryLoops", "eulerCharacteristic"}) {
			EXPECT_EQ(written[key], want[key]) << key;
		}
		EXPECT_NEAR(double(written["area"]), double(want["area"]), 1e-5);
		EXPECT_EQ(want["vertices"], 160);
		EXPECT_EQ(want["eulerCharacteristic"], 0);
	}
}

TEST_F(Remesh, TextOutputGivesBackTheBits)
{
	const std::string in = put("in.ply", binaryPly(moved(torus(40), 5e5, 5e6, 0.1), true, true));
	std::string       precision;
	ASSERT_EQ(run({"remesh", in, path("out.ply")}).exitCode, 0);
	ASSERT_EQ(run({"remesh", in, path("out.obj")}).exitCode, 0);
	const TestMesh     want = parseWrittenPly(content(path("out.ply")), precision);
	std::istringstream text(content(path("out.obj")));
	std::size_t        v = 0;
	for (std::string word; text >> word;) {
		if (word != "v") continue;
		std::array<double, 3> p;
		text >> p[0] >> p[1] >> p[2];
		ASSERT_LT(v, want.points.size());
		EXPECT_EQ(p, want.points[v++]);
	}
	EXPECT_EQ(v, want.points.size());
}

TEST_F(Remesh, DoubleWhereTheInputWasDouble)
{
	std::string    precision;
	const TestMesh in = moved(sphere(24), 500000, 5000000, 100);
	const TestMesh out =
		remeshed("utm.ply", binaryPly(in, true, true), {"--vertices", "400"}, &precision);
	EXPECT_EQ(precision, "double");
	EXPECT_LT(offSphere(out, 500000, 5000000, 100), 0.01);
	remeshed("origin.ply", binaryPly(sphere(24), true, true), {"--vertices", "400"}, &precision);
	EXPECT_EQ(precision, "double");
}

TEST_F(Remesh, DoubleWhereFloatDoesNotResolveTheOffset)
{
	// L is about 0.19: floats resolve L/1000 around 1000, not around 5000.
	std::string precision;
	remeshed("here.ply", binaryPly(sphere(24), true, false), {"--vertices", "400"}, &precision);
	EXPECT_EQ(precision, "float");
	remeshed("near.ply", binaryPly(moved(sphere(24), 1000, 0, 0), true, false),
			 {"--vertices", "400"}, &precision);
	EXPECT_EQ(precision, "float");
	remeshed("far.ply", binaryPly(moved(sphere(24), 5000, 0, 0), true, false),
			 {"--vertices", "400"}, &precision);
	EXPECT_EQ(precision, "double");
}

TEST_F(Remesh, TextWithAnOffsetKeepsItsDetail)
{
	const TestMesh in = moved(sphere(24), 500000, 5000000, 100);
	for (const auto& [name, fileContent] : std::vector<std::pair<std::string, std::string>>{
			 {"u.obj", obj(in)}, {"u.off", off(in)}, {"u.stl", asciiStl(in)}}) {
		SCOPED_TRACE(name);
		std::string    precision;
		const TestMesh out = remeshed(name, fileContent, {"--vertices", "400"}, &precision);
		EXPECT_EQ(precision, "double");
		EXPECT_EQ(out.points.size(), 400u);
		EXPECT_LT(offSphere(out, 500000, 5000000, 100), 0.01);
	}
}

TEST_F(Remesh, OpenSurfaceKeepsItsBoundary)
{
	const TestMesh out = remeshed("grid.ply", binaryPly(grid(60), true, false), {});
	expectManifold(out);
	EXPECT_EQ(out.points.size(), 372u); // 10 % of 61²
	EXPECT_EQ(eulerCharacteristic(out), 1);
	EXPECT_EQ(report()["result"]["boundaryLoops"], 1);
	EXPECT_NEAR(double(report()["result"]["area"]), 1, 0.01);
}

TEST_F(Remesh, SmoothBordersHaveTheirFiguresInTheReport)
{
	const std::string in = binaryPly(grid(60), true, false);
	remeshed("grid.ply", in, {"--boundary", "smooth", "--check"});
	const Json r = report();
	EXPECT_EQ(r["options"]["boundary"], "smooth");
	EXPECT_NEAR(double(r["border"]["length"]), 4, 1e-6);
	const double left = double(r["border"]["resultLength"]);
	EXPECT_NEAR(double(r["border"]["lengthLostPercent"]), 100 * (1 - left / 4), 1e-6);
	EXPECT_GT(left, 3.8);
	EXPECT_LT(left, 3.99) << "its corners are round now";
	remeshed("grid.ply", in, {});
	EXPECT_FALSE(report().contains("border"));
}

TEST_F(Remesh, EdgeLengthIsMet)
{
	remeshed("in.ply", binaryPly(sphere(40), true, false), {"--edge-length", "0.15"});
	EXPECT_NEAR(double(report()["quality"]["meanEdgeLength"]), 0.15, 0.01);
}

TEST_F(Remesh, InputAndOutputMayBeTheSameFile)
{
	const std::string   both   = put("both.ply", binaryPly(sphere(24), true, false));
	const ProgramResult result = run({"remesh", both, both, "--vertices", "300", "--quiet"});
	ASSERT_EQ(result.exitCode, 0) << result.err;
	std::string precision;
	EXPECT_EQ(parseWrittenPly(content(both), precision).points.size(), 300u);
	EXPECT_EQ(files(), std::vector<std::string>{"both.ply"});
}

TEST_F(Remesh, LinkedOutputStaysALink)
{
	const std::string in   = put("in.ply", binaryPly(sphere(24), true, false));
	const std::string real = put("real.ply", "old");
	std::filesystem::create_symlink(real, path("link.ply"));
	ASSERT_EQ(run({"remesh", in, path("link.ply")}).exitCode, 0);
	EXPECT_TRUE(std::filesystem::is_symlink(path("link.ply")));
	EXPECT_NE(content(real), "old");
}

TEST_F(Remesh, TooFewVerticesNamesTheSmallestCount)
{
	const std::string   in  = put("in.ply", binaryPly(torus(40), true, false));
	const std::string   old = put("out.ply", "old");
	const ProgramResult result =
		run({"remesh", in, old, "--vertices", "3", "--report", path("r.json")});
	expectFailure(result, 4);
	EXPECT_EQ(content(old), "old");
	EXPECT_EQ(files(), (std::vector<std::string>{"in.ply", "out.ply"}));

	// The number in the message works, and is at least the least number for a torus.
	std::string smallest;
	for (const char c : result.err) {
		if (c >= '0' && c <= '9') {
			smallest += c;
		}
		else if (!smallest.empty() && std::stol(smallest) > 3) {
			break;
		}
		else {
			smallest.clear();
		}
	}
	ASSERT_FALSE(smallest.empty()) << result.err;
	EXPECT_GE(std::stol(smallest), 7);
	const ProgramResult again = run({"remesh", in, path("again.ply"), "--vertices", smallest});
	ASSERT_EQ(again.exitCode, 0) << again.err;
	std::string precision;
	EXPECT_EQ(parseWrittenPly(content(path("again.ply")), precision).points.size(),
			  std::stoul(smallest));

	const ProgramResult nearest =
		run({"remesh", in, path("near.ply"), "--vertices", "3", "--allow-nearest"});
	EXPECT_EQ(nearest.exitCode, 0) << nearest.err;
}

TEST_F(Remesh, ExactlySoManyFaces)
{
	const TestMesh out =
		remeshed("in.ply", binaryPly(sphere(24), true, false), {"--faces", "1024"});
	EXPECT_EQ(out.faces.size(), 1024u);
	EXPECT_EQ(report()["options"]["target"], "faces");
	EXPECT_EQ(report()["options"]["faces"], 1024);
	EXPECT_EQ(report()["counts"]["targetVertices"], 514);

	const ProgramResult odd = run({"remesh", path("in.ply"), path("odd.ply"), "--faces", "1025"});
	EXPECT_NE(odd.exitCode, 0);
	EXPECT_NE(odd.err.find("1024 and 1026"), std::string::npos) << odd.err;
	EXPECT_EQ(run({"remesh", path("in.ply"), path("odd.ply"), "--faces", "1025", "--allow-nearest"})
				  .exitCode,
			  0);
	expectFailure(
		run({"remesh", path("in.ply"), path("two.ply"), "--faces", "9", "--vertices", "9"}), 2);
}

TEST_F(Remesh, ReportHasThePromisedKeys)
{
	remeshed("in.ply", binaryPly(sphere(40), true, false),
			 {"--vertices", "500", "--seed", "7", "--threads", "1"});
	const Json r = report();
	for (const char* part : {"input", "result"}) {
		for (const char* key :
			 {"vertices", "faces", "components", "boundaryLoops", "eulerCharacteristic", "area"}) {
			EXPECT_TRUE(r[part].contains(key)) << part << "." << key;
		}
	}
	EXPECT_EQ(r["program"]["name"], "gpremesh");
	EXPECT_EQ(r["program"]["version"], GPR_VERSION);
	EXPECT_EQ(r["result"]["vertices"], 500);
	EXPECT_EQ(r["result"]["components"], 1);
	EXPECT_EQ(r["result"]["eulerCharacteristic"], 2);
	EXPECT_NEAR(double(r["input"]["area"]), 12.56, 0.05);
	EXPECT_NEAR(double(r["result"]["area"]), 12.56, 0.2);
	EXPECT_EQ(r["options"]["vertices"], 500);
	EXPECT_EQ(r["seed"], 7);
	EXPECT_EQ(r["threads"], 1);
	EXPECT_GT(double(r["diskRadius"]), 0);
	EXPECT_GT(double(r["quality"]["radiusRatio"]["mean"]), 0.95);
	EXPECT_GT(double(r["quality"]["radiusRatio"]["min"]), 0.3);
	EXPECT_GT(double(r["quality"]["aspectRatio"]["mean"]), 0.85);
	EXPECT_GT(double(r["quality"]["angles"]["min"]), 20);
	EXPECT_TRUE(r["cleaned"].contains("nonManifoldEdges"));
	EXPECT_EQ(r["audit"]["passed"], true);
	EXPECT_GT(std::int64_t(r["peakMemoryBytes"]), 1000000);
	EXPECT_TRUE(r["notes"].is_array());
	EXPECT_TRUE(r["capsReached"].is_array());
}

TEST_F(Remesh, ReportHasP999BesideTheOtherDistances)
{
	const std::string in = binaryPly(sphere(40), true, false);
	remeshed("in.ply", in, {"--vertices", "300"});
	EXPECT_FALSE(report().contains("check"));
	remeshed("in.ply", in, {"--vertices", "300", "--check"});
	const Json   check = report()["check"];
	const double share = 100 / double(report()["input"]["diagonal"]);
	double       p999 = 0, hausdorff = 0;
	for (const char* way : {"toInput", "fromInput"}) {
		const Json& d = check[way];
		EXPECT_GT(double(d["rms"]), 0) << way;
		EXPECT_GT(double(d["p999"]), double(d["rms"])) << way;
		EXPECT_LE(double(d["p999"]), double(d["hausdorff"])) << way;
		for (const std::string key : {"rms", "p999", "hausdorff"})
			EXPECT_NEAR(double(d[key + "Percent"]), share * double(d[key]), 1e-9) << key;
		p999      = std::max(p999, double(d["p999"]));
		hausdorff = std::max(hausdorff, double(d["hausdorff"]));
	}
	EXPECT_EQ(p999, check["p999Distance"]);
	EXPECT_EQ(hausdorff, check["largestDistance"]);
}

TEST_F(Remesh, ReportHasProvenBoundsOfTheLargestDistance)
{
	const std::string in = binaryPly(sphere(40), true, false);
	remeshed("in.ply", in, {"--vertices", "300"});
	EXPECT_FALSE(report().contains("error"));
	remeshed("in.ply", in, {"--vertices", "300", "--check"});
	const Json   error   = report()["error"];
	const double largest = report()["check"]["largestDistance"];
	const double diag    = report()["input"]["diagonal"];
	for (const char* way : {"hausdorff", "toInput", "fromInput"}) {
		const double lower = error[way]["lower"], upper = error[way]["upper"];
		EXPECT_GT(lower, 0) << way;
		EXPECT_GE(upper, lower) << way;
		EXPECT_LE(upper, 1.01 * lower + 1e-5 * diag) << way;
		EXPECT_NEAR(double(error[way]["upperPercent"]), 100 * upper / diag, 1e-9) << way;
		EXPECT_EQ(error[way]["budgetSpent"], false) << way;
	}
	EXPECT_LE(double(error["hausdorff"]["lower"]), largest);
	EXPECT_GE(double(error["hausdorff"]["upper"]), largest);
	EXPECT_FALSE(error.contains("goal"));
	remeshed("in.ply", in, {"--max-error", "2%"});
	EXPECT_LE(double(report()["error"]["hausdorff"]["upperPercent"]), 2);
	EXPECT_EQ(report()["error"]["largest"], report()["error"]["hausdorff"]["upper"]);
	EXPECT_LE(int(report()["error"]["trials"]), 5);
}

TEST_F(Remesh, ReportKeepsTheKeysOfEarlierVersions)
{
	remeshed("in.ply", binaryPly(sphere(40), true, false), {"--vertices", "300", "--check"});
	const Json r = report();
	EXPECT_EQ(r["audit"]["invertedFaces"], 0);
	EXPECT_EQ(r["audit"]["flippedFaces"], 0);
	EXPECT_EQ(r["check"]["selfIntersectingFaces"], 0);
	EXPECT_EQ(r["check"]["crossingFaces"], 0);
	EXPECT_EQ(r["check"]["inputSelfIntersectingFaces"], r["check"]["inputCrossingFaces"]);
	EXPECT_EQ(r["counts"]["featureTips"], r["counts"]["featureConeApexes"]);
}

/// Names and values come back as they were given.
TEST_F(Remesh, ReportTellsTheOptionsInForce)
{
	const std::string in = put("in.ply", binaryPly(sphere(30), true, false));
	const std::vector<std::pair<std::string, std::string>> given = {
		{"preset", "fast"}, {"features", "lines"}, {"boundary", "free"}};
	std::vector<std::string> line = {"remesh", in, path("out.ply")};
	for (const auto& [name, value] : given)
		line.insert(line.end(), {"--" + name, value});
	line.insert(line.end(), {"--lambda", "2", "--report", path("report.json")});
	const ProgramResult result = run(line);
	ASSERT_EQ(result.exitCode, 0) << result.err;
	const Json options = report()["options"];
	for (const auto& [name, value] : given)
		EXPECT_EQ(options[name], value) << name;
	EXPECT_EQ(options["lambda"], 2);
	EXPECT_EQ(options["adapt"], "auto");
	EXPECT_EQ(report()["adapt"], 0) << "what it came to";
}

/// With the preset fast, 'auto' means 0; a given number is taken.
TEST_F(Remesh, AdaptivityMayBeLeftToTheProgram)
{
	const std::string in = binaryPly(sphere(30), true, false);
	remeshed("in.ply", in, {"--adapt", "auto", "--preset", "fast"});
	EXPECT_EQ(report()["adapt"], 0);
	remeshed("in.ply", in, {"--adapt", "0.1", "--preset", "fast"});
	EXPECT_EQ(report()["adapt"], 0.1);
	EXPECT_EQ(report()["options"]["adapt"], 0.1);
}

TEST_F(Remesh, SecondsAddUpToTheWallTime)
{
	const std::string   in = put("in.ply", binaryPly(sphere(250), true, false));
	const ProgramResult result =
		run({"remesh", in, path("out.ply"), "--report", path("report.json")});
	ASSERT_EQ(result.exitCode, 0) << result.err;
	const Json   s     = report()["seconds"];
	const double total = s["total"];
	EXPECT_NEAR(double(s["read"]) + double(s["remesh"]) + double(s["write"]), total, 1e-9);
	EXPECT_LE(total, result.seconds);
	// The program's clock misses some milliseconds of the start and end of the process, more on a
	// busy machine.
	EXPECT_GE(total, 0.5 * result.seconds - 0.2);
	EXPECT_GT(s.size(), 4u) << "no stages";
}

TEST_F(Remesh, TellsTheDistancesThatTheCheckMeasures)
{
	const std::string in    = put("in.ply", binaryPly(sphere(24), true, false));
	const std::string plain = run({"remesh", in, path("out.ply")}).out;
	EXPECT_EQ(plain.find("p99.9"), std::string::npos) << plain;
	const std::string checked = run({"remesh", in, path("out.ply"), "--check"}).out;
	const std::string length  = R"( \d\S* \(\d\S* %\))";
	for (const std::string way : {"result to input", "input to result"}) {
		const std::regex line(way + ": RMS" + length + ", p99\\.9" + length + ", largest" + length);
		EXPECT_TRUE(std::regex_search(checked, line)) << checked;
	}
	EXPECT_NE(checked.find("check    0 self-intersecting faces"), std::string::npos) << checked;
}

TEST_F(Remesh, QuietSilencesAllButErrors)
{
	const std::string   in   = put("in.ply", binaryPly(sphere(24), true, false));
	const ProgramResult loud = run({"remesh", in, path("out.ply")});
	EXPECT_NE(loud.out.find("wrote"), std::string::npos);
	EXPECT_EQ(loud.err, "") << "progress without a terminal";
	const ProgramResult quiet = run({"remesh", in, path("out.ply"), "--quiet"});
	EXPECT_EQ(quiet.exitCode, 0);
	EXPECT_EQ(quiet.out + quiet.err, "");
	expectFailure(run({"remesh", in, path("out.ply"), "--quiet", "--vertices", "1"}), 4);
	expectFailure(run({"remesh", path("nowhere.ply"), path("out.ply"), "--quiet"}), 3);
}

TEST_F(Remesh, ProgressOnATerminalLeavesACleanLine)
{
	const std::string   in     = put("in.ply", binaryPly(sphere(300), true, false));
	const ProgramResult result = runOnTerminal({"remesh", in, path("out.ply")});
	EXPECT_EQ(result.exitCode, 0);
	EXPECT_NE(result.err.find(" % "), std::string::npos) << result.err;
	EXPECT_EQ(result.err.find('\n'), std::string::npos) << "one line only";
	const std::string wiped = "\r\033[K";
	ASSERT_GE(result.err.size(), wiped.size());
	EXPECT_EQ(result.err.substr(result.err.size() - wiped.size()), wiped);
	EXPECT_EQ(runOnTerminal({"remesh", in, path("out.ply"), "--quiet"}).err, "");
}

TEST_F(Remesh, WhereOneHasToWaitATerminalIsToldHowLong)
{
	const std::string              in      = put("in.ply", binaryPly(sphere(200), true, false));
	const std::vector<std::string> command = {"remesh", in, path("out.ply"), "--threads", "1"};
	EXPECT_EQ(runOnTerminal(command).err.find("expected about "), std::string::npos);
	std::vector<std::string> more = command;
	more.insert(more.end(), {"--percent", "250", "--time-limit", "2"}); // told before the limit
	EXPECT_NE(runOnTerminal(more).err.find("expected about "), std::string::npos);
	EXPECT_EQ(run(more).err.find("expected about "), std::string::npos);
}

TEST_F(Remesh, SameSeedSameBytesOnAnyNumberOfThreads)
{
	const std::string in        = put("in.ply", binaryPly(sphere(60), true, false));
	const auto        bytesWith = [&](const std::vector<std::string>& options) {
        std::vector<std::string> all{"remesh", in, path("out.ply")};
        all.insert(all.end(), options.begin(), options.end());
        EXPECT_EQ(run(all).exitCode, 0);
        return content(path("out.ply"));
	};
	const std::string one = bytesWith({"--threads", "1"});
	EXPECT_EQ(bytesWith({"--threads", "1"}), one);
	EXPECT_EQ(bytesWith({"--threads", "2"}), one);
	EXPECT_EQ(bytesWith({"--threads", "4", "--seed", "1"}), one);
	EXPECT_NE(bytesWith({"--seed", "2"}), one);
}

TEST_F(Remesh, SignalCancelsAndLeavesTheOldFile)
{
	const std::string   in   = put("in.ply", binaryPly(sphere(500), true, false));
	const std::string   old  = put("out.ply", "old");
	const ProgramResult full = run({"remesh", in, path("full.ply")}, 120);
	ASSERT_EQ(full.exitCode, 0) << full.err;
	std::filesystem::remove(path("full.ply"));
	for (const int signal : {SIGINT, SIGTERM}) {
		const ProgramResult stopped =
			runAndSignal({"remesh", in, old, "--report", path("r.json")}, signal);
		expectFailure(stopped, 5, "cancelled");
		EXPECT_LT(stopped.seconds, full.seconds / 2) << "not cancelled at once";
		EXPECT_EQ(content(old), "old");
		EXPECT_EQ(files(), (std::vector<std::string>{"in.ply", "out.ply"}));
	}
}

TEST_F(Remesh, TheTimeLimitEndsItAndLeavesTheOldFile)
{
	const std::string   in  = put("in.ply", binaryPly(sphere(300), true, false));
	const std::string   old = put("out.ply", "old");
	const ProgramResult result =
		run({"remesh", in, old, "--report", path("r.json"), "--time-limit", "0.01"});
	expectFailure(result, 5, "time limit");
	EXPECT_EQ(content(old), "old");
	EXPECT_EQ(files(), (std::vector<std::string>{"in.ply", "out.ply"}));
	EXPECT_EQ(run({"remesh", put("small.ply", binaryPly(sphere(10), true, false)), old,
				   "--time-limit", "60"})
				  .exitCode,
			  0);
}

/// Each command with an older output, and the name of this output.
std::vector<std::pair<std::vector<std::string>, std::string>>
commandsWithOutput(const std::string& in, const std::string& folder)
{
	return {{{"remesh", in, folder + "/out.ply"}, "out.ply"},
			{{"remesh", in, "--out-dir", folder}, "in.ply"},
			{{"features", in, folder + "/out.ply"}, "out.ply"},
			{{"levels", in, folder + "/out_{level}.ply", "--percent", "30,20"}, "out_1.ply"},
			{{"levels", in, folder + "/out.glb", "--percent", "30,20"}, "out.glb"},
			{{"remesh", in, folder + "/tiles", "--tiles-out", "2"}, "tiles/tile0.ply"}};
}

class FullDevice : public Remesh {
protected:
	/// Runs each command with an older output. Expects a failure that leaves the older output
	/// alone.
	template <typename Run>
	void expectOldFiles(Run&& runWith)
	{
		const std::string in = put("in.ply", binaryPly(sphere(20), true, false));
		for (const auto& [command, name] : commandsWithOutput(in, path("made"))) {
			std::filesystem::create_directories(path("made/tiles"));
			put("made/" + name, "old");
			const ProgramResult failed = runWith(command);
			EXPECT_EQ(failed.exitCode, 1) << command[0] << ": " << failed.err;
			EXPECT_NE(failed.err.find("cannot write"), std::string::npos) << failed.err;
			EXPECT_EQ(content(path("made/" + name)), "old") << command[0] << " " << name;
			std::filesystem::remove(path("made/" + name));
			EXPECT_TRUE(std::filesystem::is_empty(path("made/tiles")));
			std::filesystem::remove(path("made/tiles"));
			EXPECT_TRUE(std::filesystem::is_empty(path("made"))) << command[0] << " " << name;
		}
	}
};

TEST_F(FullDevice, ForTheReportLeavesTheOldFile)
{
	expectOldFiles([&](std::vector<std::string> command) {
		command.insert(command.end(), {"--report", "/dev/full", "--quiet"});
		return run(command);
	});
}

TEST_F(FullDevice, ForStandardOutputLeavesTheOldFile)
{
	expectOldFiles([&](const std::vector<std::string>& command) {
		return runPrintingTo("/dev/full", command);
	});
}

TEST_F(FullDevice, ForStandardOutputIsAFailure)
{
	const std::string in = put("in.ply", binaryPly(sphere(20), true, false));
	for (const std::vector<std::string>& command :
		 std::vector<std::vector<std::string>>{{"--version"},
											   {"remesh", "--help-all"},
											   {"info", in},
											   {"compare", in, "--vertices", "100", "--json"}}) {
		expectFailure(runPrintingTo("/dev/full", command), 1, "cannot write to standard output");
	}
}

/// A pipe without a writer: a read never ends.
class EndlessFile {
public:
	explicit EndlessFile(const std::string& path)
	{
		if (::mkfifo(path.c_str(), 0600) != 0) throw std::runtime_error("no pipe");
		end_ = ::open(path.c_str(), O_RDWR | O_CLOEXEC);
	}
	~EndlessFile() { ::close(end_); }
	EndlessFile(const EndlessFile&)            = delete;
	EndlessFile& operator=(const EndlessFile&) = delete;

private:
	int end_;
};

TEST_F(Remesh, ASignalEndsReadingToo)
{
	const EndlessFile pipe(path("in.ply"));
	const std::string old = put("out.ply", "old");
	for (const char* command : {"remesh", "features"}) {
		for (const int signal : {SIGINT, SIGTERM}) {
			const ProgramResult stopped = runAndSignal({command, path("in.ply"), old}, signal);
			expectFailure(stopped, 5, "cancelled");
			EXPECT_EQ(content(old), "old");
			EXPECT_EQ(files(), std::vector<std::string>{"out.ply"});
		}
	}
}

TEST_F(Remesh, TheTimeLimitEndsReadingToo)
{
	const EndlessFile pipe(path("in.ply"));
	const std::string old = put("out.ply", "old");
	for (const char* command : {"remesh", "features"}) {
		expectFailure(run({command, path("in.ply"), old, "--time-limit", "0.2"}), 5, "time limit");
		EXPECT_EQ(content(old), "old");
	}
}

/// The grid of 12 by 12 squares, cut in two at x = 0.5, each half with vertices of its own.
TestMesh gridOfTwoHalves()
{
	const TestMesh                      whole = grid(12);
	TestMesh                            cut;
	std::map<std::pair<bool, int>, int> vertexOf;
	for (const auto& face : whole.faces) {
		double middle = 0;
		for (const int v : face)
			middle += whole.points[std::size_t(v)][0] / 3;
		auto own = face;
		for (int& v : own) {
			const auto added = vertexOf.insert({{middle > 0.5, v}, int(cut.points.size())});
			if (added.second) cut.points.push_back(whole.points[std::size_t(v)]);
			v = added.first->second;
		}
		cut.faces.push_back(own);
	}
	return cut;
}

TEST_F(Remesh, SeamsAreSewnUnlessOneSaysNo)
{
	const std::string input = binaryPly(gridOfTwoHalves(), true, false);
	remeshed("in.ply", input, {"--vertices", "300"});
	EXPECT_EQ(report()["cleaned"]["sewnEdges"], 12);
	EXPECT_EQ(report()["cleaned"]["sharedBorderEdges"], 0);
	EXPECT_EQ(report()["result"]["components"], 1);
	EXPECT_EQ(report()["options"]["sew"], true);
	const ProgramResult told =
		run({"remesh", path("in.ply"), path("told.ply"), "--vertices", "300"});
	EXPECT_NE(told.out.find("12 edges of seams sewn"), std::string::npos) << told.out;
	remeshed("in.ply", input, {"--vertices", "300", "--sew", "off"});
	EXPECT_EQ(report()["cleaned"]["sewnEdges"], 0);
	EXPECT_EQ(report()["result"]["components"], 2);
	expectFailure(run({"remesh", path("in.ply"), path("none.ply"), "--sew", "maybe"}), 2,
				  "takes on or off");
}

TEST_F(Remesh, SmallComponentsAreDroppedAndCounted)
{
	TestMesh  mesh  = sphere(20);
	const int first = int(mesh.points.size());
	for (int piece = 0; piece < 500; ++piece) {
		const double x = 2 + 0.01 * piece;
		mesh.points.insert(mesh.points.end(), {{x, 0, 0}, {x, 0.01, 0}, {x, 0, 0.01}});
		mesh.faces.push_back({first + 3 * piece, first + 3 * piece + 1, first + 3 * piece + 2});
	}
	const TestMesh result = remeshed("in.ply", binaryPly(mesh, true, false),
									 {"--drop-components-below", "100", "--vertices", "200"});
	EXPECT_EQ(result.points.size(), 200u);
	EXPECT_EQ(report()["result"]["components"], 1);
	EXPECT_EQ(report()["cleaned"]["droppedComponents"], 500);
	EXPECT_EQ(report()["cleaned"]["droppedFaces"], 500);
	expectFailure(
		run({"remesh", path("in.ply"), path("none.ply"), "--drop-components-below", "100000"}), 3,
		"fewer than 100000 faces");
}

/// A little input and a huge wish: told before anything is allocated.
TEST_F(Remesh, MoreThanMemoryHoldsIsRefusedAtOnce)
{
	const std::string   in     = put("in.ply", binaryPly(sphere(4), true, false));
	const ProgramResult result = run({"remesh", in, path("out.ply"), "--vertices", "200000000"});
	expectFailure(result, 1, "GB of memory would be needed");
	EXPECT_LT(result.seconds, 5);
}

TEST_F(Remesh, StlIsTakenAsFloatWithANote)
{
	const std::string   in     = put("in.ply", binaryPly(sphere(24), true, true));
	const ProgramResult result = run({"remesh", in, path("out.stl")});
	EXPECT_EQ(result.exitCode, 0) << result.err;
	EXPECT_NE(result.out.find("rounded to float"), std::string::npos);
}

/// Far from the origin floats are farther apart than the vertices of the result.
TEST_F(Remesh, FormatsThatWouldSpoilFacesAreRefused)
{
	const std::string in = put("in.ply", binaryPly(moved(sphere(24), 5e7, 5e7, 5e7), true, true));
	std::vector<std::string> refused = {"out.stl", "out.glb"};
	if (gpr::app::hasGltfText()) refused.push_back("out.gltf");
	if (gpr::app::hasThreeMf()) refused.push_back("out.3mf");
	for (const std::string& name : refused) {
		expectFailure(run({"remesh", in, path(name), "--vertices", "300"}), 4,
					  "of 596 faces of '" + path(name) +
						  "'; write PLY, OBJ or OFF, which keep the coordinates");
		EXPECT_FALSE(exists(path(name)));
	}
	for (const char* name : {"out.ply", "out.obj", "out.off"}) {
		EXPECT_EQ(run({"remesh", in, path(name), "--vertices", "300"}).exitCode, 0) << name;
		EXPECT_EQ(info(path(name))["input"]["vertices"], 300) << name;
	}
	expectFailure(run({"levels", in, path("out.glb"), "--percent", "20,10"}), 4, "holds floats");
	EXPECT_FALSE(exists(path("out.glb")));
}

/// The first file holds doubles, but is not written either.
TEST_F(Remesh, NoFileIsWrittenIfAnotherWouldBeSpoiled)
{
	const std::string ply = put("a.ply", binaryPly(moved(sphere(12), 5e7, 0, 0), true, true));
	const std::string stl = put("b.stl", asciiStl(moved(sphere(12), 5e7 + 3, 0, 0)));
	expectFailure(run({"remesh", ply, stl, "--out-dir", path("out"), "--vertices", "300"}), 4,
				  "STL holds floats only");
	EXPECT_FALSE(exists(path("out/a.ply")));
}

TEST_F(Remesh, InfoTellsWhatIsThere)
{
	const Json ball = info(put("ball.ply", asciiPly(sphere(10))));
	EXPECT_EQ(ball["input"]["vertices"], 402);
	EXPECT_EQ(ball["input"]["faces"], 800);
	EXPECT_EQ(ball["input"]["components"], 1);
	EXPECT_EQ(ball["input"]["boundaryLoops"], 0);
	EXPECT_EQ(ball["input"]["eulerCharacteristic"], 2);
	const Json ring = info(put("ring.off", off(torus(20))));
	EXPECT_EQ(ring["input"]["eulerCharacteristic"], 0);
	const Json sheet = info(put("sheet.obj", obj(grid(10))));
	EXPECT_EQ(sheet["input"]["boundaryLoops"], 1);
	EXPECT_NEAR(double(sheet["input"]["area"]), 1, 1e-6);
	EXPECT_NEAR(double(sheet["quality"]["angles"]["min"]), 45, 1e-3);
	const ProgramResult text = run({"info", path("sheet.obj")});
	EXPECT_EQ(text.exitCode, 0);
	EXPECT_NE(text.out.find("121 vertices, 200 faces"), std::string::npos) << text.out;
}

TEST_F(Remesh, InfoTellsRegionsAndJunctions)
{
	const std::string three =
		put("three.obj", "v 0 0 0\nv 0 0 1\nv 1 0 0\nv 1 0 1\nv -1 0 0\nv -1 0 1\n"
						 "v 0 1 0\nv 0 1 1\nv 9 0 0\nv 9 0 2\nv 9 2 0\n"
						 "g red\nf 1 2 4 3\nf 1 2 6 5\nf 9 10 11\ng blue\nf 1 2 8 7\n");
	const Json parts = info(three);
	ASSERT_EQ(parts["regions"].size(), 2u);
	EXPECT_EQ(parts["regions"][0]["name"], "red");
	EXPECT_EQ(parts["regions"][0]["faces"], 5);
	EXPECT_EQ(parts["regions"][0]["pieces"], 2);
	EXPECT_EQ(parts["regions"][0]["area"], 4.0);
	EXPECT_EQ(parts["regions"][1]["name"], "blue");
	EXPECT_EQ(parts["regions"][1]["pieces"], 1);
	EXPECT_EQ(parts["junctions"]["edges"], 1);
	EXPECT_EQ(parts["junctions"]["length"], 1.0);
	const ProgramResult text = run({"info", three});
	EXPECT_NE(text.out.find("2 regions in 3 pieces"), std::string::npos) << text.out;
	EXPECT_NE(text.out.find("red: 5 faces, area 4, 2 pieces"), std::string::npos) << text.out;
	EXPECT_NE(text.out.find("junctions 1 edge with more than two faces, 1 long"),
			  std::string::npos);
	const Json plain = info(put("ball.ply", asciiPly(sphere(10))));
	EXPECT_TRUE(plain["regions"].empty());
	EXPECT_EQ(plain["junctions"]["edges"], 0);
}

/// A sphere as ASCII PLY whose vertices in the upper half are selected.
static std::string sphereHalfSelected()
{
	const TestMesh mesh = sphere(24);
	std::string    text = "ply\nformat ascii 1.0\nelement vertex " +
					   std::to_string(mesh.points.size()) +
					   "\nproperty float x\nproperty float y\nproperty float z\nproperty float "
					   "selected\nelement face " +
					   std::to_string(mesh.faces.size()) +
					   "\nproperty list uchar int vertex_indices\nend_header\n";
	for (const auto& p : mesh.points) {
		text +=
			digits(p[0]) + " " + digits(p[1]) + " " + digits(p[2]) + (p[2] > 0 ? " 1\n" : " 0\n");
	}
	for (const auto& f : mesh.faces) {
		text += "3 " + std::to_string(f[0]) + " " + std::to_string(f[1]) + " " +
				std::to_string(f[2]) + "\n";
	}
	return text;
}

/// The number of a mesh's vertices in the upper half over the number in the lower half.
static double upperOverLower(const TestMesh& mesh)
{
	const auto upper = std::count_if(mesh.points.begin(), mesh.points.end(),
									 [](const auto& p) { return p[2] > 0; });
	return double(upper) / double(mesh.points.size() - std::size_t(upper));
}

TEST_F(Remesh, SelectionMakesDenser)
{
	const std::string in = sphereHalfSelected();
	EXPECT_GT(upperOverLower(
				  remeshed("s.ply", in, {"--vertices", "4000", "--feature-region", "selection"})),
			  2.5);
}

TEST_F(Remesh, SelectionThatTheFileHasNot)
{
	const std::vector<std::string> wish = {"--feature-region", "selection"};
	for (const auto& [name, content, exitCode] :
		 {std::tuple{"a.ply", asciiPly(sphere(8)), 3}, {"a.off", off(sphere(8)), 2}}) {
		std::vector<std::string> words = {"remesh", put(name, content), path("out.ply")};
		words.insert(words.end(), wish.begin(), wish.end());
		expectFailure(run(words), exitCode, "select");
	}
}

} // namespace gpr_test
