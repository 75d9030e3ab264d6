// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Arguments, help and exit code 2.
#include "mesh_files.h"
#include "program_runner.h"

namespace gpr_test {

class CommandLine : public CliTest {
protected:
	/// Runs remesh on a good mesh with further options.
	ProgramResult remesh(std::vector<std::string> options)
	{
		options.insert(options.begin(),
					   {"remesh", put("in.ply", asciiPly(sphere(8))), path("out.ply")});
		return run(options);
	}
};

TEST_F(CommandLine, HelpTellsExitCodesAndOptions)
{
	const ProgramResult all = run({"--help"});
	EXPECT_EQ(all.exitCode, 0);
	EXPECT_NE(all.out.find("Exit codes"), std::string::npos);
	EXPECT_NE(all.out.find("remesh"), std::string::npos);
	const ProgramResult remeshing = run({"remesh", "--help-all"});
	EXPECT_EQ(remeshing.exitCode, 0);
	for (const char* option : {"--vertices", "--percent", "--edge-length", "--max-error", "--relax",
							   "--seed", "--threads", "--allow-nearest", "--report", "--quiet"}) {
		EXPECT_NE(remeshing.out.find(option), std::string::npos) << option;
	}
}

/// The number of lines with an option at the begin.
std::size_t optionNum(const std::string& help)
{
	std::size_t num = 0;
	for (const char* begin : {"\n  -", "\n    -"}) {
		for (std::size_t at = help.find(begin); at != std::string::npos;
			 at             = help.find(begin, at + 1))
            ++num;
	}
	return num;
}

TEST_F(CommandLine, HelpHasTheEverydayOptionsAndHelpAllHasGroups)
{
	for (const char* command : {"remesh", "compare", "levels"}) {
		const std::string everyday = run({command, "--help"}).out;
		const std::string all      = run({command, "--help-all"}).out;
		EXPECT_LE(optionNum(everyday), 17u) << everyday;
		EXPECT_GT(optionNum(all), 30u) << all;
		EXPECT_EQ(everyday.find("\n  --seed"), std::string::npos) << everyday;
		EXPECT_NE(everyday.find(std::string("'gpremesh ") + command + " --help-all'"),
				  std::string::npos)
			<< everyday;
		for (const char* text : {"\n  --seed", "\n  --preset", "\nRun:", "\nPreset paper:"})
			EXPECT_NE(all.find(text), std::string::npos) << text;
	}
	// A command with few options shows all.
	EXPECT_EQ(run({"features", "--help"}).out, run({"features", "--help-all"}).out);
	EXPECT_NE(run({"--help-all"}).out.find("--seed"), std::string::npos);
}

TEST_F(CommandLine, VersionIsOneLine)
{
	const ProgramResult result = run({"--version"});
	EXPECT_EQ(result.exitCode, 0);
	EXPECT_EQ(result.out, std::string("gpremesh ") + GPR_VERSION + "\n");
}

TEST_F(CommandLine, MissingOrUnknownWordsAreUsageErrors)
{
	const std::string in = put("in.ply", asciiPly(sphere(4)));
	expectFailure(run({}), 2);
	expectFailure(run({"frobnicate"}), 2);
	expectFailure(run({"remesh"}), 2);
	expectFailure(run({"remesh", in}), 2);
	expectFailure(run({"remesh", in, path("out.ply"), "third.ply"}), 2);
	expectFailure(run({"info"}), 2);
	expectFailure(run({"info", in, "--frobnicate"}), 2);
	EXPECT_FALSE(exists(path("out.ply")));
}

TEST_F(CommandLine, ValuesOutOfRangeAreUsageErrors)
{
	expectFailure(remesh({"--vertices", "0"}), 2, "--vertices");
	expectFailure(remesh({"--vertices", "-5"}), 2, "--vertices");
	expectFailure(remesh({"--vertices", "12.5"}), 2, "--vertices");
	expectFailure(remesh({"--vertices", "99999999999"}), 2, "--vertices");
	expectFailure(remesh({"--vertices"}), 2, "--vertices");
	expectFailure(remesh({"--percent", "0"}), 2, "--percent");
	expectFailure(remesh({"--percent", "-3"}), 2, "--percent");
	expectFailure(remesh({"--percent", "10001"}), 2, "--percent");
	expectFailure(remesh({"--percent", "nan"}), 2, "--percent");
	expectFailure(remesh({"--percent", "ten"}), 2, "--percent");
	expectFailure(remesh({"--edge-length", "0"}), 2, "--edge-length");
	expectFailure(remesh({"--edge-length", "inf"}), 2, "--edge-length");
	expectFailure(remesh({"--max-error", "0"}), 2, "--max-error");
	expectFailure(remesh({"--max-error", "%"}), 2, "--max-error");
	expectFailure(remesh({"--max-error", "-1%"}), 2, "--max-error");
	expectFailure(remesh({"--max-edge", "%"}), 2, "--max-edge");
	expectFailure(remesh({"--min-edge", "nan%"}), 2, "--min-edge");
	expectFailure(remesh({"--lambda", "2%"}), 2, "--lambda");
	expectFailure(remesh({"--min-edge", "3%", "--max-edge", "2%"}), 2, "longer");
	expectFailure(remesh({"--relax", "1001"}), 2, "--relax");
	expectFailure(remesh({"--seed", "-1"}), 2, "--seed");
	expectFailure(remesh({"--threads", "5000"}), 2, "--threads");
	expectFailure(remesh({"--sew", "maybe"}), 2, "--sew");
	expectFailure(remesh({"--adapt", "2"}), 2, "--adapt takes auto or a number from 0 to 1");
	expectFailure(remesh({"--adapt", "-1"}), 2, "--adapt");
	EXPECT_FALSE(exists(path("out.ply")));
}

TEST_F(CommandLine, OnlyOneSize)
{
	expectFailure(remesh({"--vertices", "50", "--percent", "10"}), 2, "only one");
	expectFailure(remesh({"--edge-length", "1", "--percent", "10"}), 2, "only one");
	expectFailure(remesh({"--vertices", "50", "--edge-length", "1"}), 2, "only one");
	expectFailure(remesh({"--vertices", "50", "--max-error", "1%"}), 2, "only one");
}

TEST_F(CommandLine, UnknownFormatsAreUsageErrorsBeforeTheWork)
{
	const std::string in = put("in.ply", asciiPly(sphere(4)));
	expectFailure(run({"remesh", in, path("out.xyz")}), 2, "out.xyz");
	expectFailure(run({"remesh", in, path("out")}), 2);
	expectFailure(run({"remesh", put("in.vtk", "x"), path("out.ply")}), 2, "in.vtk");
	expectFailure(run({"info", path("in.dat")}), 2);
}

TEST_F(CommandLine, ReportMustBeAFileOfItsOwn)
{
	const std::string in = put("in.ply", asciiPly(sphere(4))), before = content(in);
	expectFailure(run({"remesh", in, path("out.ply"), "--report", in}), 2, "--report");
	expectFailure(run({"remesh", in, path("out.ply"), "--report", path("out.ply")}), 2, "--report");
	EXPECT_EQ(content(in), before);
}

TEST_F(CommandLine, PlacesThatCannotBeWrittenAreToldBeforeTheWork)
{
	const std::string in = put("in.ply", asciiPly(sphere(4)));
	expectFailure(run({"remesh", in, path("missing/out.ply")}), 1, "missing/out.ply");
	expectFailure(run({"remesh", in, path("out.ply"), "--report", path("missing/r.json")}), 1,
				  "r.json");
	expectFailure(run({"remesh", path("nowhere.ply"), path("missing/out.ply")}), 1,
				  "missing/out.ply");
	EXPECT_EQ(files(), std::vector<std::string>{"in.ply"});
}

} // namespace gpr_test
