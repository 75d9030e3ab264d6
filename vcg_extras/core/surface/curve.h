// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_SURFACE_CURVE_H
#define VCG_EXTRAS_CORE_SURFACE_CURVE_H

#include <vcg_extras/core/vec.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace gpr {

/// A polyline on the surface, by arc length: a loop of the border or a feature line.
struct Curve {
	std::vector<int>   vertex;   ///< vertices of the surface, in order
	std::vector<Vec3f> point;    ///< positions of the vertices
	std::vector<int>   halfEdge; ///< half-edge of the surface from point i to the next
	std::vector<float> arc;      ///< arc length at point i
	std::vector<float> size;     ///< wanted size at point i over the largest; empty: 1 everywhere
	float              length   = 0;
	bool               isClosed = true; ///< the last point is followed by the first

	int pointNum() const { return int(point.size()); }
	/// Arc length within the curve: once round if closed, else the nearer end.
	float wrap(float s) const;
	/// Arc length between two arcs, the shorter way round if closed.
	float arcDistance(float a, float b) const
	{
		const float d = std::abs(a - b);
		return isClosed ? std::min(d, length - d) : d;
	}
	/// The segment that holds arc length s, after wrapping.
	int   segmentAt(float s) const;
	int   faceAt(float s) const { return halfEdge[segmentAt(s)] / 3; }
	Vec3f at(float s) const;
	float sizeAt(float s) const;
	float smallestSize() const;
	/// Arc length of point i; i may run on past the end of a closed curve, once round.
	float arcOf(int i) const { return arc[i % pointNum()] + (i >= pointNum() ? length : 0.0f); }
	/// Arc length of the segment from point i to the next.
	float lengthOf(int i) const { return arcOf(i + 1) - arc[i]; }
};

/// Largest distance of a curve from the polygon of its samples, as a share of the wanted chord.
constexpr float curveTolerance = 0.08f;

/// Arc lengths of samples strictly between `from` and `to` (to may run past the curve's end).
/// chord: the wanted straight distance of neighbours for size 1. The samples lie evenly by chords
/// if the curve then stays within curveTolerance of the polygon.
/// Otherwise dynamic programming over candidates a tenth of the chord apart finds the samples of
/// least cost: the squared deviation of each chord from its wanted length, plus sixteen times the
/// squared excess over the tolerance. At least minSteps steps are made. Cost: linear in length, ×
/// candidates per chord².
std::vector<float> spaceOut(const Curve& curve, float from, float to, float chord, int minSteps);

/// Calls visit(point, arc) for the curve's points strictly between arcs a and b. Both arcs may run
/// past the end of a closed curve; the visited arcs then do so too.
template <class Visit>
inline void forEachPointBetween(const Curve& c, float a, float b, const Visit& visit)
{
	const int lap = a >= c.length ? c.pointNum() : 0;
	const int end = (c.isClosed ? 3 : 1) * c.pointNum(); // rounding puts b beyond an open curve
	for (int i = c.segmentAt(a) + 1 + lap; i < end; ++i) {
		const int   round = i / c.pointNum();
		const float s     = c.arc[i % c.pointNum()] + float(round) * c.length;
		if (s >= b) break;
		visit(c.point[i % c.pointNum()], s);
	}
}

/// Largest distance of the curve's points between arcs a and b from the chord between them.
float deviation(const Curve& curve, float a, float b);

} // namespace gpr

#endif
