// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the figure at the head of vcg_extras/docs/algorithm.md from the engine's table of stages.
//
//   gpr_pipeline_figure                 prints the figure
//   gpr_pipeline_figure --write ROOT    writes the figure between its marks in the page
//   gpr_pipeline_figure --check ROOT    ends with 0 if the page has the figure and, below, an entry
//                                       with the key of every stage, else with 1
#include <tests/support/stages_of.h>
#include <vcg_extras/core/base/stages.h>

#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>

namespace {

using gpr::Pipeline;
using gpr::Stage;

const std::string beginMark =
	"<!-- pipeline: begin (made by build/bin/gpr_pipeline_figure --write .) -->\n";
const std::string endMark = "<!-- pipeline: end -->\n";

/// Text of at least so many columns. Keys and phrases are plain ASCII.
std::string padded(std::string text, std::size_t columns)
{
	if (text.size() < columns) text.resize(columns, ' ');
	return text;
}

/// A row for each stage: its key in the report, its phrase for users, and a bar as long as its
/// share of a run.
std::string figure()
{
	constexpr double columns = 100; // of all bars together
	std::string      text    = beginMark + "```text\n" + padded("key in the report", 18) +
					   padded("what is done", 40) + "share of the time on a scan\n";
	double before = 0;
	for (Stage stage : gpr::test::stagesOf(Pipeline::Remeshing)) {
		const gpr::StageRow& row   = gpr::rowOf(stage);
		const double         share = gpr::shareAtEnd(stage, Pipeline::Remeshing) - before;
		const int            bar   = int(std::ceil(columns * share - 1e-9));
		before += share;
		text += padded(row.key, 18) + padded(row.phrase, 40) + std::string(std::size_t(bar), '#') +
				"\n";
	}
	return text + "```\n" + endMark;
}

std::string contentOf(const std::string& path)
{
	std::ifstream in(path, std::ios::binary);
	return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// The page with the figure between its marks; empty without the marks.
std::string pageWithFigure(const std::string& page)
{
	const std::size_t begin = page.find("<!-- pipeline: begin");
	const std::size_t end   = page.find(endMark);
	if (begin == std::string::npos || end == std::string::npos || end < begin) return "";
	return page.substr(0, begin) + figure() + page.substr(end + endMark.size());
}

/// Keys without an entry below the figure, with commas between.
std::string keysWithoutEntry(const std::string& page)
{
	const std::string entries = page.substr(page.find(endMark) + endMark.size());
	std::string       missing;
	for (Stage stage : gpr::test::stagesOf(Pipeline::Remeshing)) {
		const std::string key = std::string("`") + gpr::rowOf(stage).key + "`";
		if (entries.find(key) == std::string::npos) missing += (missing.empty() ? "" : ", ") + key;
	}
	return missing;
}

} // namespace

int main(int argc, char** argv)
{
	if (argc < 3) {
		std::fputs(figure().c_str(), stdout);
		return 0;
	}
	const std::string path   = std::string(argv[2]) + "/vcg_extras/docs/algorithm.md";
	const std::string page   = contentOf(path);
	const std::string wanted = pageWithFigure(page);
	if (wanted.empty()) {
		std::fprintf(stderr, "%s has no marks for the figure of the pipeline\n", path.c_str());
		return 1;
	}
	if (std::strcmp(argv[1], "--write") == 0) {
		std::ofstream(path, std::ios::binary) << wanted;
		return 0;
	}
	const std::string missing = keysWithoutEntry(page);
	if (!missing.empty()) {
		std::fprintf(stderr, "%s has no entry for %s\n", path.c_str(), missing.c_str());
		return 1;
	}
	if (page == wanted) return 0;
	std::fprintf(
		stderr,
		"the figure of the pipeline in %s is not up to date: gpr_pipeline_figure --write .\n",
		path.c_str());
	return 1;
}
