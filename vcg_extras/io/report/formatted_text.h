// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_IO_REPORT_FORMATTED_TEXT_H
#define VCG_EXTRAS_IO_REPORT_FORMATTED_TEXT_H

#include <cstdint>
#include <string>

namespace gpr::app {

/// printf into a string of at most 511 characters; the program never leaves the C locale, so the
/// decimal sign is a point.
#ifdef __GNUC__
__attribute__((format(printf, 1, 2))) // the compiler checks the arguments
#endif
std::string
formatted(const char* format, ...);

/// Breaks a text into lines of at most `width` characters; `indent` goes before all lines but the
/// first, and counts.
std::string wrapped(const std::string& text, std::size_t width, const std::string& indent = "");

/// "1,234,567": large counts are read more easily in groups.
std::string grouped(std::int64_t count);

} // namespace gpr::app

#endif
