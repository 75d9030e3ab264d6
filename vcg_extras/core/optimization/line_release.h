// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OPTIMIZATION_LINE_RELEASE_H
#define VCG_EXTRAS_CORE_OPTIMIZATION_LINE_RELEASE_H

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/surface/result_mesh.h>

#include <cstdint>

namespace gpr {

// Between relaxation and fit: where feature lines are crowded, those near poor faces become plain
// edges, and their vertices may go anywhere. Strips between lines that are narrower than an edge
// have acute angles as long as every vertex of a line stays on it. A face is poor where it has an
// angle below angleDeg.

/// Whether between 6 and 25 % of the faces at lines are poor. Cost: a pass over the edges round the
/// vertices; parallel.
bool areLinesCrowded(float angleDeg, const ResultMesh& result, Workers& workers);

/// Takes the marks off the edges of lines within two rings of poor faces at lines. A vertex that is
/// on no marked edge any more loses its curve and is no corner. Vertices of borders and pinned ones
/// stay as they are, and so do edges that end in pinned ones. Returns how many vertices were
/// released. The fit then draws them to the sharp edge from both sides; what raises angles after it
/// needs a limit on how far faces get from the surface (PoorFaces::maxGap). Cost: as above, and
/// serial near the poor faces.
std::int64_t releaseLines(float angleDeg, ResultMesh& result, Workers& workers);

} // namespace gpr

#endif
