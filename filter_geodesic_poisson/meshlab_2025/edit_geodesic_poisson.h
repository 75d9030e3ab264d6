// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EDIT_GEODESIC_POISSON_H
#define EDIT_GEODESIC_POISSON_H

#include <QObject>
#include <common/plugins/interfaces/edit_plugin.h>
#include <memory>

namespace gpr_filter {
class EditSession;
struct EditMemory;
} // namespace gpr_filter

/// The edit tool for MeshLab 2025.07, one a document: names and types of that version, nothing of
/// what the tool does.
class EditGeodesicPoisson : public QObject, public EditTool {
	Q_OBJECT

public:
	EditGeodesicPoisson();
	~EditGeodesicPoisson() override;

	using EditTool::endEdit;
	using EditTool::startEdit;
	bool startEdit(MeshModel& layer, GLArea* view, MLSceneGLSharedDataContext* context) override;
	void endEdit(MeshModel& layer, GLArea* view, MLSceneGLSharedDataContext* context) override;
	void endEdit(MeshDocument& document, GLArea* view,
				 MLSceneGLSharedDataContext* context) override;
	using EditTool::decorate;
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
class EditGeodesicPoissonPlugin : public QObject, public EditPlugin {
	Q_OBJECT
	MESHLAB_PLUGIN_IID_EXPORTER(EDIT_PLUGIN_IID)
	Q_INTERFACES(EditPlugin)

public:
	/// Runs before the host has checked version and scalar, so it does next to nothing.
	EditGeodesicPoissonPlugin();

	QString   pluginName() const override;
	QString   vendor() const override;
	EditTool* getEditTool(const QAction* action) override;
	QString   getEditToolDescription(const QAction* action) override;
};

#endif
