// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare_methods.h"
#include "compare_output.h"

#include <vcg_extras/apps/gpremesh/commands/commands.h>
#include <vcg_extras/apps/gpremesh/platform/end_at_once.h>
#include <vcg_extras/apps/gpremesh/report/progress_bar.h>
#include <vcg_extras/io/base/exit_code.h>
#include <vcg_extras/io/base/platform.h>
#include <vcg_extras/io/mesh_io.h>
#include <vcg_extras/io/report/formatted_text.h>

#include <filesystem>

namespace gpr::app {

namespace {

std::string pagePath(const std::string& folder)
{
	return folder + "/index.html";
}

/// Throws AppError (Failure) if the page cannot be written. For a call before long work.
void checkFolder(const std::string& folder)
{
	std::error_code error;
	if (!std::filesystem::is_directory(folder, error)) {
		throw AppError(ExitCode::Failure, "cannot make the folder '" + folder + "'.");
	}
	checkWritable(pagePath(folder));
}

/// Shows the bar and throws if the user stops the run.
CompareProgress progressOn(ProgressBar& bar)
{
	return [&bar](double share, const std::string& phrase) {
		if (stopRequested()) throw AppError(ExitCode::Stopped, "cancelled.");
		bar.show(share, phrase.c_str());
	};
}

std::vector<CaptionedPictures> takePictures(const InputMesh& input, const CompareRecord& record,
											MeshPhotographer& photographer, ProgressBar& bar)
{
	std::vector<CaptionedPictures> list;
	const auto                     take = [&](const std::string& name, const MeshView& mesh) {
        bar.show(1, "taking pictures");
        list.push_back({name + ", " + grouped(std::int64_t(mesh.faceNum)) + " faces",
                        photographer.take(mesh)});
	};
	take("input", input.view());
	for (const MethodRecord& m : record.methods)
		if (m.failure.empty()) take(m.name, m.mesh.view());
	return list;
}

std::unique_ptr<Output> writePage(const std::string& folder, const InputMesh& input,
								  CompareRecord& record, ProgressBar& bar)
{
	const std::string workFolder = folder + "/.gpremesh-" + std::to_string(processId());
	const double      edgeLen    = record.methods.front().record.quality.meanEdgeLen;
	MeshPhotographer  photographer(input.view(), edgeLen, workFolder);
	const std::vector<CaptionedPictures> pictures = takePictures(input, record, photographer, bar);
	if (!photographer.complaint().empty()) record.notes.push_back(photographer.complaint());
	if (!hasViewer()) {
		record.notes.push_back(
			"The page has no rotatable views: this program was built without three.js.");
	}
	bar.show(1, "measuring for the views");
	const std::string viewer = hasViewer() ? viewerHtml(input.view(), record) : "";
	auto              page   = std::make_unique<OutputFile>(pagePath(folder));
	page->text(comparePage(record, pictures, viewer));
	page->finish();
	return page;
}

InputMesh readUnlessStopped(const CommandLine& line)
{
	const EndAtOnce guard{RunLimit()};
	return readMesh(line.input, neededBy(line.options));
}

} // namespace

void runCompare(const CommandLine& line)
{
	const NewFolder folder(line.htmlFolder);
	if (!line.htmlFolder.empty()) checkFolder(line.htmlFolder);
	catchStopSignals();
	const InputMesh input = readUnlessStopped(line);
	ProgressBar     bar(errorIsTerminal());
	CompareRecord   record = compareMethods(input, line, progressOn(bar));
	if (!line.optionsText.empty())
		record.notes.push_back("gpremesh was run with " + line.optionsText + ".");
	Outputs outputs;
	if (!line.htmlFolder.empty()) outputs.push_back(writePage(line.htmlFolder, input, record, bar));
	bar.clear();
	endRun(line, "", line.json ? compareJson(record) : compareText(record), outputs);
}

} // namespace gpr::app
