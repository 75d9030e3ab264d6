// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands.h"

#include <vcg_extras/apps/gpremesh/platform/end_at_once.h>
#include <vcg_extras/apps/gpremesh/report/progress_bar.h>
#include <vcg_extras/apps/gpremesh/report/summary.h>
#include <vcg_extras/apps/gpremesh/tiles/result_tiles.h>
#include <vcg_extras/core/prepared_surface.h>
#include <vcg_extras/core/run_estimate.h>
#include <vcg_extras/io/base/exit_code.h>
#include <vcg_extras/io/base/platform.h>
#include <vcg_extras/io/formats/mesh_formats.h>
#include <vcg_extras/io/mesh/attribute_carry.h>
#include <vcg_extras/io/mesh/joined_pieces.h>
#include <vcg_extras/io/mesh_io.h>
#include <vcg_extras/io/report/remesh_outcome.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace gpr::app {

namespace {

/// Shows the expected time of long runs, so that the user can stop at once.
void tellEstimate(const MeshView& mesh, const RemeshOptions& options, ProgressBar& bar)
{
	constexpr double  shortTime = 2; // s
	const RunEstimate estimate  = estimateRun(mesh, options);
	if (estimate.seconds >= shortTime) bar.tell("expected " + estimateText(estimate));
}

/// The column of a mesh with the wanted edge lengths at its vertices; empty if no column was named.
std::vector<float> wantedSizes(const MeshAttributes& attributes, const std::string& name)
{
	if (name.empty()) return {};
	const ValueColumn* const column = attributes.ofVertex(name);
	if (column == nullptr)
		throw AppError(ExitCode::BadInput,
					   "its vertices have no property '" + name + "' for --sizes.");
	return std::vector<float>(column->values.begin(), column->values.end());
}

WantedAttributes wantedBy(const CommandLine& line)
{
	WantedAttributes wanted = neededBy(line.options);
	wanted.regions          = line.regions;
	wanted.carried          = true;
	wanted.mayStayInFile    = line.sizes.empty();
	return wanted;
}

/// A file of the input.
struct Source : MeshSource {
	std::string        path;
	std::vector<float> sizes; ///< wanted sizes at the vertices; empty: none

	Source(const std::string& file, const CommandLine& line) :
			MeshSource(readMesh(file, wantedBy(line)), line.options), path(file),
			sizes(wantedSizes(mesh.attributes, line.sizes))
	{
	}

