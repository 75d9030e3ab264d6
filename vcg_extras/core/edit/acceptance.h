// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_EDIT_ACCEPTANCE_H
#define VCG_EXTRAS_CORE_EDIT_ACCEPTANCE_H

#include <vcg_extras/core/base/triangle.h>
#include <vcg_extras/core/mesh/half_edge_mesh.h>

#include <cmath>

namespace gpr {

/// What a change must leave of the mesh. Each figure keeps its limit, or is no worse than it was
/// before the change. A figure whose limit stands at its default is not measured.
struct Acceptance {
	// Each face by itself.
	float turn  = -2; ///< cosine of the face's normals before and after, 0 or more; below -1: any
	float shape = 0;  ///< see triangleShape
	float angle = 0;  ///< radians, the smallest of the face
	float agreement = -1; ///< cosine of the face's normal and the surface's
	float falls     = 1;  ///< below this share of its value before a figure is worse: rounding

	// The faces of a patch together.
	float distance = HUGE_VALF; ///< of the assigned points of the input, in mean edges
	float guarded  = HUGE_VALF; ///< points so far off get no farther on the mean; working units
	float gap      = HUGE_VALF; ///< of the faces from the surface, working units
	bool  contacts = false;     ///< no more pairs of faces touch than before

	// Vertices and edges.
	float move        = HUGE_VALF; ///< of a vertex from where the search found it, in mean edges
	float normalTurn  = -2; ///< cosine of the surface's normals at a vertex before and after a move
	bool  gentleFlips = false; ///< see PatchEditor::isGentleFlip
};

/// What changes a mesh of triangles.
enum class Driver {
	Relaxation,        ///< moves of all vertices on the surface
	Fit,               ///< moves of all vertices to the input
	CurveFit,          ///< moves of vertices of curves to their curve
	Count,             ///< collapses for the exact count
	InvertedFaces,     ///< local search before the fit
	AnglesOnly,        ///< local search where no fit follows
	PoorFaces,         ///< local search after the fit
	LargeAngles,       ///< the same for the largest angles
	WorstDistances,    ///< moves where input and result are farthest apart
	Refinement,        ///< splits for an error that is asked for
	GuardedRelaxation, ///< flips and slides where the guard has made vertices
};

/// A face that agrees less with the surface than this, 73°, is about to turn over.
constexpr float minAgreement = 0.3f;

/// The limits of a driver. angle: what takes the place of the table's angle where that says
/// `asked`; radians.
Acceptance acceptanceOf(Driver driver, float angle = 0);

/// Whether a change of a face's corners is forbidden by its turn, shape or angle.
bool spoilsFace(const Acceptance& limits, const Corners& before, const Corners& after);

/// Whether v may not move from its place to `to` while all other vertices stay. Faces with the
/// vertex `without`, which the move is to take out, do not count.
bool spoilsRing(const Acceptance& limits, const HalfEdgeMesh& mesh, int v, const Vec3f& to,
				int without = -1);

/// Whether the agreement of a face with the surface falls too low.
inline bool spoilsAgreement(const Acceptance& limits, float before, float after)
{
	return after < limits.agreement && after < limits.falls * before;
}

} // namespace gpr

#endif
