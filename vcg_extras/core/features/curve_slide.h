// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_FEATURES_CURVE_SLIDE_H
#define VCG_EXTRAS_CORE_FEATURES_CURVE_SLIDE_H

#include "boundary_curves.h"

#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/surface/result_mesh.h>

namespace gpr {

/// How far a vertex of a curve may slide along it: arc lengths to its two neighbours on the curve.
/// Zero where it must stay or where a neighbour is on no curve of the same.
struct SlideRoom {
	float backward = 0;
	float forward  = 0;
	int   last     = -1; ///< the neighbour behind
	int   next     = -1; ///< the neighbour ahead

	/// Whether there is room both ways.
	bool isOpen() const { return backward > 0 && forward > 0; }
};

/// The room of v, a vertex of a curve. None for a vertex where feature lines meet.
SlideRoom slideRoom(const ResultMesh& result, const BoundaryCurves& curves, int v);

/// Unit direction in which the arc of a vertex with room to slide grows: of the chord over a
/// quarter of the way to its neighbours.
Vec3f slideDirection(const BoundaryCurves& curves, const ResultVertex& vertex,
					 const SlideRoom& room);

/// Whether after a slide of v by `step` the two chords at it leave the curve no further than
/// spacing may (CurveSpacing), or than they do now.
bool slideKeepsToCurve(const ResultMesh& result, const BoundaryCurves& curves, int v,
					   const SlideRoom& room, float step);

/// Whether the one edge between its neighbours on the curve would stay as close to the curve as the
/// two edges of v do, or as is aimed at; false for vertices that must stay.
bool mayLeaveCurve(const ResultMesh& result, const BoundaryCurves& curves, int v);

/// Whether after a slide of v by `step` its neighbours on the curve lie between 0.7 and 1.3 wanted
/// edges away along it, or at least within what they do now: slide after slide must not crowd
/// vertices here and leave long edges there.
bool slideKeepsSpacing(const ResultMesh& result, const BoundaryCurves& curves, int v,
					   const SlideRoom& room, float step);

/// The record of a vertex, moved by `step` along its curve.
ResultVertex slid(const Surface& surface, const BoundaryCurves& curves, const ResultVertex& vertex,
				  float step);

} // namespace gpr

#endif
