// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "off_lines.h"

#include <vcg_extras/io/base/exit_code.h>
#include <vcg_extras/io/text/number_text.h>

namespace gpr::app {

namespace {

void checkKeyword(std::string_view keyword)
{
	const std::size_t off = keyword.find("OFF");
	if (off == keyword.npos || off + 3 != keyword.size())
		failInput("an OFF file must begin with the word OFF");
	if (keyword.find_first_of("4n") != keyword.npos)
		failInput("OFF files of other than three dimensions are not read");
}

std::size_t countOf(std::string_view word, std::uint64_t fileBytes)
{
	std::int64_t count = 0;
	if (word == "BINARY") failInput("binary OFF files are not read");
	if (!parseInteger(word, count))
		failInput("bad OFF header: '" + std::string(word.substr(0, 30)) + "' is no count");
	if (count < 0) failInput("bad OFF header: a negative count");
	// A record takes at least a digit and a line break.
	if (std::uint64_t(count) > (fileBytes + 1) / 2)
		failInput("the file ends too early: its header promises " + std::string(word) + " records");
	return std::size_t(count);
}

} // namespace

OffHeader readOffHeader(std::string_view begin, std::uint64_t fileBytes)
{
	OffHeader        header;
	std::size_t      wordNum = 0;
	std::string_view rest    = begin;
	while (wordNum < 3 && !rest.empty()) {
		Words words(withoutComment(takeLine(rest)));
		for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
			++wordNum;
			if (wordNum == 1) checkKeyword(word);
			if (wordNum == 2) header.vertexNum = countOf(word, fileBytes);
			if (wordNum == 3) header.faceNum = countOf(word, fileBytes);
		}
	}
	if (wordNum == 0) checkKeyword({});
	if (wordNum < 3) failInput("the file ends too early and seems to be cut off");
	header.byteNum = begin.size() - rest.size();
	return header;
}

void requireAllOffRecords(const OffHeader& header, std::uint64_t recordNum)
{
	if (recordNum >= header.recordNum()) return;
	failInput("the file ends too early: its header promises " + std::to_string(header.recordNum()) +
			  " records");
}

void failAtOffLine(std::string_view text, const char* place, std::size_t linesBefore,
				   bool textEndsFile)
{
	const std::string_view from   = text.substr(std::size_t(place - text.data()));
	const bool             isLast = textEndsFile && from.find('\n') == from.npos;
	failInput("line " + std::to_string(linesBefore + lineNumber(text, place)) + ": " + badNumber +
			  (isLast ? ", or the file ends too early" : ""));
}

std::size_t countOffRecords(std::string_view text)
{
	std::size_t num = 0;
	while (!text.empty())
		num += !Words(withoutComment(takeLine(text))).isAtEnd();
	return num;
}

bool readOffVertex(Words& words, std::array<double, 3>& position)
{
	for (double& c : position) {
		if (!words.nextCoordinate(c)) return false;
	}
	return true;
}

bool readOffFace(Words& words, std::vector<std::int64_t>& corners)
{
	std::int64_t cornerNum = 0;
	if (!parseInteger(words.next(), cornerNum) || cornerNum < 0) return false;
	corners.clear();
	for (std::int64_t k = 0; k < cornerNum; ++k) {
		std::int64_t index = 0;
		if (!parseInteger(words.next(), index)) return false;
		corners.push_back(index);
	}
	return true;
}

} // namespace gpr::app
