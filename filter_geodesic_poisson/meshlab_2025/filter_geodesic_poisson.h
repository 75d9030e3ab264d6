// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef FILTER_GEODESIC_POISSON_H
#define FILTER_GEODESIC_POISSON_H

#include "filter_run.h"

#include <common/plugins/interfaces/filter_plugin.h>

/// The adapter to MeshLab 2025.07's plugin interface: names and types of this version, and nothing
/// of the filters' work. PyMeshLab of the same version calls the same functions.
class FilterGeodesicPoisson : public QObject, public FilterPlugin {
	Q_OBJECT
	MESHLAB_PLUGIN_IID_EXPORTER(FILTER_PLUGIN_IID)
	Q_INTERFACES(FilterPlugin)

public:
	/// A filter for each tool of the engine, by the tool's number.
	enum {
		FP_GEODESIC_POISSON_REMESHING = gpr_filter::RemeshFilter,
		FP_GEODESIC_POISSON_SAMPLING  = gpr_filter::SamplingFilter,
		FP_RETRIANGULATION            = gpr_filter::RetriangulateFilter,
		FP_FEATURE_DETECTION          = gpr_filter::FeatureFilter,
		FP_COMPARISON                 = gpr_filter::CompareFilter,
	};

	/// Runs before the host has checked version and scalar, so the constructor does next to
	/// nothing.
	FilterGeodesicPoisson();

	QString pluginName() const override;
	QString vendor() const override;
	using FilterPlugin::filterName;
	QString filterName(ActionIDType filter) const override;
	using FilterPlugin::pythonFilterName;
	QString pythonFilterName(ActionIDType filter) const override;
	using FilterPlugin::filterInfo;
	QString     filterInfo(ActionIDType filter) const override;
	FilterClass getClass(const QAction* action) const override;
	int         getPreConditions(const QAction* action) const override;
	int         postCondition(const QAction* action) const override;
	FilterArity filterArity(const QAction* action) const override;
	using FilterPlugin::initParameterList;
	RichParameterList initParameterList(const QAction*      action,
										const MeshDocument& document) override;

	/// Returns figures of the run, which PyMeshLab exports as a dictionary. Throws MLException,
	/// after a log line, if nothing was done: then the document is unchanged.
	std::map<std::string, QVariant>
	applyFilter(const QAction* action, const RichParameterList& list, MeshDocument& document,
				unsigned int& postConditionMask, vcg::CallBackPos* progress) override;

private:
	gpr_filter::FilterRunner _runner;
};

#endif
