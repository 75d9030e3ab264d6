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
#include <vector>

namespace gpr {

/// The corners of a triangle in double precision.
using Triangle = std::array<Vec3d, 3>;

/// Whether a face has corners that exist and are finite.
bool hasPlaces(const MeshView& mesh, std::size_t face);
/// Whether a face also has three different corners.
bool isUsableFace(const MeshView& mesh, std::size_t face);

/// Squared distance of a point from a triangle. The distance belongs to a point of the triangle, so
/// it is too small by nothing but rounding, and too large by at most 1e-8 of the extent of both,
/// even for needles and degenerate triangles.
double squaredDistance(const Vec3d& p, const Triangle& t);

/// Bounding-box tree over the triangles of a mesh in double precision, with their neighbours, for
/// nearest points; FaceBoxes find pairs of near faces. Any set of triangles, manifold or not;
/// unusable faces are left out. Nearest distances are exact but for rounding, so proofs may use the
/// tree.
class TriangleTree {
public:
	/// A triangle, by its place in the tree, and its squared distance.
	struct Nearest {
		int    triangle = -1;
		double squared  = HUGE_VAL;
	};

	/// Keeps positions relative to origin, so that no digit is lost to an offset. The mesh may be
	/// freed afterwards. Throws as Workers do. Cost: O(F log F), parallel, 125 B per face; the same
	/// tree for any number of threads.
	TriangleTree(const MeshView& mesh, const Vec3d& origin, Workers& workers);

	int             size() const { return int(triangle_.size()); }
	const Triangle& triangle(int t) const { return triangle_[t]; }
	/// Box of all triangles, relative to origin.
	const Box<double>& box() const { return box_; }

	/// The triangle across the edge from corner k to the next corner; -1 if there is no such
	/// triangle, or more than one.
	int neighbour(int t, int k) const { return neighbour_[3 * std::size_t(t) + std::size_t(k)]; }

	/// The triangle nearest to p; p is relative to origin. -1 if p is not finite. hint: a triangle
	/// that may be near; makes the search quicker, and decides between equally near triangles.
	/// Needs a tree that is not empty. Cost: O(log F) on well-behaved meshes.
	Nearest nearest(const Vec3d& p, int hint = -1) const;

	/// The face nearest to p; of equally near faces the face of lowest index. -1 if p is not finite
	/// or there is no face. Cost: as nearest().
	int nearestFace(const Vec3d& p) const;

	/// Triangles come in spatial order and in groups: each level has 2^level groups. Group i of a
	/// level has the triangles groupBegin(level, i) to groupBegin(level, i + 1).
	int levelNum() const { return depth_ + 1; }
	int groupBegin(int level, int i) const
	{
		return int((std::int64_t(i) * std::int64_t(size())) >> level);
	}
	/// Box of a group, rounded outwards; empty for an empty group.
	const Box<float>& groupBox(int level, int i) const
	{
		return node_[(std::size_t(1) << level) - 1 + std::size_t(i)];
	}

private:
	Buffer<Triangle>   triangle_;
	std::vector<int>   face_;
	Buffer<int>        neighbour_;
	Buffer<Box<float>> node_; ///< a heap: the children of node i are 2i + 1 and 2i + 2
	Box<double>        box_;
	int                depth_ = 0; ///< level of the leaves

	void order(const MeshView& mesh, const Vec3d& origin, Workers& workers);
	void fillBoxes(Workers& workers);
	enum class Ties { FirstFound, LowestFace };
	void search(const Vec3d& p, Ties ties, Nearest& best) const;
};

} // namespace gpr

#endif
