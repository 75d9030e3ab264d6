// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_TILES_TILE_SPLIT_H
#define VCG_EXTRAS_APPS_GPREMESH_TILES_TILE_SPLIT_H

#include "border_split.h"
#include "tile_plan.h"

#include <vcg_extras/core/progress.h>
#include <vcg_extras/io/base/run_limit.h>

#include <cstdint>
#include <string>
#include <vector>

namespace gpr::app {

/// The figures of the split, for the next steps.
struct SplitFacts {
	struct Tile {
		std::uint64_t vertexNum = 0, faceNum = 0;
		double        area = 0;
		FileStamp     mesh, names;
	};
	std::vector<Tile> tiles;

	double area() const;
	/// Whether the input is a triangle soup: no two faces have a common vertex.
	bool isSoup() const;
};

/// Cuts the inputs into tiles: each vertex belongs to its cell, each face to the lowest cell of its
/// corners. Vertices and faces are read once, in the order of the files; then each tile becomes a
/// PLY file with all properties of its vertices and faces. Does nothing if done before. Throws
/// AppError: (BadInput) for an input that is damaged or has changed since the plan, (Failure) for a
/// full disk, (Stopped) if the run has to end. Memory: 2 B per vertex, and some 50 B per face of a
/// tile. Cost: two passes over the input, and as much written.
SplitFacts split(const TilePlan& plan, const RunFolder& folder, const RunLimit& limit,
				 const ProgressCallback& progress);

/// The names of the vertices of a tile or part, in a file beside its mesh.
std::vector<SharedName> readNames(const std::string& path);
FileStamp               writeNames(const std::vector<SharedName>& names, const std::string& path,
								   const RunLimit& limit);

/// Throws AppError (Usage) if the split was not done.
SplitFacts readSplit(const TilePlan& plan, const RunFolder& folder);

} // namespace gpr::app

#endif
