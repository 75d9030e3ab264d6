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

/// Stage::Retriangulation as the paper has it (§3, last paragraph; Fu & Zhou 2008): every vertex of
/// the surface that is no sample is taken out of the mutual tessellation; its star is flattened by
/// the geodesic polar map, and the hole closed by a constrained Delaunay triangulation. A vertex
/// whose hole cannot be closed without doubling an edge or folding the surface is tried again when
/// its neighbours are gone, then under looser geometry, then merged into a neighbour (collapseRest,
/// counted in byCollapseNum); what the topology needs stays and is counted in leftoverNum.
///
/// The paper leaves open, and here is chosen: rounds in which no two neighbours go, so that the
/// mesh coarsens evenly; at a border the angles are scaled to 180° and the hole closed along it.
///
/// Works block by block like removeVertices, whose result it shares: the same samples give the same
/// vertices. Needs a sampling's samples to be the fused mesh's. Cost: about 1 M vertices/s a core.
ResultMesh removeOriginalVertices(FusedMesh&& fused, const Surface& surface,
								  const Sampling& sampling, const BoundaryCurves& boundary,
								  const OctreeBlocks& partition, Workers& workers);

/// The geodesic polar map of a star: place i of its ring lies at its true distance from the vertex,
/// in the directions the faces' angles give, scaled to add up to 360°, or 180° at a border. All
/// places lie in one direction where the star has no angle at all. Returns the mean of the faces'
/// normals by area. Cost: linear.
Vec3d flattenStar(const HalfEdgeMesh& m, const VertexStar& star, std::vector<Vec2d>& flat);

/// What a hole must keep to.
struct HoleRules {
	float minCosine      = -2;        ///< of new faces' normals with the star's mean normal
	float longestSquared = HUGE_VALF; ///< of new edges, squared length
};

/// Removes vertices of one mesh; each thread has one of its own.
class HoleRetriangulator {
public:
	explicit HoleRetriangulator(HalfEdgeMesh& mesh) : m_(mesh) {}

	/// Takes v out and closes the hole. False, and nothing changed: the polygon cannot be
	/// triangulated, the new faces break the rules, topology forbids it (see canRemoveVertex), or
	/// the ring has more than maxPlaces places.
	bool remove(int v, const HoleRules& rules);

	/// The star of the vertex removed last.
	const VertexStar& star() const { return star_; }

	/// Larger rings are left to collapses: the time of a hole grows with the square of its size.
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
