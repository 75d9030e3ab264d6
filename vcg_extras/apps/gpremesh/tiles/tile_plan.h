// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_TILES_TILE_PLAN_H
#define VCG_EXTRAS_APPS_GPREMESH_TILES_TILE_PLAN_H

#include "cell_tree.h"
#include "ply_records.h"
#include "run_folder.h"

#include <vcg_extras/apps/gpremesh/commands/command_line.h>

#include <cstdint>
#include <string>
#include <vector>

namespace gpr::app {

/// The plan of a run in tiles, for all steps. The plan depends on the inputs and the options alone:
/// the same plan gives the same bytes on any machine.
struct TilePlan {
	std::vector<std::string>   inputs;
	std::vector<std::uint64_t> vertexNum; ///< per input
	std::vector<std::uint64_t> faceNum;
	std::string                optionsText;
	RemeshOptions              options;
	double                     memoryBytes = 0;
	CellTree                   cells; ///< a cell per tile
	std::string                name;  ///< a checksum of the plan: tells steps of different plans
									  ///< apart

	std::uint64_t allVertices() const;
	std::uint64_t allFaces() const;
	int           tileNum() const { return cells.cellNum(); }
};

/// Approximate memory of a run without tiles, bytes.
double bytesUntiled(double faceNum, double resultVertexNum);

/// Vertices of the result if options name a count or a share; 0 if options name an edge length.
double resultVertexNum(const RemeshOptions& options, double inputVertexNum);

/// Makes a plan from the headers and a sample of the vertices. options: of the result. The inputs
/// must be binary PLY files.
/// Throws AppError: (BadInput) for files that cannot be read in tiles, (Usage) for options without
/// support in tiles, (PromiseBroken) if the memory is too small for the result. Cost: 100,000
/// reads.
TilePlan makePlan(const RemeshOptions& options, const TileSettings& settings);

/// Writes the plan into the folder, which is made. Keeps an equal plan in the folder; throws
/// AppError (Usage) for a different plan.
void writePlan(const TilePlan& plan, const RunFolder& folder);
/// Throws AppError (Usage) if there is no plan, or an input has changed since.
TilePlan readPlan(const RunFolder& folder);

/// Vertices of the condensed surface per vertex of the result: four, or fewer if the memory of the
/// last step is too small for four. memoryBytes 0: unlimited.
double condensedDensity(double resultVertexNum, double memoryBytes);

/// Approximate peak disk space of the run, bytes, without converted inputs.
double diskBytesOf(const TilePlan& plan);

/// Throws AppError (PromiseBroken) if the last step needs more memory than the plan allows.
void requireMemoryFor(double resultVertexNum, double memoryBytes);
/// The same for a condensed surface with more faces than planned, as some tiles could not be
/// condensed.
void requireMemoryForFaces(double condensedFaceNum, double memoryBytes);

} // namespace gpr::app

#endif
