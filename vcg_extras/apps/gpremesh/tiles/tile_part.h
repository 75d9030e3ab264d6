// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_TILES_TILE_PART_H
#define VCG_EXTRAS_APPS_GPREMESH_TILES_TILE_PART_H

#include "tile_split.h"

namespace gpr::app {

/// The outcome of a tile.
struct PartFacts {
	std::uint64_t vertexNum = 0, faceNum = 0;
	bool          isCondensed = false; ///< false: the tile was taken unchanged
	std::string   note;                ///< a sentence if the tile could not be condensed, or empty
	FileStamp     mesh, names;
};

/// Condenses a tile: remeshes the tile by the preset 'fast' and a quick fit, with sizes that follow
/// the error, with condensedDensity(), and with all border vertices kept. Long border edges are
/// split before. A tile is taken unchanged if it has no higher density, or if a remeshing would
/// lose shared vertices or edges. Does nothing if done before. Throws AppError: (BadInput) for a
/// damaged file of the tile, (Stopped), (Failure) without memory or disk. Cost: a fast run on the
/// tile.
PartFacts makePart(const TilePlan& plan, const SplitFacts& split, int tile, const RunFolder& folder,
				   const RunLimit& limit, const ProgressCallback& progress);

/// Null if the part is missing.
std::optional<PartFacts> readPart(const TilePlan& plan, int tile, const RunFolder& folder);

/// Joins the parts to a PLY file, part after part; a vertex of several parts takes its place in the
/// first of these parts. Does nothing if done before. Throws AppError: (Usage) for a missing part,
/// (BadInput) if a file is damaged or the parts have different properties, (Failure) for a full
/// disk. Memory: some 50 B per shared vertex, and 4 B per vertex of the largest part. Cost: two
/// passes over the parts.
void joinParts(const TilePlan& plan, const RunFolder& folder, const RunLimit& limit,
			   const ProgressCallback& progress);

/// Vertices of the result, from the options and the area of the input.
double resultVertexNum(const TilePlan& plan, const SplitFacts& split);

} // namespace gpr::app

#endif
