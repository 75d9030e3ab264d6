// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_IO_REPORT_RANGE_TEXT_H
#define VCG_EXTRAS_IO_REPORT_RANGE_TEXT_H

#include <vcg_extras/core/parameters.h>

#include <string>

namespace gpr::app {

/// A number without trailing zeros.
std::string plainText(double value);

/// The kind of a row of real numbers: "a number", or "auto or a number".
std::string numberKind(const Parameter& p);

/// The range of a row of numbers in words; a given size is above 0: " from 0 to 1000", " above 0,
/// at most 10000".
std::string rangeText(const Parameter& p);

/// Whether a value lies in this range; false for NaN.
bool isInRange(const Parameter& p, double value);

} // namespace gpr::app

#endif
