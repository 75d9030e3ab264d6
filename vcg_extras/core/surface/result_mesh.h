// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_SURFACE_RESULT_MESH_H
#define VCG_EXTRAS_CORE_SURFACE_RESULT_MESH_H

#include "surface_point.h"

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/half_edge_mesh.h>

#include <vector>

namespace gpr {

/// What a vertex of the result knows of the input.
struct ResultVertex {
	SurfacePoint point;  ///< where on the input's surface it lies, or nearly (see ResultMesh)
	Vec3f        normal; ///< of that face
	int          curve    = -1;    ///< border or feature line it belongs to, or -1
	float        arc      = 0;     ///< where on the curve
	bool         isCorner = false; ///< of the curves, or a cone apex: never moves
	bool isShared = false; ///< other borders have a vertex here: never moves, so that no gap opens
	bool isPinned = false; ///< one of the caller's vertices that is to be kept: never goes either
	bool isMade   = false; ///< by the guard
	int  sample   = -1;    ///< the sample it was, in the sampling's order; -1 for later ones
};

/// The mesh under way from retriangulation to the end. Until the fit vertex[v].point.position is
/// mesh.position[v]; the fit then takes vertices off the surface, and surface points stay on it
/// below them.
struct ResultMesh {
	HalfEdgeMesh              mesh;
	std::vector<ResultVertex> vertex;
	bool                      keepsBorder = false; ///< no border edge may be split
	bool  hasSmoothBorder = false; ///< its vertices need not lie on the input's border
	float idealEdge       = 0;     ///< edge of the lattice of equilateral triangles, L0
	int   copyNum         = 0;     ///< vertices that go when sheets are joined: see junctions.h

	std::int64_t flipNum       = 0;
	std::int64_t splitNum      = 0;
	std::int64_t collapseNum   = 0;
	std::int64_t byCollapseNum = 0; ///< input vertices that went though their hole was not closed
	std::int64_t leftoverNum   = 0; ///< input vertices that removal had to keep

	/// Of the result with its sheets joined.
	std::int64_t vertexNum() const { return mesh.vertexNum - copyNum; }
};

/// Whether v may move over the surface and be merged: neither on a curve nor a cone apex.
inline bool isFree(const ResultMesh& result, int v)
{
	return !result.vertex[v].isCorner && !result.mesh.isCurveVertex(v);
}

/// Whether the border edge h may get a vertex in its middle. Where borders lie at one place all of
/// them would have to.
inline bool maySplitBorder(const ResultMesh& result, int h)
{
	const HalfEdgeMesh& m = result.mesh;
	const bool          isAlone =
		!result.vertex[m.origin[h]].isShared || !result.vertex[m.target(h)].isShared;
	return !result.keepsBorder && isAlone;
}

/// Size at a point of a surface whose sizes differ: interpolated over its face.
float interpolatedSize(const Surface& surface, const SurfacePoint& at);

/// The wanted size at a point of the surface over the largest one.
inline float sizeAt(const Surface& surface, const SurfacePoint& at)
{
	return surface.size.empty() ? 1.0f : interpolatedSize(surface, at);
}

/// The sizes wanted at the vertices of a result; empty where all are the same.
Buffer<float> sizesOf(const Surface& surface, const ResultMesh& result, Workers& workers);

/// Results cannot be copied by accident. No room beyond the vertices and faces is copied.
ResultMesh copyResult(const ResultMesh& result, Workers& workers);

/// Drops dead faces and vertices (see mesh_edit.h) from mesh and vertex records.
void compactResult(ResultMesh& result, Workers& workers);

/// The largest distance of a vertex from its surface point on the input. Cost: O(V).
float farthestFromSurface(const ResultMesh& result);

} // namespace gpr

#endif
