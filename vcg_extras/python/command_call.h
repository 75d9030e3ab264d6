// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_PYTHON_COMMAND_CALL_H
#define VCG_EXTRAS_PYTHON_COMMAND_CALL_H

#include <vcg_extras/apps/gpremesh/commands/remesh_words.h>

#include <map>
#include <nanobind/nanobind.h>
#include <string>
#include <vector>

// `gpremesh remesh` with a Python parser, for packages built without the program.

namespace gpr::python {

/// The texts of the command, as a dictionary: description, in, out, and options, a list of
/// dictionaries with option, argument (empty: a switch) and help.
nanobind::dict remeshCommandTexts();

/// Runs `gpremesh remesh` and returns the exit code. files: the arguments that are no options;
/// options: the values of options, by the names in the texts. Writes to standard output and
/// standard error like the program, and handles signals itself.
int runRemeshWords(const std::vector<std::string>&           files,
				   const std::map<std::string, std::string>& options);

} // namespace gpr::python

#endif
