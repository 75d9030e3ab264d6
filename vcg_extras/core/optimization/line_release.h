// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OPTIMIZATION_LINE_RELEASE_H
#define VCG_EXTRAS_CORE_OPTIMIZATION_LINE_RELEASE_H

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/surface/result_mesh.h>

#include <cstdint>

namespace gpr {

// Between relaxation and fit: if feature lines are crowded, lines near poor faces become plain
// edges, and their vertices may move freely. A strip between lines narrower than an edge has acute
// angles as long as every vertex of a line stays on the line. A face is poor if an angle is below
// angleDeg.

/// Whether between 6 and 25 % of the faces at lines are poor. Cost: a pass over the edges round the
/// vertices; parallel.
bool areLinesCrowded(float angleDeg, const ResultMesh& result, Workers& workers);

/// Removes the marks of line edges within two rings of poor faces at lines. A vertex without a
/// marked edge loses its curve and is no corner. Border vertices, pinned vertices and edges to
/// pinned vertices stay. Returns the number of released vertices. The fit then pulls the vertices
/// to the crease edge of the input from both sides; a later search for angles needs a limit on the
/// distance of faces from the surface (PoorFaces::maxGap). Cost: as above, and serial near the poor
/// faces.
std::int64_t releaseLines(float angleDeg, ResultMesh& result, Workers& workers);

} // namespace gpr

#endif
