// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_IO_TEXT_NUMBER_TEXT_H
#define VCG_EXTRAS_IO_TEXT_NUMBER_TEXT_H

#include <charconv>
#include <cstdint>
#include <string_view>
#include <type_traits>

// Numbers in text. std::from_chars and std::to_chars for real numbers, also with libc++
// (emscripten), whose functions take whole numbers only.

namespace gpr::app {

/// Reads a whole word as a real number in the C locale ("nan" and "inf" included); false for other
/// words. Values too small for a double become 0, too large values infinite.
bool parseNumber(std::string_view word, double& value);

/// Reads a whole word as a whole number; false for other words or too large numbers.
bool parseInteger(std::string_view word, std::int64_t& value);

/// The same as std::from_chars for a real number, by strtod.
template <class Real>
std::from_chars_result readReal(const char* at, const char* end, Real& value);

/// The same as std::to_chars for a finite number, by printf: the fewest digits from which every bit
/// can be read. 40 characters are enough without an exponent.
template <class Real>
char* writeReal(char* at, Real value);

template <class Number, class = void>
struct LibraryReads : std::false_type {
};
template <class Number>
struct LibraryReads<
	Number, std::void_t<decltype(std::from_chars(nullptr, nullptr, std::declval<Number&>()))>>
		: std::true_type {
};

template <class Number, class = void>
struct LibraryWrites : std::false_type {
};
template <class Number>
struct LibraryWrites<
	Number, std::void_t<decltype(std::to_chars(nullptr, nullptr, std::declval<Number>()).ptr)>>
		: std::true_type {
};

/// As std::from_chars.
template <class Number>
std::from_chars_result fromChars(const char* at, const char* end, Number& value)
{
	if constexpr (LibraryReads<Number>::value)
		return std::from_chars(at, end, value);
	else
		return readReal(at, end, value);
}

/// As std::to_chars, which has room enough; returns the end.
template <class Number>
char* toChars(char* at, char* end, Number value)
{
	if constexpr (LibraryWrites<Number>::value)
		return std::to_chars(at, end, value).ptr;
	else
		return writeReal(at, value);
}

} // namespace gpr::app

#endif
