// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "number_text.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <string>

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

template <class Real>
Real ofWord(const char* word)
{
	if constexpr (std::is_same_v<Real, double>)
		return std::strtod(word, nullptr);
	else
		return std::strtof(word, nullptr);
}

bool isRangeError(const std::string& word, double value)
{
	const std::string_view digits(word.data(), std::min(word.find_first_of("eE"), word.size()));
	if (std::isinf(value)) return digits.find_first_of("iI") == digits.npos;
	return value == 0 && digits.find_first_of("123456789") != digits.npos;
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
		} while (ofWord<Real>(text) != value);
		exponent = std::atoi(std::strchr(text, 'e') + 1);
	}
};

std::string_view withoutPlus(std::string_view word)
{
	const bool plus = word.size() > 1 && word[0] == '+' && word[1] != '-';
	return plus ? word.substr(1) : word;
}

} // namespace

template <class Real>
std::from_chars_result readReal(const char* at, const char* end, Real& value)
{
	const char* const last = endOfReal(at, end);
	if (last == nullptr) return {at, std::errc::invalid_argument};
	const std::string word(at, last);
	const Real        parsed = ofWord<Real>(word.c_str());
	if (isRangeError(word, double(parsed))) return {last, std::errc::result_out_of_range};
	value = parsed;
	return {last, std::errc()};
}

template <class Real>
char* writeReal(char* at, Real value)
{
	const Scientific s(value);
	// As an integer times a power of ten; by this the shorter way of writing is known.
	const int power = s.exponent - (s.digitNum - 1), single = s.digitNum == 1 ? 1 : 0;
	if (power < -(s.digitNum + 3) + single || power > 5 - single)
		return at + std::sprintf(at, "%s", s.text);
	return at + std::sprintf(at, "%.*f", std::max(0, -power), double(value));
}

template std::from_chars_result readReal(const char*, const char*, double&);
template std::from_chars_result readReal(const char*, const char*, float&);
template char*                  writeReal(char*, double);
template char*                  writeReal(char*, float);

bool parseNumber(std::string_view word, double& value)
{
	const std::string_view digits = withoutPlus(word);
	const char* const      end    = digits.data() + digits.size();
	const auto             parsed = fromChars(digits.data(), end, value);
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
	const auto             parsed = fromChars(digits.data(), end, value);
	return parsed.ptr == end && parsed.ec == std::errc();
}

} // namespace gpr::app
