// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_IO_FORMATS_PLY_LAYOUT_H
#define VCG_EXTRAS_IO_FORMATS_PLY_LAYOUT_H

#include "ply_header.h"

// The place of the mesh in a PLY file, among any other content. All functions throw AppError
// (BadInput) if the mesh cannot be found.

namespace gpr::app {

/// Refuses a header with a repeated element of vertices, faces or strips.
void checkElements(const PlyHeader& header);

/// Nothing after the last element of the three is read: files with damaged extras still serve.
std::size_t usefulElementNum(const PlyHeader& header);

/// Which of an element's properties are the coordinates.
struct CoordinateProperties {
	int x = -1, y = -1, z = -1;
};

CoordinateProperties findCoordinates(const PlyElement& e);

/// Whether x, y or z is stored as double or as a whole number of 32 bits.
bool needsDouble(const PlyElement& e, const CoordinateProperties& c);

/// The number of the property with the vertices of a face or strip.
int findIndexList(const PlyElement& e);

/// For an element with more records than the rest of the file can hold.
[[noreturn]] void failTruncated(const PlyElement& e);

} // namespace gpr::app

#endif
