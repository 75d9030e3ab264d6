// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh_command.h"

#include <vcg_extras/apps/gpremesh/platform/end_at_once.h>
#include <vcg_extras/apps/gpremesh/report/progress_bar.h>
#include <vcg_extras/apps/gpremesh/report/summary.h>
#include <vcg_extras/apps/gpremesh/tiles/result_tiles.h>
#include <vcg_extras/core/run_estimate.h>
#include <vcg_extras/io/base/exit_code.h>
#include <vcg_extras/io/base/output_file.h>
#include <vcg_extras/io/base/platform.h>
#include <vcg_extras/io/mesh/mesh_source.h>
#include <vcg_extras/io/mesh_io.h>
#include <vcg_extras/io/report/remesh_outcome.h>

#include <cstdio>

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

RemeshResult remeshWithProgress(const MeshSource& source, const CommandLine& line,
								const RunLimit& limit)
{
	ProgressBar      bar(!line.quiet && errorIsTerminal());
	const InputMesh& mesh          = source.mesh;
	MeshView         view          = source.view();
	RemeshOptions    options       = source.withPlaces(line.options);
	options.timeLimitSeconds       = limit.secondsLeft();
	const std::vector<float> sizes = wantedSizes(mesh.attributes, line.sizes);
	if (!sizes.empty()) view.wantedEdge = sizes.data();
	if (line.shareDone == 0) tellEstimate(view, options, bar);
	const char*  phraseBefore = nullptr;
	RemeshResult result       = remesh(view, options, [&](double share, const char* phrase) {
        // What the engine has copied is no longer looked at, mostly.
        const bool isNext = phraseBefore != nullptr && phrase != phraseBefore;
        if (isNext && mesh.isInFile()) mesh.file->giveBackPages();
        phraseBefore = phrase;
        bar.show(line.shareDone + (1 - line.shareDone) * share, phrase);
        return !stopRequested();
    });
	bar.clear();
	if (stopRequested()) limit.check();
	requireMesh(result);
	return result;
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

MeshSource readSource(const CommandLine& line, const RunLimit& limit)
{
	const EndAtOnce guard(limit);
	return MeshSource(readMesh(line.input, wantedBy(line)), line.options);
}

MeshAttributes carriedAttributes(MeshSource& source, const RemeshResult& result, Transfer transfer,
								 const RunLimit& limit)
{
	const EndAtOnce guard(limit);
	return carryAttributes(source.mesh.attributes, source.mesh.view(), source.texture.get(), result,
						   transfer);
}

/// Everything between the mesh in memory and the mesh on the disk. The input is handed back before
/// the clock is read, so that no time is left out of the report.
RunRecord process(MeshSource& source, const CommandLine& line, const RunLimit& limit,
				  const Stopwatch& programClock)
{
	RunRecord run;
	run.times.read      = programClock.seconds();
	InputMesh&   input  = source.mesh;
	RemeshResult result = remeshWithProgress(source, line, limit);
	const double done   = programClock.seconds();
	run.times.remesh    = done - run.times.read;

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

	source          = MeshSource();
	result          = RemeshResult();
	run.times.write = programClock.seconds() - done;
	return run;
}

} // namespace

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
	MeshSource     source = readSource(line, limit);
	RunRecord      run    = process(source, line, limit, programClock);
	run.peakMemoryBytes   = peakMemoryBytes();
	if (!line.report.empty()) writeReport(line.report, run);
	if (!line.quiet) std::fputs(remeshSummary(run).c_str(), stdout);
}

} // namespace gpr::app
