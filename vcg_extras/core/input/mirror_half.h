// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_INPUT_MIRROR_HALF_H
#define VCG_EXTRAS_CORE_INPUT_MIRROR_HALF_H

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/mesh_view.h>
#include <vcg_extras/core/options.h>
#include <vcg_extras/core/surface/surface_point.h>

#include <array>
#include <cstdint>
#include <vector>

namespace gpr {

/// A plane with coordinates of its own: the height above the plane, and two coordinates along the
/// plane. For a plane perpendicular to an axis these are the coordinates of the input mesh, with
/// the plane at 0.
struct MirrorPlane {
	int                  axis = 0; ///< of the height; -1: the plane is perpendicular to no axis
	std::array<Vec3d, 3> row  = {Vec3d(1, 0, 0), Vec3d(0, 1, 0), Vec3d(0, 0, 1)}; ///< normal first
	double               at   = 0; ///< height of the plane above the origin of the input mesh
	/// Heights above the plane are multiples of this step, so that floats hold the heights on both
	/// sides; 0: any height.
	double step = 0;

	/// The axis of the height in the plane's coordinates.
	int   heightAxis() const { return std::max(axis, 0); }
	Vec3d toPlane(const Vec3d& p) const;
	Vec3d toCaller(const Vec3d& q) const;
	/// Rounds the height of a point above the plane, but never to 0.
	Vec3d rounded(Vec3d q) const;
	/// The mirror image of a point in the plane's coordinates.
	Vec3d mirrored(Vec3d q) const;
	/// The mirror image of a point in the coordinates of the input mesh.
	Vec3d imageOf(const Vec3d& p) const { return toCaller(mirrored(toPlane(p))); }
};

/// A plane, and the distance of a surface from its mirror image.
struct FoundPlane {
	MirrorPlane plane;
	double      mismatch = 0; ///< largest distance of a vertex's image from the surface, mesh units
	Vec3d       farthest;     ///< the vertex with this distance
};

/// Finds the plane of a symmetry: perpendicular to the given axis, through the middle of the box.
/// For Symmetry::Auto, the plane of least mismatch among the planes of the three axes; if this
/// mismatch exceeds `allowed` (mesh units), also among the planes of the principal axes. Cost: a
/// nearest point for each vertex, parallel.
FoundPlane findMirrorPlane(const Surface& surface, Symmetry symmetry, double allowed,
						   Workers& workers);

/// The part of a surface above a plane. Faces across the plane are cut.
struct MirrorHalf : MarkedMesh {
	// Positions are in the plane's coordinates, with height 0 at the cut.
	std::vector<std::int32_t> faceOf; ///< per face: whole face of the surface
	std::vector<SurfacePoint> point;  ///< per vertex: its point on the surface

	/// A view of all arrays that are not empty; of `line` if the input has lines.
	MeshView view(const MeshView& input, const MirrorPlane& plane) const;
};

/// Cuts a surface. Vertices within a millionth of the diagonal from the plane count as on the
/// plane. Cost: linear, serial.
MirrorHalf cutHalf(const MeshView& input, const Surface& surface, const MirrorPlane& plane,
				   Workers& workers);

} // namespace gpr

#endif