	MeshView view() const
	{
		MeshView v = MeshSource::view();
		if (!sizes.empty()) v.wantedEdge = sizes.data();
		return v;
	}
};

using Sources = std::vector<Source>;

/// Asks the engine for the surface points needed by carried attributes and by the cut into pieces.
void askForPoints(const Sources& sources, RemeshOptions& options)
{
	const bool isCut                = sources.size() > 1;
	options.surfacePointsOfVertices = std::any_of(sources.begin(), sources.end(),
												  [](const Source& s) { return s.needsPoints(); });
	options.surfacePointsOfFaces =
		isCut || std::any_of(sources.begin(), sources.end(),
							 [](const Source& s) { return s.needsPointsOfFaces(); });
}

/// prepared: of this mesh, for several results of the same mesh; else null.
RemeshResult remeshWithProgress(const Sources& sources, const MeshView& view,
								const CommandLine& line, const RunLimit& limit,
								PreparedSurface* prepared)
{
	ProgressBar   bar(!line.quiet && errorIsTerminal());
	RemeshOptions options    = line.options;
	options.timeLimitSeconds = limit.secondsLeft();
	askForPoints(sources, options);
	if (line.shareDone == 0) tellEstimate(view, options, bar);
	const char*            phraseBefore = nullptr;
	const ProgressCallback progress     = [&](double share, const char* phrase) {
        // Pages of data copied by the engine are rarely read again.
        const bool isNext = phraseBefore != nullptr && phrase != phraseBefore;
        for (const Source& source : sources) {
            if (isNext && source.mesh.isInFile()) source.mesh.file->giveBackPages();
        }
        phraseBefore = phrase;
        bar.show(line.shareDone + (1 - line.shareDone) * share, phrase);
        return !stopRequested();
	};
	if (prepared != nullptr) prepared->setInput(view);
	RemeshResult result =
		prepared != nullptr ? prepared->remesh(options, progress) : remesh(view, options, progress);
	bar.clear();
	if (stopRequested()) limit.check();
	requireDone(result);
	return result;
}

/// Path of the result of a source.
std::string targetOf(const Source& source, const CommandLine& line)
{
	return line.pieces.empty() ? line.output : pathOfPiece(line, source.path);
}

std::unique_ptr<Output> writeResult(const TriangleMesh& mesh, bool doublePrecision,
									MeshAttributes& attributes, const std::string& path,
									const CommandLine& line, const RunLimit& limit)
{
	if (line.outTileNum > 0)
		return writeTiles(mesh, doublePrecision, attributes, line.outTileNum, path, limit);
	auto out = std::make_unique<OutputFile>(path, limit);
	writeMesh(mesh, doublePrecision, attributes, *out);
	return out;
}

Source readSource(const std::string& path, const CommandLine& line, const RunLimit& limit)
{
	const EndAtOnce guard(limit);
	return Source(path, line);
}

Sources readSources(const CommandLine& line, const RunLimit& limit)
{
	Sources sources;
	if (line.pieces.empty()) sources.push_back(readSource(line.input, line, limit));
	for (const std::string& path : line.pieces)
		sources.push_back(readSource(path, line, limit));
	return sources;
}

MeshAttributes carriedAttributes(Source& source, const RemeshResult& result,
								 const CommandLine& line, const RunLimit& limit)
{
	const EndAtOnce guard(limit);
	return carryAttributes(source.mesh.attributes, source.mesh.view(), source.texture.get(), result,
						   line.transfer);
}

/// Adds the name of the file to a note, for several files.
std::string noteOf(const Source& source, const CommandLine& line, const std::string& sentence)
{
	return line.pieces.empty() ? sentence : source.path + ": " + sentence;
}

/// The common parts of all results of a run.
struct SharedByResults {
	PreparedSurface*       prepared = nullptr; ///< of the source of several levels
	std::vector<GlbLevel>* file     = nullptr; ///< of all levels; null: each has its own file
	Outputs                outputs;
};

/// Throws AppError if the format of a result would spoil the faces.
void requireFormat(const Source& source, const RemeshResult& result, const CommandLine& line)
{
	if (line.outTileNum == 0)
		requireFaces(result.mesh, needsDoubleOutput(source.mesh, result), targetOf(source, line));
}

/// Writes the result of a source; uses up the attributes of the source.
void writeSource(Source& source, const RemeshResult& result, const CommandLine& line,
				 const RunLimit& limit, SharedByResults& shared, RunRecord& run)
{
	const std::string path     = targetOf(source, line);
	const bool        isDouble = needsDoubleOutput(source.mesh, result);
	const std::string floatFormat =
		line.outTileNum > 0 ? "" : nameOfFloatFormat(formatOfPath(path));
	if (isDouble && !floatFormat.empty())
		run.notes.push_back(floatFormat +
							" holds floats only; the coordinates were rounded to float.");
	run.inputDouble           = run.inputDouble || source.mesh.doublePrecision;
	run.outputDouble          = run.outputDouble || (isDouble && floatFormat.empty());
	MeshAttributes attributes = carriedAttributes(source, result, line, limit);
	if (shared.file != nullptr) {
		const double error = run.report.provenDistance.hausdorff().upper;
		tellLost(MeshFormat::Glb, attributes);
		shared.file->push_back({result.mesh, attributes, error});
	}
	else
		shared.outputs.push_back(writeResult(result.mesh, isDouble, attributes, path, line, limit));
	if (!line.pieces.empty())
		run.files.push_back(
			{path, std::int64_t(result.mesh.vertexNum()), std::int64_t(result.mesh.faceNum())});
	const std::string lost = noteOfLost(attributes.lost);
	if (!lost.empty()) run.notes.push_back(noteOf(source, line, lost));
}

/// The results of all files; each must have a face.
std::vector<RemeshResult> piecesOf(const JoinedPieces& joined, const RemeshResult& whole,
								   const Sources& sources)
{
	std::vector<RemeshResult> pieces;
	for (std::size_t k = 0; k < sources.size(); ++k) {
		pieces.push_back(joined.ofPiece(whole, k));
		if (pieces.back().mesh.faceNum() == 0) {
			throw AppError(ExitCode::PromiseBroken,
						   sources[k].path +
							   " would have no face in the result; ask for more vertices.");
		}
	}
	return pieces;
}

/// All work between the meshes in memory and the meshes on the disk; sets all times but the time of
/// writing. begun: begin of the work on this result.
RunRecord process(Sources& sources, const CommandLine& line, const RunLimit& limit,
				  const Stopwatch& programClock, double begun, SharedByResults& shared)
{
	RunRecord run;
	run.times.read = programClock.seconds() - begun;
	std::vector<MeshView> views;
	for (const Source& source : sources)
		views.push_back(source.view());
	std::optional<JoinedPieces> joined;
	if (sources.size() > 1) joined.emplace(views);
	const MeshView view   = joined ? joined->view() : views.front();
	RemeshResult   result = remeshWithProgress(sources, view, line, limit, shared.prepared);
	run.times.remesh      = programClock.seconds() - begun - run.times.read;

	run.inputPath  = line.pieces.empty() ? line.input : withCommas(line.pieces);
	run.outputPath = line.output;
	run.options    = line.options;
	resolveFeatureRegion(view.anySelected(), run.options);
	for (const Source& source : sources) {
		for (const std::string& note : source.mesh.notes)
			run.notes.push_back(noteOf(source, line, note));
	}
	run.notes.insert(run.notes.end(), result.notes.begin(), result.notes.end());
	run.notes.insert(run.notes.end(), line.notes.begin(), line.notes.end());
	run.report = std::move(result.report);
	std::vector<RemeshResult> pieces;
	if (joined) pieces = piecesOf(*joined, result, sources);
	const auto resultOf = [&](std::size_t k) -> const RemeshResult& {
		return joined ? pieces[k] : result;
	};
	for (std::size_t k = 0; k < sources.size(); ++k) // before any file is written
		requireFormat(sources[k], resultOf(k), line);
	for (std::size_t k = 0; k < sources.size(); ++k)
		writeSource(sources[k], resultOf(k), line, limit, shared, run);
	return run;
}

/// Sets the rest of the time of a result.
void endTimes(double begun, const Stopwatch& programClock, RunRecord& run)
{
	run.times.write     = programClock.seconds() - begun - run.times.read - run.times.remesh;
	run.peakMemoryBytes = peakMemoryBytes();
}

/// The command line of a level: its size, its file, and a proof of its distance from the input.
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
	for (std::size_t at; (at = path.find(place)) != std::string::npos;)
		path.replace(at, place.size(), std::to_string(level));
	return path;
}

