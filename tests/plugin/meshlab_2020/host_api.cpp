// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "host_api.h"

#include <QFileInfo>
#include <common/pluginmanager.h>

namespace plugin_test {

namespace {

PluginManager& manager()
{
	// Never destroyed: plugins do not survive the end of QApplication.
	static PluginManager& loaded = *[] {
		auto*             made = new PluginManager;
		RichParameterList globals;
		made->loadPlugins(globals, QFileInfo(GPR_PLUGIN_FILE).absoluteDir());
		return made;
	}();
	return loaded;
}

} // namespace

PluginInterface& loadedPlugin()
{
	return *manager().stringFilterMap.value("Remeshing: Geodesic Poisson Disk");
}

QAction* loadedAction(const char* name)
{
	return manager().actionFilterMap.value(name);
}

RichParameterList defaultsOf(QAction* action, MeshDocument& document)
{
	RichParameterList list;
	loadedPlugin().initParameterSet(action, document, list);
	return list;
}

bool applyAction(QAction* action, MeshDocument& document, const RichParameterList& list,
				 vcg::CallBackPos* progress, QString& errorText)
{
	const bool done = loadedPlugin().applyFilter(action, document, list, progress);
	errorText       = loadedPlugin().errorMsg();
	return done;
}

} // namespace plugin_test
