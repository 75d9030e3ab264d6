// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_COMPARE_EMBEDDED_VIEWER_H
#define VCG_EXTRAS_APPS_GPREMESH_COMPARE_EMBEDDED_VIEWER_H

#include <string>

// The files of the folder viewer and three.js; CMake makes the functions from these files.

namespace gpr::app {

std::string viewerScript();
std::string viewerStyle();
std::string viewerMarkup();
std::string threeLicence();
/// Empty if the program was built without three.js.
std::string threeScript();

} // namespace gpr::app

#endif
