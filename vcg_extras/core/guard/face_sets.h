// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_GUARD_FACE_SETS_H
#define VCG_EXTRAS_CORE_GUARD_FACE_SETS_H

#include <vcg_extras/core/mesh/half_edge_mesh.h>

#include <vector>

namespace gpr {

// Sets of faces; all lists are ascending.

/// The faces with a mark.
std::vector<int> markedFaces(const std::vector<char>& marked);

/// Whether all faces at a living vertex have a mark.
bool hasOnlyMarked(const HalfEdgeMesh& mesh, int v, const std::vector<char>& marked);

/// The faces with all corners among the vertices.
std::vector<int> facesBetween(const HalfEdgeMesh& mesh, const std::vector<int>& vertices);

/// A mesh of some faces and vertices, without adjacency. vertices: all corners of the faces, and
/// any others.
HalfEdgeMesh facesAlone(const HalfEdgeMesh& from, const std::vector<int>& faces,
						const std::vector<int>& vertices);

/// The same with the adjacency of the faces among themselves, for vertices with all their faces
/// among the faces.
HalfEdgeMesh cutOut(const HalfEdgeMesh& from, const std::vector<int>& faces,
					const std::vector<int>& vertices);

} // namespace gpr

#endif
