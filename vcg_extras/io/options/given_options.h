// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_IO_OPTIONS_GIVEN_OPTIONS_H
#define VCG_EXTRAS_IO_OPTIONS_GIVEN_OPTIONS_H

#include <vcg_extras/core/parameters.h>

#include <map>
#include <optional>
#include <string>

namespace gpr::app {

/// The options of the engine's parameter table given by the user, with values as words.
using GivenOptions = std::map<const Parameter*, std::string>;

/// A number without trailing zeros.
std::string plainText(double value);

/// The kind of a row of real numbers: "a number", or "auto or a number".
std::string numberKind(const Parameter& p);

/// The range of a row of numbers in words; a given size is above 0: " from 0 to 1000", " above 0,
/// at most 10000".
std::string rangeText(const Parameter& p);

/// Whether a value lies in this range; false for NaN.
bool isInRange(const Parameter& p, double value);

/// The default in the spelling of the user; empty for the size, whose default is a share.
std::string defaultText(const Parameter& p);

/// The name in Python: the option's name with underscores, or another name if Python needs the
/// word.
std::string pythonName(const Parameter& p, Tool tool);

/// The kind of a parameter in a word, for hosts that read the table.
const char* kindName(ParameterKind kind);

/// Whether an option chooses the size of the result; "off" chooses none.
bool choosesSize(const Parameter& row, const std::string& word);

/// The value of a length with a percent sign, such as "0.2%"; none for another word.
std::optional<ParameterValue> percentOf(const Parameter& p, const std::string& word);

/// The engine's options from the given options; all other options keep their defaults. Throws
/// AppError (Usage) for values of the wrong kind or out of range, and for more than one size.
RemeshOptions optionsOf(const GivenOptions& given);

/// The options in a text of textOf. Throws AppError (Usage) for other texts.
RemeshOptions optionsOfText(const std::string& text);

/// The given options in the usual spelling, in alphabetical order: "--lambda 2 --percent 5".
std::string textOf(const GivenOptions& given, bool (*isWanted)(const Parameter&) = nullptr);

} // namespace gpr::app

#endif
