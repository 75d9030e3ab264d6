// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "char_conversion.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>

namespace gpr::app {

namespace {

bool isDigit(char c)
{
	return c >= '0' && c <= '9';
}

const char* endOfDigits(const char* at, const char* end)
{
	return std::find_if_not(at, end, isDigit);
}

/// The place after the word, in lower or upper case; null for another text.
const char* behindWord(const char* at, const char* end, std::string_view word)
{
	if (std::size_t(end - at) < word.size()) return nullptr;
	const bool same = std::equal(word.begin(), word.end(), at,
								 [](char a, char b) { return a == (b | ('a' ^ 'A')); });
	return same ? at + word.size() : nullptr;
}

/// The place after "e-5"; the same place without an exponent.
const char* endOfExponent(const char* at, const char* end)
{
	if (at == end || (*at != 'e' && *at != 'E')) return at;
	const char* digits = at + 1;
	if (digits != end && (*digits == '+' || *digits == '-')) ++digits;
	const char* const last = endOfDigits(digits, end);
	return last == digits ? at : last;
}

/// The place after a decimal number, since strtod would read farther; null without a number.
const char* endOfReal(const char* at, const char* end)
{
	if (at != end && *at == '-') ++at;
	for (const std::string_view word : {"infinity", "inf", "nan"})
		if (const char* const behind = behindWord(at, end, word)) return behind;
	const char* last  = endOfDigits(at, end);
	auto        found = last - at;
	if (last != end && *last == '.') {
		const char* const behind = endOfDigits(last + 1, end);
		found += behind - last - 1;
		last = behind;
	}
	return found == 0 ? nullptr : endOfExponent(last, end);
}

double ofWord(const char* word, double)
{
	return std::strtod(word, nullptr);
}

float ofWord(const char* word, float)
{
	return std::strtof(word, nullptr);
}

bool isRangeError(const std::string& word, double value)
{
	const std::string_view digits(word.data(), std::min(word.find_first_of("eE"), word.size()));
	if (std::isinf(value)) return digits.find_first_of("iI") == digits.npos;
	return value == 0 && digits.find_first_of("123456789") != digits.npos;
}

template <class Real>
std::from_chars_result read(const char* at, const char* end, Real& value)
{
	const char* const last = endOfReal(at, end);
	if (last == nullptr) return {at, std::errc::invalid_argument};
	const std::string word(at, last);
	const Real        parsed = ofWord(word.c_str(), Real());
	if (isRangeError(word, double(parsed))) return {last, std::errc::result_out_of_range};
	value = parsed;
	return {last, std::errc()};
}

/// A number as "d.ddde-05".
struct Scientific {
	char text[40];
	int  digitNum = 0;
	int  exponent = 0;

	/// With the fewest digits from which every bit can be read.
	template <class Real>
	explicit Scientific(Real value)
	{
		do {
			std::snprintf(text, sizeof text, "%.*e", digitNum++, double(value));
		} while (ofWord(text, Real()) != value);
		exponent = std::atoi(std::strchr(text, 'e') + 1);
	}
};

template <class Real>
char* write(char* at, Real value)
{
	const Scientific s(value);
	// As an integer times a power of ten; by this the shorter way of writing is known.
	const int power = s.exponent - (s.digitNum - 1), single = s.digitNum == 1 ? 1 : 0;
	if (power < -(s.digitNum + 3) + single || power > 5 - single)
		return at + std::sprintf(at, "%s", s.text);
	return at + std::sprintf(at, "%.*f", std::max(0, -power), double(value));
}

} // namespace

std::from_chars_result readReal(const char* at, const char* end, double& value)
{
	return read(at, end, value);
}

std::from_chars_result readReal(const char* at, const char* end, float& value)
{
	return read(at, end, value);
}

char* writeReal(char* at, double value)
{
	return write(at, value);
}

char* writeReal(char* at, float value)
{
	return write(at, value);
}

} // namespace gpr::app
