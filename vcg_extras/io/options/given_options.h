// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_IO_OPTIONS_GIVEN_OPTIONS_H
#define VCG_EXTRAS_IO_OPTIONS_GIVEN_OPTIONS_H

#include <vcg_extras/core/parameters.h>

#include <map>
#include <optional>
#include <string>

namespace gpr::app {

/// The options of the engine's parameter table that the user gave, their values as words.
using GivenOptions = std::map<const Parameter*, std::string>;

/// The default as the user would write it; empty for the size, whose default is a share.
std::string defaultText(const Parameter& p);

/// What Python calls it: the option's name with underscores, and other names where Python has a use
/// of its own for it.
std::string pythonName(const Parameter& p, Tool tool);

/// The kind of a parameter in a word, for hosts that read the table.
const char* kindName(ParameterKind kind);

/// Whether an option chooses the size of the result; "off" chooses none.
bool choosesSize(const Parameter& row, const std::string& word);

/// The value of a length that is given with a percent sign, such as "0.2%"; none if the word is
/// another one.
std::optional<ParameterValue> percentOf(const Parameter& p, const std::string& word);

/// The engine's options from what was given; all others keep their defaults. Throws AppError
/// (Usage) for values of the wrong kind or out of range, and for more than one size.
RemeshOptions optionsOf(const GivenOptions& given);

/// The options that textOf has written. Throws AppError (Usage) for others.
RemeshOptions optionsOfText(const std::string& text);

/// What was given as one writes it, in alphabetical order: "--lambda 2 --percent 5".
std::string textOf(const GivenOptions& given, bool (*isWanted)(const Parameter&) = nullptr);

} // namespace gpr::app

#endif
