// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_TILES_TILE_JOIN_H
#define VCG_EXTRAS_APPS_GPREMESH_TILES_TILE_JOIN_H

#include "tile_part.h"

namespace gpr::app {

/// Joins the parts to a PLY file, part after part; a vertex of several parts takes its place in the
/// first of these parts. Does nothing if done before. Throws AppError: (Usage) for a missing part,
/// (BadInput) if a file is damaged or the parts have different properties, (Failure) for a full
/// disk. Memory: some 50 B per shared vertex, and 4 B per vertex of the largest part. Cost: two
/// passes over the parts.
void joinParts(const TilePlan& plan, const RunFolder& folder, const RunLimit& limit,
			   const ProgressCallback& progress);

} // namespace gpr::app

#endif
