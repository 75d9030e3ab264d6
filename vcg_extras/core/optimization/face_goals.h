// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OPTIMIZATION_FACE_GOALS_H
#define VCG_EXTRAS_CORE_OPTIMIZATION_FACE_GOALS_H

#include <vcg_extras/core/edit/local_search.h>

#include <functional>

namespace gpr {

// The goals of local searches. face_goals.cpp lists the limits of all goals side by side.

/// Goal against faces that are inverted, lie across a feature line or are degenerate. The
/// retriangulation leaves such faces on parts thinner than the triangles are long: fingers, rims,
/// thin plates.
Goal invertedFaces(LocalSearch& search, bool mayCollapse);

/// Goal against degenerate faces only. No result may have a degenerate face, so that the search has
/// no work limit.
Goal facesWithoutArea(LocalSearch& search);

/// Goal against faces with an angle below `angle` (radians). Minimises the sum over the faces of
/// the squared lack of the smallest angle.
Goal smallAngles(LocalSearch& search, float angle);
/// The same by operations that change the number of vertices.
Goal smallAnglesByCount(LocalSearch& search, float angle);

/// Goal against contacts of the wanted faces with other faces. Minimises the number of contacts
/// plus the sum over the faces of the squared lack of the smallest angle.
Goal facesInContact(LocalSearch& search, std::function<bool(int face)> isWanted);

/// Goal to split an edge of each wanted face, until no face is wanted. Any split within the limits
/// helps.
Goal splitFaces(std::function<bool(int face)> isWanted);

/// The largest angle (radians) that counts as poor as a smallest angle: 110° for 32°, 180° for 0.
float asPoorAs(float smallestAngle);

/// Goal against faces with a largest angle above asPoorAs(angle). Minimises the sum over the faces
/// of the squared excess of the largest angle and the squared lack of the smallest angle; no angle
/// falls below `angle` (radians), and smaller angles do not fall further.
Goal largeAngles(LocalSearch& search, float angle);

} // namespace gpr

#endif
