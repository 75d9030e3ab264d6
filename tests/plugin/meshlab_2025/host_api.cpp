// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "host_api.h"

#include <QtGlobal>
#include <common/mlexception.h>
#include <common/plugins/plugin_manager.h>

namespace plugin_test {

namespace {

PluginManager& manager()
{
	// Never destroyed: plugins do not survive the end of QApplication.
	static PluginManager& loaded = *[] {
		auto* made = new PluginManager;
		made->loadPlugin(qEnvironmentVariable("GPR_PLUGIN_FILE", GPR_PLUGIN_FILE));
		return made;
	}();
	return loaded;
}

} // namespace

PluginInterface& loadedPlugin()
{
	return *manager().getFilterPluginFromAction(loadedAction("Remeshing: Geodesic Poisson Disk"));
}

QAction* loadedAction(const char* name)
{
	return manager().filterAction(name);
}

RichParameterList defaultsOf(QAction* action, MeshDocument& document)
{
	const MeshDocument& asTheHostHasIt = document;
	return loadedPlugin().initParameterList(action, asTheHostHasIt);
}

bool applyAction(QAction* action, MeshDocument& document, const RichParameterList& list,
				 vcg::CallBackPos* progress, QString& errorText)
try {
	errorText.clear();
	unsigned int changed = 0;
	loadedPlugin().applyFilter(action, list, document, changed, progress);
	return true;
}
catch (const MLException& failure) { // any other kind ends MeshLab
	errorText = QString::fromUtf8(failure.what());
	return false;
}

} // namespace plugin_test
