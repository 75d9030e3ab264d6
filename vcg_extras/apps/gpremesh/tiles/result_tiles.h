// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_TILES_RESULT_TILES_H
#define VCG_EXTRAS_APPS_GPREMESH_TILES_RESULT_TILES_H

#include <vcg_extras/io/base/output_file.h>
#include <vcg_extras/io/mesh/mesh_attributes.h>

#include <string>

// A result as a folder of tiles, for viewers that load only visible tiles.

namespace gpr::app {

/// Throws AppError (Failure) if the folder cannot be made: the folder round it is missing or not
/// writable, or the path is not a folder of tiles. For a call before long work.
void checkWritableFolder(const std::string& folder);

/// Writes a mesh as tile0.ply, tile1.ply, ... and tiles.json, with the counts and the box of each
/// tile. Every face is in one tile, and the tiles have about as many faces each; empty tiles are
/// left out. A vertex of several tiles has the same bytes in all of these, so that their borders
/// coincide. Attributes are cut likewise; attributes.lost receives words for attributes without a
/// place in PLY. At commit() the folder appears whole, and replaces an older folder of tiles.
/// Throws AppError (Failure) if writing fails, (Stopped) if the run has to end. tileNum: at least
/// 1. Memory: a tile, and 40 B per face. Cost: O(F log tileNum).
std::unique_ptr<Output> writeTiles(const TriangleMesh& mesh, bool doublePrecision,
								   MeshAttributes& attributes, int tileNum,
								   const std::string& folder, const RunLimit& limit);

} // namespace gpr::app

#endif
