// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The corpus of the fuzzers as a test: findings and starts, in files of hexadecimal bytes in
// corpus/<target>; '#' begins a comment.

#include "corpus.h"
#include "pipeline.h"
#include "reader_check.h"

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

TEST(Corpus, EveryFileIsReadOrRefused)
{
	for (const NamedReader& reader : readers) {
		const std::string target(reader.format);
		ASSERT_FALSE(corpusFiles(target).empty()) << target;
		for (const std::filesystem::path& file : corpusFiles(target))
			EXPECT_EQ(complaintsAbout(reader.read, bytesOf(file)), "") << file;
	}
}

} // namespace

} // namespace gpr::test
