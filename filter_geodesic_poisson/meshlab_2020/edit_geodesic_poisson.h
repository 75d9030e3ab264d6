// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EDIT_GEODESIC_POISSON_H
#define EDIT_GEODESIC_POISSON_H

#include <QObject>
#include <common/interfaces.h>
#include <memory>

namespace gpr_filter {
class EditSession;
struct EditMemory;
} // namespace gpr_filter

/// The edit tool for MeshLab 2020.09, one a document: names and types of that version, nothing of
/// what the tool does.
class EditGeodesicPoisson : public QObject, public MeshEditInterface {
	Q_OBJECT

public:
	EditGeodesicPoisson();
	~EditGeodesicPoisson() override;

	using MeshEditInterface::EndEdit;
	using MeshEditInterface::StartEdit;
	bool StartEdit(MeshModel& layer, GLArea* view, MLSceneGLSharedDataContext* context) override;
	void EndEdit(MeshModel& layer, GLArea* view, MLSceneGLSharedDataContext* context) override;
	void EndEdit(MeshDocument& document, GLArea* view,
				 MLSceneGLSharedDataContext* context) override;
	using MeshEditInterface::Decorate;
	void Decorate(MeshModel& layer, GLArea* view) override;
	void mousePressEvent(QMouseEvent* event, MeshModel& layer, GLArea* view) override;
	void mouseMoveEvent(QMouseEvent* event, MeshModel& layer, GLArea* view) override;
	void mouseReleaseEvent(QMouseEvent* event, MeshModel& layer, GLArea* view) override;
	void wheelEvent(QWheelEvent* event, MeshModel& layer, GLArea* view) override;

private:
	std::unique_ptr<gpr_filter::EditMemory>  _memory;
	std::unique_ptr<gpr_filter::EditSession> _session;
};

/// Makes a tool for each document.
class EditGeodesicPoissonFactory : public QObject, public MeshEditInterfaceFactory {
	Q_OBJECT
	MESHLAB_PLUGIN_IID_EXPORTER(MESH_EDIT_INTERFACE_FACTORY_IID)
	Q_INTERFACES(MeshEditInterfaceFactory)

public:
	EditGeodesicPoissonFactory();

	QList<QAction*>    actions() const override;
	MeshEditInterface* getMeshEditInterface(QAction* action) override;
	QString            getEditToolDescription(QAction* action) override;

private:
	QList<QAction*> _actions;
};

#endif
