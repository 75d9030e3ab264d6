// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EDIT_GEODESIC_POISSON_H
#define EDIT_GEODESIC_POISSON_H

#include "edit_interface.h"

#include <QObject>
#include <memory>

namespace gpr_filter {
class EditSession;
struct EditMemory;
} // namespace gpr_filter

/// The edit tool, one for each document: names and types of MeshLab's interface, and nothing of the
/// tool's work.
class EditGeodesicPoisson : public QObject, public gpr_filter::EditTool {
	Q_OBJECT

public:
	EditGeodesicPoisson();
	~EditGeodesicPoisson() override;

	bool startEdit(MeshModel& layer, GLArea* view, MLSceneGLSharedDataContext* context) override;
	void endEdit(MeshModel& layer, GLArea* view, MLSceneGLSharedDataContext* context) override;
	void endEdit(MeshDocument& document, GLArea* view,
				 MLSceneGLSharedDataContext* context) override;
	void decorate(MeshModel& layer, GLArea* view) override;
	void mousePressEvent(QMouseEvent* event, MeshModel& layer, GLArea* view) override;
	void mouseMoveEvent(QMouseEvent* event, MeshModel& layer, GLArea* view) override;
	void mouseReleaseEvent(QMouseEvent* event, MeshModel& layer, GLArea* view) override;
	void wheelEvent(QWheelEvent* event, MeshModel& layer, GLArea* view) override;

private:
	std::unique_ptr<gpr_filter::EditMemory>  _memory;
	std::unique_ptr<gpr_filter::EditSession> _session;
};

/// Makes a tool for each document.
class EditGeodesicPoissonPlugin : public QObject, public gpr_filter::EditPlugin {
	Q_OBJECT
	MESHLAB_PLUGIN_IID_EXPORTER(GPR_EDIT_PLUGIN_IID)
	Q_INTERFACES(GPR_EDIT_PLUGIN)

public:
	/// Runs before a host has checked version and scalar, so the constructor does next to nothing.
	EditGeodesicPoissonPlugin();

	QString               pluginName() const override;
	QString               vendor() const override;
	gpr_filter::EditTool* getEditTool(const QAction* action) override;
	QString               getEditToolDescription(const QAction* action) override;
};

#endif
