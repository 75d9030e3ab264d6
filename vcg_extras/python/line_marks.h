// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_PYTHON_LINE_MARKS_H
#define VCG_EXTRAS_PYTHON_LINE_MARKS_H

#include <vcg_extras/core/mesh_view.h>

#include <cstdint>
#include <vector>

namespace gpr::python {

/// Marks edges, given as pairs of vertices, in the form of MeshView::line: three marks per face.
/// Returns the number of the first edge without a face, or -1. Cost: O((E + F) log E).
std::int64_t markEdges(const MeshView& mesh, const std::int32_t* edges, std::size_t edgeNum,
					   std::vector<std::uint8_t>& marks);

} // namespace gpr::python

#endif
