// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_MESH_FACE_CONTACT_H
#define VCG_EXTRAS_CORE_MESH_FACE_CONTACT_H

#include "half_edge_mesh.h"

#include <vcg_extras/core/base/workers.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace gpr {

/// A triangle with the names of its corners.
struct NamedTriangle {
	int   vertex[3];
	Vec3f at[3];

	/// Area times two times the unit normal.
	Vec3f cross() const { return gpr::cross(at[1] - at[0], at[2] - at[0]); }
};

NamedTriangle triangleOf(const HalfEdgeMesh& mesh, int face);

/// Whether two triangles have a point in common beyond the corners, or the edge, that they share by
/// name. Touching counts. Exact: see base/orientation.h. Two triangles that share all corners
/// touch. meetsAtPlaces: corners at one place are shared, whatever their names.
bool touch(const NamedTriangle& s, const NamedTriangle& t, bool meetsAtPlaces = false);

/// Whether a triangle of half a symmetric mesh has points beyond the mirror plane, or on it where
/// the border is not: it may touch the mirror image. Its corners are named by the mesh, and may lie
/// elsewhere.
bool reachesMirrorImage(const HalfEdgeMesh& mesh, const NamedTriangle& t);
/// The same of a face; false where it is dead.
bool reachesMirrorImage(const HalfEdgeMesh& mesh, int face);

/// Two faces that touch, the smaller first; a face that reaches the mirror image is paired with
/// itself.
using FacePair = std::pair<int, int>;

/// Border vertices at one place: where a surface was cut, its two sides meet. Joined: they count as
/// one vertex, so that sides with the same vertices do not touch. Apart: all sides touch.
enum class Seams { Joined, Apart };

/// All self-intersections: the pairs of faces that touch, ascending, of which at least one is from
/// firstFace on; dead faces are passed over. Cost: O(F log F), parallel.
std::vector<FacePair> findTouchingPairs(const HalfEdgeMesh& mesh, Workers& workers,
										Seams seams = Seams::Joined, int firstFace = 0);
/// The faces of all these pairs, ascending.
std::vector<int> findTouchingFaces(const HalfEdgeMesh& mesh, Workers& workers);

/// Number of touching pairs of which one is among `faces` and the other there or in `near`, both
/// ascending; dead faces are passed over. Adds the number of pairs that were compared to `work`, if
/// it is given. Cost: the product of the two for the boxes of the faces.
int countTouchingPairs(const HalfEdgeMesh& mesh, const std::vector<int>& faces,
					   const std::vector<int>& near, std::int64_t* work = nullptr);

/// The touching pairs of a mesh that changes: faces that are as they were at the last search are
/// not compared with each other again. What was found is kept together with the faces that it was
/// found for, so that no one has to tell what has changed.
class KnownContacts {
public:
	/// What findTouchingPairs(mesh, workers) gives. Cost: a pass over the mesh, and the faces that
	/// have changed.
	const std::vector<FacePair>& find(const HalfEdgeMesh& mesh, Workers& workers);

private:
	Buffer<Vec3f>         position_; ///< of the mesh at the last search
	Buffer<int>           origin_;
	std::vector<FacePair> pairs_;

	bool hasChanged(const HalfEdgeMesh& mesh, int face) const;
	void keep(const HalfEdgeMesh& mesh, Workers& workers);
};

} // namespace gpr

#endif
