// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_INPUT_REPAIR_MANIFOLD_H
#define VCG_EXTRAS_CORE_INPUT_REPAIR_MANIFOLD_H

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/indexed_mesh.h>
#include <vcg_extras/core/options.h>
#include <vcg_extras/core/report.h>

namespace gpr {

/// Makes any set of triangles an oriented 2-manifold with border. Drops duplicate faces. At an edge
/// of more than two faces the smoothest pairs stay linked and the rest get a border; with
/// JunctionMode::Keep all faces get a border. Orients faces consistently; cuts a one-sided surface
/// open. Gives each fan of faces at a vertex a vertex of its own. Cut borders stay in place; tips
/// of closed fans are drawn apart, unless keepsPlaces. link: the opposites of half-edges after a
/// failed connect(); used up. Cost: linear parallel passes to find faults; serial work linear in
/// the faults. Inconsistent orientation takes a serial pass over all faces.
void repairManifold(IndexedMesh& mesh, Buffer<int>& link, JunctionMode junctions, bool keepsPlaces,
					Workers& workers, CleanCounts& counts);

} // namespace gpr

#endif
