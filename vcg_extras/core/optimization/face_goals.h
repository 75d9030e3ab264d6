// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OPTIMIZATION_FACE_GOALS_H
#define VCG_EXTRAS_CORE_OPTIMIZATION_FACE_GOALS_H

#include <vcg_extras/core/edit/local_search.h>

#include <vector>

namespace gpr {

// What local searches are for. The limits of all goals stand side by side in face_goals.cpp.

/// Operations that leave the number of vertices as it is, and those that change it.
extern const std::vector<Operation::Kind> keepingCount, changingCount;

/// Faces that are inverted, lie across a feature line or have no area. They are left by
/// the retriangulation where the surface is thinner than the triangles are long: fingers, rims,
/// thin plates.
Goal invertedFaces(LocalSearch& search, bool mayCollapse);

/// Faces without area alone. No result may have one, so nothing bounds this search.
Goal facesWithoutArea(LocalSearch& search);

/// Faces with an angle below `angle` (radians). Minimised is the sum over the faces of the squares
/// of what the smallest angle lacks. guardedDistance: see Acceptance::guarded.
Goal smallAngles(LocalSearch& search, float angle, const std::vector<Operation::Kind>& operations,
				 float guardedDistance = HUGE_VALF);

/// The largest angle (radians) that is as poor as a smallest one: 110° for 32°, 180° for 0.
float asPoorAs(float smallestAngle);

/// Faces with a largest angle above asPoorAs(angle). Minimised is the sum over the faces of the
/// squares of what is too much, and of what smallest angles lack; no angle falls below `angle`
/// (radians), and none below it falls further. guardedDistance: see Acceptance::guarded.
Goal largeAngles(LocalSearch& search, float angle, float guardedDistance = HUGE_VALF);

} // namespace gpr

#endif
