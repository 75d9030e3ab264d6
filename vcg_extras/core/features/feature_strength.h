// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_FEATURES_FEATURE_STRENGTH_H
#define VCG_EXTRAS_CORE_FEATURES_FEATURE_STRENGTH_H

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/half_edge_mesh.h>

#include <cstdint>

namespace gpr {

/// Second-order differences of the edges of a surface, degrees, per half-edge and the same for both
/// halves; 0 at borders.
struct EdgeDifferences {
	/// Uniformly supported: the angle between the mean normals of the edge's two half-disks.
	Buffer<float> supported;
	/// Unsupported: the angle between the normals of its two faces.
	Buffer<float> dihedral;
	std::int64_t  cappedRayNum = 0;
};

/// The half-disk of an edge is what of one side of it lies within `support` (working units) of its
/// midpoint, along the surface:
///
///            . - - .
///         .  \  |  /  .         Its area-weighted mean normal is summed up along straight
///        . \  \ | /  / .        geodesics, each standing for a sector: a piece of one from
///        .-- \ \|/ / --.        distance p to q weighs (q² - p²)/2. So the cost goes with the
///       ------- e -------       support over the local edge length, not with its square.
///
/// All half-disks have one metric size: where the mesh is finer or coarser makes no difference.
/// Rays that cross more than 256 faces end there and are counted. Cost: about 50 faces an edge with
/// a support of two edges; linear, parallel.
EdgeDifferences edgeDifferences(const HalfEdgeMesh& mesh, float support, Workers& workers);

/// Angle between two vectors in degrees; 0 where one is zero.
float angleDegBetween(const Vec3f& a, const Vec3f& b);

} // namespace gpr

#endif
