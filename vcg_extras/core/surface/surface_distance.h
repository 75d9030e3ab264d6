// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_SURFACE_SURFACE_DISTANCE_H
#define VCG_EXTRAS_CORE_SURFACE_SURFACE_DISTANCE_H

#include "triangle_tree.h"

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/half_edge_mesh.h>
#include <vcg_extras/core/mesh_view.h>
#include <vcg_extras/core/report.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace gpr {

/// Distances of the points of one surface from another, mesh units.
struct DistanceFigures : SurfaceDistance {
	double       mean      = 0; ///< over the area
	double       vertexMax = 0; ///< largest of a vertex
	std::int64_t sampleNum = 0; ///< spread evenly over the area
	std::int64_t vertexNum = 0; ///< vertices measured beside them; they count for max only
};

/// A point of a surface and its distance from another one, mesh units.
struct FarthestPoint {
	Vec3d  position;
	double distance = 0;
};

/// A surface with the tree by which distances from it are measured and proven. Any set of
/// triangles, manifold or not, whoever made it. Double precision, so that needles of CAD do not
/// make figures wrong.
class MeasuredSurface {
public:
	/// Faces without three different, finite corners are left out. The mesh may go afterwards.
	/// Throws what workers throw. Cost: see TriangleTree.
	MeasuredSurface(const MeshView& mesh, Workers& workers);
	/// With positions relative to the same origin as another one: proofs need that.
	MeasuredSurface(const MeshView& mesh, const MeasuredSurface& other, Workers& workers);

	const TriangleTree& tree() const { return *tree_; }
	const Vec3d&        origin() const { return origin_; }

	/// Distances of another surface from this one (Cignoni, Rocchini, Scopigno 1998: Metro): about
	/// sampleNum points spread evenly over its area, and for the largest distance all vertices that
	/// faces have, too. The points depend on the mesh only, the figures not on the number of
	/// threads. The p99.9 is at most 0.05 % too large: see DistanceHistogram. All figures are 0
	/// where either has no usable face, and those over the area where it has none. Cost:
	/// O(sampleNum + V) searches of some microseconds, parallel.
	DistanceFigures from(const MeshView& mesh, std::int64_t sampleNum, Workers& workers) const;

	/// Root mean square of the distance of each face of another surface from this one, by seven
	/// points (Stroud's rule of degree 3); 0 for faces that are not usable, and where this surface
	/// has none. Cost: seven searches a face, parallel.
	std::vector<float> ofFaces(const MeshView& mesh, Workers& workers) const;

	/// For each of these faces of another surface that of the same seven points which is farthest
	/// from this one. The faces must be usable. Distance 0 where this surface has no usable face.
	std::vector<FarthestPoint> farthestPoints(const MeshView&                   mesh,
											  const std::vector<std::uint32_t>& faces,
											  Workers&                          workers) const;

private:
	class Search;

	Vec3d                         origin_;
	std::unique_ptr<TriangleTree> tree_;
};

/// Points for a comparison of two surfaces: ten for each face of the result, but neither so few
/// that the figures depend on where they fall nor so many that measuring takes longer than meshing.
std::int64_t distanceSampleNum(std::size_t resultFaceNum);

/// Distances of input and result from each other, in their own unit.
struct SampledDistance {
	MutualDistance mutual;
	double         vertexDistance = 0; ///< largest of a vertex of the result from the input
};

/// A mesh without dead faces, and the same for measuring.
struct MeasuredMesh {
	const HalfEdgeMesh&    mesh;
	const MeasuredSurface& surface;
};

/// As MeasuredSurface::from() both ways, by ten points for each face of the result, but at least
/// 20000 and at most 200000: the p99.9 is known to some percent. The largest distance is a lower
/// bound; certifiedDistance proves a better one.
SampledDistance sampledDistance(const MeasuredMesh& input, const MeasuredMesh& result,
								Workers& workers);

} // namespace gpr

#endif
