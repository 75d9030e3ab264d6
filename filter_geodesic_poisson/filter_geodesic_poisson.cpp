// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_geodesic_poisson.h"

#include "filter_text.h"
#include "layer_job.h"
#include "mesh_bridge.h"
#include "parameter_bridge.h"
#include "refusal.h"
#include "run_report.h"

#include <exception>
#include <new>
#include <vcg_extras/core/remesh.h>

namespace {

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
	if (result.status != gpr::Status::Ok) throw gpr_filter::Refusal(result.message);
}

} // namespace

FilterGeodesicPoisson::FilterGeodesicPoisson()
{
	typeList << FP_GEODESIC_POISSON_REMESHING << FP_GEODESIC_POISSON_SAMPLING << FP_RETRIANGULATION
			 << FP_FEATURE_DETECTION;
	for (FilterIDType filter : types()) {
		actionList << new QAction(filterName(filter), this);
	}
}

QString FilterGeodesicPoisson::pluginName() const
{
	return "FilterGeodesicPoisson";
}

QString FilterGeodesicPoisson::filterName(FilterIDType filter) const
{
	return QString::fromUtf8(gpr_filter::textOf(gpr::Tool(filter)).name);
}

QString FilterGeodesicPoisson::filterInfo(FilterIDType filter) const
{
	return QString::fromUtf8(gpr_filter::textOf(gpr::Tool(filter)).info);
}

MeshFilterInterface::FilterClass FilterGeodesicPoisson::getClass(QAction* action)
{
	switch (ID(action)) {
	case FP_GEODESIC_POISSON_SAMPLING:
		return Sampling;
	case FP_FEATURE_DETECTION:
		return FilterClass(Selection | Quality);
	default:
		return Remeshing;
	}
}

int FilterGeodesicPoisson::getPreConditions(QAction*) const
{
	return MeshModel::MM_FACENUMBER;
}

int FilterGeodesicPoisson::postCondition(QAction* action) const
{
	switch (ID(action)) {
	case FP_GEODESIC_POISSON_SAMPLING:
		return MeshModel::MM_NONE; // it only adds a layer
	case FP_FEATURE_DETECTION:
		return MeshModel::MM_VERTQUALITY | MeshModel::MM_VERTFLAGSELECT |
			   MeshModel::MM_FACEFLAGSELECT;
	default:
		return MeshModel::MM_GEOMETRY_AND_TOPOLOGY_CHANGE;
	}
}

MeshFilterInterface::FILTER_ARITY FilterGeodesicPoisson::filterArity(QAction*) const
{
	return SINGLE_MESH;
}

void FilterGeodesicPoisson::initParameterSet(QAction* action, MeshDocument& document,
											 RichParameterList& list)
{
	gpr_filter::fillParameterList(gpr::parametersOf(gpr::Tool(ID(action))),
								  gpr_filter::factsOf(document), list);
}

bool FilterGeodesicPoisson::applyFilter(QAction* action, MeshDocument& document,
										const RichParameterList& list, vcg::CallBackPos* progress)
try {
	errorMessage.clear();
	if (_running) return refuse({"A filter of this plugin is running already; wait for its end."});
	const Flagged running(_running);
	logAll(run(ID(action), document, list, progress));
	return true;
}
catch (const gpr_filter::Refusal& refusal) {
	return refuse(refusal.sentences());
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

FilterGeodesicPoisson::Lines FilterGeodesicPoisson::run(FilterIDType filter, MeshDocument& document,
														const RichParameterList& list,
														vcg::CallBackPos*        progress)
{
	const gpr_filter::LayerJob job(document, gpr::Tool(filter), list);
	switch (filter) {
	case FP_GEODESIC_POISSON_SAMPLING:
		return sample(job, progress);
	case FP_RETRIANGULATION:
		return retriangulate(job, progress);
	case FP_FEATURE_DETECTION:
		return detectFeatures(job, progress);
	default:
		return remesh(job, progress);
	}
}

FilterGeodesicPoisson::Lines FilterGeodesicPoisson::remesh(const gpr_filter::LayerJob& job,
														   vcg::CallBackPos*           progress)
{
	const gpr::RemeshResult result =
		gpr::remesh(job.copy().view(), job.options(), progressTo(progress));
	requireOk(result);
	CMeshO built;
	gpr_filter::buildMesh(result, job.copy(), built);
	Lines lines = gpr_filter::remeshingLines(result);
	lines.push_back(job.put(built, "_remeshed"));
	return lines;
}

FilterGeodesicPoisson::Lines FilterGeodesicPoisson::sample(const gpr_filter::LayerJob& job,
														   vcg::CallBackPos*           progress)
{
	const gpr::SamplingResult result =
		gpr::samplePoissonDisks(job.copy().view(), job.options(), progressTo(progress));
	requireOk(result);
	CMeshO built;
	gpr_filter::buildPoints(result, job.copy(), built);
	Lines lines = gpr_filter::samplingLines(result);
	job.putPoints(built, "_samples");
	return lines;
}

FilterGeodesicPoisson::Lines FilterGeodesicPoisson::retriangulate(const gpr_filter::LayerJob& job,
																  vcg::CallBackPos* progress)
{
	const gpr::RemeshResult result =
		gpr::retriangulate(job.copy().view(), job.samples(), job.options(), progressTo(progress));
	requireOk(result);
	CMeshO built;
	gpr_filter::buildMesh(result, job.copy(), built);
	Lines lines = gpr_filter::retriangulationLines(result);
	lines.push_back(job.put(built, "_retriangulated"));
	return lines;
}

FilterGeodesicPoisson::Lines FilterGeodesicPoisson::detectFeatures(const gpr_filter::LayerJob& job,
																   vcg::CallBackPos* progress)
{
	const gpr::FeatureResult result =
		gpr::detectFeatures(job.copy().view(), job.options(), progressTo(progress));
	requireOk(result);
	job.mark(result);
	return gpr_filter::featureLines(result);
}

void FilterGeodesicPoisson::logAll(const Lines& lines)
{
	// As std::string and by itself, a line is never taken for a printf format.
	for (const std::string& line : lines) {
		if (!line.empty()) Log(line);
	}
}

bool FilterGeodesicPoisson::refuse(const Lines& sentences)
{
	// The failure box shows errorMessage as HTML; meshlabserver shows the log only.
	QStringList paragraphs;
	for (const std::string& sentence : sentences) {
		paragraphs << QString::fromStdString(sentence).toHtmlEscaped();
	}
	errorMessage = paragraphs.join("<br>");
	logAll(sentences);
	return false;
}

bool FilterGeodesicPoisson::giveUp(const char* what, const char* why) noexcept
try {
	return refuse({std::string(what) + why});
}
catch (...) {
	// Not even memory for a sentence.
	return false;
}
