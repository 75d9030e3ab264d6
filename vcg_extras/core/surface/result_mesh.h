// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_SURFACE_RESULT_MESH_H
#define VCG_EXTRAS_CORE_SURFACE_RESULT_MESH_H

#include "surface_point.h"

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/half_edge_mesh.h>

#include <vector>

namespace gpr {

/// The place of a vertex of the result on the working surface, and its rights to move.
struct ResultVertex {
	SurfacePoint point;            ///< at or below the vertex (see ResultMesh)
	Vec3f        normal;           ///< of the face of point
	int          curve    = -1;    ///< border or feature line of the vertex, or -1
	float        arc      = 0;     ///< arc length on the curve
	bool         isCorner = false; ///< corner of the curves, or cone apex: never moves
	bool isShared = false; ///< other borders have a vertex here: never moves, so that no gap opens
	bool isPinned = false; ///< kept vertex of the input: never moves, never removed
	bool isMade   = false; ///< made by the guard
	int  sample   = -1;    ///< index of the vertex among the samples; -1: made later
};

/// The facts about a result mesh under way.
struct ResultFacts {
	bool keepsBorder     = false; ///< no border edge may be split
	bool hasSmoothBorder = false; ///< border vertices need not lie on the border of the working
								  ///< surface
	float idealEdge = 0;          ///< edge of the lattice of equilateral triangles, L0
	int   copyNum   = 0;          ///< vertices that go when sheets are joined: see junctions.h

	std::int64_t flipNum     = 0;
	std::int64_t splitNum    = 0;
	std::int64_t collapseNum = 0;
	std::int64_t leftoverNum = 0; ///< input vertices that could not be removed
};

/// The result mesh under way, from retriangulation to the end. Before the fit,
/// vertex[v].point.position is mesh.position[v]. The fit then moves vertices off the surface; the
/// surface points stay on the surface, below the vertices.
struct ResultMesh : ResultFacts {
	HalfEdgeMesh              mesh;
	std::vector<ResultVertex> vertex;

	/// Number of vertices after joining the sheets, and after joining half a symmetric mesh to its
	/// mirror image.
	std::int64_t vertexNum() const;
	/// Number of faces after the same joining.
	std::int64_t faceNum() const { return std::int64_t(mesh.sideNum()) * mesh.faceNum; }
};

/// Whether v may move over the surface and may be merged: v lies on no curve and is no cone apex.
inline bool isFree(const ResultMesh& result, int v)
{
	return !result.vertex[v].isCorner && !result.mesh.isCurveVertex(v);
}

/// Whether the border edge h may be split. With several borders at the same place, all of these
/// would have to be split.
inline bool maySplitBorder(const ResultMesh& result, int h)
{
	const HalfEdgeMesh& m = result.mesh;
	const bool          isAlone =
		!result.vertex[m.origin[h]].isShared || !result.vertex[m.target(h)].isShared;
	return !result.keepsBorder && isAlone;
}

/// Local size at a point of the surface, as a share of the largest size; interpolated over the
/// face.
float sizeAt(const Surface& surface, const SurfacePoint& at);

/// Local sizes at the vertices of a result; empty if all sizes are equal.
Buffer<float> sizesOf(const Surface& surface, const ResultMesh& result, Workers& workers);

/// A copy, without spare memory. Results cannot be copied by accident.
ResultMesh copyResult(const ResultMesh& result, Workers& workers);

/// Drops dead faces and vertices (see mesh_edit.h) from the mesh and from the vertex records.
void compactResult(ResultMesh& result, Workers& workers);

/// The largest distance of a vertex from its surface point on the input. Cost: O(V).
float farthestFromSurface(const ResultMesh& result);

} // namespace gpr

#endif
