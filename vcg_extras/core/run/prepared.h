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

/// Edge length in largest errors that a search for the count of an error begins with: many
/// triangles a trial cost more than a trial.
constexpr double edgePerError = 5;

/// The input made ready, and what was learnt on the way.
struct Prepared {
	Surface      surface;
	double       area      = 0; ///< working units squared
	std::int64_t targetNum = 0;
	float        radius    = 0; ///< of the largest disks, working units
	float  callersMeanEdge = 0; ///< before edges were split, working units; 0: hardly any were
	double radiusFactor    = 1; ///< that over the radius of eq. (1): see Sizing
	Buffer<char>     isFeatureVertex;  ///< of the region to be preserved; empty: none
	std::vector<int> tips;             ///< vertices at tips of cones
	BoundaryCurves   curves;           ///< with samples, where they are known already
	float            curvesRadius = 0; ///< for which they were sampled; 0: not yet
	std::vector<int> kept;             ///< the caller's vertices that stay
};

/// Vertices of about-equilateral triangles of this edge length that cover the area.
double vertexNumForEdgeLength(double area, double edgeLength);

/// Eq. (1).
double diskRadius(double area, double vertexNum, double constant);

/// c of eq. (1) for the equations and the placement chosen.
double radiusConstant(const RemeshOptions& options);

/// More vertices are refused.
constexpr double mostResultVertices = 2e8;

/// The number of vertices that the options ask for, not rounded, whatever it is; area and scale as
/// below.
double wantedVertexNum(const MeshView& input, const RemeshOptions& options, double area,
					   double scale);

/// The number of vertices that the options ask for; area in working units squared, scale from mesh
/// to working units. Throws Failure where it is more than a mesh may have.
std::int64_t resolveTarget(const MeshView& input, const RemeshOptions& options, double area,
						   double scale);

/// Edge length of the largest triangles.
float idealEdge(const Prepared& p);

/// Sets the target, and the radius that goes with it.
void setTarget(RunContext& run, std::int64_t targetNum, Prepared& p);

} // namespace gpr

#endif
