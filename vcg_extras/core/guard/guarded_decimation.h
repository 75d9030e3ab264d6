// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_GUARD_GUARDED_DECIMATION_H
#define VCG_EXTRAS_CORE_GUARD_GUARDED_DECIMATION_H

#include "quadric.h"

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/half_edge_mesh.h>

#include <cstdint>
#include <limits>
#include <vector>

namespace gpr {

/// Points of a surface, in a list per vertex of a mesh that stands for it.
class StoodFor {
public:
	explicit StoodFor(int vertexNum) : list_(std::size_t(vertexNum)) {}

	void clear(int v) { list_[std::size_t(v)] = {}; }
	void add(int v, const Vec3f& place);
	/// Vertex `to` stands for the points of `from`, too.
	void merge(int from, int to);
	/// Vertices have got other numbers, or are gone (-1).
	void rename(const Buffer<int>& newIndex, int vertexNum);

	int numOf(int v) const { return list_[std::size_t(v)].num; }

	template <class Visit>
	void forEach(int v, const Visit& visit) const
	{
		for (int i = list_[std::size_t(v)].first; i >= 0; i = next_[std::size_t(i)])
			visit(place_[std::size_t(i)]);
	}

private:
	struct List {
		int first = -1, last = -1, num = 0;
	};
	std::vector<List>  list_; ///< per vertex
	std::vector<Vec3f> place_;
	std::vector<int>   next_; ///< per point
};

/// A mesh that is made coarser, and what its vertices know of the one that it was.
struct GuardedMesh {
	HalfEdgeMesh         mesh;    ///< without feature lines: the quadrics hold what is sharp
	std::vector<Quadric> quadric; ///< per vertex: of the planes that it stands for
	std::vector<Vec3f>   normal;  ///< per vertex: sum of area times normal of what it stands for
	std::vector<float>   area;    ///< per vertex: of what it stands for
	std::vector<int>     anchor;  ///< per vertex: one of those merged into it, near to where it is
	std::vector<Vec3f>   anchorPlace;         ///< where that lay
	std::vector<char>    isFixed;             ///< per vertex: stays where it is
	StoodFor             points;              ///< vertices of what it was
	std::size_t          anchorNum   = 0;     ///< vertices at first
	bool                 hadContacts = false; ///< some faces touched at first

	/// Of a mesh without dead faces. Each vertex is its own anchor.
	GuardedMesh(HalfEdgeMesh from, bool hasContacts);

	/// Vertices no longer stand for their own faces, but for those of another mesh, of whose vertex
	/// v they are number name[v], or for none (-1). Border edges count that are marked as creases.
	void standFor(const HalfEdgeMesh& other, const std::vector<int>& name);

	/// Whether the cosine between a normal, of any length, and that of what a face between three
	/// vertices stands for is larger than `cosine`. another: a fourth vertex, whose share counts
	/// too, or -1. True at a rim so thin that the normals of what the face stands for cancel out.
	bool agrees(const int* vertex, const Vec3f& normal, float cosine, int another = -1) const;

	/// Drops dead faces and vertices.
	void compact(Workers& workers);
};

struct GuardedSettings {
	std::int64_t targetNum  = 0;    ///< vertices
	double       idealEdge  = 0;    ///< of the result, working units
	double lengthWeight     = 0.01; ///< of an edge's length against what merging costs in distance
	bool   mayLeaveVertices = true; ///< merged vertices may come to lie where none has lain
	/// The border's fixed vertices are all that it shall have. Its others go as soon as they can,
	/// and at last even where faces touch then.
	bool keepsBorder = false;
	/// Longer edges stay, working units.
	double longestEdge = std::numeric_limits<double>::infinity();
};

/// Collapses edges until the mesh has targetNum vertices, those first that cost least: the
/// quadrics' squared distance (Garland and Heckbert 1997) plus lengthWeight times the fourth power
/// of the length. The merged vertex comes to the lowest point of the quadrics, the middle or an
/// end. A collapse is refused where it would change the topology (link condition), turn a face, or
/// turn one against the normals of what it stands for, make a face too narrow, take a vertex too
/// far from the planes of what it stands for, or make faces touch that did not (ContactGuard). The
/// bounds on turns, shapes and distances are loosened step by step where nothing else is left.
/// Border vertices move along their border only, and vertices inside never onto it but where it is.
/// Edges of faces without area go before all others, within the loosest of the bounds.
///
/// Returns false where no more collapse is allowed; the mesh then has as few vertices as it came
/// to. Leaves no dead faces. Serial but for the trees, so that the bits do not depend on the
/// threads. Cost: about 10 µs a collapse.
bool decimateGuarded(const GuardedSettings& settings, GuardedMesh& guarded, Workers& workers);

} // namespace gpr

#endif
