// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_IO_MESH_PRECISION_H
#define VCG_EXTRAS_IO_MESH_PRECISION_H

#include "mesh_data.h"

namespace gpr::app {

/// The largest finite coordinate of a mesh, without its sign.
double largestCoordinate(const MeshView& mesh);

/// Whether floats of this size resolve a thousandth of an edge.
bool floatResolves(double largestCoordinate, double edgeLen);

/// Takes the coordinates of a mesh held in double as floats.
void roundToFloat(InputMesh& mesh);

/// Decides whether float suffices for a mesh read from text, held in double so far: float suffices
/// if a thousandth of the mean edge is resolved, for any number of digits in the text. So a text
/// file gives the same mesh as in MeshLab, and a georeferenced mesh keeps its detail.
void settlePrecision(InputMesh& mesh);

} // namespace gpr::app

#endif
