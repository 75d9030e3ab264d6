// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_BENCH_MESH_GROWTH_H
#define VCG_EXTRAS_BENCH_MESH_GROWTH_H

#include <vcg_extras/core/mesh_view.h>

#include <cstdint>

namespace gpr::bench {

/// The places of new vertices.
struct MeshGrowth {
	double roundness = 1;    ///< 1 = on a curve along the vertex normals, 0 = on the edge
	double roughness = 0.04; ///< largest displacement along the normal, in edge lengths
	double jitter =
		0.2; ///< largest displacement along the edge, in edge lengths, < 0.5; last passes only
	std::uint32_t seed = 1;
};

/// Makes a mesh of faceNum faces with the look of a scan out of a mesh of fewer faces. Edges are
/// split near their middles: all edges while many times the faces are missing, then the longest
/// edges, so that vertices of all valences arise. A new vertex lies on the cubic curve that meets
/// the normals of the edge's ends (Vlachos et al., Curved PN Triangles, 2001), displaced at random
/// by a share of the edge: rough on every scale, like fractals by midpoint displacement (Fournier,
/// Fussell, Carpenter 1982).
///
/// Borders, components and holes stay; a mesh with enough faces is returned unchanged. At borders
/// and at edges of more than two faces the count can be missed by a face or two. The same settings
/// give the same mesh. Cost: linear, but for sorting edges by length; about a second per million
/// faces.
TriangleMesh growMesh(TriangleMesh mesh, std::int64_t faceNum, const MeshGrowth& growth);

} // namespace gpr::bench

#endif
