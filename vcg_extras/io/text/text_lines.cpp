// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "text_lines.h"

#include <algorithm>
#include <cmath>

namespace gpr::app {

std::string lowerCase(std::string_view text)
{
	std::string lower(text);
	for (char& c : lower)
		c = c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
	return lower;
}

bool isNonFinite(std::string_view word)
{
	if (!word.empty() && (word[0] == '-' || word[0] == '+')) word.remove_prefix(1);
	const std::string begin = lowerCase(word.substr(0, 3));
	return begin == "nan" || begin == "inf";
}

bool goesOn(std::string_view line)
{
	std::size_t end = line.size();
	while (end > 0 && isBlank(line[end - 1]))
		--end;
	return end > 0 && line[end - 1] == '\\';
}

std::string_view takeLine(std::string_view& text)
{
	const std::size_t      end  = std::min(text.find('\n'), text.size());
	const std::string_view line = text.substr(0, end);
	text.remove_prefix(std::min(end + 1, text.size()));
	return line;
}

std::string_view withoutComment(std::string_view line)
{
	return line.substr(0, std::min(line.find('#'), line.size()));
}

std::vector<std::string_view> linePieces(std::string_view text, bool mayGoOn)
{
	constexpr std::size_t         usualBytes = 1 << 20;
	std::vector<std::string_view> pieces;
	while (!text.empty()) {
		std::size_t end = std::min(usualBytes, text.size()), begin = end;
		while (end < text.size()) {
			end = std::min(text.find('\n', end), text.size() - 1) + 1;
			if (!mayGoOn || !goesOn(text.substr(begin, end - begin))) break;
		}
		pieces.push_back(text.substr(0, end));
		text.remove_prefix(end);
	}
	return pieces;
}

std::vector<std::size_t>
recordsBefore(const std::vector<std::string_view>&                pieces,
			  const std::function<std::size_t(std::string_view)>& countRecords, Workers& workers)
{
	std::vector<std::size_t> before(pieces.size() + 1, 0);
	workers.forTasks(pieces.size(),
					 [&](std::size_t i, int) { before[i + 1] = countRecords(pieces[i]); });
	for (std::size_t i = 0; i < pieces.size(); ++i)
		before[i + 1] += before[i];
	return before;
}

std::size_t lineNumber(std::string_view text, const char* place)
{
	return 1 + std::size_t(std::count(text.data(), place, '\n'));
}

void Words::skipBlanks()
{
	while (at_ < end_ && isBlank(*at_))
		++at_;
}

bool Words::isAtEnd()
{
	skipBlanks();
	return at_ == end_;
}

std::string_view Words::rest()
{
	skipBlanks();
	while (end_ > at_ && isBlank(end_[-1]))
		--end_;
	return {at_, std::size_t(end_ - at_)};
}

std::string_view Words::restOfLine()
{
	const char* const begin = at_;
	at_                     = std::find(at_, end_, '\n');
	return Words({begin, std::size_t(at_ - begin)}).rest();
}

std::string_view Words::next()
{
	skipBlanks();
	const char* const begin = at_;
	while (at_ < end_ && !isBlank(*at_))
		++at_;
	return {begin, std::size_t(at_ - begin)};
}

bool Words::nextCoordinate(double& value)
{
	skipBlanks();
	const char* const begin = at_;
	if (takePlainNumber(at_, end_, value) && std::isfinite(value)) return true;
	at_                         = begin;
	const std::string_view word = next();
	if (isNonFinite(word)) {
		value = std::nan("");
		return true;
	}
	return parseNumber(word, value) && std::isfinite(value);
}

} // namespace gpr::app
