// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_RETRIANGULATION_HOLE_RETRIANGULATION_H
#define VCG_EXTRAS_CORE_RETRIANGULATION_HOLE_RETRIANGULATION_H

#include "polygon_delaunay.h"
#include "sampled_result.h"

#include <vcg_extras/core/mesh/octree_blocks.h>
#include <vcg_extras/core/sampling/fused_mesh.h>
#include <vcg_extras/core/surface/result_mesh.h>

namespace gpr {

/// Stage::Retriangulation of the paper (§3, last paragraph; Fu & Zhou 2008). Removes every vertex
/// of the mutual tessellation that is no sample: flattens its star by the geodesic polar map, and
/// closes the hole by a constrained Delaunay triangulation. If this would double an edge or fold
/// the surface, the vertex is tried again after its neighbours, then under looser geometry, and at
/// last merged into a neighbour (collapseRest). Vertices that the topology needs stay and are
/// counted in leftoverNum.
///
/// Two choices that the paper leaves open: no two neighbours are removed in the same round, so that
/// the mesh coarsens evenly; at a border the angles are scaled to 180° and the hole is closed along
/// the border.
///
/// Works block by block like removeVertices, and gives the same vertices from the same samples.
/// Needs a fused mesh made from the samples of `sampling`. Cost: about 1 M vertices/s a core.
ResultMesh removeOriginalVertices(FusedMesh&& fused, const Surface& surface,
								  const Sampling& sampling, const BoundaryCurves& boundary,
								  const OctreeBlocks& partition, Workers& workers);

/// Computes the geodesic polar map of a star: place i of the ring keeps its distance from the
/// vertex; its direction follows from the angles of the faces, scaled to a sum of 360°, or 180° at
/// a border. If all angles are 0, all places lie in the same direction. Returns the mean normal of
/// the faces by area. Cost: linear.
Vec3d flattenStar(const HalfEdgeMesh& m, const VertexStar& star, std::vector<Vec2d>& flat);

/// The rules of new faces.
struct HoleRules {
	float minCosine;      ///< of a new face's normal with the star's mean normal
	float longestSquared; ///< largest squared length of a new edge
};

/// Removes vertices of a mesh; every thread has an object of its own.
class HoleRetriangulator {
public:
	explicit HoleRetriangulator(HalfEdgeMesh& mesh) : m_(mesh) {}

	/// Removes v and closes the hole. Returns false without a change if the polygon cannot be
	/// triangulated, the new faces break the rules, the topology forbids the removal
	/// (canRemoveVertex), or the ring has more than maxPlaces places.
	bool remove(int v, const HoleRules& rules);

	/// The star of the last removed vertex.
	const VertexStar& star() const { return star_; }

	/// Larger rings are left to collapses, as the time of a hole grows with the square of its size.
	static constexpr int maxPlaces = 128;

private:
	HalfEdgeMesh&      m_;
	VertexStar         star_;
	HolePatch          patch_;
	PolygonDelaunay    delaunay_;
	std::vector<Vec2d> flat_;
	EditScratch        scratch_;

	void forbidPresentEdges();
	bool keeps(const HoleRules& rules, const Vec3f& normal) const;
};

} // namespace gpr

#endif
