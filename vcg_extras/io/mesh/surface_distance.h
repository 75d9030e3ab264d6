// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_IO_MESH_SURFACE_DISTANCE_H
#define VCG_EXTRAS_IO_MESH_SURFACE_DISTANCE_H

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh_view.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace gpr::app {

/// Distances of the points of one surface from another, mesh units.
struct DistanceFigures {
	double       mean      = 0; ///< over the surface
	double       rms       = 0; ///< over the surface: the E_RMS of Metro
	double       p999      = 0; ///< 99.9 % of the surface is nearer than this
	double       max       = 0; ///< largest of those measured
	std::int64_t sampleNum = 0; ///< points spread evenly over the area
	std::int64_t vertexNum = 0; ///< vertices measured beside them; they count for max only
};

/// A point of a surface and its distance from another one, mesh units.
struct FarPoint {
	Vec3d  position;
	double distance = 0;
};

/// A surface to which distances are measured: CGAL's bounding-box tree over its triangles.
class DistanceTarget {
public:
	/// Faces with corners that are not finite or without area in the index sense are left out.
	/// The mesh must stay where it is. Cost: O(F log F), about 150 B a face.
	explicit DistanceTarget(const MeshView& mesh);
	~DistanceTarget();
	DistanceTarget(const DistanceTarget&)            = delete;
	DistanceTarget& operator=(const DistanceTarget&) = delete;

	/// Distances of another surface from this one (Cignoni, Rocchini, Scopigno 1998: Metro): about
	/// sampleNum points spread evenly over its area, and all its vertices. The points depend on the
	/// mesh only. The p99.9 is at most 0.05 % too large: see DistanceHistogram. No distance is
	/// found where either has no usable face: all figures are 0 then.
	DistanceFigures from(const MeshView& mesh, std::int64_t sampleNum, Workers& workers) const;

	/// For each of these faces of another surface that of seven points which is farthest from this
	/// one: its corners, the middles of its edges and its own middle. The faces must have finite
	/// corners. Distance 0 where this surface has no usable face.
	std::vector<FarPoint> farthestPoints(const MeshView&                   mesh,
										 const std::vector<std::uint32_t>& faces,
										 Workers&                          workers) const;

private:
	struct Tree;
	std::unique_ptr<Tree> tree_;
};

/// Points for a comparison of two surfaces: ten for each face of the result, but neither so few
/// that the figures depend on where they fall nor so many that measuring takes longer than meshing.
std::int64_t distanceSampleNum(std::size_t resultFaceNum);

} // namespace gpr::app

#endif
