// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_EDIT_ACCEPTANCE_H
#define VCG_EXTRAS_CORE_EDIT_ACCEPTANCE_H

#include <vcg_extras/core/base/triangle.h>
#include <vcg_extras/core/mesh/half_edge_mesh.h>

#include <cmath>
#include <cstdint>

namespace gpr {

/// The limits on a change of the mesh. Each figure keeps its limit, or is no worse than before the
/// change. A figure with its limit at the default is not measured.
struct Acceptance {
	// Each face by itself.
	float turn  = -2; ///< cosine of the face's normals before and after, 0 or more; below -1: any
	float shape = 0;  ///< see triangleShape
	float angle = 0;  ///< smallest angle of the face, radians
	float agreement = -1; ///< normal agreement of the face

	float distance    = HUGE_VALF; ///< of a patch from the assigned points, in mean edges
	float move        = HUGE_VALF; ///< of a vertex from its place before the search, in mean edges
	float normalTurn  = -2; ///< cosine of the surface normals at a vertex before and after a move
	bool  gentleFlips = false; ///< see PatchEditor::isGentleFlip
	bool  contacts    = false; ///< a patch gets no more contacts than before

	// Not in the table of drivers.
	float falls   = 1;         ///< a figure below this share of its value before is worse: rounding
	float guarded = HUGE_VALF; ///< points this far off get no farther on the mean; working units
	float gap     = HUGE_VALF; ///< of the faces of a patch from the surface, working units
};

/// The algorithms that change a result mesh.
enum class Driver {
	Relaxation,        ///< moves of all vertices on the surface
	Fit,               ///< moves of all vertices to the input
	CurveFit,          ///< moves of vertices of curves to their curve
	Count,             ///< collapses for the exact count
	InvertedFaces,     ///< local search before the fit, where inverted faces are few
	DegenerateFaces,   ///< the same for degenerate faces, and where inverted faces are many
	AnglesOnly,        ///< local search without a fit after it
	PoorFaces,         ///< local search after the fit
	LargeAngles,       ///< local search after the fit, for the largest angles
	WorstDistances,    ///< moves at the largest distances of input and result
	Refinement,        ///< splits for a given error bound
	Contacts,          ///< local search against contacts
	GuardedRelaxation, ///< flips and slides at vertices made by the guard
};

/// A face with a normal agreement below this, 73°, is about to become inverted.
constexpr float minAgreement = 0.3f;

/// The limits of a driver. angle: the limit in place of the entry `asked` of the table; radians.
Acceptance acceptanceOf(Driver driver, float angle = 0);
/// The most work of all searches of a driver on a result with faceNum faces. The unit is a look at
/// a face, at a point, or at a pair of triangles, about 20 ns.
std::int64_t workOf(Driver driver, int faceNum = 0);

/// Whether turn, shape or angle forbid a change of a face's corners.
bool spoilsFace(const Acceptance& limits, const Corners& before, const Corners& after);

/// Whether the limits forbid a move of v to `to` while all other vertices stay. Faces with the
/// vertex `without` do not count: the move is made to remove this vertex.
bool spoilsRing(const Acceptance& limits, const HalfEdgeMesh& mesh, int v, const Vec3f& to,
				int without = -1);

/// Whether the normal agreement of a face falls too low.
inline bool spoilsAgreement(const Acceptance& limits, float before, float after)
{
	return after < limits.agreement && after < limits.falls * before;
}

} // namespace gpr

#endif
