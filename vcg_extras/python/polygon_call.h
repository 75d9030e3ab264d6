// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_PYTHON_POLYGON_CALL_H
#define VCG_EXTRAS_PYTHON_POLYGON_CALL_H

#include "arrays.h"

#include <nanobind/nanobind.h>

namespace gpr::python {

/// Cuts polygons into triangles like the readers of the command line: first the triangles,
/// unchanged, then the parts of larger polygons. Returns the corners of the triangles, three per
/// triangle, as numbers into `corners`. `sizes` has the number of corners of each polygon, at least
/// 3. The indices must be in range.
nb::object cutPolygons(const Positions& positions, const Indices& corners, const Indices& sizes);

} // namespace gpr::python

#endif
