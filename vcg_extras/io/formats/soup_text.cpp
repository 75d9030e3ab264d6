// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "soup_text.h"

#include <algorithm>

namespace gpr::app {

namespace {

constexpr const char* nonFiniteMarkText = "-1.7976931348623157e308"; // the lowest double

char lower(char c)
{
	return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
}

bool isBlank(char c)
{
	return c == ' ' || (c >= '\t' && c <= '\r');
}

bool isDigit(char c)
{
	return c >= '0' && c <= '9';
}

/// Whether a word begins like nan, inf, infinity, whatever follows ("nan(ind)").
bool isNonFiniteWord(std::string_view word)
{
	if (word.size() < 3) return false;
	const char begin[] = {lower(word[0]), lower(word[1]), lower(word[2]), 0};
	return std::string_view(begin) == "nan" || std::string_view(begin) == "inf";
}

/// Whether a character that is neither a digit nor a blank may follow another one in a number.
bool mayFollow(char before, char c)
{
	const bool afterDigit = isDigit(before) || before == '.';
	if (c == '.') return isBlank(before) || isDigit(before) || before == '-' || before == '+';
	if (c == '-' || c == '+') return isBlank(before) || lower(before) == 'e';
	return lower(c) == 'e' && afterDigit;
}

/// Appends a text of numbers, with the words nan, inf and the like replaced by the mark. The text
/// ends before the first word that is no number: a stream would read "1.5x" as 1.5, so it finds too
/// little there. Comments are left as they are.
void appendNumbers(std::string_view text, std::string& out)
{
	std::size_t done = 0;
	for (std::size_t i = 0; i < text.size(); ++i) {
		const char c = text[i], before = i > 0 ? text[i - 1] : ' ';
		if (isDigit(c) || isBlank(c) || mayFollow(before, c)) continue;
		if (c == '#') {
			i = std::min(text.find('\n', i), text.size());
			continue;
		}
		const std::size_t begin    = text.find_last_of(" \t\r\n", i) + 1;
		const bool        isSigned = i == begin + 1 && (before == '-' || before == '+');
		const std::size_t end      = std::min(text.find_first_of(" \t\r\n", i), text.size());
		out.append(text, done, begin - done);
		if (!(i == begin || isSigned) || !isNonFiniteWord(text.substr(i, end - i))) return;
		out += nonFiniteMarkText;
		done = i = end;
	}
	out.append(text, done);
}

/// Blanks out what follows the word solid or endsolid on its line.
void dropSolidNames(std::string& text)
{
	constexpr std::size_t wordLen = 5;
	for (std::size_t at = text.find("solid"); at != text.npos; at = text.find("solid", at)) {
		const std::size_t end = std::min(text.find('\n', at), text.size());
		std::fill(text.begin() + long(at + wordLen), text.begin() + long(end), ' ');
		at = end;
	}
}

/// Where the third word from a place on ends.
std::size_t afterThreeWords(std::string_view text, std::size_t at)
{
	for (int k = 0; k < 3; ++k) {
		at = std::min(text.find_first_not_of(" \t\r\n", at), text.size());
		at = std::min(text.find_first_of(" \t\r\n", at), text.size());
	}
	return at;
}

/// Appends the text of a file with the numbers of its corners checked.
void appendStl(std::string_view text, std::string& out)
{
	constexpr std::string_view keyword = "vertex";
	std::size_t                done    = 0;
	for (std::size_t at = text.find(keyword); at != text.npos; at = text.find(keyword, done)) {
		at += keyword.size();
		out.append(text, done, at - done);
		done = afterThreeWords(text, at);
		appendNumbers(text.substr(at, done - at), out);
	}
	out.append(text, done);
}

std::size_t occurrenceNum(std::string_view text, std::string_view word)
{
	std::size_t num = 0;
	for (std::size_t at = text.find(word); at != text.npos; at = text.find(word, at + 1))
		++num;
	return num;
}

bool solidIsClosed(std::string_view text)
{
	const std::size_t end = text.rfind("endsolid"), facet = text.rfind("facet");
	return end != text.npos && (facet == text.npos || facet < end);
}

} // namespace

SoupText prepareAsciiStl(std::string_view file)
{
	SoupText    soup;
	std::string text(file);
	std::transform(text.begin(), text.end(), text.begin(), lower);
	dropSolidNames(text);
	appendStl(text, soup.text);
	// CGAL passes over words that it does not know, such as a damaged "facet".
	soup.faceNum =
		std::max(occurrenceNum(soup.text, "endloop"), occurrenceNum(soup.text, "endfacet"));
	soup.ended = solidIsClosed(soup.text);
	if (!soup.ended) soup.text += "\nendsolid\n";
	// CGAL tries the binary form on a text that it could not read: let the count there be absurd.
	soup.text.append(100, ' ');
	return soup;
}

} // namespace gpr::app
