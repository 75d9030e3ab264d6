// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "number_text.h"

#include "char_conversion.h"

#include <limits>

namespace gpr::app {

namespace {

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
