// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_RUN_PREPARED_H
#define VCG_EXTRAS_CORE_RUN_PREPARED_H

#include <vcg_extras/core/base/run_context.h>
#include <vcg_extras/core/features/boundary_curves.h>
#include <vcg_extras/core/mesh/connect.h>

#include <cstdint>
#include <vector>

namespace gpr {

/// The input made ready, and what was learnt on the way.
struct Prepared {
	Surface      surface;
	double       area      = 0; ///< working units squared
	std::int64_t targetNum = 0;
	std::int64_t madeFor   = 0; ///< count that edges were split and sizes found for
	float        radius    = 0; ///< of the largest disks, working units
	float  callersMeanEdge = 0; ///< before edges were split, working units; 0: hardly any were
	double radiusFactor    = 1; ///< that over the radius of eq. (1): see Sizing
	Buffer<char>     isFeatureVertex;           ///< of the region to be preserved; empty: none
	std::vector<int> coneApexes;                ///< vertices at cone apexes
	BoundaryCurves   curves;                    ///< with samples, where they are known already
	float            curvesRadius = 0;          ///< for which they were sampled; 0: not yet
	std::vector<int> kept;                      ///< the caller's vertices that stay
	bool             keepsRaggedBorder = false; ///< BoundaryMode::Smooth was given up
	bool             isSewn            = false; ///< along seams
	bool             sharesBorders     = false; ///< some lie at one place: see shared_borders.h
};

/// What becomes of the border of the prepared surface.
BoundaryMode borderMode(const RemeshOptions& options, const Prepared& p);

/// Eq. (1).
double diskRadius(double area, double vertexNum, double constant);

/// c of eq. (1) for the preset chosen.
double radiusConstant(const RemeshOptions& options);

/// Edge length of the largest triangles.
float idealEdge(const Prepared& p);
/// Edge length of the triangles if all had one size.
float evenEdge(const Prepared& p);

/// Sets the target, and the radius that goes with it.
void setTarget(RunContext& run, std::int64_t targetNum, Prepared& p);

} // namespace gpr

#endif
