// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh_command.h"

#include <vcg_extras/apps/gpremesh/platform/end_at_once.h>
#include <vcg_extras/apps/gpremesh/report/progress_bar.h>
#include <vcg_extras/apps/gpremesh/report/remesh_outcome.h>
#include <vcg_extras/apps/gpremesh/report/summary.h>
#include <vcg_extras/apps/gpremesh/tiles/result_tiles.h>
#include <vcg_extras/core/run_estimate.h>
#include <vcg_extras/io/base/exit_code.h>
#include <vcg_extras/io/base/output_file.h>
#include <vcg_extras/io/base/platform.h>
#include <vcg_extras/io/mesh/attribute_carry.h>
#include <vcg_extras/io/mesh/joined_pieces.h>
#include <vcg_extras/io/mesh/precision.h>
#include <vcg_extras/io/mesh_io.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

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

/// One file of the input, and what goes with it.
struct Source {
	std::string                    path;
	InputMesh                      mesh;
	std::unique_ptr<TextureSource> texture;
	std::vector<float>             sizes; ///< wanted at the vertices; empty: none

	MeshView view() const
	{
		MeshView v = mesh.view();
		if (texture != nullptr && texture->hasSeams()) v.line = texture->seams().data();
		if (!sizes.empty()) v.wantedEdge = sizes.data();
		return v;
	}
	bool needsPointsOfFaces() const { return texture != nullptr || mesh.attributes.ofFacesToo(); }
	bool needsPoints() const { return needsPointsOfFaces() || mesh.attributes.any(); }
};

using Sources = std::vector<Source>;

/// What the engine must say of the result, for what is carried over and for the cut into pieces.
void askForPoints(const Sources& sources, RemeshOptions& options)
{
	const bool isCut                = sources.size() > 1;
	options.surfacePointsOfVertices = std::any_of(sources.begin(), sources.end(),
												  [](const Source& s) { return s.needsPoints(); });
	options.surfacePointsOfFaces =
		isCut || std::any_of(sources.begin(), sources.end(),
							 [](const Source& s) { return s.needsPointsOfFaces(); });
}