bool isOneFile(const CommandLine& line)
{
	return line.output.find(levelPlace) == std::string::npos;
}

void runLevels(const CommandLine& line, const Stopwatch& programClock)
{
	for (std::size_t i = 0; i < line.levels.sizes.size(); ++i)
		checkOutput(lineOfLevel(line, i));
	catchStopSignals();
	const RunLimit         limit(programClock, line.options.timeLimitSeconds);
	Sources                sources = readSources(line, limit);
	PreparedSurface        prepared(sources.front().view());
	const MeshAttributes   attributes = sources.front().mesh.attributes; // each level empties them
	std::vector<RunRecord> levels;
	double                 begun = 0;
	std::vector<GlbLevel>  ofFile;
	SharedByResults        shared{&prepared, isOneFile(line) ? &ofFile : nullptr, {}};
	for (std::size_t i = 0; i < line.levels.sizes.size(); ++i) {
		const CommandLine one           = lineOfLevel(line, i);
		sources.front().mesh.attributes = attributes;
		levels.push_back(process(sources, one, limit, programClock, begun, shared));
		endTimes(begun, programClock, levels.back());
		begun = programClock.seconds();
		if (!line.quiet) print(remeshSummary(levels.back()));
	}
	if (shared.file != nullptr) {
		auto out = std::make_unique<OutputFile>(line.output, limit);
		writeGlbLevels(ofFile, *out);
		out->finish();
		shared.outputs.push_back(std::move(out));
	}
	endRun(line, levelsReportJson(levels), "", shared.outputs);
}

void checkOutput(const CommandLine& line)
{
	if (line.outTileNum > 0)
		checkWritableFolder(line.output);
	else if (!line.pieces.empty())
		for (const std::string& piece : line.pieces)
			checkWritable(pathOfPiece(line, piece));
	else
		checkWritable(line.output);
	if (!line.report.empty()) checkWritable(line.report);
}

void runRemesh(const CommandLine& line, const Stopwatch& programClock)
{
	const NewFolder folder(line.pieces.empty() ? "" : line.output);
	checkOutput(line);
	catchStopSignals();
	const RunLimit  limit(programClock, line.options.timeLimitSeconds);
	Sources         sources = readSources(line, limit);
	SharedByResults shared;
	RunRecord       run = process(sources, line, limit, programClock, 0, shared);
	sources.clear(); // freed before the clock is read
	endTimes(0, programClock, run);
	endRun(line, remeshReportJson(run), remeshSummary(run), shared.outputs);
}

} // namespace gpr::app
