// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_SURFACE_TRIANGLE_TREE_H
#define VCG_EXTRAS_CORE_SURFACE_TRIANGLE_TREE_H

#include <vcg_extras/core/base/box.h>
#include <vcg_extras/core/base/buffer.h>
#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh_view.h>

#include <array>
#include <cstdint>

namespace gpr {

/// The corners of a triangle in double precision.
using Triangle = std::array<Vec3d, 3>;

/// Squared distance of a point from a triangle. It is that of a point of the triangle, so it is too
/// small by nothing but rounding, and too large by at most 1e-8 of the extent of both, even for
/// needles and triangles without area.
double squaredDistance(const Vec3d& p, const Triangle& t);

/// Bounding-box tree over the triangles of a mesh in double precision, with their neighbours, for
/// nearest points; FaceBoxes are for pairs of faces that are near each other. Any set of triangles,
/// manifold or not; those that are not usable are left out. Nearest distances are exact but for
/// rounding, so proofs may rest on them.
class TriangleTree {
public:
	/// A triangle by its place in the tree, and how far it is.
	struct Nearest {
		int    triangle = -1;
		double squared  = HUGE_VAL;
	};

	/// Positions are kept relative to origin, so that no digit is lost to an offset. The mesh may
	/// go afterwards. Throws what workers throw. Cost: O(F log F), parallel, 125 B a face; the same
	/// tree for any number of threads.
	TriangleTree(const MeshView& mesh, const Vec3d& origin, Workers& workers);

	int             size() const { return int(triangle_.size()); }
	const Triangle& triangle(int t) const { return triangle_[std::size_t(t)]; }
	/// Of the whole, relative to origin.
	const Box<double>& box() const { return box_; }

	/// Across the edge from corner k to the next: the triangle there, or -1 where there is none or
	/// more than one.
	int neighbour(int t, int k) const { return neighbour_[3 * std::size_t(t) + std::size_t(k)]; }

	/// The triangle nearest to p, given relative to origin; none where p is not finite. A hint is
	/// some triangle that may be near; it makes the search quicker, and decides between triangles
	/// that are equally near. Needs a tree that is not empty. Cost: O(log F) on well-behaved
	/// meshes.
	Nearest nearest(const Vec3d& p, int hint = -1) const;

	/// The face nearest to p, of those equally near the one of the lowest index; -1 where p is not
	/// finite or there is no face. Cost: as nearest().
	int nearestFace(const Vec3d& p) const;

	/// Triangles come in spatial order, and in groups: 2^level of them, group i of level has the
	/// triangles groupBegin(level, i) to groupBegin(level, i + 1).
	int levelNum() const { return depth_ + 1; }
	int groupBegin(int level, int i) const
	{
		return int((std::int64_t(i) * std::int64_t(size())) >> level);
	}
	/// Box of a group, rounded outwards; empty where the group is.
	const Box<float>& groupBox(int level, int i) const
	{
		return node_[(std::size_t(1) << level) - 1 + std::size_t(i)];
	}

private:
	Buffer<Triangle>   triangle_;
	Buffer<int>        face_;
	Buffer<int>        neighbour_;
	Buffer<Box<float>> node_; ///< a heap: the children of node i are 2i + 1 and 2i + 2
	Box<double>        box_;
	int                depth_ = 0; ///< level of the leaves

	int  face(int t) const { return face_[std::size_t(t)]; }
	void order(const MeshView& mesh, const Vec3d& origin, Workers& workers);
	void fillBoxes(Workers& workers);
	enum class Ties { FirstFound, LowestFace };
	bool isBetter(const Nearest& a, const Nearest& b, Ties ties) const;
	void search(const Vec3d& p, Ties ties, Nearest& best) const;
};

} // namespace gpr

#endif
