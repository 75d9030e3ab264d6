// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_TEXT_SCANNER_H
#define VCG_EXTRAS_APPS_GPREMESH_TEXT_SCANNER_H

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace gpr::app {

/// Walks over the words of a text in memory. Numbers are read as in the C locale, whatever the
/// user's is. Every complaint is an AppError (BadInput) that names the line.
class TextScanner {
public:
	/// A comment runs from commentSign to the end of its line; 0 = there are no comments.
	/// With joinLines a backslash at the end of a line continues it on the next (OBJ).
	/// Complaints count lines from firstLine on.
	TextScanner(std::string_view text, char commentSign, bool joinLines = false,
				std::size_t firstLine = 1);

	/// The next word of the current line, empty at its end.
	std::string_view wordOnLine();
	/// The next word of the text, on whatever line; empty at the end of the text.
	std::string_view word();
	/// Goes to the begin of the next line; false at the end of the text.
	bool nextLine();

	double       number(std::string_view word) const;
	std::int64_t integer(std::string_view word) const;
	/// The same for the next word of the text; the text must not end here.
	double       nextNumber() { return number(existing(word())); }
	std::int64_t nextInteger() { return integer(existing(word())); }

	std::size_t bytesLeft() const { return std::size_t(end_ - at_); }
	/// Throws the complaint: "line 12: <what>".
	[[noreturn]] void fail(const std::string& what) const;
	[[noreturn]] void failTruncated() const;

private:
	const char* at_;
	const char* end_;
	std::size_t line_;
	char        commentSign_;
	bool        joinLines_;

	void             skipBlanks();
	std::size_t      continuationLength() const;
	std::string_view existing(std::string_view word) const;
};

/// Reads a whole word as a real number in the C locale ("nan" and "inf" included); false when it is
/// none. Values too small for a double become 0, too large ones infinite.
bool parseNumber(std::string_view word, double& value);

/// Reads a whole word as a whole number; false when it is none or does not fit.
bool parseInteger(std::string_view word, std::int64_t& value);

} // namespace gpr::app

#endif
