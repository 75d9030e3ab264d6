// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_SURFACE_SURFACE_DISTANCE_H
#define VCG_EXTRAS_CORE_SURFACE_SURFACE_DISTANCE_H

#include "face_tree.h"

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh_view.h>
#include <vcg_extras/core/report.h>

#include <functional>
#include <vector>

namespace gpr {

/// Distances of about pointNum points, spread evenly over a surface. distance: of a point, from
/// whatever; called by several threads at once. The p99.9 is at most 0.05 % too large: see
/// DistanceHistogram. All figures are 0 where the surface has no area. Cost: so many calls,
/// parallel, and 8 B a face.
SurfaceDistance distanceOfEvenPoints(const MeshView& mesh, std::int64_t pointNum,
									 const std::function<double(const Vec3d&)>& distance,
									 Workers&                                   workers);

/// A surface to which distances are measured. Any set of triangles, manifold or not, whoever made
/// it; float precision of its own extent.
class NearSurface {
public:
	/// Faces without three different, finite corners are left out. Throws what workers throw.
	/// Cost: O(F log F), serial, about 70 B a face.
	NearSurface(const MeshView& mesh, Workers& workers);

	/// Root mean square over each face, by seven points (Stroud's rule of degree 3); 0 for those
	/// that are not usable, and where there is no surface. Cost: seven searches a face, parallel.
	std::vector<float> ofFaces(const MeshView& mesh, Workers& workers) const;

	/// Over about pointNum even points, as above, and for the largest distance also over all
	/// vertices that faces have. Cost: O(pointNum + V) searches of some microseconds, parallel.
	SurfaceDistance from(const MeshView& mesh, std::int64_t pointNum, Workers& workers) const;

private:
	Vec3d        origin_;
	HalfEdgeMesh faces_; ///< positions and corners only
	FaceTree     tree_;

	double distance(const Vec3d& p) const;
	double meanSquareOver(const MeshView& mesh, std::size_t face) const;
	double largestOfVertices(const MeshView& mesh, Workers& workers) const;
};

} // namespace gpr

#endif