RemeshResult remeshWithProgress(const Sources& sources, const MeshView& view,
								const CommandLine& line, const RunLimit& limit)
{
	ProgressBar   bar(!line.quiet && errorIsTerminal());
	RemeshOptions options    = line.options;
	options.timeLimitSeconds = limit.secondsLeft();
	askForPoints(sources, options);
	if (line.shareDone == 0) tellEstimate(view, options, bar);
	const char*  phraseBefore = nullptr;
	RemeshResult result       = remesh(view, options, [&](double share, const char* phrase) {
        // What the engine has copied is no longer looked at, mostly.
        const bool isNext = phraseBefore != nullptr && phrase != phraseBefore;
        for (const Source& source : sources) {
            if (isNext && source.mesh.isInFile()) source.mesh.file->giveBackPages();
        }
        phraseBefore = phrase;
        bar.show(line.shareDone + (1 - line.shareDone) * share, phrase);
        return !stopRequested();
    });
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

/// Where the result of a source is written.
std::string targetOf(const Source& source, const CommandLine& line)
{
	return line.pieces.empty() ? line.output : pathOfPiece(line, source.path);
}

void writeResult(const TriangleMesh& mesh, bool doublePrecision, MeshAttributes& attributes,
				 const std::string& path, const CommandLine& line, const RunLimit& limit)
{
	if (line.outTileNum > 0)
		writeTiles(mesh, doublePrecision, attributes, line.outTileNum, path, limit);
	else
		writeMesh(mesh, doublePrecision, attributes, path, limit);
}

/// Some formats hold no doubles.
void dropDoubles(MeshFormat format, bool& isDouble, std::vector<std::string>& notes)
{
	if ((format != MeshFormat::Stl && format != MeshFormat::Glb) || !isDouble) return;
	const std::string name = format == MeshFormat::Stl ? "STL" : "glTF";
	isDouble               = false;
	notes.push_back(name + " holds floats only; the coordinates were rounded to float.");
}

void writeReport(const std::string& path, const RunRecord& run)
{
	OutputFile out(path);
	out.text(remeshReportJson(run));
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

Source readSource(const std::string& path, const CommandLine& line, const RunLimit& limit)
{
	const EndAtOnce guard(limit);
	const bool      isSewn = line.options.sew && !line.options.selectedOnly;
	Source          source;
	source.path    = path;
	source.mesh    = readMesh(path, wantedBy(line));
	source.texture = takeTexture(source.mesh.attributes, source.mesh.view(), isSewn);
	source.sizes   = wantedSizes(source.mesh.attributes, line.sizes);
	return source;
}

Sources readSources(const CommandLine& line, const RunLimit& limit)
{
	Sources sources;
	if (line.pieces.empty()) sources.push_back(readSource(line.input, line, limit));
	for (const std::string& path : line.pieces)
		sources.push_back(readSource(path, line, limit));
	return sources;
}

MeshAttributes carriedAttributes(Source& source, const RemeshResult& result, Transfer transfer,
								 const RunLimit& limit)
{
	const EndAtOnce guard(limit);
	return carryAttributes(source.mesh.attributes, source.mesh.view(), source.texture.get(), result,
						   transfer);
}

/// A note about one of several files names the file.
std::string noteOf(const Source& source, const CommandLine& line, const std::string& sentence)
{
	return line.pieces.empty() ? sentence : source.path + ": " + sentence;
}

/// Writes what became of a source; the attributes of the source are used up.
void writeSource(Source& source, const RemeshResult& result, const CommandLine& line,
				 const RunLimit& limit, RunRecord& run)
{
	const std::string path     = targetOf(source, line);
	bool              isDouble = needsDoubleOutput(source.mesh, result);
	dropDoubles(line.outTileNum > 0 ? MeshFormat::Ply : formatOfPath(path), isDouble, run.notes);
	run.inputDouble           = run.inputDouble || source.mesh.doublePrecision;
	run.outputDouble          = run.outputDouble || isDouble;
	MeshAttributes attributes = carriedAttributes(source, result, line.transfer, limit);
	writeResult(result.mesh, isDouble, attributes, path, line, limit);
	if (!line.pieces.empty())
		run.files.push_back(
			{path, std::int64_t(result.mesh.vertexNum()), std::int64_t(result.mesh.faceNum())});
	if (!attributes.lost.empty())
		run.notes.push_back(
			noteOf(source, line, "Not carried over: " + listOf(attributes.lost) + "."));
}

/// The results of all files; none may be without a face.
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

/// Everything between the meshes in memory and the meshes on the disk. The input is handed back
/// before the clock is read, so that no time is left out of the report.
RunRecord process(Sources& sources, const CommandLine& line, const RunLimit& limit,
				  const Stopwatch& programClock)
{
	RunRecord run;
	run.times.read = programClock.seconds();
	std::vector<MeshView> views;
	for (const Source& source : sources)
		views.push_back(source.view());
	std::optional<JoinedPieces> joined;
	if (sources.size() > 1) joined.emplace(views);
	const MeshView view   = joined ? joined->view() : views.front();
	RemeshResult   result = remeshWithProgress(sources, view, line, limit);
	const double   done   = programClock.seconds();
	run.times.remesh      = done - run.times.read;

	run.inputPath  = line.pieces.empty() ? line.input : listOf(line.pieces);
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
	for (std::size_t k = 0; k < sources.size(); ++k)
		writeSource(sources[k], joined ? pieces[k] : result, line, limit, run);

	joined.reset();
	pieces.clear();
	sources.clear();
	result          = RemeshResult();
	run.times.write = programClock.seconds() - done;
	return run;
}

} // namespace

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
	if (!line.pieces.empty()) std::filesystem::create_directories(line.output);
	checkOutput(line);
	catchStopSignals();
	const RunLimit limit(programClock, line.options.timeLimitSeconds);
	Sources        sources = readSources(line, limit);
	RunRecord      run     = process(sources, line, limit, programClock);
	run.peakMemoryBytes    = peakMemoryBytes();
	if (!line.report.empty()) writeReport(line.report, run);
	if (!line.quiet) std::fputs(remeshSummary(run).c_str(), stdout);
}

} // namespace gpr::app
