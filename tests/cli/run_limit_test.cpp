// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Writing under a time limit.
#include <vcg_extras/io/base/exit_code.h>
#include <vcg_extras/io/base/output_file.h>
#include <vcg_extras/io/mesh_io.h>

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>
#include <unistd.h>

namespace gpr_test {

namespace {

using namespace gpr;
using namespace gpr::app;
namespace fs = std::filesystem;

/// A limit of one second, of which ten have passed.
RunLimit timeIsUp()
{
	return {Stopwatch(10), 1};
}

class WritingUnderALimit : public ::testing::Test {
protected:
	WritingUnderALimit() :
			folder_(fs::temp_directory_path() / ("gpremesh_limit_" + std::to_string(getpid())))
	{
		fs::create_directories(folder_);
	}
	~WritingUnderALimit() override { fs::remove_all(folder_); }

	/// A file with old content.
	std::string oldFile(const std::string& name) const
	{
		std::ofstream((folder_ / name).string()) << "old";
		return (folder_ / name).string();
	}
	void expectOldFileAlone(const std::string& path) const
	{
		std::stringstream text;
		text << std::ifstream(path).rdbuf();
		EXPECT_EQ(text.str(), "old");
		for (const auto& entry : fs::directory_iterator(folder_))
			EXPECT_EQ(entry.path().string().find(".part"), std::string::npos) << entry.path();
	}

	fs::path folder_;
};

TEST_F(WritingUnderALimit, ItEndsWithinAMegabyteAndLeavesTheOldFile)
{
	const std::string path    = oldFile("out.txt");
	std::size_t       written = 0;
	try {
		OutputFile        out(path, timeIsUp());
		const std::string line(1000, 'x');
		for (; written < 10000000; written += line.size())
			out.text(line);
		out.commit();
		FAIL() << "not ended";
	}
	catch (const AppError& error) {
		EXPECT_EQ(error.code, ExitCode::Stopped);
		EXPECT_NE(std::string(error.what()).find("time limit"), std::string::npos);
	}
	EXPECT_LE(written, 1u << 20);
	expectOldFileAlone(path);
}

/// The limit is asked even for a small result, before the new file replaces the old file.
TEST_F(WritingUnderALimit, EveryFormatAsksBeforeItReplacesTheOldFile)
{
	const TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 1, 2}};
	for (const char* name : {"out.ply", "out.obj", "out.off", "out.stl"}) {
		const std::string path = oldFile(name);
		MeshAttributes    none;
		EXPECT_THROW(writeMesh(mesh, false, none, path, timeIsUp()), AppError) << name;
		expectOldFileAlone(path);
		writeMesh(mesh, false, none, path, RunLimit(Stopwatch(), 1000));
		EXPECT_GT(fs::file_size(path), 30u) << name;
	}
}

TEST(RunLimit, TheEngineIsGivenWhatIsLeft)
{
	EXPECT_EQ(RunLimit().secondsLeft(), 0) << "no limit";
	EXPECT_EQ(RunLimit(Stopwatch(10), 0).secondsLeft(), 0) << "no limit";
	EXPECT_NEAR(RunLimit(Stopwatch(10), 30).secondsLeft(), 20, 1);
	EXPECT_GT(timeIsUp().secondsLeft(), 0) << "0 would be no limit";
	EXPECT_LT(timeIsUp().secondsLeft(), 0.1);
}

} // namespace

} // namespace gpr_test
