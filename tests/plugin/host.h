// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef TESTS_PLUGIN_HOST_H
#define TESTS_PLUGIN_HOST_H

// A host for the plugin without window or OpenGL: MeshLab's own plugin manager and documents.

#include "filter_rows.h"
#include "host_api.h"
#include "mesh_bridge.h"

#include <vcg_extras/core/mesh_view.h>
#include <vcg_extras/core/parameters.h>

#include <functional>
#include <vector>

namespace plugin_test {

/// The plugin from MeshLab's plugin manager.
PluginInterface& plugin();
/// The action of a filter of the plugin.
QAction* actionOf(gpr_filter::Filter filter);

/// A document with a log that goes to the plugin, as in the real hosts.
class Document {
public:
	Document();
	~Document();

	MeshDocument& operator*() { return _document; }
	MeshDocument* operator->() { return &_document; }
	MeshModel&    layer(int i = 0) { return layerAt(_document, i); }
	int           layerNum() const { return plugin_test::layerNum(_document); }
	QString       logText() const;

private:
	MeshDocument _document;
};

/// Adds a closed ball of about 10,000 vertices. Vertex colour and quality are linear in the
/// position: colour = 128 + 100 p in each channel, quality = z.
MeshModel& addBall(Document& document);
/// Adds a square sheet of 51 x 51 vertices in z = 0.
MeshModel& addSheet(Document& document);

/// Adds a layer of points without faces.
MeshModel& addPoints(Document& document, const std::vector<gpr::Vec3d>& points);

/// A filter's parameters with their defaults for the current layer.
RichParameterList defaults(Document&          document,
						   gpr_filter::Filter filter = gpr_filter::RemeshFilter);

/// Calls a filter.
bool apply(Document& document, const RichParameterList& list, vcg::CallBackPos* progress = nullptr);
bool apply(Document& document, gpr_filter::Filter filter, const RichParameterList& list,
		   vcg::CallBackPos* progress = nullptr);

/// The message of the last call to the user; empty after a success.
QString errorText();

/// Fails for a mesh with deleted elements, faces out of range, stale normals or a stale box.
void expectSoundMesh(CMeshO& mesh);

/// The state of the current layer and of the document: a failing filter must not change this state.
class Snapshot {
public:
	explicit Snapshot(Document& document);
	bool operator==(const Snapshot& o) const;

private:
	gpr_filter::LayerCopy     _copy;
	std::vector<vcg::Color4b> _colours;
	std::vector<Scalarm>      _qualities;
	int                       _mask, _layers, _currentId;
};

/// Lets a test do something while the filter runs: called with the percentage.
class DuringRun {
public:
	explicit DuringRun(std::function<bool(int)> action);
	~DuringRun();
	vcg::CallBackPos* callback();
};

} // namespace plugin_test

#endif
