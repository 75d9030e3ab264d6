// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh_command.h"

#include <vcg_extras/apps/gpremesh/platform/end_at_once.h>
#include <vcg_extras/apps/gpremesh/report/progress_bar.h>
#include <vcg_extras/apps/gpremesh/report/remesh_outcome.h>
#include <vcg_extras/apps/gpremesh/report/summary.h>
#include <vcg_extras/apps/gpremesh/tiles/result_tiles.h>
#include <vcg_extras/core/prepared_surface.h>
#include <vcg_extras/core/run_estimate.h>
#include <vcg_extras/io/base/exit_code.h>
#include <vcg_extras/io/base/output_file.h>
#include <vcg_extras/io/base/platform.h>
#include <vcg_extras/io/mesh/attribute_carry.h>
#include <vcg_extras/io/mesh/precision.h>
#include <vcg_extras/io/mesh_io.h>

#include <cstdio>
#include <memory>

namespace gpr::app {

namespace {

/// Where one has to wait, so that who will not need not.
void tellEstimate(const MeshView& mesh, const RemeshOptions& options, ProgressBar& bar)
{
	constexpr double  shortTime = 2; // s
	const RunEstimate estimate  = estimateRun(mesh, options);
	if (estimate.seconds >= shortTime) bar.tell("expected " + estimateText(estimate));
}

/// The column of a mesh that holds the edge lengths wanted at its vertices; empty where none is
/// asked for.
std::vector<float> wantedSizes(const MeshAttributes& attributes, const std::string& name)
{
	if (name.empty()) return {};
	const ValueColumn* const column = attributes.ofVertex(name);
	if (column == nullptr)
		throw AppError(ExitCode::BadInput,
					   "its vertices have no property '" + name + "' for --sizes.");
	return std::vector<float>(column->values.begin(), column->values.end());
}

/// prepared: of this mesh, where more than one result is made of it; else null.
RemeshResult remeshWithProgress(const InputMesh& mesh, const TextureSource* texture,
								const CommandLine& line, const RunLimit& limit,
								PreparedSurface* prepared)
{
	ProgressBar   bar(!line.quiet && errorIsTerminal());
	MeshView      view              = mesh.view();
	RemeshOptions options           = line.options;
	options.timeLimitSeconds        = limit.secondsLeft();
	options.surfacePointsOfVertices = mesh.attributes.any() || texture != nullptr;
	options.surfacePointsOfFaces    = texture != nullptr || mesh.attributes.ofFacesToo();
	if (texture != nullptr && texture->hasSeams()) view.line = texture->seams().data();
	const std::vector<float> sizes = wantedSizes(mesh.attributes, line.sizes);
	if (!sizes.empty()) view.wantedEdge = sizes.data();
	if (line.shareDone == 0) tellEstimate(view, options, bar);
	const char*            phraseBefore = nullptr;
	const ProgressCallback progress     = [&](double share, const char* phrase) {
        // What the engine has copied is no longer looked at, mostly.
        const bool isNext = phraseBefore != nullptr && phrase != phraseBefore;
        if (isNext && mesh.isInFile()) mesh.file->giveBackPages();
        phraseBefore = phrase;
        bar.show(line.shareDone + (1 - line.shareDone) * share, phrase);
        return !stopRequested();
	};
	if (prepared != nullptr) prepared->setInput(view);
	RemeshResult result =
		prepared != nullptr ? prepared->remesh(options, progress) : remesh(view, options, progress);
	bar.clear();
	if (stopRequested()) limit.check();
	requireMesh(result);
	return result;
}

/// Double for a double input, or where a float would not resolve a thousandth of the mean edge.
bool needsDoubleOutput(const InputMesh& input, const RemeshResult& result)
{
	return input.doublePrecision ||
		   !floatResolves(largestCoordinate(result.mesh.view()), result.report.quality.meanEdgeLen);
}

/// Of OUT, which may be a folder of tiles.
MeshFormat writtenFormat(const CommandLine& line)
{
	return line.outTileNum > 0 ? MeshFormat::Ply : formatOfPath(line.output);
}

void writeResult(const TriangleMesh& mesh, bool doublePrecision, MeshAttributes& attributes,
				 const CommandLine& line, const RunLimit& limit)
{
	if (line.outTileNum > 0)
		writeTiles(mesh, doublePrecision, attributes, line.outTileNum, line.output, limit);
	else
		writeMesh(mesh, doublePrecision, attributes, line.output, limit);
}

void addPrecisionNote(MeshFormat format, RunRecord& run)
{
	if ((format != MeshFormat::Stl && format != MeshFormat::Glb) || !run.outputDouble) return;
	const std::string name = format == MeshFormat::Stl ? "STL" : "glTF";
	run.outputDouble       = false;
	run.notes.push_back(name + " holds floats only; the coordinates were rounded to float.");
}

void writeText(const std::string& path, const std::string& text)
{
	OutputFile out(path);
	out.text(text);
	out.commit();
}

WantedAttributes wantedBy(const CommandLine& line)
{
	WantedAttributes wanted = neededBy(line.options);
	wanted.regions          = line.regions;
	wanted.carried          = true;
	wanted.mayStayInFile    = line.sizes.empty();
	return wanted;
}

std::string listOf(const std::vector<std::string>& words)
{
	std::string list;
	for (const std::string& word : words)
		list += (list.empty() ? "" : ", ") + word;
	return list;
}

/// The input, and what goes with it.
struct Source {
	InputMesh                      mesh;
	std::unique_ptr<TextureSource> texture;
};

Source readSource(const CommandLine& line, const RunLimit& limit)
{
	const EndAtOnce guard(limit);
	const bool      isSewn = line.options.sew && !line.options.selectedOnly;
	Source          source;
	source.mesh    = readMesh(line.input, wantedBy(line));
	source.texture = takeTexture(source.mesh.attributes, source.mesh.view(), isSewn);
	return source;
}

MeshAttributes carriedAttributes(Source& source, const RemeshResult& result, Transfer transfer,
								 const RunLimit& limit)
{
	const EndAtOnce guard(limit);
	return carryAttributes(source.mesh.attributes, source.mesh.view(), source.texture.get(), result,
						   transfer);
}

/// Everything between the mesh in memory and the mesh on the disk, all times but those of writing
/// included. begun: when the work on this result began.
RunRecord process(Source& source, const CommandLine& line, const RunLimit& limit,
				  const Stopwatch& programClock, double begun, PreparedSurface* prepared = nullptr)
{
	RunRecord run;
	run.times.read      = programClock.seconds() - begun;
	InputMesh&   input  = source.mesh;
	RemeshResult result = remeshWithProgress(input, source.texture.get(), line, limit, prepared);
	run.times.remesh    = programClock.seconds() - begun - run.times.read;

	run.inputPath    = line.input;
	run.outputPath   = line.output;
	run.inputDouble  = input.doublePrecision;
	run.outputDouble = needsDoubleOutput(input, result);
	run.options      = line.options;
	resolveFeatureRegion(input.view().anySelected(), run.options);
	run.notes = input.notes;
	run.notes.insert(run.notes.end(), result.notes.begin(), result.notes.end());
	run.notes.insert(run.notes.end(), line.notes.begin(), line.notes.end());
	addPrecisionNote(writtenFormat(line), run);
	run.report                = std::move(result.report);
	MeshAttributes attributes = carriedAttributes(source, result, line.transfer, limit);
	writeResult(result.mesh, run.outputDouble, attributes, line, limit);
	if (!attributes.lost.empty())
		run.notes.push_back("Not carried over: " + listOf(attributes.lost) + ".");
	return run;
}

/// The rest of the time that a result took.
void endTimes(double begun, const Stopwatch& programClock, RunRecord& run)
{
	run.times.write     = programClock.seconds() - begun - run.times.read - run.times.remesh;
	run.peakMemoryBytes = peakMemoryBytes();
}

/// The line for one level: its size, its file, and a proof of how far it is from the input.
CommandLine lineOfLevel(const CommandLine& line, std::size_t level)
{
	CommandLine    one  = line;
	const double   size = line.levels.sizes[level];
	RemeshOptions& o    = one.options;
	o.targetMode        = line.levels.mode;
	o.check             = true;
	if (o.targetMode == TargetMode::VertexNum) o.targetVertexNum = std::int64_t(size);
	if (o.targetMode == TargetMode::FaceNum) o.targetFaceNum = std::int64_t(size);
	if (o.targetMode == TargetMode::Percent) o.targetPercent = size;
	one.output = pathOfLevel(line.output, level + 1);
	return one;
}

} // namespace

std::string pathOfLevel(const std::string& pattern, std::size_t level)
{
	const std::string place = levelPlace;
	std::string       path  = pattern;
	path.replace(path.find(place), place.size(), std::to_string(level));
	return path;
}

void runLevels(const CommandLine& line, const Stopwatch& programClock)
{
	for (std::size_t i = 0; i < line.levels.sizes.size(); ++i)
		checkOutput(lineOfLevel(line, i));
	catchStopSignals();
	const RunLimit         limit(programClock, line.options.timeLimitSeconds);
	Source                 source = readSource(line, limit);
	PreparedSurface        prepared(source.mesh.view());
	const MeshAttributes   attributes = source.mesh.attributes; // each level empties them
	std::vector<RunRecord> levels;
	double                 begun = 0;
	for (std::size_t i = 0; i < line.levels.sizes.size(); ++i) {
		const CommandLine one  = lineOfLevel(line, i);
		source.mesh.attributes = attributes;
		levels.push_back(process(source, one, limit, programClock, begun, &prepared));
		endTimes(begun, programClock, levels.back());
		begun = programClock.seconds();
		if (!line.quiet) std::fputs(remeshSummary(levels.back()).c_str(), stdout);
	}
	if (!line.report.empty()) writeText(line.report, levelsReportJson(levels));
}

void checkOutput(const CommandLine& line)
{
	if (line.outTileNum > 0)
		checkWritableFolder(line.output);
	else
		checkWritable(line.output);
	if (!line.report.empty()) checkWritable(line.report);
}

void runRemesh(const CommandLine& line, const Stopwatch& programClock)
{
	checkOutput(line);
	catchStopSignals();
	const RunLimit limit(programClock, line.options.timeLimitSeconds);
	Source         source = readSource(line, limit);
	RunRecord      run    = process(source, line, limit, programClock, 0);
	source                = Source(); // handed back before the clock is read
	endTimes(0, programClock, run);
	if (!line.report.empty()) writeText(line.report, remeshReportJson(run));
	if (!line.quiet) std::fputs(remeshSummary(run).c_str(), stdout);
}

} // namespace gpr::app
