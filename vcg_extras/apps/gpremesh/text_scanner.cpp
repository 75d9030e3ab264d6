// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "text_scanner.h"

#include "exit_code.h"

#include <charconv>
#include <limits>

namespace gpr::app {

namespace {

bool isBlank(char c)
{
	return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

/// A word fit to be quoted in a sentence: short, and without control characters.
std::string quoted(std::string_view word)
{
	constexpr std::size_t longest = 30;
	std::string           text    = "'";
	for (const char c : word.substr(0, longest))
		text += (c >= ' ' && c < 127) ? c : '?';
	return text + (word.size() > longest ? "...'" : "'");
}

std::string_view withoutPlus(std::string_view word)
{
	const bool plus = word.size() > 1 && word[0] == '+' && word[1] != '-';
	return plus ? word.substr(1) : word;
}

} // namespace

bool parseNumber(std::string_view word, double& value)
{
	const std::string_view digits = withoutPlus(word);
	const char* const      end    = digits.data() + digits.size();
	const auto             parsed = std::from_chars(digits.data(), end, value);
	if (parsed.ptr != end) return false;
	if (parsed.ec == std::errc::result_out_of_range) {
		const bool tiny = digits.find("e-") != digits.npos || digits.find("E-") != digits.npos;
		value           = tiny ? 0 : std::numeric_limits<double>::infinity();
		return true;
	}
	return parsed.ec == std::errc();
}

bool parseInteger(std::string_view word, std::int64_t& value)
{
	const std::string_view digits = withoutPlus(word);
	const char* const      end    = digits.data() + digits.size();
	const auto             parsed = std::from_chars(digits.data(), end, value);
	return parsed.ptr == end && parsed.ec == std::errc();
}

TextScanner::TextScanner(std::string_view text, char commentSign, bool joinLines,
						 std::size_t firstLine) :
		at_(text.data()),
		end_(text.data() + text.size()), line_(firstLine), commentSign_(commentSign),
		joinLines_(joinLines)
{
}

/// How many characters a backslash that joins this line to the next one takes here; 0 = none.
std::size_t TextScanner::continuationLength() const
{
	if (!joinLines_ || at_ == end_ || *at_ != '\\') return 0;
	const char* after = at_ + 1;
	if (after != end_ && *after == '\r') ++after;
	return after != end_ && *after == '\n' ? std::size_t(after + 1 - at_) : 0;
}

void TextScanner::skipBlanks()
{
	while (at_ != end_) {
		const std::size_t joint = continuationLength();
		if (joint == 0 && !isBlank(*at_)) break;
		if (joint > 0) ++line_;
		at_ += joint > 0 ? joint : 1;
	}
	if (commentSign_ != 0 && at_ != end_ && *at_ == commentSign_) {
		while (at_ != end_ && *at_ != '\n')
			++at_;
	}
}

std::string_view TextScanner::wordOnLine()
{
	skipBlanks();
	const char* const begin = at_;
	while (at_ != end_ && *at_ != '\n' && !isBlank(*at_) && continuationLength() == 0)
		++at_;
	return {begin, std::size_t(at_ - begin)};
}

std::string_view TextScanner::word()
{
	std::string_view found = wordOnLine();
	while (found.empty() && nextLine())
		found = wordOnLine();
	return found;
}

bool TextScanner::nextLine()
{
	while (at_ != end_ && *at_ != '\n')
		++at_;
	if (at_ == end_) return false;
	++at_;
	++line_;
	return at_ != end_;
}

double TextScanner::number(std::string_view word) const
{
	double value = 0;
	if (!parseNumber(word, value)) fail(quoted(word) + " is not a number");
	return value;
}

std::int64_t TextScanner::integer(std::string_view word) const
{
	std::int64_t value = 0;
	if (!parseInteger(word, value)) fail(quoted(word) + " is not a whole number");
	return value;
}

std::string_view TextScanner::existing(std::string_view word) const
{
	if (word.empty()) failTruncated();
	return word;
}

void TextScanner::fail(const std::string& what) const
{
	throw AppError(ExitCode::BadInput, "line " + std::to_string(line_) + ": " + what);
}

void TextScanner::failTruncated() const
{
	throw AppError(ExitCode::BadInput, "the file ends too early; it seems to be cut off");
}

} // namespace gpr::app
