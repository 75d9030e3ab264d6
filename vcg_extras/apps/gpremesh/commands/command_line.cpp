// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_line.h"

#include "commands.h"

#include <vcg_extras/io/base/exit_code.h>
#include <vcg_extras/io/mesh_io.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

namespace gpr::app {

namespace {

/// Links followed; files that do not exist yet have the same path.
bool sameFile(const std::string& a, const std::string& b)
{
	namespace fs = std::filesystem;
	std::error_code error;
	return fs::equivalent(a, b, error) ||
		   fs::weakly_canonical(a, error) == fs::weakly_canonical(b, error);
}

void checkReport(const CommandLine& line)
{
	if (line.report.empty()) return;
	std::vector<std::string> files = {line.input, line.output};
	for (const std::string& piece : line.pieces)
		files.insert(files.end(), {piece, pathOfPiece(line, piece)});
	for (std::size_t i = 0; i < line.levels.sizes.size(); ++i)
		files.push_back(pathOfLevel(line.output, i + 1));
	for (const std::string& file : files) {
		if (sameFile(line.report, file))
			failUsage("--report must name another file than IN and OUT.");
	}
}

bool isInput(const std::string& path, const CommandLine& line)
{
	std::error_code error;
	return std::filesystem::exists(path, error) &&
		   std::any_of(line.pieces.begin(), line.pieces.end(),
					   [&](const std::string& piece) { return sameFile(path, piece); });
}

/// OUT may be IN, but a whole folder of inputs is too easily named by mistake.
void requireOtherFolder(const CommandLine& line)
{
	const auto replacer =
		std::find_if(line.pieces.begin(), line.pieces.end(), [&](const std::string& piece) {
			return isInput(pathOfPiece(line, piece), line);
		});
	if (replacer != line.pieces.end())
		failUsage("'" + pathOfPiece(line, *replacer) +
				  "' would replace an input; --out-dir must name another folder.");
}

void checkPieces(const CommandLine& line)
{
	std::set<std::string> names;
	for (const std::string& piece : line.pieces) {
		formatOfPath(piece);
		if (!names.insert(pathOfPiece(line, piece)).second)
			failUsage("Two of the files have the same name, so DIR cannot hold both results.");
	}
	if (line.options.selectedOnly) failUsage("--selected is for a single file only.");
	if (!line.options.sew)
		failUsage("Several files are joined along coinciding borders; --sew off is not possible.");
	if (line.outTileNum > 0 || line.tiles.memoryBytes > 0)
		failUsage("Tiles are made from a single file only.");
	requireOtherFolder(line);
	checkReport(line);
}

/// OUT must have a place for the number of the level, and sizes must be valid for their mode.
void checkLevels(const CommandLine& line)
{
	const LevelSizes& levels = line.levels;
	if (levels.sizes.empty()) failUsage("levels needs one of --percent, --vertices and --faces.");
	if (isOneFile(line) && formatOfPath(line.output) != MeshFormat::Glb)
		failUsage("OUT must have {level} in its name, such as small_{level}.ply, or be a .glb "
				  "file, which holds all levels.");
	const double most = levels.mode == TargetMode::Percent ? 10000 : 2147483647.0;
	for (const double size : levels.sizes) {
		const bool isWhole = levels.mode == TargetMode::Percent || size == std::floor(size);
		if (!isWhole || size > most)
			failUsage("the sizes of levels are percentages up to 10000, or whole numbers.");
	}
	formatOfPath(line.output);
	checkReport(line);
}

/// OUT of --tiles-out replaces a whole folder.
void requireOutside(const std::string& file, const CommandLine& line)
{
	namespace fs = std::filesystem;
	if (!file.empty() && sameFile(fs::absolute(file).parent_path().string(), line.output))
		failUsage("'" + file + "' lies in the folder OUT, which the tiles replace.");
}

void checkOutputPath(const CommandLine& line)
{
	if (line.outTileNum > 0 && isMeshName(line.output))
		failUsage("With --tiles-out OUT is a folder and cannot have the name of a mesh, '" +
				  line.output + "'.");
	for (const std::string& file : {line.input, line.report})
		if (line.outTileNum > 0) requireOutside(file, line);
	const bool isPly = line.outTileNum > 0 || formatOfPath(line.output) == MeshFormat::Ply;
	if (line.command == Command::Features && !isPly)
		failUsage("features writes .ply only, the only format with quality and colour.");
	checkReport(line);
}

void checkPaths(const CommandLine& line)
{
	const bool isTile = line.command == Command::Tile;
	if (isTile && line.tiles.step == TileStep::Finish) return checkOutputPath(line);
	if (isTile) return;
	if (!line.pieces.empty()) return checkPieces(line);
	formatOfPath(line.input);
	if (line.command == Command::Levels) return checkLevels(line);
	if (line.command == Command::Remesh || line.command == Command::Features) checkOutputPath(line);
}

void takeSizes(const GivenOptions& given, CommandLine& line)
{
	if (line.sizes.empty()) return;
	const bool isSized = std::any_of(given.begin(), given.end(),
									 [](const auto& g) { return choosesSize(*g.first, g.second); });
	if (!isSized) line.options.targetMode = TargetMode::Sizes;
	if (line.tiles.memoryBytes > 0) failUsage("--sizes is not possible in tiles.");
}

void takePeriod(CommandLine& line)
{
	if (line.period.empty()) return;
	if (line.tiles.memoryBytes > 0) failUsage("--periodic is not possible in tiles.");
	line.options.period = {line.period[0], line.period[1], line.period[2]};
	if (!isPeriodic(line.options)) failUsage("--periodic needs a length above 0.");
}

} // namespace

std::string withoutSlashAtEnd(const std::string& path)
{
	const std::filesystem::path all(path);
	return all.has_filename() ? path : all.parent_path().string();
}

bool isForPlan(const Parameter& p)
{
	return std::string(p.key) != "TimeLimit" && std::string(p.key) != "Threads";
}

std::string pathOfPiece(const CommandLine& line, const std::string& piece)
{
	return (std::filesystem::path(line.output) / std::filesystem::path(piece).filename()).string();
}

void complete(const GivenOptions& given, CommandLine& line)
{
	line.options = optionsOf(given);
	takeSizes(given, line);
	takePeriod(line);
	const bool isTiled = line.tiles.memoryBytes > 0 || line.command == Command::Tile;
	if (isTiled && line.options.symmetry != Symmetry::Off)
		failUsage("--symmetry is not possible in tiles.");
	line.optionsText       = textOf(given);
	line.tiles.optionsText = textOf(given, isForPlan);
	if (line.outTileNum > 0) line.output = withoutSlashAtEnd(line.output);
	std::vector<double>& sizes = line.levels.sizes;
	if (isOneFile(line)) std::sort(sizes.rbegin(), sizes.rend()); // the finest level is the root
	checkPaths(line);
}

} // namespace gpr::app
