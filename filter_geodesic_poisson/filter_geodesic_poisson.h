// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef FILTER_GEODESIC_POISSON_H
#define FILTER_GEODESIC_POISSON_H

#include <common/interfaces.h>
#include <string>
#include <vcg_extras/core/parameters.h>
#include <vector>

namespace gpr_filter {
class LayerJob;
}

/// The adapter to MeshLab 2020.09's plugin interface: turns one applyFilter into one call of the
/// engine. Parameters, mesh and texts go over bridges that other versions' adapters share.
class FilterGeodesicPoisson : public QObject, public MeshFilterInterface {
	Q_OBJECT
	MESHLAB_PLUGIN_IID_EXPORTER(MESH_FILTER_INTERFACE_IID)
	Q_INTERFACES(MeshFilterInterface)

public:
	/// A filter for each tool of the engine, by the tool's number.
	enum {
		FP_GEODESIC_POISSON_REMESHING = gpr::RemeshTool,
		FP_GEODESIC_POISSON_SAMPLING  = gpr::SamplingTool,
		FP_RETRIANGULATION            = gpr::RetriangulateTool,
		FP_FEATURE_DETECTION          = gpr::FeatureTool,
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

	/// Never throws. False, with errorMessage and a log line, when nothing was done: then the
	/// document is as it was.
	bool applyFilter(QAction* action, MeshDocument& document, const RichParameterList& list,
					 vcg::CallBackPos* progress) override;

private:
	/// The host's progress bar handles events, so Apply can be pressed again while the filter runs.
	bool _running = false;

	using Lines = std::vector<std::string>; ///< for the log

	// What a filter does; throws gpr_filter::Refusal where it cannot.
	static Lines run(FilterIDType filter, MeshDocument& document, const RichParameterList& list,
					 vcg::CallBackPos* progress);
	static Lines remesh(const gpr_filter::LayerJob& job, vcg::CallBackPos* progress);
	static Lines sample(const gpr_filter::LayerJob& job, vcg::CallBackPos* progress);
	static Lines retriangulate(const gpr_filter::LayerJob& job, vcg::CallBackPos* progress);
	static Lines detectFeatures(const gpr_filter::LayerJob& job, vcg::CallBackPos* progress);

	bool refuse(const Lines& sentences);
	bool giveUp(const char* what, const char* why) noexcept;
	void logAll(const Lines& lines);
};

#endif
