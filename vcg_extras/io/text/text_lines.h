// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_IO_TEXT_TEXT_LINES_H
#define VCG_EXTRAS_IO_TEXT_TEXT_LINES_H

#include "number_text.h"

#include <vcg_extras/core/base/workers.h>

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

// Text files by their lines: pieces for threads side by side, and the words of a line.

namespace gpr::app {

constexpr const char* badNumber = "a number is malformed or missing";

inline bool isBlank(char c)
{
	return c == ' ' || (c >= '\t' && c <= '\r');
}

/// ASCII letters in lower case.
std::string lowerCase(std::string_view text);

/// Reads a number of the plain form of nearly all words, in a single look, and moves on after the
/// number. False, and nothing is read, for another next word.
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

/// Whether a line goes on in the next line: its last character except blanks is a backslash.
bool goesOn(std::string_view line);

/// Pieces of about a megabyte of whole lines. With `mayGoOn`, no piece ends at a line that goes on.
std::vector<std::string_view> linePieces(std::string_view text, bool mayGoOn = false);

/// Cuts the first line, without its end, off a text.
std::string_view takeLine(std::string_view& text);

/// The text before the first '#' of a line.
std::string_view withoutComment(std::string_view line);

/// For every piece the number of records in earlier pieces, and at the end the number of all
/// records.
std::vector<std::size_t>
recordsBefore(const std::vector<std::string_view>&                pieces,
			  const std::function<std::size_t(std::string_view)>& countRecords, Workers& workers);

/// The number of the line, from 1 on, at a place of the text.
std::size_t lineNumber(std::string_view text, const char* place);

/// The words of one line, from its begin on, parted by any white space.
class Words {
public:
	explicit Words(std::string_view line) : at_(line.data()), end_(line.data() + line.size()) {}

	/// The next word; empty at the end of the line.
	std::string_view next();
	/// The next word as a coordinate: NaN for words such as inf and nan(ind). False for a missing
	/// word or no number.
	bool nextCoordinate(double& value);
	bool isAtEnd();
	/// All further words as one name, which may have blanks.
	std::string_view rest();
	/// The same for this line, if the words belong to several lines; goes on at the end of the
	/// line.
	std::string_view restOfLine();

private:
	const char* at_;
	const char* end_;

	void skipBlanks();
};

} // namespace gpr::app

#endif
