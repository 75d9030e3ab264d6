// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "input_conversion.h"
#include "tile_part.h"

#include <vcg_extras/apps/gpremesh/commands/commands.h>
#include <vcg_extras/apps/gpremesh/report/progress_bar.h>
#include <vcg_extras/core/base/pages.h>
#include <vcg_extras/core/run_estimate.h>
#include <vcg_extras/io/base/exit_code.h>
#include <vcg_extras/io/base/output_file.h>
#include <vcg_extras/io/base/platform.h>
#include <vcg_extras/io/report/formatted_text.h>

#include <cstdio>
#include <filesystem>

namespace gpr::app {

namespace {

namespace fs = std::filesystem;

/// Shares of the work of a run, for even progress.
constexpr double shareOfSplit = 0.15, shareOfParts = 0.6, shareOfJoin = 0.05;

constexpr double shareUntilJoin = shareOfSplit + shareOfParts;
constexpr double shareCondensed = shareUntilJoin + shareOfJoin;

void noteDensity(double vertexNum, double memoryBytes, std::vector<std::string>& notes)
{
	const double density = condensedDensity(vertexNum, memoryBytes);
	const double usual   = condensedDensity(vertexNum, 0);
	if (density >= usual) return;
	notes.push_back(
		formatted("The memory allows a condensed surface with %.1f vertices for each vertex of "
				  "the result; %.0f are usual. The result is a little farther from the input.",
				  density, usual));
}

/// The last step: an ordinary run on the condensed surface.
CommandLine lastStepOf(const CommandLine& line, const TilePlan& plan, const SplitFacts& facts,
					   const RunFolder& folder)
{
	CommandLine last              = line;
	last.command                  = Command::Remesh;
	last.input                    = folder.joined();
	last.options                  = plan.options;
	last.options.threads          = line.options.threads;
	last.options.timeLimitSeconds = line.options.timeLimitSeconds;
	if (last.options.targetMode == TargetMode::Percent) {
		last.options.targetMode      = TargetMode::VertexNum;
		last.options.targetVertexNum = std::int64_t(resultVertexNum(plan, facts));
		last.options.allowNearest    = true; // a share is a wish
	}
	last.notes.push_back("The input was condensed in " + std::to_string(plan.tileNum()) +
						 " tiles first. All figures of the input here are figures of the condensed "
						 "surface.");
	noteDensity(resultVertexNum(plan, facts), plan.memoryBytes, last.notes);
	for (const std::string& note : conversionNotes(plan.inputs.size(), folder))
		last.notes.push_back(note);
	return last;
}

void finish(const CommandLine& line, const TilePlan& plan, const SplitFacts& facts,
			const RunFolder& folder, const Stopwatch& programClock)
{
	const auto joined = readRecord(folder.joinRecord(), plan.name);
	if (!joined) failUsage("The parts were not joined yet. Run 'gpremesh tile join'.");
	requireStamp(folder.joined(), stampOf(joined->at("mesh")));
	runRemesh(lastStepOf(line, plan, facts, folder), programClock);
}

/// Progress of a part of the whole run.
ProgressCallback partOf(ProgressBar& bar, double from, double to)
{
	return [&bar, from, to](double share, const char* phrase) {
		bar.show(from + (to - from) * share, phrase);
		return !stopRequested();
	};
}

/// The plan of the inputs; converts inputs if needed.
TilePlan planFor(const CommandLine& line, const RunFolder& folder, const RunLimit& limit,
				 const ProgressCallback& progress)
{
	folder.requireUnused();
	TileSettings settings = line.tiles;
	settings.inputs =
		convertInputs(settings.inputs, double(settings.memoryBytes), folder, limit, progress);
	TilePlan plan = makePlan(line.options, settings);
	writePlan(plan, folder);
	return plan;
}

/// The plan of a finished split; the converted inputs are already removed.
TilePlan planOfSplit(const TileSettings& settings, const RunFolder& folder)
{
	TilePlan plan = readPlan(folder);
	if (plan.optionsText != settings.optionsText ||
		plan.memoryBytes != double(settings.memoryBytes))
		failOtherPlan(folder.plan());
	requireSameInputs(settings.inputs, folder);
	return plan;
}

/// Removes the converted inputs: only the split reads these files.
void removeConverted(const TilePlan& plan, const RunFolder& folder)
{
	for (std::size_t i = 0; i < plan.inputs.size(); ++i)
		fs::remove(folder.input(i));
}

/// Seconds of an ordinary run, from the numbers alone.
double secondsOfRun(double faceNum, double vertexNum, RemeshOptions options)
{
	MeshView sizes;
	sizes.faceNum           = std::size_t(faceNum);
	sizes.vertexNum         = std::size_t(faceNum / 2);
	options.targetMode      = TargetMode::VertexNum;
	options.targetVertexNum = std::int64_t(vertexNum);
	return estimateRun(sizes, options).seconds;
}

/// The expected time, if the options tell the size of the result.
std::string expectation(const TilePlan& plan, const RunFolder& folder)
{
	constexpr double splitSecondsPerFace = 0.25e-6; // on one thread
	const double     faceNum             = double(plan.allFaces());
	const double     vertexNum = resultVertexNum(plan.options, double(plan.allVertices()));
	const double     condensed = condensedDensity(vertexNum, plan.memoryBytes) * vertexNum;
	RemeshOptions    quick     = plan.options;
	quick.preset               = Preset::Fast;
	RunEstimate estimate;
	estimate.bytes   = plan.memoryBytes;
	estimate.seconds = splitSecondsPerFace * faceNum + secondsOfRun(faceNum, condensed, quick) +
					   secondsOfRun(2 * condensed, vertexNum, plan.options);
	return formatted("In %d tiles: ", plan.tileNum()) + (vertexNum > 0 ? "" : "more than ") +
		   estimateText(estimate) +
		   formatted(", and %.2g GB of disk in '", 1e-9 * diskBytesOf(plan)) + folder.path() +
		   "'.\n";
}

/// Makes the condensed surface.
void condense(const TilePlan& plan, const RunFolder& folder, const RunLimit& limit,
			  ProgressBar& bar)
{
	const SplitFacts facts = split(plan, folder, limit, partOf(bar, 0, shareOfSplit));
	removeConverted(plan, folder);
	requireMemoryFor(resultVertexNum(plan, facts), plan.memoryBytes);
	const double each    = shareOfParts / plan.tileNum();
	double       faceNum = 0;
	for (int tile = 0; tile < plan.tileNum(); ++tile) {
		const double from = shareOfSplit + each * tile;
		faceNum += double(
			makePart(plan, facts, tile, folder, limit, partOf(bar, from, from + each)).faceNum);
		fs::remove(folder.tile(tile));
		fs::remove(folder.tileNames(tile));
		returnReleasedMemory(); // the next step needs another mix of sizes
	}
	requireMemoryForFaces(faceNum, plan.memoryBytes);
	joinParts(plan, folder, limit, partOf(bar, shareUntilJoin, shareCondensed));
}

void printJson(const Json& json)
{
	print(json.dump() + "\n");
}

Json stepJson(const TilePlan& plan, const char* step)
{
	return {{"step", step}, {"plan", plan.name}};
}

/// The files of the user must stay as they are.
void requireForeignFiles(const CommandLine& line, const RunFolder& folder)
{
	std::vector<std::string> files = line.tiles.inputs;
	for (const std::string& file : {line.input, line.output, line.report})
		if (!file.empty()) files.push_back(file);
	folder.requireForeign(files);
}

// ---- steps

void stepPlan(const CommandLine& line, const RunFolder& folder, const RunLimit& limit)
{
	const TilePlan plan = planFor(line, folder, limit, nullptr);
	Json           json = stepJson(plan, "plan");
	json["tiles"]       = plan.tileNum();
	json["vertices"]    = plan.allVertices();
	json["faces"]       = plan.allFaces();
	printJson(json);
}

void stepSplit(const RunFolder& folder, const RunLimit& limit)
{
	const TilePlan   plan  = readPlan(folder);
	const SplitFacts facts = split(plan, folder, limit, nullptr);
	requireMemoryFor(resultVertexNum(plan, facts), plan.memoryBytes);
	Json json     = stepJson(plan, "split");
	json["tiles"] = Json::array();
	for (const SplitFacts::Tile& tile : facts.tiles)
		json["tiles"].push_back(tile.faceNum);
	printJson(json);
}

void stepPart(const CommandLine& line, const RunFolder& folder, const RunLimit& limit)
{
	TilePlan         plan  = readPlan(folder);
	const SplitFacts facts = readSplit(plan, folder);
	plan.options.threads   = line.options.threads;
	if (line.tiles.unit < 0 || line.tiles.unit >= plan.tileNum())
		failUsage("--unit takes a number from 0 to " + std::to_string(plan.tileNum() - 1) + ".");
	const auto      mayGoOn = [](double, const char*) { return !stopRequested(); };
	const PartFacts part    = makePart(plan, facts, line.tiles.unit, folder, limit, mayGoOn);
	Json            json    = stepJson(plan, "part");
	json["unit"]            = line.tiles.unit;
	json["vertices"]        = part.vertexNum;
	json["condensed"]       = part.isCondensed;
	json["note"]            = part.note;
	printJson(json);
}

void stepJoin(const RunFolder& folder, const RunLimit& limit)
{
	const TilePlan plan = readPlan(folder);
	joinParts(plan, folder, limit, nullptr);
	printJson(stepJson(plan, "join"));
}

} // namespace

bool needsTiles(const CommandLine& line)
{
	if (!(line.tiles.memoryBytes > 0)) return false;
	const MeshSize size = estimatedSize(line.input);
	if (bytesUntiled(size.faceNum, resultVertexNum(line.options, size.vertexNum)) <=
		double(line.tiles.memoryBytes))
		return false;
	if (tileInputOf(line.input) != TileInput::NotAtAll) return true;
	failInput("'" + line.input +
			  "' may need more memory than --memory allows, and files "
			  "of this format cannot be read in tiles. Convert the file "
			  "to PLY.");
}

void remeshInTiles(const CommandLine& line, const Stopwatch& programClock)
{
	checkOutput(line);
	catchStopSignals();
	const RunLimit  limit(programClock, line.options.timeLimitSeconds);
	const RunFolder folder(line.tiles.folder.empty() ? line.output + ".tiles" : line.tiles.folder);
	requireForeignFiles(line, folder);
	CommandLine whole  = line;
	whole.tiles.inputs = {line.input};
	const bool isSplit = fs::exists(folder.splitRecord()) && fs::exists(folder.inputRecord(0));
	TilePlan   plan;
	{
		ProgressBar bar(!line.quiet && errorIsTerminal());
		plan                 = isSplit ? planOfSplit(whole.tiles, folder)
									   : planFor(whole, folder, limit, partOf(bar, 0, 1));
		plan.options.threads = line.options.threads;
		bar.clear();
		if (!line.quiet) std::fputs(expectation(plan, folder).c_str(), stderr);
		condense(plan, folder, limit, bar);
	}
	whole.shareDone = shareCondensed;
	finish(whole, plan, readSplit(plan, folder), folder, programClock);
	folder.remove();
}

void runTileStep(const CommandLine& line, const Stopwatch& programClock)
{
	catchStopSignals();
	const RunLimit  limit(programClock, line.options.timeLimitSeconds);
	const RunFolder folder(line.tiles.folder);
	requireForeignFiles(line, folder);
	switch (line.tiles.step) {
	case TileStep::Plan:
		return stepPlan(line, folder, limit);
	case TileStep::Split:
		return stepSplit(folder, limit);
	case TileStep::Part:
		return stepPart(line, folder, limit);
	case TileStep::Join:
		return stepJoin(folder, limit);
	case TileStep::Finish: {
		const TilePlan plan = readPlan(folder);
		return finish(line, plan, readSplit(plan, folder), folder, programClock);
	}
	}
}

} // namespace gpr::app
