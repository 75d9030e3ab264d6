// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef FILTER_GEODESIC_POISSON_EDIT_INTERFACE_H
#define FILTER_GEODESIC_POISSON_EDIT_INTERFACE_H

// The interface of MeshLab 2020.09 to edit tools, under the names of MeshLab 2025.07.

#include <QAction>
#include <common/interfaces.h>

#define GPR_EDIT_PLUGIN MeshEditInterfaceFactory
#define GPR_EDIT_PLUGIN_IID MESH_EDIT_INTERFACE_FACTORY_IID

namespace gpr_filter {

class EditTool : public MeshEditInterface {
public:
	using Scene = MLSceneGLSharedDataContext;
	using MeshEditInterface::Decorate;
	using MeshEditInterface::StartEdit;

	virtual bool startEdit(MeshModel& layer, GLArea* view, Scene* scene)     = 0;
	virtual void endEdit(MeshModel& layer, GLArea* view, Scene* scene)       = 0;
	virtual void endEdit(MeshDocument& document, GLArea* view, Scene* scene) = 0;
	virtual void decorate(MeshModel& layer, GLArea* view)                    = 0;

	bool StartEdit(MeshModel& m, GLArea* v, Scene* s) final { return startEdit(m, v, s); }
	void EndEdit(MeshModel& m, GLArea* v, Scene* s) final { endEdit(m, v, s); }
	void EndEdit(MeshDocument& d, GLArea* v, Scene* s) final { endEdit(d, v, s); }
	void Decorate(MeshModel& m, GLArea* v) final { decorate(m, v); }
};

class EditPlugin : public MeshEditInterfaceFactory {
public:
	virtual QString   pluginName() const                            = 0;
	virtual QString   vendor() const                                = 0;
	virtual EditTool* getEditTool(const QAction* action)            = 0;
	virtual QString   getEditToolDescription(const QAction* action) = 0;

	QList<QAction*>    actions() const final { return actionList; }
	MeshEditInterface* getMeshEditInterface(QAction* a) final { return getEditTool(a); }
	QString            getEditToolDescription(QAction* a) final
	{
		return getEditToolDescription(static_cast<const QAction*>(a));
	}

protected:
	QList<QAction*> actionList;
};

} // namespace gpr_filter

#endif
