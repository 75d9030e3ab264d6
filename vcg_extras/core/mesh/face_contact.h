// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_MESH_FACE_CONTACT_H
#define VCG_EXTRAS_CORE_MESH_FACE_CONTACT_H

#include "half_edge_mesh.h"

#include <vcg_extras/core/base/triangle.h>
#include <vcg_extras/core/base/workers.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace gpr {

/// A triangle with the vertex numbers of its corners.
struct NamedTriangle {
	int   vertex[3];
	Vec3f at[3];

	/// The unit normal times twice the area.
	Vec3f cross() const { return gpr::cross(at[1] - at[0], at[2] - at[0]); }
	float shape() const { return triangleShape(at[0], at[1], at[2]); }
	/// See isLine in base/triangle.h.
	bool isLine() const { return gpr::isLine(at[0], at[1], at[2], cross()); }
};

NamedTriangle triangleOf(const HalfEdgeMesh& mesh, int face);

/// Whether two triangles have a common point beyond their shared corners or edge. Touching counts.
/// Exact: see base/orientation.h. Two triangles with three shared corners touch. Corners are shared
/// if their vertices are the same; with meetsAtPlaces also if their places are the same.
bool touch(const NamedTriangle& s, const NamedTriangle& t, bool meetsAtPlaces = false);

/// Whether a triangle of half a symmetric mesh has a point beyond the mirror plane, or a point of
/// the plane off the border: the triangle may then touch the mirror image. Corners have the mesh's
/// vertex numbers, and may lie elsewhere.
bool reachesMirrorImage(const HalfEdgeMesh& mesh, const NamedTriangle& t);
/// Likewise for a face; false if the face is dead.
bool reachesMirrorImage(const HalfEdgeMesh& mesh, int face);

/// Two faces in contact, the smaller first; a face that reaches the mirror image is paired with
/// itself.
using FacePair = std::pair<int, int>;

/// The rule for border vertices at the same place, as along a cut: they count as the same vertex.
/// Joined: faces on both sides of the cut do not touch. Apart: faces touch that have an edge of the
/// cut on both sides; faces that meet at a single place, as at the corners of two holes, do not.
enum class Seams { Joined, Apart };

/// Finds all self-intersections: pairs of faces in contact, ascending, with at least one wanted
/// face (a mark of 1 per face; empty: all are wanted). Skips dead faces. Cost: O(F log F),
/// parallel.
std::vector<FacePair> findTouchingPairs(const HalfEdgeMesh& mesh, Workers& workers,
										Seams                    seams  = Seams::Joined,
										const std::vector<char>& wanted = {});
/// Finds the faces in contact, ascending. Faster than the search for pairs where faces have many
/// contacts: most pairs of two faces with known contacts are not tested. Cost: O(F log F),
/// parallel.
std::vector<int> findTouchingFaces(const HalfEdgeMesh& mesh, Workers& workers,
								   Seams seams = Seams::Joined);
/// The faces of some pairs, each once, ascending.
std::vector<int> facesOf(const std::vector<FacePair>& pairs);

/// Counts contacts between `faces`, ascending, and the union of `faces` and `near`. Skips dead
/// faces. Adds the number of compared pairs to `work`, unless null. Cost: the product of both
/// numbers for the comparison of boxes.
int countTouchingPairs(const HalfEdgeMesh& mesh, const std::vector<int>& faces,
					   const std::vector<int>& near, std::int64_t* work = nullptr);

} // namespace gpr

#endif
