// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What fuzzing has found, and what it starts from, as a test: files of hexadecimal bytes in
// corpus/<target>, '#' begins a comment.

#include "corpus.h"
#include "pipeline.h"

#include <gtest/gtest.h>
#include <vcg_extras/apps/gpremesh/exit_code.h>
#include <vcg_extras/apps/gpremesh/ply_reader.h>
#include <vcg_extras/apps/gpremesh/soup_io.h>

namespace gpr::test {

namespace {

namespace fs = std::filesystem;

TEST(Corpus, EveryCaseOfTheEngineEndsWell)
{
	ASSERT_FALSE(corpusFiles("pipeline").empty());
	for (const fs::path& file : corpusFiles("pipeline")) {
		const std::string bytes = bytesOf(file);
		const auto* const data  = reinterpret_cast<const std::uint8_t*>(bytes.data());
		EXPECT_EQ(complaintsAbout(caseOf(data, bytes.size())), "") << file;
	}
}

void expectReadOrRefused(const char* target, app::InputMesh (*read)(std::string_view))
{
	ASSERT_FALSE(corpusFiles(target).empty());
	for (const fs::path& file : corpusFiles(target)) {
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
