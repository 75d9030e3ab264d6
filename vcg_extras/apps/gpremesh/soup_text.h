// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_SOUP_TEXT_H
#define VCG_EXTRAS_APPS_GPREMESH_SOUP_TEXT_H

#include "ply_header.h"

#include <cstddef>
#include <limits>
#include <string>
#include <string_view>

// Text files made ready for CGAL's readers: what those misread or trip over is taken out here.
// Throws AppError (BadInput) where that shows already that a file is malformed.

namespace gpr::app {

/// What CGAL is given, and what it must find there.
struct SoupText {
	std::string text;
	std::size_t vertexNum       = 0;
	std::size_t faceNum         = 0;
	std::size_t stripBegin      = 0; ///< the first face that is a triangle strip; PLY only
	std::size_t stripNum        = 0;
	std::size_t lineNumShift    = 0;     ///< lines of the file before the text's first one
	bool        ended           = true;  ///< STL only: the last solid is closed
	bool        doublePrecision = false; ///< PLY only: what the header says
};

/// Keywords in lower case, no names of solids, the last solid closed. CGAL 5.5 knows lower case
/// only and takes the name "solid" for a keyword.
SoupText prepareAsciiStl(std::string_view file);

/// A header with the types that CGAL can take and those elements only that matter here; the types
/// of an ASCII file say nothing about how its values are stored. Triangle strips go as faces.
/// CGAL 5.5 reads coordinates as float and double only, indices as 32-bit numbers only.
SoupText prepareAsciiPly(const PlyHeader& header, std::string_view body);

/// The number in the file of the line that the character before a position belongs to.
std::size_t lineAt(const SoupText& soup, std::size_t position);

/// Stands for "nan" and "inf", which streams do not read, until the mesh is made. As an index it is
/// out of range.
constexpr double nonFiniteMark = std::numeric_limits<double>::lowest();

} // namespace gpr::app

#endif
