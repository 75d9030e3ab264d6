// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OPTIMIZATION_FIT_H
#define VCG_EXTRAS_CORE_OPTIMIZATION_FIT_H

#include "curve_fit.h"

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/features/boundary_curves.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/surface/closest_face_map.h>
#include <vcg_extras/core/surface/result_mesh.h>

#include <memory>

namespace gpr {

struct FitSettings {
	int rounds = 4;                 ///< times to update the map and move all vertices; 0: vertices
									///< are raised over their neighbours, without the input
	float    shapeWeight = 0.0105f; ///< of the shape of triangles against the distance
	float    minAngleDeg = 32;      ///< no angle falls below; smaller angles fall no further
	int      worstRounds = 0;       ///< against the largest distances: see worst_distances.h
	CurveFit curveFit    = CurveFit::MeanAndLargest; ///< of borders and feature lines
};

struct FitOutcome {
	std::unique_ptr<ClosestFaceMap> map; ///< of the last round; null without rounds
	float largestGap = 0;     ///< between result and input after worstRounds, working units
	bool  capped     = false; ///< a guard gave up and took back the moves of a round
};

/// Stage::Fit: moves the vertices off the surface to the places with the smallest distance between
/// triangles and surface, and keeps the triangles regular. Minimises over the positions x of the
/// vertices
///
///     Σ_p A_p (n_p · (p - Σ_k b_k x_k))²  +  Σ_f s_f E_f  +  μ Σ_i M_i |x_i - x_i⁰|²
///
/// p runs over the vertices of the input, with area A_p and normal n_p; the nearest triangle has
/// the corners x_k, with weights b_k at the foot of p (see ClosestFaceMap). The first term is the
/// squared distance between triangles and tangent planes of the input. E_f = (a² + b² + c²) /
/// (4√3·area) is the conformal energy of a triangle, 1 if equilateral; only its tangential part
/// moves a vertex, so that the first term alone decides across the surface. A small pull to the
/// start keeps the system sound for vertices without input vertices near.
///
/// A round updates the map, assembles the first term as a matrix per vertex and edge, whose size
/// does not depend on the input, descends by Jacobi steps with momentum, shortens the moves of
/// faces that turn, look away from the surface or get poor angles, and lets the surface points
/// follow on the surface. At the end, inverted faces return to their places before the first round.
/// Vertices of borders and curves are fitted to their curves first (curve_fit.h) and stay there.
/// Faces may touch others afterwards: see guard/contact_removal.h.
///
/// Without rounds, each vertex is raised by a third of its height over the mean of its neighbours:
/// the volume stays, and the distance (RMS) is 14 to 38 % smaller on seven models, for the cost of
/// one pass over the result.
///
/// Changes mesh.position and the surface points. Cost: linear in the input per round; parallel; the
/// bits do not depend on the threads.
FitOutcome fitToInput(const Surface& surface, const BoundaryCurves& curves,
					  const FitSettings& settings, ResultMesh& result, Workers& workers);

} // namespace gpr

#endif
