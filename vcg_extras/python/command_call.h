// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_PYTHON_COMMAND_CALL_H
#define VCG_EXTRAS_PYTHON_COMMAND_CALL_H

#include <vcg_extras/apps/gpremesh/commands/remesh_words.h>

#include <map>
#include <nanobind/nanobind.h>
#include <string>
#include <vector>

// `gpremesh remesh` behind a parser of Python's, where the program itself was not built.

namespace gpr::python {

/// A dictionary: description, in, out, and options, a list of dictionaries with option, argument
/// (empty: a switch) and help.
nanobind::dict remeshCommandTexts();

/// Runs `gpremesh remesh` and returns its exit code. files: the words that are no options; options:
/// their words by the names that the texts have. Writes to standard output and standard
/// error as the program does, and takes signals for itself.
int runRemeshWords(const std::vector<std::string>&           files,
				   const std::map<std::string, std::string>& options);

} // namespace gpr::python

#endif
