// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_MESH_CUT_MESH_H
#define VCG_EXTRAS_CORE_MESH_CUT_MESH_H

#include "half_edge_mesh.h"

#include <vcg_extras/core/base/workers.h>

#include <vector>

namespace gpr {

/// A mesh cut along feature lines, which become borders.
struct CutMesh {
	HalfEdgeMesh     mesh;   ///< the old vertices, then copies
	std::vector<int> copyOf; ///< per copy: its old vertex
};

/// Cuts a mesh. Each vertex of a line gets a copy for each further sector between lines. Faces and
/// half-edges keep their numbers. lines: per half-edge, set at both halves of an edge. Cost: a copy
/// of the mesh, 32 B a face.
CutMesh cutAlong(const HalfEdgeMesh& mesh, const Buffer<char>& lines, Workers& workers);

} // namespace gpr

#endif
