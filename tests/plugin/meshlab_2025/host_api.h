// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef TESTS_PLUGIN_HOST_API_H
#define TESTS_PLUGIN_HOST_API_H

// The parts of MeshLab's interface with another name or form in other versions: 2025.07.

#include <common/plugins/interfaces/filter_plugin.h>
#include <iterator>

namespace plugin_test {

using PluginInterface = FilterPlugin;
using EnumValue       = IntValue;
using AbsPercValue    = FloatValue;

/// The plugin from MeshLab's plugin manager, and its filter of a name.
PluginInterface& loadedPlugin();
QAction*         loadedAction(const char* name);

RichParameterList defaultsOf(QAction* action, MeshDocument& document);

/// Applies a filter; false after a failure, with a text for the user.
bool applyAction(QAction* action, MeshDocument& document, const RichParameterList& list,
				 vcg::CallBackPos* progress, QString& errorText);

inline int layerNum(const MeshDocument& document)
{
	return int(document.meshNumber());
}

inline MeshModel& layerAt(MeshDocument& document, int i)
{
	return *std::next(document.meshBegin(), i);
}

inline void removeLayer(MeshDocument& document, MeshModel* layer)
{
	document.delMesh(unsigned(layer->id()));
}

inline bool hasCurvature(CMeshO& mesh)
{
	return vcg::tri::HasPerVertexAttribute(mesh, "KH") ||
		   vcg::tri::HasPerVertexAttribute(mesh, "KG");
}

} // namespace plugin_test

#endif
