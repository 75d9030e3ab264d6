// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_FEATURES_FEATURE_REGION_H
#define VCG_EXTRAS_CORE_FEATURES_FEATURE_REGION_H

#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/mesh_view.h>

#include <cstdint>
#include <vector>

namespace gpr {

/// The feature region (paper §3.1.1) on the working surface: 1 for every vertex that is a marked
/// input vertex (mark not 0) or lies between marked vertices; empty if there is none. marks: per
/// input vertex, or null. Cost: linear, parallel.
Buffer<char> regionVertices(const MeshView& input, const std::uint8_t* marks,
							const Surface& surface, Workers& workers);

/// The vertices of a region that are vertices of the input mesh, not made by edge splits;
/// ascending. Cost: linear in the surface.
std::vector<int> callersVertices(const MeshView& input, const Buffer<char>& region,
								 const Surface& surface, Workers& workers);

/// The vertices of the input mesh on the border, ascending; with MeshView::keptBorder only the
/// marked vertices. Cost: linear.
std::vector<int> borderVertices(const MeshView& input, const Surface& surface, Workers& workers);

/// The union of two sets of vertices, each ascending.
std::vector<int> unionOf(const std::vector<int>& a, const std::vector<int>& b);

} // namespace gpr

#endif
