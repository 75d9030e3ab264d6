// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_COMPARE_COMPARE_VIEWER_H
#define VCG_EXTRAS_APPS_GPREMESH_COMPARE_COMPARE_VIEWER_H

#include <vcg_extras/apps/gpremesh/compare/compare_record.h>

namespace gpr::app {

/// Whether the program was built with three.js, which the viewer draws with.
bool hasViewer();

/// The part of the page in which one turns the meshes: the viewer's program, three.js with its
/// licence, and the meshes. Nothing is read from elsewhere. Needs hasViewer(). Cost: for each mesh
/// seven searches of the nearest point a triangle that is shown, parallel; about 30 B of text a
/// triangle.
std::string viewerHtml(const MeshView& input, const CompareRecord& record);

} // namespace gpr::app

#endif
