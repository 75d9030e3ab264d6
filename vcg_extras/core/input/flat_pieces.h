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

/// Whether a triangle in working units is thin: narrower than a millionth of the box and a
/// thousandth of its length, each times `factor`.
bool isThin(const Vec3f& a, const Vec3f& b, const Vec3f& c, float factor = 1);

/// Thin faces to drop, ascending: the surface loses nothing, and no triangles with an area could
/// replace these faces. The faces of each piece are thin together too. A piece is a whole
/// component, or grows from the border: by faces with two border edges, and by faces with their
/// longest edge at the border and an inner third corner. All other components keep their topology.
/// Cost: a parallel pass over the vertices; O(t log t) for t thin faces.
std::vector<int> findFlatPieces(const Surface& surface, Workers& workers);

/// The surface without `faces` (ascending) and without vertices of these faces alone, as a mesh to
/// order and connect anew. Afterwards the surface is empty. droppedNum grows by the number of
/// dropped faces of the input mesh.
IndexedMesh withoutFaces(Surface& surface, const std::vector<int>& faces, Workers& workers,
						 std::int64_t& droppedNum);

/// Whether all faces are thin: the surface may then consist of lines, and splitting long edges
/// would make endless faces. Cost: a parallel pass, ended by the first face that is not thin.
bool allFacesThin(const IndexedMesh& mesh, Workers& workers);

} // namespace gpr

#endif
