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

class SpaceGrid;

/// A vertex under decimation, with the part of the first mesh assigned to the vertex.
struct GuardedVertex {
	Quadric quadric;     ///< of the assigned planes
	Vec3f   normal;      ///< sum of area times normal of the assigned surface
	float   area   = 0;  ///< of the assigned surface
	int     anchor = -1; ///< vertex of the first mesh merged into the vertex, near its place
	Vec3f   anchorPlace;
	std::vector<Vec3f> points;          ///< assigned vertices of the first mesh
	bool               isFixed = false; ///< must not move

	GuardedVertex withoutPoints() const
	{
		return {quadric, normal, area, anchor, anchorPlace, {}, isFixed};
	}
};

/// A mesh under decimation.
struct GuardedMesh {
	HalfEdgeMesh               mesh; ///< without feature lines: the quadrics keep creases
	std::vector<GuardedVertex> vertex;
	bool                       hadContacts = false; ///< the first mesh had contacts

	bool isFixed(int v) const { return vertex[v].isFixed; }
	/// Whether all corners of a face are fixed.
	bool isFixedFace(int f) const
	{
		return isFixed(mesh.origin[3 * f]) && isFixed(mesh.origin[3 * f + 1]) &&
			   isFixed(mesh.origin[3 * f + 2]);
	}

	GuardedMesh() = default;
	/// From a mesh without dead faces. Each vertex is its own anchor. asked: whether to go on; may
	/// be null, here and below.
	GuardedMesh(HalfEdgeMesh from, bool hasContacts, Workers* asked = nullptr);

	/// Assigns the surface of another mesh to the vertices, in place of their own faces. name: per
	/// vertex of the other mesh, its vertex here or -1. Border edges of the other mesh count if
	/// marked as creases.
	void assign(const HalfEdgeMesh& other, const std::vector<int>& name, Workers* asked = nullptr);

	/// Whether the cosine between a normal, of any length, and the assigned normals of three
	/// vertices exceeds `cosine`. another: a fourth vertex with a share, or -1. True at a rim so
	/// thin that the assigned normals cancel out.
	bool agrees(const int* vertex, const Vec3f& normal, float cosine, int another = -1) const;

	/// Drops dead faces and vertices.
	void compact(Workers& workers);
};

struct GuardedSettings {
	std::int64_t targetNum    = 0;    ///< vertices
	double       idealEdge    = 0;    ///< of the result, working units
	double       lengthWeight = 0.01; ///< of an edge's length against the distance cost of merging
	bool         mayLeaveVertices = true; ///< merged vertices may move to new places
	/// Keep only the fixed vertices of the border. All other border vertices are removed as soon as
	/// possible, and at last even with contacts.
	bool keepsBorder = false;
	/// Longer edges are not collapsed, working units.
	double longestEdge = std::numeric_limits<double>::infinity();
	/// A collapse that moves the surface by less than this, in edges, needs no test for contacts.
	/// For callers that test the result; 0: every collapse is tested.
	double untested = 0;
	/// If given, merged vertices stay in one of its cubes.
	const SpaceGrid* grid = nullptr;
	int              cube = 0;
};

/// Collapses edges until the mesh has targetNum vertices, by ascending cost: the squared distance
/// by the quadrics (Garland and Heckbert 1997) plus lengthWeight times the fourth power of the
/// length. The merged vertex moves to the lowest point of the quadrics, the middle or an end. A
/// collapse is refused if it
/// - would change the topology (link condition) or make new contacts (ContactGuard),
/// - would turn a face too far, by itself or against the assigned normals,
/// - would make a face too narrow, or
/// - would take a vertex too far from the assigned planes.
/// The bounds on turns, shapes and distances are loosened step by step when no collapse is left.
/// Border vertices move along their border only; an inner vertex merges into a border vertex at its
/// place. Edges at degenerate faces go first, within the loosest bounds.
///
/// Returns false if no more collapse is allowed above targetNum. Leaves dead faces. Serial but for
/// the trees: the same bits for any number of threads. Cost: about 10 µs per collapse in a small
/// mesh, 25 µs in a mesh of a million vertices. decimateGuarded (cube_decimation.h) begins in
/// cubes.
bool collapseGuarded(const GuardedSettings& settings, GuardedMesh& guarded, Workers& workers);
/// The same within the strictest bounds only.
void collapseStrictly(const GuardedSettings& settings, GuardedMesh& guarded, Workers& workers);

} // namespace gpr

#endif
