// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_IO_FORMATS_SOUP_TEXT_H
#define VCG_EXTRAS_IO_FORMATS_SOUP_TEXT_H

#include <cstddef>
#include <limits>
#include <string>
#include <string_view>

// ASCII STL files made ready for CGAL's reader: what that misreads or trips over is taken out here.

namespace gpr::app {

/// What CGAL is given, and what it must find there.
struct SoupText {
	std::string text;
	std::size_t faceNum = 0;
	bool        ended   = true; ///< the last solid is closed
};

/// Keywords in lower case, no names of solids, the last solid closed. CGAL 5.5 knows lower case
/// only and takes the name "solid" for a keyword.
SoupText prepareAsciiStl(std::string_view file);

/// Stands for "nan" and "inf", which streams do not read, until the mesh is made.
constexpr double nonFiniteMark = std::numeric_limits<double>::lowest();

} // namespace gpr::app

#endif
