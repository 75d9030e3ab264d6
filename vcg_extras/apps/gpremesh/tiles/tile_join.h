// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_TILES_TILE_JOIN_H
#define VCG_EXTRAS_APPS_GPREMESH_TILES_TILE_JOIN_H

#include "tile_part.h"

namespace gpr::app {

/// Puts the parts together into one PLY file: part after part, a vertex that several have where the
/// first of them has it. Does nothing where that was done. Throws AppError: (Usage) where a part
/// was not made yet, (BadInput) where a file is damaged or the parts have different properties,
/// (Failure) where the disk is full. Memory: some 50 B a shared vertex, and 4 B a vertex of the
/// largest part. Cost: two passes over the parts.
void joinParts(const TilePlan& plan, const RunFolder& folder, const RunLimit& limit,
			   const ProgressCallback& progress);

} // namespace gpr::app

#endif
