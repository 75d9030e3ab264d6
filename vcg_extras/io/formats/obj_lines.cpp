// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "obj_lines.h"

#include <vcg_extras/io/base/exit_code.h>
#include <vcg_extras/io/text/number_text.h>

#include <algorithm>
#include <cmath>

namespace gpr::app {

namespace {

/// The rest of a corner after its first index: more indices, which are not read.
bool isRestOfCorner(std::string_view rest)
{
	return std::all_of(rest.begin(), rest.end(), [](char c) {
		return c == '/' || c == '-' || c == '+' || (c >= '0' && c <= '9');
	});
}

} // namespace

std::string_view takeWholeLine(std::string_view& text, std::string& joined)
{
	std::string_view line = takeLine(text);
	if (!goesOn(line)) return line;
	joined.clear();
	while (goesOn(line)) {
		joined.append(line.substr(0, line.rfind('\\')));
		joined += ' ';
		line = takeLine(text);
	}
	joined.append(line);
	return joined;
}

std::size_t countObjVertices(std::string_view text)
{
	std::size_t num = 0;
	std::string joined;
	while (!text.empty())
		num += Words(takeWholeLine(text, joined)).next() == "v";
	return num;
}

bool readObjCorner(std::string_view word, std::int64_t& index)
{
	const std::size_t slash = std::min(word.find('/'), word.size());
	return parseInteger(word.substr(0, slash), index) && isRestOfCorner(word.substr(slash));
}

bool readObjColour(Words& behindCoordinates, std::array<std::uint8_t, 3>& colour)
{
	for (std::uint8_t& c : colour) {
		const std::string_view word = behindCoordinates.next();
		if (word.empty()) return false;
		double value = 0;
		if (!parseNumber(word, value) || std::isnan(value)) value = 0;
		c = std::uint8_t(std::floor(255 * std::clamp(value, 0.0, 1.0) + 0.5));
	}
	return behindCoordinates.isAtEnd();
}

void failAtObjLine(std::size_t number)
{
	failInput("line " + std::to_string(number) + ": " + badNumber);
}

} // namespace gpr::app
