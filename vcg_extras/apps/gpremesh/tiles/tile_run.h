// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_TILES_TILE_RUN_H
#define VCG_EXTRAS_APPS_GPREMESH_TILES_TILE_RUN_H

#include <vcg_extras/apps/gpremesh/commands/command_line.h>
#include <vcg_extras/io/base/stopwatch.h>

namespace gpr::app {

/// Whether a run of 'gpremesh remesh --memory' has to be done in tiles. Reads the header of the
/// input. Throws AppError (BadInput) for an input that is too large and has a format that tiles do
/// not read.
bool needsTiles(const CommandLine& line);

/// Runs all steps of a run in tiles in turn, in the folder of the command line or in OUT.tiles;
/// continues an earlier run of the same command. Removes the folder at the end, but keeps the
/// folder after a failure. Throws AppError.
void remeshInTiles(const CommandLine& line, const Stopwatch& programClock);

/// One step: 'gpremesh tile'. Prints a line of JSON. Throws AppError.
void runTileStep(const CommandLine& line, const Stopwatch& programClock);

} // namespace gpr::app

#endif
