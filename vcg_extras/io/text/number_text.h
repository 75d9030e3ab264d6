// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_IO_TEXT_NUMBER_TEXT_H
#define VCG_EXTRAS_IO_TEXT_NUMBER_TEXT_H

#include <cstdint>
#include <string_view>

namespace gpr::app {

/// Reads a whole word as a real number in the C locale ("nan" and "inf" included); false when it is
/// none. Values too small for a double become 0, too large ones infinite.
bool parseNumber(std::string_view word, double& value);

/// Reads a whole word as a whole number; false when it is none or does not fit.
bool parseInteger(std::string_view word, std::int64_t& value);

} // namespace gpr::app

#endif
