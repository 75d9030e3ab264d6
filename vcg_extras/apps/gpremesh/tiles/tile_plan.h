// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_TILES_TILE_PLAN_H
#define VCG_EXTRAS_APPS_GPREMESH_TILES_TILE_PLAN_H

#include "cell_tree.h"
#include "ply_records.h"
#include "run_folder.h"

#include <vcg_extras/core/options.h>

#include <cstdint>
#include <string>
#include <vector>

namespace gpr::app {

/// What is asked for of a run in tiles.
struct TileRequest {
	std::vector<std::string> inputs;          ///< pieces of one surface
	RemeshOptions            options;         ///< of the result
	std::string              optionsText;     ///< these as the user gave them
	double                   memoryBytes = 0; ///< at most, of each process; 0: not limited
	int                      tileNum     = 0; ///< 0: by the memory
};

/// All that the steps of a run in tiles need to know. It depends on the inputs and the options
/// alone, never on who runs the steps: so the same plan gives the same bytes.
struct TilePlan {
	std::vector<std::string>   inputs;
	std::vector<std::uint64_t> vertexNum; ///< per input
	std::vector<std::uint64_t> faceNum;
	std::string                optionsText;
	RemeshOptions              options;
	double                     memoryBytes = 0;
	CellTree                   cells; ///< one a tile
	std::string                name;  ///< a checksum of all this: steps of another plan differ

	std::uint64_t allVertices() const;
	std::uint64_t allFaces() const;
	int           tileNum() const { return cells.cellNum(); }
};

/// Memory that a run takes without tiles, bytes, about.
double bytesUntiled(double faceNum, double resultVertexNum);

/// Vertices of the result where options name a count or a share; 0 where they name an edge length.
double resultVertexNum(const RemeshOptions& options, double inputVertexNum);

/// Reads the headers and a sample of the vertices. The inputs are binary PLY files here. Throws
/// AppError: (BadInput) for files that cannot be read in tiles, (Usage) for options that tiles do
/// not serve, (PromiseBroken) where the memory is too small for the result. Cost: 100,000 reads.
TilePlan makePlan(const TileRequest& request);

/// Writes the plan into the folder, which is made. An equal plan that is there is left alone;
/// throws AppError (Usage) for another one.
void writePlan(const TilePlan& plan, const RunFolder& folder);
/// Throws AppError (Usage) where there is none, or an input has changed since.
TilePlan readPlan(const RunFolder& folder);

/// Vertices of the condensed surface for one of the result: four, and fewer where so many do not
/// fit into the memory of the last step. That is not limited where memoryBytes is 0.
double condensedDensity(double resultVertexNum, double memoryBytes);

/// What the files of the run take of the disk at most, bytes, about, without converted inputs.
double diskBytesOf(const TilePlan& plan);

/// Throws AppError (PromiseBroken) where the last step needs more memory than the plan allows.
void requireMemoryFor(double resultVertexNum, double memoryBytes);
/// The same for a condensed surface that has more faces than it should, where tiles could not be
/// condensed.
void requireMemoryForFaces(double condensedFaceNum, double memoryBytes);

} // namespace gpr::app

#endif
