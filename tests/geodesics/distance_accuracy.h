// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GPR_TESTS_GEODESICS_DISTANCE_ACCURACY_H
#define GPR_TESTS_GEODESICS_DISTANCE_ACCURACY_H

#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/mesh_view.h>

#include <cstdint>

namespace gpr::test {

/// The distances to be compared with exact distances.
enum class Metric {
	Default,    ///< the placement by disk intersection: chords on flat disks
	BorderEdge, ///< the paper's placement: unfolding everywhere
};

/// Relative errors of distances over vertices: (computed - exact) / exact.
struct Accuracy {
	std::int64_t vertexNum     = 0;
	std::int64_t unreachedNum  = 0; ///< nearer than 0.95 of the reach, but not reached
	double       mean          = 0; ///< of the absolute values
	double       largestOver   = 0; ///< too long by
	double       largestUnder  = 0; ///< too short by; 0 or below
	double       above5Percent = 0; ///< share of the vertices with an error above 5 %
};

/// A surface as prepared for a sampling with a target of `percent`, and its disk radius.
struct Ground {
	Surface surface;
	float   radius = 0; ///< working units

	Ground(const MeshView& mesh, double percent);
};

/// Distances from random points of the surface, up to `reach` disk radii, against exact geodesics.
Accuracy measureAccuracy(const Ground& ground, Metric metric, double reach, int sourceNum,
						 std::uint32_t seed);

/// Accuracy under a stretch of distances (eq. (4)), by unfolding: on a jittered grid of cellNum
/// cells a side, stretched by 1 / y over [0, 1] × [0.25, 1]. This is a part of the hyperbolic
/// plane, with distances in closed form. The disks have the radius `radius`, below 0.6, and lie
/// inside of the part.
Accuracy measureUnderStretch(int cellNum, double radius, int sourceNum, std::uint32_t seed);

} // namespace gpr::test

#endif
