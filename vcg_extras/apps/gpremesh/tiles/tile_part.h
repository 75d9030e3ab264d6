// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_TILES_TILE_PART_H
#define VCG_EXTRAS_APPS_GPREMESH_TILES_TILE_PART_H

#include "border_split.h"
#include "tile_split.h"

namespace gpr::app {

/// What became of one tile.
struct PartFacts {
	std::uint64_t vertexNum = 0, faceNum = 0;
	bool          isCondensed = false; ///< else it was taken as it is
	std::string   note;                ///< a sentence where it could not be condensed, or empty
	FileStamp     mesh, names;
};

/// Condenses one tile: remeshes it by the preset 'fast' and a quick fit, with sizes that follow the
/// error and the density of condensedDensity(), all vertices of its border kept. Long edges of the
/// border are split before. A tile that is not denser than that is taken as it is, and so is one
/// that cannot be remeshed with all the vertices and edges that it shares. Does nothing where that
/// was done. Throws AppError: (BadInput) where a file of the tile is damaged, (Stopped), (Failure)
/// without memory or disk. Cost: that of a fast run on the tile.
PartFacts makePart(const TilePlan& plan, const SplitFacts& split, int tile, const RunFolder& folder,
				   const RunLimit& limit, const ProgressCallback& progress);

/// Null where the part was not made yet.
std::optional<PartFacts> readPart(const TilePlan& plan, int tile, const RunFolder& folder);

/// Vertices of the result, by the options and the area of the input.
double resultVertexNum(const TilePlan& plan, const SplitFacts& split);

} // namespace gpr::app

#endif
