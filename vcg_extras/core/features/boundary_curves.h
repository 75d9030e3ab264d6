// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_FEATURES_BOUNDARY_CURVES_H
#define VCG_EXTRAS_CORE_FEATURES_BOUNDARY_CURVES_H

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/options.h>
#include <vcg_extras/core/surface/curve.h>
#include <vcg_extras/core/surface/surface_point.h>

#include <vector>

namespace gpr {

/// Distance of neighbouring border samples in disk radii: the mean edge length of the result.
constexpr float borderSpacing = 1.04f;

/// A sample on a curve. Its curve fixes the number of samples; a sample that is no corner may slide
/// along the curve. Curves that meet at a vertex share the sample there. A cone apex has no curve,
/// and no curve has a kept vertex inside the surface.
struct CurveSample {
	SurfacePoint point;
	int          curve    = -1;
	float        arc      = 0;
	bool         isCorner = false;
	bool         isShared = false; ///< other borders have a sample at the same place
	bool isPinned = false; ///< a vertex to keep, whatever the count or the shape of triangles
	int  vertex   = -1;    ///< its vertex of the working surface in the removal; -1 if none is left
};

/// The border loops and feature lines of the working surface, their samples, and the sample of each
/// vertex on a curve.
struct BoundaryCurves {
	std::vector<Curve>       curves; ///< loops of the border first
	std::vector<CurveSample> samples;
	/// For every vertex of curves[c], in order: the nearest sample along the arc.
	std::vector<std::vector<int>> sampleOfPoint;
};

/// Whether feature lines end, fork, cross or meet the border at v.
bool isCreaseNode(const HalfEdgeMesh& mesh, int v);
/// The next half-edge of the feature line after h, whose target is no node.
int nextOnCrease(const HalfEdgeMesh& mesh, int h);

/// The edges of feature lines (mesh.crease), each by its smaller half-edge, as sets of edges that
/// are connected. edges: all edges of the lines. Cost: a mark for each vertex, and the edges.
std::vector<std::vector<int>> connectedLines(const HalfEdgeMesh&     mesh,
											 const std::vector<int>& edges);

/// The border loops, then the feature lines (mesh.crease), cut into chains between nodes.
std::vector<Curve> traceCurves(const HalfEdgeMesh& mesh, Workers& workers);

/// Stage::Boundary: samples the border and the feature lines (surface.mesh.crease) before the
/// inside, so that both keep their shape and the triangles there are regular.
///
/// Feature lines are cut into chains between nodes. A node is a vertex at which a feature line
/// ends, forks or meets the border. Nodes and cone apexes are samples that never move. The vertices
/// in `kept` are samples too, and cut a curve as corners do. Loops and chains are also cut at
/// corners (a turn of 50° that persists over r). Each part gets samples by chords of length
/// `spacing` (see spaceOut). A loop too short for three samples keeps three of its own vertices.
///
/// This holds for border loops with BoundaryMode::Resample. With Keep the samples of a border loop
/// are its kept vertices; with Free and Smooth it has no corners. If sharesBorders is set, borders
/// at the same place get their samples once (see shared_borders.h). With Keep they share their
/// samples anyway. Cost: linear in the curves.
BoundaryCurves sampleBoundary(const Surface& surface, float diskRadius, float spacing,
							  Workers& workers, const std::vector<int>& coneApexes = {},
							  const std::vector<int>& kept          = {},
							  BoundaryMode            border        = BoundaryMode::Resample,
							  bool                    sharesBorders = false);

} // namespace gpr

#endif
