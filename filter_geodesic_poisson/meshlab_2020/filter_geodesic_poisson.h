// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef FILTER_GEODESIC_POISSON_H
#define FILTER_GEODESIC_POISSON_H

#include "filter_run.h"

#include <common/interfaces.h>

/// The adapter to MeshLab 2020.09's plugin interface: names and types of this version, and nothing
/// of the filters' work.
class FilterGeodesicPoisson : public QObject, public MeshFilterInterface {
	Q_OBJECT
	MESHLAB_PLUGIN_IID_EXPORTER(MESH_FILTER_INTERFACE_IID)
	Q_INTERFACES(MeshFilterInterface)

public:
	/// A filter for each tool of the engine, by the tool's number.
	enum {
		FP_GEODESIC_POISSON_REMESHING = gpr_filter::RemeshFilter,
		FP_GEODESIC_POISSON_SAMPLING  = gpr_filter::SamplingFilter,
		FP_RETRIANGULATION            = gpr_filter::RetriangulateFilter,
		FP_FEATURE_DETECTION          = gpr_filter::FeatureFilter,
		FP_COMPARISON                 = gpr_filter::CompareFilter,
	};

	FilterGeodesicPoisson();

	QString      pluginName() const override;
	QString      filterName(FilterIDType filter) const override;
	QString      filterInfo(FilterIDType filter) const override;
	FilterClass  getClass(QAction* action) override;
	int          getPreConditions(QAction* action) const override;
	int          postCondition(QAction* action) const override;
	FILTER_ARITY filterArity(QAction* action) const override;
	using MeshFilterInterface::initParameterSet;
	void initParameterSet(QAction* action, MeshDocument& document,
						  RichParameterList& list) override;

	/// Never throws. False, with errorMessage and a log line, if nothing was done: then the
	/// document is unchanged.
	bool applyFilter(QAction* action, MeshDocument& document, const RichParameterList& list,
					 vcg::CallBackPos* progress) override;

private:
	gpr_filter::FilterRunner _runner;
};

#endif
