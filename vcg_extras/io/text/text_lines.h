// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_IO_TEXT_TEXT_LINES_H
#define VCG_EXTRAS_IO_TEXT_TEXT_LINES_H

#include "char_conversion.h"

#include <vcg_extras/core/base/workers.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

// Text files by their lines: pieces that threads can read side by side, and the words of a line.

namespace gpr::app {

constexpr const char* badNumber = "a number is malformed or missing";

inline bool isBlank(char c)
{
	return c == ' ' || (c >= '\t' && c <= '\r');
}

/// ASCII letters in lower case.
std::string lowerCase(std::string_view text);

/// Reads a number of the plain form that nearly all words have, which are looked at once so, and
/// goes on behind it. False, and nothing is read, where the next word is none.
template <class Number>
bool takePlainNumber(const char*& at, const char* end, Number& value)
{
	const auto parsed = fromChars(at, end, value);
	const bool isWord = parsed.ptr == end || isBlank(*parsed.ptr);
	if (parsed.ec != std::errc() || !isWord) return false;
	at = parsed.ptr;
	return true;
}

/// Whether a word begins like nan, inf or infinity, with or without a sign, whatever follows.
bool isNonFinite(std::string_view word);

/// Whether a line goes on behind its end: its last character that is no blank is a backslash.
bool goesOn(std::string_view line);

/// Pieces of about a megabyte that end at the end of a line. Where `mayGoOn`, none ends at one that
/// goes on.
std::vector<std::string_view> linePieces(std::string_view text, bool mayGoOn = false);

/// Cuts the first line, without its end, off a text.
std::string_view takeLine(std::string_view& text);

/// What stands before the first '#' of a line.
std::string_view withoutComment(std::string_view line);

/// For every piece how many records the pieces before it have, and at the end how many all have.
std::vector<std::size_t>
recordsBefore(const std::vector<std::string_view>&                pieces,
			  const std::function<std::size_t(std::string_view)>& countRecords, Workers& workers);

/// The number of the line, from 1 on, that a place of the text is in.
std::size_t lineNumber(std::string_view text, const char* place);

/// The words of one line, from its begin on. Any white space parts them.
class Words {
public:
	explicit Words(std::string_view line) : at_(line.data()), end_(line.data() + line.size()) {}

	/// The next word; empty at the end of the line.
	std::string_view next();
	/// The next word as a coordinate: NaN for words such as inf and nan(ind). False where it is
	/// missing or no number.
	bool nextCoordinate(double& value);
	bool isAtEnd();
	/// All words that are left as one name, which may have blanks in it.
	std::string_view rest();
	/// The same of this line, where the words are those of several lines; goes on at its end.
	std::string_view restOfLine();

private:
	const char* at_;
	const char* end_;

	void skipBlanks();
};

} // namespace gpr::app

#endif
