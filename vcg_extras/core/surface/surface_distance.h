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
#include <vector>

namespace gpr {

/// Distances of the points of one surface from another, mesh units.
struct DistanceFigures : SurfaceDistance {
	double       mean      = 0; ///< over the area
	double       vertexMax = 0; ///< largest distance of a vertex
	std::int64_t sampleNum = 0; ///< spread evenly over the area
	std::int64_t vertexNum = 0; ///< measured vertices beside the samples; count for max only
};

/// A point of a surface and its distance from another one, mesh units.
struct FarthestPoint {
	Vec3d  position;
	double distance = 0;
};

/// A surface with a tree, for measuring and proving distances from this surface. Any set of
/// triangles, manifold or not, of any origin. Double precision, so that needles of CAD do not make
/// figures wrong.
class MeasuredSurface {
public:
	/// Leaves out faces without three different, finite corners. The mesh may be freed afterwards.
	/// Throws as Workers do. Cost: see TriangleTree.
	MeasuredSurface(const MeshView& mesh, Workers& workers);
	/// With positions relative to the origin of `other`: proofs need a common origin.
	MeasuredSurface(const MeshView& mesh, const MeasuredSurface& other, Workers& workers);

	const TriangleTree& tree() const { return tree_; }
	const Vec3d&        origin() const { return origin_; }

	/// Distances of another surface from this surface (Cignoni, Rocchini, Scopigno 1998: Metro), at
	/// about sampleNum points spread evenly over the other surface. The largest distance also
	/// counts all vertices of usable faces. The points depend on the mesh only; the figures do not
	/// depend on the number of threads. The p99.9 is at most 0.05 % too large: see
	/// DistanceHistogram. All figures are 0 if either surface has no usable face; figures over the
	/// area are 0 if the other surface has no area. Cost: O(sampleNum + V) searches of some
	/// microseconds, parallel.
	DistanceFigures from(const MeshView& mesh, std::int64_t sampleNum, Workers& workers) const;

	/// Root mean square of the distance of each face of another surface from this surface, by seven
	/// points (Stroud's rule of degree 3). 0 for faces that are not usable, and if this surface has
	/// no usable face. Cost: seven searches per face, parallel.
	std::vector<float> ofFaces(const MeshView& mesh, Workers& workers) const;

	/// For each given face of another surface, the farthest of the same seven points from this
	/// surface. The faces must be usable. Distance 0 if this surface has no usable face.
	std::vector<FarthestPoint> farthestPoints(const MeshView&                   mesh,
											  const std::vector<std::uint32_t>& faces,
											  Workers&                          workers) const;

private:
	class Search;

	Vec3d        origin_;
	TriangleTree tree_;

	void measureArea(const MeshView& mesh, std::int64_t sampleNum, Workers& workers,
					 DistanceFigures& figures) const;
};

/// Number of points for a comparison of two surfaces: ten per face of the result, at least 200000
/// and at most 2000000. Fewer would make the figures depend on the places of the points; with more,
/// measuring would take longer than meshing.
std::int64_t distanceSampleNum(std::size_t resultFaceNum);

/// Distances of input and result from each other, in the unit of both meshes.
struct SampledDistance {
	MutualDistance mutual;
	double         vertexDistance = 0; ///< largest distance of a vertex of the result from the
									   ///< input
};

/// A mesh without dead faces, and the same surface for measuring.
struct MeasuredMesh {
	const HalfEdgeMesh&    mesh;
	const MeasuredSurface& surface;
};

/// MeasuredSurface::from() in both directions, by pointsPerFace points for each face of the result,
/// for at least 2000 and at most 20000 faces. By ten points, the p99.9 is known to some percent.
/// The largest distance is a lower bound; certifiedDistance proves a better bound.
SampledDistance sampledDistance(const MeasuredMesh& input, const MeasuredMesh& result,
								int pointsPerFace, Workers& workers);

} // namespace gpr

#endif
