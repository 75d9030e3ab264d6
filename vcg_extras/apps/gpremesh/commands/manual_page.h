// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_COMMANDS_MANUAL_PAGE_H
#define VCG_EXTRAS_APPS_GPREMESH_COMMANDS_MANUAL_PAGE_H

#include <CLI/App.hpp>
#include <string>

namespace gpr::app {

/// The program's manual page, gpremesh(1), in the language of man(7), made from the parser's
/// commands and options: the page has the content of --help.
std::string manualPage(const CLI::App& program);

} // namespace gpr::app

#endif
