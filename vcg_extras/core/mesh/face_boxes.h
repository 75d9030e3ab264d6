// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_MESH_FACE_BOXES_H
#define VCG_EXTRAS_CORE_MESH_FACE_BOXES_H

#include "half_edge_mesh.h"

#include <vcg_extras/core/base/box.h>
#include <vcg_extras/core/base/workers.h>

#include <algorithm>
#include <vector>

namespace gpr {

/// The box of a living face.
Box<float> boxOfFace(const HalfEdgeMesh& mesh, int face);

/// The box of all living vertices.
Box<float> boxOfAll(const HalfEdgeMesh& mesh, Workers& workers);
/// The box of some faces, without dead faces.
Box<float> boxOfFaces(const HalfEdgeMesh& mesh, const std::vector<int>& faces);

/// A tree of the boxes of a mesh's faces at the time of building. Faces are in the order of octree
/// blocks, so that neighbours share a path through the tree. 30 B a face.
class FaceBoxes {
public:
	/// Boxes below one node of the tree.
	static constexpr int fanOut = 4;

	/// Takes all living faces. Cost: linear, parallel.
	FaceBoxes(const HalfEdgeMesh& mesh, Workers& workers) : FaceBoxes(mesh, {}, workers) {}
	/// Takes only faces that may meet a wanted face (a mark of 1 per face; empty: all are wanted).
	FaceBoxes(const HalfEdgeMesh& mesh, const std::vector<char>& wanted, Workers& workers);

	/// Calls visit(i) for the places i of faces whose boxes meet `box`, until visit returns false.
	/// Cost: O(log F) a face.
	template <class Visit>
	bool forEachMeeting(const Box<float>& box, const Visit& visit) const
	{
		const auto meetsBox = [&](int level, int i) { return level_[level][i].meets(box); };
		return forEachNode(0, meetsBox, visit);
	}

	/// Calls visit(i) for the nodes i of a level that pass a test, as all nodes above them do,
	/// until visit returns false. test(level, i): of node i of a level.
	template <class Test, class Visit>
	bool forEachNode(int level, const Test& test, const Visit& visit) const
	{
		return face_.empty() || visitFrom(int(level_.size()) - 1, 0, level, test, visit);
	}

	/// Enlarges the box of the face at place i, and all boxes above.
	void grow(int i, const Box<float>& box);

	int                       faceNum() const { return int(face_.size()); }
	int                       face(int i) const { return face_[i]; }
	const Buffer<Box<float>>& level(int l) const { return level_[l]; }

private:
	Buffer<int>                     face_;
	std::vector<Buffer<Box<float>>> level_; ///< from the box of each face in face_ to the root

	void addLevel(Workers& workers);

	template <class Test, class Visit>
	bool visitFrom(int level, int i, int lowest, const Test& test, const Visit& visit) const
	{
		if (!test(level, i)) return true;
		if (level == lowest) return visit(i);
		const int begin = i * fanOut;
		for (int k = std::min(int(level_[level - 1].size()), begin + fanOut) - 1; k >= begin; --k) {
			if (!visitFrom(level - 1, k, lowest, test, visit)) return false;
		}
		return true;
	}
};

/// The faces of a mesh by their place, while the mesh changes. The boxes of a tree grow with
/// changes; after as many changes as faces the tree is made anew. 45 B a face.
class FacesInSpace {
public:
	/// The mesh must stay in memory.
	FacesInSpace(const HalfEdgeMesh& mesh, Workers& workers);

	/// Calls visit(f) once for each face that may meet a box, dead or alive, until visit returns
	/// false. Cost: O(log F) a face, and a look at each added face.
	template <class Visit>
	bool forEachNear(const Box<float>& box, const Visit& visit) const
	{
		for (int f : added_) {
			if (!visit(f)) return false;
		}
		return boxes_.forEachMeeting(box, [&](int place) { return visit(boxes_.face(place)); });
	}
	std::vector<int> near(const Box<float>& box) const;

	/// Needed after each change. changed: the living faces that moved or are new.
	void follow(const std::vector<int>& changed);

private:
	const HalfEdgeMesh& m_;
	Workers&            workers_;
	FaceBoxes           boxes_;
	std::vector<int>    placeOf_; ///< per face: its place in the tree, or below 0
	std::vector<int>    added_;   ///< faces that came after the tree
	std::size_t         changedNum_ = 0;

	void findPlaces();
};

} // namespace gpr

#endif
