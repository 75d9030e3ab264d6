// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_FEATURES_CURVE_SLIDE_H
#define VCG_EXTRAS_CORE_FEATURES_CURVE_SLIDE_H

#include "boundary_curves.h"

#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/surface/result_mesh.h>

namespace gpr {

/// How far a vertex may slide along its curve: arc lengths to its two neighbours on the curve. Zero
/// towards a neighbour that is not on the curve.
struct SlideRoom {
	float backward = 0;
	float forward  = 0;
	int   last     = -1; ///< the neighbour behind
	int   next     = -1; ///< the neighbour ahead

	/// Whether there is room both ways.
	bool isOpen() const { return backward > 0 && forward > 0; }
};

/// The room of v. None without a curve, for pinned or shared vertices, and at nodes and corners of
/// feature lines. A corner of a border has room.
SlideRoom slideRoom(const ResultMesh& result, const BoundaryCurves& curves, int v);

/// Unit direction in which the arc grows at a vertex with room to slide: the direction of the chord
/// over a quarter of the room on either side.
Vec3f slideDirection(const BoundaryCurves& curves, const ResultVertex& vertex,
					 const SlideRoom& room);

/// Whether a slide of v by the arc length `step` (below 0: backward) keeps both chords at v within
/// curveTolerance from the curve, or no farther than now.
bool slideKeepsToCurve(const ResultMesh& result, const BoundaryCurves& curves, int v,
					   const SlideRoom& room, float step);

/// Whether v may leave its curve: the edge between its neighbours on the curve is as close to the
/// curve as the two edges at v, or within this tolerance. False without open room.
bool mayLeaveCurve(const ResultMesh& result, const BoundaryCurves& curves, int v);

/// Whether both arcs at v, after a slide by `step`, are 0.7 to 1.3 times the wanted edge length, or
/// within the range of both arcs now. So repeated slides cannot crowd vertices at one place and
/// leave long edges at another.
bool slideKeepsSpacing(const ResultMesh& result, const BoundaryCurves& curves, int v,
					   const SlideRoom& room, float step);

/// The record of a vertex after a slide by `step` along its curve.
ResultVertex slid(const Surface& surface, const BoundaryCurves& curves, const ResultVertex& vertex,
				  float step);

/// Normal agreement of the face of half-edge h on a feature line: the cosine of the angle to the
/// face of the working surface on the same side of the line, halfway between the ends of h. 1 if h
/// is on no feature line, or if neither end can slide along a line.
float creaseAgreement(const Surface& surface, const BoundaryCurves& curves,
					  const ResultMesh& result, int h);

} // namespace gpr

#endif
