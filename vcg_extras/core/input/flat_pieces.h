// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_INPUT_FLAT_PIECES_H
#define VCG_EXTRAS_CORE_INPUT_FLAT_PIECES_H

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/mesh/indexed_mesh.h>

#include <cstdint>
#include <vector>

namespace gpr {

/// Whether a triangle in working units is thinner than a millionth of the box and a thousandth of
/// its length, or than `factor` times that.
bool isThin(const Vec3f& a, const Vec3f& b, const Vec3f& c, float factor = 1);

/// Faces, in ascending order, that a surface is no poorer without, and that no triangles with an
/// area could take the place of. All are thin, and so is what is joined of them. They make up whole
/// components that are lines; or hang on a border by one edge; or lie along a border with their
/// longest edge. Without the components every other one keeps its topology. Cost: a parallel pass
/// over the vertices; O(t log t) for t thin faces.
std::vector<int> findFlatPieces(const Surface& surface, Workers& workers);

/// The surface without `faces` (ascending) and the vertices only they have, as a mesh to be ordered
/// and connected anew; the surface is empty then. droppedNum grows by the caller's faces that are
/// concerned.
IndexedMesh withoutFaces(Surface& surface, const std::vector<int>& faces, Workers& workers,
						 std::int64_t& droppedNum);

/// Whether all faces are that thin, so that the surface may be nothing but lines: splitting their
/// edges would make endless faces of them. Cost: a parallel pass that ends at the first other face.
bool allFacesThin(const IndexedMesh& mesh, Workers& workers);

} // namespace gpr

#endif
