// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_COMPARE_COMPARE_VIEWER_H
#define VCG_EXTRAS_APPS_GPREMESH_COMPARE_COMPARE_VIEWER_H

#include <vcg_extras/apps/gpremesh/compare/compare_record.h>

namespace gpr::app {

/// Whether the program was built with three.js, which draws in the viewer.
bool hasViewer();

/// The part of the page with a view of the meshes that a user can turn: the viewer's program,
/// three.js with its licence, and the meshes. Needs no other file. Needs hasViewer(). Cost: seven
/// searches of a nearest point for each shown triangle of each mesh, parallel; about 30 B of text
/// per triangle.
std::string viewerHtml(const MeshView& input, const CompareRecord& record);

} // namespace gpr::app

#endif
