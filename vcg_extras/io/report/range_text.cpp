// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "range_text.h"

#include <cmath>
#include <locale>
#include <sstream>

namespace gpr::app {

namespace {

/// A size of 0 means "off" in the dialog; elsewhere a missing size is off, and 0 a mistake.
bool isAboveMinimum(const Parameter& p)
{
	return isSizeParameter(p) && p.minimum == 0;
}

} // namespace

std::string plainText(double value)
{
	std::ostringstream text;
	text.imbue(std::locale::classic());
	text.precision(10);
	text << value;
	return text.str();
}

std::string numberKind(const Parameter& p)
{
	return p.isAutomatic ? std::string(automaticName) + " or a number" : "a number";
}

std::string rangeText(const Parameter& p)
{
	const bool  open = isAboveMinimum(p);
	std::string text = open ? " above 0" : " from " + plainText(p.minimum);
	if (p.maximum < 1e100) text += (open ? ", at most " : " to ") + plainText(p.maximum);
	return text;
}

bool isInRange(const Parameter& p, double value)
{
	if (!std::isfinite(value) || (isAboveMinimum(p) && value <= 0)) return false;
	return value >= p.minimum && value <= p.maximum;
}

} // namespace gpr::app
