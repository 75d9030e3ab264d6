// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_IO_TEXT_NUMBER_TEXT_H
#define VCG_EXTRAS_IO_TEXT_NUMBER_TEXT_H

#include <cstdint>
#include <string_view>

namespace gpr::app {

/// Reads a whole word as a real number in the C locale ("nan" and "inf" included); false for other
/// words. Values too small for a double become 0, too large values infinite.
bool parseNumber(std::string_view word, double& value);

/// Reads a whole word as a whole number; false for other words or too large numbers.
bool parseInteger(std::string_view word, std::int64_t& value);

} // namespace gpr::app

#endif
