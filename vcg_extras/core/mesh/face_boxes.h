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

/// The box of some faces, without dead faces.
Box<float> boxOfFaces(const HalfEdgeMesh& mesh, const std::vector<int>& faces);

/// A tree of the boxes of a mesh's faces at the time of building. Faces are in the order of octree
/// blocks, so that neighbours share a path through the tree. 30 B a face.
class FaceBoxes {
public:
	/// Boxes below one node of the tree.
	static constexpr int fanOut = 4;

	/// Takes all living faces. Cost: linear, parallel.
	FaceBoxes(const HalfEdgeMesh& mesh, Workers& workers);
	/// Takes only faces that may meet a wanted face (a mark of 1 per face).
	FaceBoxes(const HalfEdgeMesh& mesh, const std::vector<char>& wanted, Workers& workers);

	/// Faces whose boxes met `box` at the time of building; ascending. Cost: O(log F) a face.
	std::vector<int> meeting(const Box<float>& box) const;

	/// Calls visit(i) for the places i of faces whose boxes meet `box`, until visit returns false.
	/// Cost: O(log F) a face.
	template <class Visit>
	bool forEachMeeting(const Box<float>& box, const Visit& visit) const
	{
		for (int k = 0; k < int(level_.back().size()); ++k) {
			if (!visitBelow(levelNum() - 1, k, box, visit)) return false;
		}
		return true;
	}

	/// Enlarges the box of the face at place i, and all boxes above.
	void grow(int i, const Box<float>& box);

	int                       faceNum() const { return int(face_.size()); }
	int                       face(int i) const { return face_[i]; }
	int                       levelNum() const { return int(level_.size()); }
	const Buffer<Box<float>>& level(int l) const { return level_[l]; }

private:
	Buffer<int>                     face_;
	std::vector<Buffer<Box<float>>> level_; ///< level 0 has the box of each face in face_

	void build(const HalfEdgeMesh& mesh, const std::vector<char>& wanted, Workers& workers);
	void addLevel(Workers& workers);

	template <class Visit>
	bool visitBelow(int level, int index, const Box<float>& box, const Visit& visit) const
	{
		if (!level_[level][index].meets(box)) return true;
		if (level == 0) return visit(index);
		const int end = std::min(int(level_[level - 1].size()), (index + 1) * fanOut);
		for (int k = index * fanOut; k < end; ++k) {
			if (!visitBelow(level - 1, k, box, visit)) return false;
		}
		return true;
	}
};

} // namespace gpr

#endif
