// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What fuzzing has found, and what it starts from, as a test: files of hexadecimal bytes in
// corpus/<target>, '#' begins a comment.

#include "pipeline.h"

#include <cctype>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <vcg_extras/apps/gpremesh/exit_code.h>
#include <vcg_extras/apps/gpremesh/ply_reader.h>
#include <vcg_extras/apps/gpremesh/soup_io.h>
#include <vector>

namespace gpr::test {

namespace {

namespace fs = std::filesystem;

std::string bytesOf(const fs::path& file)
{
	std::ifstream stream(file);
	std::string   bytes;
	for (std::string line; std::getline(stream, line);) {
		const std::string hex = line.substr(0, line.find('#'));
		for (std::size_t i = 0; i + 1 < hex.size(); ++i) {
			if (!std::isxdigit(static_cast<unsigned char>(hex[i]))) continue;
			bytes += char(std::stoi(hex.substr(i, 2), nullptr, 16));
			++i;
		}
	}
	return bytes;
}

std::vector<fs::path> corpus(const std::string& target)
{
	std::vector<fs::path> files;
	for (const auto& entry : fs::directory_iterator(fs::path(GPR_CORPUS_DIR) / target))
		files.push_back(entry.path());
	std::sort(files.begin(), files.end());
	return files;
}

TEST(Corpus, EveryCaseOfTheEngineEndsWell)
{
	ASSERT_FALSE(corpus("pipeline").empty());
	for (const fs::path& file : corpus("pipeline")) {
		const std::string bytes = bytesOf(file);
		const auto* const data  = reinterpret_cast<const std::uint8_t*>(bytes.data());
		EXPECT_EQ(complaintsAbout(caseOf(data, bytes.size())), "") << file;
	}
}

void expectReadOrRefused(const char* target, app::InputMesh (*read)(std::string_view))
{
	ASSERT_FALSE(corpus(target).empty());
	for (const fs::path& file : corpus(target)) {
		try {
			const app::InputMesh mesh = read(bytesOf(file));
			for (const std::int32_t v : mesh.triangles)
				ASSERT_TRUE(v >= 0 && std::size_t(v) < mesh.vertexNum()) << file;
		}
		catch (const app::AppError& error) {
			EXPECT_EQ(error.code, app::ExitCode::BadInput) << file << ": " << error.what();
		}
	}
}

TEST(Corpus, EveryFileIsReadOrRefused)
{
	expectReadOrRefused("ply", app::readPly);
	expectReadOrRefused("obj", app::readObj);
	expectReadOrRefused("off", app::readOff);
	expectReadOrRefused("stl", app::readStl);
}

} // namespace

} // namespace gpr::test
