// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_FUSED_MESH_H
#define VCG_EXTRAS_CORE_FUSED_MESH_H

#include "half_edge_mesh.h"

#include <vector>

namespace gpr {

/// The mutual tessellation (paper §3, figure 1): the surface with every sample made a vertex of it
/// by edge splits. The surface's own vertices keep their numbers, new ones follow; every face lies
/// in one face of the surface, so that nothing has moved and topology is the surface's.
struct FusedMesh {
	HalfEdgeMesh     mesh;
	Buffer<int>      parentFace;   ///< of at least mesh.faceNum: the surface's face it lies in
	std::vector<int> sampleVertex; ///< per sample: its vertex, no two alike
};

} // namespace gpr

#endif
