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

/// A plane with coordinates of its own: the height above it, and two along it. Across an axis these
/// are the caller's coordinates, with the plane at 0.
struct MirrorPlane {
	int                  axis = 0; ///< of the height; -1: the plane lies across no axis
	std::array<Vec3d, 3> row  = {Vec3d(1, 0, 0), Vec3d(0, 1, 0), Vec3d(0, 0, 1)}; ///< normal first
	double               at   = 0; ///< height of the plane above the caller's origin
	/// Heights above the plane are multiples of this, so that floats hold them on both sides; 0:
	/// any.
	double step = 0;

	/// The axis of the height in the plane's coordinates.
	int   heightAxis() const { return std::max(axis, 0); }
	Vec3d toPlane(const Vec3d& p) const;
	Vec3d toCaller(const Vec3d& q) const;
	/// Rounds the height of a point above the plane, and never to 0.
	Vec3d rounded(Vec3d q) const;
	/// The mirror image of a point in the plane's coordinates.
	Vec3d mirrored(Vec3d q) const;
	/// The same in the caller's.
	Vec3d imageOf(const Vec3d& p) const { return toCaller(mirrored(toPlane(p))); }
};

/// A plane and how far a surface is from its mirror image.
struct FoundPlane {
	MirrorPlane plane;
	double mismatch = 0; ///< of the vertex whose image is farthest from the surface, mesh units
	Vec3d  farthest;     ///< that vertex
};

/// Finds the plane of a symmetry: across the axis, through the middle of the box; or, with
/// Symmetry::Auto, that of the axes' planes with the least mismatch, and where all of these have
/// more than `allowed` (mesh units) that of the principal axes. Cost: a nearest point for each
/// vertex, parallel.
FoundPlane findMirrorPlane(const Surface& surface, Symmetry symmetry, double allowed,
						   Workers& workers);

/// What of a surface lies above a plane. Faces across the plane are cut there.
struct MirrorHalf {
	std::vector<Vec3d>        positions; ///< in the plane's coordinates; 0 above it where cut
	std::vector<std::int32_t> triangles;
	std::vector<std::int32_t> faceOf; ///< per face: the surface's that it is a part of
	std::vector<SurfacePoint> point;  ///< per vertex: where on the surface it lies
	std::vector<std::uint8_t> line;   ///< three a face: on a feature line of the surface

	// Where the caller's mesh has them.
	std::vector<std::uint8_t> selected;
	std::vector<float>        wantedEdge;
	std::vector<std::int32_t> region;

	/// Of the arrays that are not empty, and of `line` where the caller has lines.
	MeshView view(const MeshView& input, const MirrorPlane& plane) const;
};

/// Cuts a surface. Vertices within a millionth of the diagonal of the plane are taken to lie on it.
/// Cost: linear, serial.
MirrorHalf cutHalf(const MeshView& input, const Surface& surface, const MirrorPlane& plane,
				   Workers& workers);

} // namespace gpr

#endif
