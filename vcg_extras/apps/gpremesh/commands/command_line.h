// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_COMMANDS_COMMAND_LINE_H
#define VCG_EXTRAS_APPS_GPREMESH_COMMANDS_COMMAND_LINE_H

#include <vcg_extras/core/options.h>
#include <vcg_extras/io/mesh/attribute_carry.h>
#include <vcg_extras/io/options/given_options.h>

#include <cstdint>
#include <string>
#include <vector>

namespace gpr::app {

/// In the order of commandNames.
enum class Command {
	Remesh,
	Levels,
	Info,
	Features,
	Compare,
	Tile,
	None, ///< --help, --version or --manual-page: printed already
};

/// The place of a level's number in OUT of levels.
constexpr const char* levelPlace = "{level}";

/// Sizes of levels, all of the same kind: percent, vertices or faces.
struct LevelSizes {
	TargetMode          mode = TargetMode::Percent;
	std::vector<double> sizes;
};

enum class TileStep { Plan, Split, Part, Join, Finish };

/// Settings of runs in tiles.
struct TileSettings {
	TileStep                 step = TileStep::Plan;
	std::string              folder;      ///< of the run; remesh: empty = OUT.tiles
	std::vector<std::string> inputs;      ///< of 'tile plan'
	std::string              optionsText; ///< the options that a plan depends on
	int                      unit        = 0;
	int                      tileNum     = 0; ///< 0 = by the memory
	std::uint64_t            memoryBytes = 0; ///< 0 = unlimited
};

/// A checked command line.
struct CommandLine {
	Command     command = Command::None;
	std::string input;
	/// remesh with several files: all files, written into the folder `output`; else empty
	std::vector<std::string> pieces;
	std::string              output; ///< remesh, 'tile finish' and features only
	std::string              report; ///< remesh and features only; empty = none
	int         outTileNum = 0; ///< remesh and 'tile finish': OUT is a folder of tiles; 0 = a file
	bool        quiet      = false;
	bool        json       = false;        ///< info and compare only
	bool        isotropic  = false;        ///< compare only
	int         runNum     = 1;            ///< compare only
	std::string regions;                   ///< remesh only: see regionsOf
	Transfer    transfer = Transfer::Auto; ///< remesh only
	std::string htmlFolder;                ///< compare only; empty = no page
	RemeshOptions       options;           ///< all but info
	std::vector<double> period;            ///< remesh: lengths of a periodic cell; empty = none
	std::string         sizes;             ///< remesh: name of a vertex property; empty = none
	std::string         optionsText;       ///< options as given: "--lambda 2 --preset fast"
	LevelSizes          levels;            ///< levels only
	TileSettings        tiles;             ///< tile, and remesh with --memory

	std::vector<std::string> notes; ///< sentences that the program adds to the report
	double shareDone = 0;           ///< remesh: share of the whole work done before, for the
									///< progress bar
};

/// Path of the result of one of several files.
std::string pathOfPiece(const CommandLine& line, const std::string& piece);

/// "tiles/" is "tiles".
std::string withoutSlashAtEnd(const std::string& path);

/// Whether the plan of a run in tiles depends on an option; each step takes all other options anew.
bool isForPlan(const Parameter& p);

/// Takes the options of the table into the line and checks the whole line. Throws AppError (Usage)
/// with a sentence on any mistake.
void complete(const GivenOptions& given, CommandLine& line);

} // namespace gpr::app

#endif
