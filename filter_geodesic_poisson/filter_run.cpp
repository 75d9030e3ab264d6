// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_run.h"

#include "comparison_report.h"
#include "layer_job.h"
#include "mesh_bridge.h"
#include "refusal.h"
#include "run_report.h"

#include <vcg_extras/core/mesh/measure.h>
#include <vcg_extras/core/remesh.h>
#include <vcg_extras/core/run_estimate.h>

#include <exception>
#include <new>

namespace gpr_filter {

namespace {

using Lines = std::vector<std::string>;

/// Sets a flag for the life of the object.
class Flagged {
public:
	explicit Flagged(bool& flag) : _flag(flag) { _flag = true; }
	~Flagged() { _flag = false; }
	Flagged(const Flagged&)            = delete;
	Flagged& operator=(const Flagged&) = delete;

private:
	bool& _flag;
};

/// meshlabserver prints the phrases back to back, so each ends its line; the status bar of the
/// window shows one line anyway.
gpr::ProgressCallback progressTo(vcg::CallBackPos* host)
{
	if (host == nullptr) return nullptr;
	return [host](double share, const char* phrase) {
		return host(int(100 * share), (std::string(phrase) + '\n').c_str());
	};
}

template <class Result>
void requireOk(const Result& result)
{
	if (result.status != gpr::Status::Ok) throw Refusal(result.message);
}

void append(const Lines& more, Lines& lines)
{
	lines.insert(lines.end(), more.begin(), more.end());
}

RunOutcome remesh(const LayerJob& job, vcg::CallBackPos* progress)
{
	const gpr::RemeshResult result =
		gpr::remesh(job.copy().view(), job.options(), progressTo(progress));
	requireOk(result);
	const gpr::QualityFigures before =
		gpr::measureQuality(job.copy().view(), job.options().threads);
	Lines lines = remeshingLines(result, before);
	lines.push_back(job.sentenceOfSelectedFaces());
	append(job.put(result, "_remeshed"), lines);
	return {true, lines, remeshingFigures(result)};
}

RunOutcome sample(const LayerJob& job, vcg::CallBackPos* progress)
{
	const gpr::SamplingResult result =
		gpr::samplePoissonDisks(job.copy().view(), job.options(), progressTo(progress));
	requireOk(result);
	Lines lines = samplingLines(result);
	job.putPoints(result, "_samples");
	return {true, lines, samplingFigures(result)};
}

RunOutcome retriangulate(const LayerJob& job, vcg::CallBackPos* progress)
{
	const gpr::RemeshResult result =
		gpr::retriangulate(job.copy().view(), job.samples(), job.options(), progressTo(progress));
	requireOk(result);
	Lines lines = retriangulationLines(result);
	append(job.put(result, "_retriangulated"), lines);
	return {true, lines, remeshingFigures(result)};
}

RunOutcome detectFeatures(const LayerJob& job, vcg::CallBackPos* progress)
{
	const gpr::FeatureResult result =
		gpr::detectFeatures(job.copy().view(), job.options(), progressTo(progress));
	requireOk(result);
	job.mark(result);
	return {true, featureLines(result), featureFigures(result)};
}

RunOutcome compare(const LayerJob& job, vcg::CallBackPos* progress)
{
	const Comparison comparison =
		compareWithQuadricCollapse(job.copy().view(), job.options(), progressTo(progress));
	const Lines lines = comparisonLines(comparison);
	job.putCompared(comparison);
	return {true, lines, comparisonFigures(comparison)};
}

/// Of Quadric Edge Collapse in MeshLab, always on one thread.
constexpr double kCollapseMicrosecondsPerFace = 10;

/// No MeshLab host can cancel a filter, so the log tells the expected time and memory beforehand.
std::string estimateLine(Filter filter, const LayerJob& job)
{
	gpr::RemeshOptions options = job.options();
	if (filter == RetriangulateFilter) {
		options.targetMode      = gpr::TargetMode::VertexNum;
		options.targetVertexNum = job.sampleNum();
	}
	const gpr::MeshView view     = job.copy().view();
	gpr::RunEstimate    estimate = gpr::estimateRun(view, options, toolOf(filter));
	if (filter == CompareFilter)
		estimate.seconds += 1e-6 * kCollapseMicrosecondsPerFace * double(view.faceNum);
	return "Expected: " + gpr::estimateText(estimate);
}

RunOutcome runFilter(Filter filter, const LayerJob& job, vcg::CallBackPos* progress)
{
	switch (filter) {
	case SamplingFilter:
		return sample(job, progress);
	case RetriangulateFilter:
		return retriangulate(job, progress);
	case FeatureFilter:
		return detectFeatures(job, progress);
	case CompareFilter:
		return compare(job, progress);
	default:
		return remesh(job, progress);
	}
}

RunOutcome giveUp(const char* what, const char* why) noexcept
try {
	return {false, {std::string(what) + why}, {}};
}
catch (...) {
	// Not even memory for a sentence.
	return {};
}

} // namespace

int postConditionOf(Filter filter)
{
	switch (filter) {
	case SamplingFilter:
	case CompareFilter:
		return MeshModel::MM_NONE; // they only add layers
	case FeatureFilter:
		return MeshModel::MM_VERTQUALITY | MeshModel::MM_VERTFLAGSELECT;
	default:
		return MeshModel::MM_GEOMETRY_AND_TOPOLOGY_CHANGE;
	}
}

RunOutcome FilterRunner::run(Filter filter, MeshDocument& document, const RichParameterList& list,
							 vcg::CallBackPos* progress, const LogLine& log) noexcept
try {
	if (_running) throw Refusal("A filter of this plugin is running already; wait for its end.");
	const Flagged  running(_running);
	const LayerJob job(document, filter, list);
	for (const std::string& note : job.notes())
		log(note);
	log(estimateLine(filter, job));
	return runFilter(filter, job, progress);
}
catch (const Refusal& refusal) {
	return {false, refusal.sentences(), {}};
}
catch (const std::bad_alloc&) {
	return giveUp("There is not enough memory for this.", "");
}
catch (const std::exception& error) {
	return giveUp("Internal error: ", error.what());
}
catch (...) {
	return giveUp("Internal error.", "");
}

QString asHtml(const std::vector<std::string>& sentences, const char* separator)
{
	QStringList paragraphs;
	for (const std::string& sentence : sentences) {
		paragraphs << QString::fromStdString(sentence).toHtmlEscaped().replace("&quot;", "\"");
	}
	return paragraphs.join(separator);
}

} // namespace gpr_filter
