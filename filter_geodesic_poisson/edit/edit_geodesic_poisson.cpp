// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "edit_geodesic_poisson.h"

#include "edit_session.h"
#include "edit_text.h"

#include <QAction>
#include <QIcon>

EditGeodesicPoisson::EditGeodesicPoisson() : _memory(new gpr_filter::EditMemory) {}
EditGeodesicPoisson::~EditGeodesicPoisson() = default;

bool EditGeodesicPoisson::startEdit(MeshModel& layer, GLArea* view,
									MLSceneGLSharedDataContext* context)
{
	_session.reset();
	if (layer.cm.fn == 0 || view->md() == nullptr || context == nullptr) return false;
	if (view->md()->isBusy()) return false; // a file is being opened, or a filter runs
	_session =
		std::make_unique<gpr_filter::EditSession>(*view->md(), layer, *view, *context, *_memory);
	connect(view, &QObject::destroyed, _session.get(), [this] {
		_session->forgetView();
		_session.reset();
	});
	return true;
}

void EditGeodesicPoisson::endEdit(MeshModel&, GLArea*, MLSceneGLSharedDataContext*)
{
	_session.reset();
}

void EditGeodesicPoisson::endEdit(MeshDocument&, GLArea*, MLSceneGLSharedDataContext*)
{
	_session.reset();
}

void EditGeodesicPoisson::decorate(MeshModel&, GLArea*)
{
	if (_session != nullptr) _session->draw();
}

void EditGeodesicPoisson::mousePressEvent(QMouseEvent* event, MeshModel&, GLArea*)
{
	if (_session != nullptr) _session->mousePressEvent(*event);
}

void EditGeodesicPoisson::mouseMoveEvent(QMouseEvent* event, MeshModel&, GLArea*)
{
	if (_session != nullptr) _session->mouseMoveEvent(*event);
}

void EditGeodesicPoisson::mouseReleaseEvent(QMouseEvent* event, MeshModel&, GLArea*)
{
	if (_session != nullptr) _session->mouseReleaseEvent(*event);
}

void EditGeodesicPoisson::wheelEvent(QWheelEvent* event, MeshModel&, GLArea*)
{
	if (_session != nullptr) _session->passOn(*event);
}

EditGeodesicPoissonPlugin::EditGeodesicPoissonPlugin()
{
	auto* action = new QAction(QIcon(gpr_filter::kEditIcon), gpr_filter::kEditName, this);
	action->setCheckable(true);
	actionList.push_back(action);
}

QString EditGeodesicPoissonPlugin::pluginName() const
{
	return "EditGeodesicPoisson";
}

QString EditGeodesicPoissonPlugin::vendor() const
{
	return "the gpremesh authors";
}

gpr_filter::EditTool* EditGeodesicPoissonPlugin::getEditTool(const QAction*)
{
	return new EditGeodesicPoisson();
}

QString EditGeodesicPoissonPlugin::getEditToolDescription(const QAction*)
{
	return gpr_filter::kEditDescription;
}
