// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_FEATURES_CURVE_SLIDE_H
#define VCG_EXTRAS_CORE_FEATURES_CURVE_SLIDE_H

#include "boundary_curves.h"

#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/surface/result_mesh.h>

namespace gpr {

/// How far a vertex may slide along its curve: arc lengths to its two neighbours on the curve. Zero
/// if the vertex must stay or the neighbour is on another curve.
struct SlideRoom {
	float backward = 0;
	float forward  = 0;
	int   last     = -1; ///< the neighbour behind
	int   next     = -1; ///< the neighbour ahead

	/// Whether there is room both ways.
	bool isOpen() const { return backward > 0 && forward > 0; }
};

/// The room of v, a vertex of a curve. None for a vertex at which feature lines meet.
SlideRoom slideRoom(const ResultMesh& result, const BoundaryCurves& curves, int v);

/// Unit direction in which the arc grows at a vertex with room to slide: the direction of the chord
/// over a quarter of the room on either side.
Vec3f slideDirection(const BoundaryCurves& curves, const ResultVertex& vertex,
					 const SlideRoom& room);

/// Whether a slide of v by `step` keeps the two chords at v close to the curve: within the
/// tolerance of spacing (see CurveSpacing), or no further from the curve than now.
bool slideKeepsToCurve(const ResultMesh& result, const BoundaryCurves& curves, int v,
					   const SlideRoom& room, float step);

/// Whether v may go from its curve: the edge between its neighbours on the curve is as close to the
/// curve as the two edges at v, or within the tolerance of spacing. False for vertices that must
/// stay.
bool mayLeaveCurve(const ResultMesh& result, const BoundaryCurves& curves, int v);

/// Whether a slide of v by `step` leaves its neighbours on the curve between 0.7 and 1.3 wanted
/// edges away along the curve, or within the range of the two arcs now. So repeated slides cannot
/// crowd vertices at one place and leave long edges at another.
bool slideKeepsSpacing(const ResultMesh& result, const BoundaryCurves& curves, int v,
					   const SlideRoom& room, float step);

/// The record of a vertex after a slide by `step` along its curve.
ResultVertex slid(const Surface& surface, const BoundaryCurves& curves, const ResultVertex& vertex,
				  float step);

} // namespace gpr

#endif
