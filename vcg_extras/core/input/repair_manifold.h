// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_INPUT_REPAIR_MANIFOLD_H
#define VCG_EXTRAS_CORE_INPUT_REPAIR_MANIFOLD_H

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/indexed_mesh.h>
#include <vcg_extras/core/options.h>
#include <vcg_extras/core/report.h>

namespace gpr {

/// Makes any set of triangles an oriented 2-manifold with border, without moving anything:
/// duplicate faces are dropped; where more than two faces share an edge the smoothest pair stays
/// joined and the others get a border, or all of them do with JunctionMode::Keep; faces are
/// oriented alike, a one-sided surface being cut open; each fan of faces round a vertex gets a
/// vertex of its own. Cut borders stay where they were. link: the opposites of half-edges as
/// connect() leaves them where it fails; used up. Cost: faults are found in linear passes,
/// parallel; the rest as that of the faults, serial, but for faces that are not oriented alike:
/// then all faces are visited in turn.
void repairManifold(IndexedMesh& mesh, Buffer<int>& link, JunctionMode junctions, Workers& workers,
					CleanCounts& counts);

} // namespace gpr

#endif
