// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef TESTS_PLUGIN_HOST_H
#define TESTS_PLUGIN_HOST_H

// A host for the plugin without window or OpenGL: MeshLab's own plugin manager and documents.

#include <common/interfaces.h>
#include <functional>

namespace plugin_test {

/// The plugin as MeshLab's plugin manager loaded it.
MeshFilterInterface& plugin();
/// The plugin's one filter.
QAction* remeshAction();

/// A document with a log that goes to the plugin, as in the real hosts.
class Document {
public:
	Document();
	~Document();

	MeshDocument& operator*() { return _document; }
	MeshDocument* operator->() { return &_document; }
	MeshModel&    layer(int i = 0) { return *_document.meshList.at(i); }
	QString       logText() const;

private:
	MeshDocument _document;
};

/// Adds a closed ball of about 10,000 vertices with vertex colour and quality that are linear in
/// the position: colour = 128 + 100 p in each channel, quality = z.
MeshModel& addBall(Document& document);
/// Adds a square sheet of 51 x 51 vertices in z = 0.
MeshModel& addSheet(Document& document);

/// The filter's parameters with their defaults for the current layer.
RichParameterList defaults(Document& document);

/// Calls the filter.
bool apply(Document& document, const RichParameterList& list, vcg::CallBackPos* progress = nullptr);

/// Lets a test do something while the filter runs: called with the percentage.
class DuringRun {
public:
	explicit DuringRun(std::function<bool(int)> action);
	~DuringRun();
	vcg::CallBackPos* callback();
};

} // namespace plugin_test

#endif
