// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_FEATURES_FEATURE_REGION_H
#define VCG_EXTRAS_CORE_FEATURES_FEATURE_REGION_H

#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/mesh_view.h>

#include <cstdint>
#include <vector>

namespace gpr {

/// The feature region of the paper's §3.1.1 on the working surface: 1 for every vertex that is one
/// of the caller's with a mark (not 0), or lies between such; empty where there is none.
/// marks: one for each of the caller's vertices, or null. Cost: linear, parallel.
Buffer<char> regionVertices(const MeshView& input, const std::uint8_t* marks,
							const Surface& surface, Workers& workers);

/// Those vertices of a region that are vertices of the caller's mesh, not made by splits of its
/// edges; ascending. Cost: linear in the surface.
std::vector<int> callersVertices(const MeshView& input, const Buffer<char>& region,
								 const Surface& surface, Workers& workers);

/// The caller's own vertices on the border, ascending. Cost: linear.
std::vector<int> borderVertices(const MeshView& input, const Surface& surface, Workers& workers);

/// Of two sets of vertices, each ascending.
std::vector<int> unionOf(const std::vector<int>& a, const std::vector<int>& b);

} // namespace gpr

#endif
