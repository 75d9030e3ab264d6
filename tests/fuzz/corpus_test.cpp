// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The corpus of the fuzzers as a test: findings and starts, in files of hexadecimal bytes in
// corpus/<target>; '#' begins a comment.

#include "corpus.h"
#include "pipeline.h"
#include "reader_check.h"

#include <vcg_extras/io/formats/mesh_formats.h>

#include <gtest/gtest.h>

namespace gpr::test {

namespace {

TEST(Corpus, EveryCaseOfTheEngineEndsWell)
{
	ASSERT_FALSE(corpusFiles("pipeline").empty());
	for (const std::filesystem::path& file : corpusFiles("pipeline")) {
		const std::string bytes = bytesOf(file);
		const auto* const data  = reinterpret_cast<const std::uint8_t*>(bytes.data());
		for (const CaseSize size : {CaseSize::Any, CaseSize::Small})
			EXPECT_EQ(complaintsAbout(caseOf(data, bytes.size(), size)), "") << file;
		EXPECT_EQ(complaintsAbout(caseOfParts(data, bytes.size())), "") << file;
	}
}

void expectReadOrRefused(const char* target, Reader read)
{
	ASSERT_FALSE(corpusFiles(target).empty());
	for (const std::filesystem::path& file : corpusFiles(target))
		EXPECT_EQ(complaintsAbout(read, bytesOf(file)), "") << file;
}

TEST(Corpus, EveryFileIsReadOrRefused)
{
	expectReadOrRefused("ply", app::readPly);
	expectReadOrRefused("obj", app::readObj);
	expectReadOrRefused("off", app::readOff);
	expectReadOrRefused("stl", app::readStl);
	expectReadOrRefused("glb", [](std::string_view file) { return app::readGlb(file); });
}

} // namespace

} // namespace gpr::test
