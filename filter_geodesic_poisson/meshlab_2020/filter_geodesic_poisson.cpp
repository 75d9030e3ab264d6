// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_geodesic_poisson.h"

#include "dialog_height.h"
#include "filter_text.h"
#include "layer_job.h"
#include "parameter_bridge.h"

FilterGeodesicPoisson::FilterGeodesicPoisson()
{
	typeList << FP_GEODESIC_POISSON_REMESHING << FP_GEODESIC_POISSON_SAMPLING << FP_RETRIANGULATION
			 << FP_FEATURE_DETECTION << FP_COMPARISON;
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
	return QString::fromUtf8(gpr_filter::textOf(gpr_filter::Filter(filter)).name);
}

QString FilterGeodesicPoisson::filterInfo(FilterIDType filter) const
{
	return QString::fromUtf8(gpr_filter::textOf(gpr_filter::Filter(filter)).info);
}

MeshFilterInterface::FilterClass FilterGeodesicPoisson::getClass(QAction* action)
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

int FilterGeodesicPoisson::getPreConditions(QAction*) const
{
	return gpr_filter::kPreCondition;
}

int FilterGeodesicPoisson::postCondition(QAction* action) const
{
	return gpr_filter::postConditionOf(gpr_filter::Filter(ID(action)));
}

MeshFilterInterface::FILTER_ARITY FilterGeodesicPoisson::filterArity(QAction*) const
{
	return SINGLE_MESH;
}

void FilterGeodesicPoisson::initParameterSet(QAction* action, MeshDocument& document,
											 RichParameterList& list)
{
	const std::vector<gpr::Parameter>& table = gpr_filter::rowsOf(gpr_filter::Filter(ID(action)));
	gpr_filter::fillParameterList(table, gpr_filter::factsOf(document), list,
								  gpr_filter::proposedFor(document));
	// The host asks just before the dialog is shown; meshlabserver asks, too, and shows no dialog.
	gpr_filter::shortenDialogLater(filterName(ID(action)), int(gpr_filter::everydayRowNum(table)),
								   this);
}

bool FilterGeodesicPoisson::applyFilter(QAction* action, MeshDocument& document,
										const RichParameterList& list, vcg::CallBackPos* progress)
try {
	errorMessage.clear();
	// As std::string and by itself, a line is never taken for a printf format.
	const gpr_filter::LogLine    tell = [this](const std::string& line) { Log(line); };
	const gpr_filter::RunOutcome outcome =
		_runner.run(gpr_filter::Filter(ID(action)), document, list, progress, tell);
	// The failure box shows errorMessage as HTML; meshlabserver shows the log only.
	if (!outcome.done) errorMessage = gpr_filter::asHtml(outcome.lines, "<br>");
	for (const std::string& line : outcome.lines) {
		if (!line.empty()) tell(line);
	}
	return outcome.done;
}
catch (...) {
	// No memory for the words about the failure.
	return false;
}
