// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh_command.h"

#include "exit_code.h"
#include "mesh_io.h"
#include "output_file.h"
#include "platform.h"
#include "precision.h"
#include "progress_bar.h"
#include "summary.h"

#include <cstdio>

namespace gpr::app {

namespace {

ExitCode exitCodeOf(Status status)
{
	switch (status) {
	case Status::Ok:
		return ExitCode::Done;
	case Status::BadOptions:
		return ExitCode::Usage;
	case Status::UnusableInput:
		return ExitCode::BadInput;
	case Status::CountTooSmall:
	case Status::PromiseBroken:
		return ExitCode::PromiseBroken;
	case Status::Cancelled:
		return ExitCode::Stopped;
	case Status::OutOfMemory:
	case Status::InternalError:
		return ExitCode::Failure;
	}
	return ExitCode::Failure;
}

/// The sentence for a run that gave no mesh.
std::string sentenceOf(const RemeshResult& result)
{
	if (result.message.empty()) return "the remeshing failed, for a reason it did not tell.";
	const std::string smallest = std::to_string(result.smallestVertexNum);
	const bool        named    = result.message.find(smallest) != std::string::npos;
	if (result.status != Status::CountTooSmall || named) return result.message;
	return result.message + " The smallest possible number is " + smallest + ".";
}

RemeshResult remeshWithProgress(const InputMesh& mesh, const CommandLine& line)
{
	ProgressBar  bar(!line.quiet && errorIsTerminal());
	RemeshResult result = remesh(mesh.view(), line.options, [&](double share, const char* phrase) {
		bar.show(share, phrase);
		return !stopRequested();
	});
	bar.clear();
	if (stopRequested()) throw AppError(ExitCode::Stopped, "cancelled; nothing was written.");
	if (result.status != Status::Ok) throw AppError(exitCodeOf(result.status), sentenceOf(result));
	return result;
}

/// Double for a double input, or where a float would not resolve a thousandth of the mean edge.
bool needsDoubleOutput(const InputMesh& input, const RemeshResult& result)
{
	return input.doublePrecision ||
		   !floatResolves(largestCoordinate(result.mesh.view()), result.report.quality.meanEdgeLen);
}

void addPrecisionNote(RunRecord& run)
{
	if (formatOfPath(run.outputPath) != MeshFormat::Stl || !run.outputDouble) return;
	run.outputDouble = false;
	run.notes.push_back("STL holds floats only; the coordinates were rounded to float.");
}

void writeReport(const std::string& path, const RunRecord& run)
{
	OutputFile out(path);
	out.text(remeshReportJson(run));
	out.commit();
}

WantedAttributes wantedBy(const RemeshOptions& options)
{
	WantedAttributes wanted;
	wanted.quality   = options.lambda > 0 && options.sizing == SizingSource::Quality;
	wanted.selection = options.featureRegion == FeatureRegion::Selection;
	return wanted;
}

/// Everything between the mesh in memory and the mesh on the disk. The input is handed back before
/// the clock is read, so that no time is left out of the report.
RunRecord process(InputMesh& input, const CommandLine& line, const Stopwatch& programClock)
{
	RunRecord run;
	run.times.read      = programClock.seconds();
	RemeshResult result = remeshWithProgress(input, line);
	const double done   = programClock.seconds();
	run.times.remesh    = done - run.times.read;

	run.inputPath    = line.input;
	run.outputPath   = line.output;
	run.inputDouble  = input.doublePrecision;
	run.outputDouble = needsDoubleOutput(input, result);
	run.options      = line.options;
	run.notes        = input.notes;
	run.notes.insert(run.notes.end(), result.notes.begin(), result.notes.end());
	addPrecisionNote(run);
	run.report = std::move(result.report);
	writeMesh(result.mesh, run.outputDouble, line.output, stopRequested);

	input           = InputMesh();
	result          = RemeshResult();
	run.times.write = programClock.seconds() - done;
	return run;
}

} // namespace

void runRemesh(const CommandLine& line, const Stopwatch& programClock)
{
	checkWritable(line.output);
	if (!line.report.empty()) checkWritable(line.report);
	catchStopSignals();
	InputMesh input     = readMesh(line.input, wantedBy(line.options));
	RunRecord run       = process(input, line, programClock);
	run.peakMemoryBytes = peakMemoryBytes();
	if (!line.report.empty()) writeReport(line.report, run);
	if (!line.quiet) std::fputs(remeshSummary(run).c_str(), stdout);
}

} // namespace gpr::app
