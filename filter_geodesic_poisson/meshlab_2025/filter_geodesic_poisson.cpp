// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_geodesic_poisson.h"

#include "filter_text.h"
#include "layer_job.h"
#include "parameter_bridge.h"

#include <common/mlexception.h>

FilterGeodesicPoisson::FilterGeodesicPoisson()
{
	typeList = {FP_GEODESIC_POISSON_REMESHING, FP_GEODESIC_POISSON_SAMPLING, FP_RETRIANGULATION,
				FP_FEATURE_DETECTION, FP_COMPARISON};
	for (ActionIDType filter : types()) {
		actionList.push_back(new QAction(filterName(filter), this));
	}
}

QString FilterGeodesicPoisson::pluginName() const
{
	return "FilterGeodesicPoisson";
}

QString FilterGeodesicPoisson::vendor() const
{
	return "the gpremesh authors";
}

QString FilterGeodesicPoisson::filterName(ActionIDType filter) const
{
	return QString::fromUtf8(gpr_filter::textOf(gpr_filter::Filter(filter)).name);
}

QString FilterGeodesicPoisson::pythonFilterName(ActionIDType filter) const
{
	return QString::fromUtf8(gpr_filter::textOf(gpr_filter::Filter(filter)).pythonName);
}

QString FilterGeodesicPoisson::filterInfo(ActionIDType filter) const
{
	return QString::fromUtf8(gpr_filter::textOf(gpr_filter::Filter(filter)).info);
}

FilterPlugin::FilterClass FilterGeodesicPoisson::getClass(const QAction* action) const
{
	switch (ID(action)) {
	case FP_GEODESIC_POISSON_SAMPLING:
		return Sampling;
	case FP_FEATURE_DETECTION:
		return FilterClass(Selection | Quality);
	case FP_COMPARISON:
		return FilterClass(Remeshing | MeshCreation); // the latter shows all layers anew
	default:
		return Remeshing;
	}
}

int FilterGeodesicPoisson::getPreConditions(const QAction*) const
{
	return gpr_filter::kPreCondition;
}

int FilterGeodesicPoisson::postCondition(const QAction* action) const
{
	return gpr_filter::postConditionOf(gpr_filter::Filter(ID(action)));
}

FilterPlugin::FilterArity FilterGeodesicPoisson::filterArity(const QAction*) const
{
	return SINGLE_MESH;
}

RichParameterList FilterGeodesicPoisson::initParameterList(const QAction*      action,
														   const MeshDocument& document)
{
	RichParameterList list;
	gpr_filter::fillParameterList(gpr_filter::rowsOf(gpr_filter::Filter(ID(action))),
								  gpr_filter::factsOf(document), list,
								  gpr_filter::proposedFor(document));
	return list;
}

std::map<std::string, QVariant> FilterGeodesicPoisson::applyFilter(const QAction*           action,
																   const RichParameterList& list,
																   MeshDocument& document,
																   unsigned int&,
																   vcg::CallBackPos* progress)
{
	// As std::string and by itself, a line is never taken for a printf format.
	const gpr_filter::LogLine    tell = [this](const std::string& line) { log(line); };
	const gpr_filter::RunOutcome outcome =
		_runner.run(gpr_filter::Filter(ID(action)), document, list, progress, tell);
	for (const std::string& line : outcome.lines) {
		if (!line.empty()) tell(line);
	}
	// The failure box shows the text as HTML, Python as plain text.
	if (!outcome.done) throw MLException(gpr_filter::asHtml(outcome.lines, "\n"));
	std::map<std::string, QVariant> figures;
	for (const auto& [name, figure] : outcome.figures) {
		figures[name] = figure;
	}
	return figures;
}
