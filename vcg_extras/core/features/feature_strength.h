// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_FEATURES_FEATURE_STRENGTH_H
#define VCG_EXTRAS_CORE_FEATURES_FEATURE_STRENGTH_H

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/half_edge_mesh.h>

#include <cstdint>

namespace gpr {

/// Second-order differences of the edges of a surface, degrees, per half-edge; both halves of an
/// edge are alike, 0 at borders.
struct EdgeDifferences {
	/// Uniformly supported: the angle between the mean normals of the two half-disks of the edge.
	Buffer<float> supported;
	/// Unsupported: the angle between the normals of the two faces of the edge.
	Buffer<float> dihedral;
	std::int64_t  cappedRayNum = 0;
};

/// Measures the differences of all edges. The half-disk of an edge is the part of the surface on
/// one side of the edge within `support` (working units) of its midpoint, along the surface:
///
///            . - - .
///         .  \  |  /  .         The area-weighted mean normal is summed up along straight
///        . \  \ | /  / .        geodesics, each of which covers a sector: a stretch of a ray
///        .-- \ \|/ / --.        from distance p to q weighs (q² - p²)/2. So the cost grows with
///       ------- e -------       support over local edge length, not with the square of the ratio.
///
/// All half-disks have one metric size, however fine the mesh is. A ray that crosses 256 faces ends
/// there and is counted. Cost: about 50 faces an edge with a support of two edges; linear,
/// parallel.
EdgeDifferences edgeDifferences(const HalfEdgeMesh& mesh, float support, Workers& workers);

/// Angle between two vectors in degrees; 0 if a vector is zero.
float angleDegBetween(const Vec3f& a, const Vec3f& b);

} // namespace gpr

#endif
