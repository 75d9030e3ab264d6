// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef TESTS_PLUGIN_HOST_API_H
#define TESTS_PLUGIN_HOST_API_H

// The parts of MeshLab's interface with another name or form in other versions: 2020.09.

#include <common/interfaces.h>

namespace plugin_test {

using PluginInterface = MeshFilterInterface;

/// The plugin from MeshLab's plugin manager, and its filter of a name.
PluginInterface& loadedPlugin();
QAction*         loadedAction(const char* name);

RichParameterList defaultsOf(QAction* action, MeshDocument& document);

/// Applies a filter; false after a failure, with a text for the user.
bool applyAction(QAction* action, MeshDocument& document, const RichParameterList& list,
				 vcg::CallBackPos* progress, QString& errorText);

inline int layerNum(const MeshDocument& document)
{
	return document.size();
}

inline MeshModel& layerAt(MeshDocument& document, int i)
{
	return *document.meshList.at(i);
}

inline void removeLayer(MeshDocument& document, MeshModel* layer)
{
	document.delMesh(layer);
}

inline bool hasCurvature(CMeshO& mesh)
{
	return mesh.vert.IsCurvatureEnabled();
}

} // namespace plugin_test

#endif
