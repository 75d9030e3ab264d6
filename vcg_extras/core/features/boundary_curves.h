// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_FEATURES_BOUNDARY_CURVES_H
#define VCG_EXTRAS_CORE_FEATURES_BOUNDARY_CURVES_H

#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/options.h>
#include <vcg_extras/core/surface/curve.h>
#include <vcg_extras/core/surface/surface_point.h>
#include <vcg_extras/core/surface/walk.h>

#include <vector>

namespace gpr {

/// Spacing of border samples in r: the mean edge length of the result.
constexpr float borderSpacing = 1.04f;

/// A sample on a curve: fixed in number, free to slide along its curve unless a corner. Where
/// curves meet they share one; a cone apex, or a vertex to be kept inside, has no curve.
struct CurveSample {
	SurfacePoint point;
	int          curve    = -1;
	float        arc      = 0;
	bool         isCorner = false;
	bool         isShared = false; ///< other borders have one at the same place
	bool         isPinned = false; ///< kept as it is, whatever the count or the shape of triangles
	int vertex = -1; ///< the input vertex that stands for it in the removal; -1 if none is left
};

/// The border loops and feature lines of the input, their samples, and which sample each of their
/// vertices belongs to.
struct BoundaryCurves {
	std::vector<Curve>       curves; ///< loops of the border first
	std::vector<CurveSample> samples;
	/// For every vertex of curves[c], in order: the nearest sample along the arc.
	std::vector<std::vector<int>> sampleOfPoint;
};

/// The loops of the border, then the feature lines (mesh.crease), cut into chains between nodes.
std::vector<Curve> traceCurves(const HalfEdgeMesh& mesh);

/// Stage::Boundary: samples border and feature lines (surface.mesh.crease) before anything else, so
/// that they keep their shape and triangles are as regular there as inside. Feature lines are cut
/// into chains between nodes, the vertices where other than two of their edges meet or the border
/// is met; nodes and the given cone apexes are samples that never move. Vertices to be kept are
/// samples too: those on a curve cut it into pieces as corners do. Loops and chains are cut further
/// at corners (a turn of 50° that persists over r), each piece is sampled by chords of `spacing`
/// (see spaceOut). Loops too short for three samples keep three of their own vertices. What is said
/// here of loops holds for BoundaryMode::Resample; with Keep their samples are those of the
/// vertices to be kept that lie on them, with Free they have no corners. Where sharesBorders,
/// borders that lie at the same place get samples at the same numbers (see shared_borders.h), but
/// with Keep, where they do so anyway. Cost: linear in the curves.
BoundaryCurves sampleBoundary(const Surface& surface, float diskRadius, float spacing,
							  const std::vector<int>& coneApexes    = {},
							  const std::vector<int>& kept          = {},
							  BoundaryMode            border        = BoundaryMode::Resample,
							  bool                    sharesBorders = false);

} // namespace gpr

#endif
