// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formatted_text.h"

#include <cstdarg>
#include <cstdio>
#include <sstream>

namespace gpr::app {

std::string formatted(const char* format, ...)
{
	char         text[512];
	std::va_list arguments;
	va_start(arguments, format);
	std::vsnprintf(text, sizeof text, format, arguments);
	va_end(arguments);
	return text;
}

std::string wrapped(const std::string& text, std::size_t width, const std::string& indent)
{
	std::istringstream words(text);
	std::string        lines, line;
	for (std::string word; words >> word;) {
		if (!line.empty() && line.size() + 1 + word.size() > width) {
			lines += line + "\n";
			line = indent + word;
		}
		else {
			line += (line.empty() ? "" : " ") + word;
		}
	}
	return lines + line;
}

std::string grouped(std::int64_t count)
{
	std::string digits = std::to_string(count);
	for (int at = int(digits.size()) - 3; at > (count < 0 ? 1 : 0); at -= 3) {
		digits.insert(std::size_t(at), ",");
	}
	return digits;
}

} // namespace gpr::app
