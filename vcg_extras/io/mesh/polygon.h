// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_IO_MESH_POLYGON_H
#define VCG_EXTRAS_IO_MESH_POLYGON_H

#include <vcg_extras/core/vec.h>

#include <cstddef>
#include <vector>

namespace gpr::app {

/// Cuts a polygon into corners.size() - 2 triangles by clipping ears: a convex polygon becomes the
/// fan around its first corner, a concave polygon is covered without folds. A polygon that crosses
/// itself or has no area is cut somehow, and a polygon of more than 500 corners as a fan. The
/// corners need no common plane. triangles receives three corner numbers each.
void cutPolygon(const std::vector<Vec3d>& corners, std::vector<std::size_t>& triangles);

} // namespace gpr::app

#endif
