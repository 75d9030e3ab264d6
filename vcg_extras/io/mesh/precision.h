// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_IO_MESH_PRECISION_H
#define VCG_EXTRAS_IO_MESH_PRECISION_H

#include "mesh_data.h"

#include <vcg_extras/core/results.h>

#include <cstddef>

namespace gpr::app {

/// The largest finite coordinate of a mesh, without its sign.
double largestCoordinate(const MeshView& mesh);

/// Whether floats of this size resolve a thousandth of an edge.
bool floatResolves(double largestCoordinate, double edgeLen);

/// Takes the coordinates of a mesh held in double as floats.
void roundToFloat(InputMesh& mesh);

/// How many faces floats would spoil: faces with a vertex that comes to the place of another
/// vertex, and faces that lose their area or turn by more than 60 degrees. Cost: O(V log V).
std::size_t facesSpoiledByFloat(const TriangleMesh& mesh);

/// Decides whether float suffices for a mesh read from text, held in double so far: float suffices
/// if a thousandth of the mean edge is resolved, for any number of digits in the text. So a text
/// file gives the same mesh as in MeshLab, and a georeferenced mesh keeps its detail.
void settlePrecision(InputMesh& mesh);

} // namespace gpr::app

#endif
