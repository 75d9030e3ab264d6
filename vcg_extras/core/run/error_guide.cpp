// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "error_guide.h"

#include <vcg_extras/core/mesh/face_quality.h>
#include <vcg_extras/core/sampling/sizing.h>
#include <vcg_extras/core/surface/certified_distance.h>

#include <algorithm>
#include <cmath>

namespace gpr {

namespace {

/// How much is done about the places that are too far.
struct Effort {
	double reachInEdges; ///< triangles are made smaller so far round a place, in their own edges
	/// Over the size that would do if the error went with the size, as on creases and rims: samples
	/// fall elsewhere in every trial.
	double caution;
	double nearGoal; ///< nearer to the goal than this, a place may be beyond it in the next trial
};

/// There are many places after the first trial, and fewer after the second. Those after later ones
/// shall be the last. Samples fall elsewhere in each trial, so that places near the goal get
/// smaller triangles, too.
constexpr Effort first = {1.2, 0.75, 0.9}, second = {1.5, 0.6, 0.8}, later = {1.5, 0.5, 0.65};
constexpr double leastOfTrial = 0.3, mostOfTrial = 0.8;

const Effort& effortAfter(std::size_t missedNum)
{
	if (missedNum == 0) return first;
	return missedNum == 1 ? second : later;
}

FineSpot spotAt(const FarPlace& place, const Effort& effort, double goal, double edge,
				const Surface& surface)
{
	FineSpot spot;
	spot.position = surface.frame.toCaller(Vec3f(place.position));
	spot.reach    = (effort.reachInEdges * edge + place.distance) / surface.frame.scale;
	spot.factor   = std::clamp(effort.caution * goal / place.distance, leastOfTrial, mostOfTrial);
	return spot;
}

double areaOf(const std::vector<FarPlace>& places, double goal)
{
	double area = 0;
	for (const FarPlace& p : places)
		if (p.distance > goal) area += p.area;
	return area;
}

/// What smaller triangles at the spots multiply the number of triangles by.
double growthBy(const FineSpots& spots, const Surface& surface, Workers& workers)
{
	return meanSquaredStretch(surface.mesh, factorsOf(spots, surface, workers), workers);
}

} // namespace

void findPlacesBeyond(RunContext& run, const Surface& surface, const ComparedSurfaces& both,
					  float idealEdge)
{
	ErrorGuide&   guide    = *run.guide;
	const double  goal     = guide.goal * surface.frame.scale;
	const Effort& effort   = effortAfter(guide.spots.size());
	const double  limit    = effort.nearGoal * goal;
	const auto    ofInput  = placesBeyond(both.input, both.result, limit, run.workers);
	const auto    ofResult = placesBeyond(both.result, both.input, limit, run.workers);
	const double  total    = surfaceArea(surface.mesh, run.workers);
	guide.share            = std::min(1.0, areaOf(ofInput, goal) / std::max(total, 1e-300));
	guide.found.clear();
	for (const std::vector<FarPlace>* places : {&ofInput, &ofResult})
		for (const FarPlace& p : *places)
			guide.found.push_back(spotAt(p, effort, goal, double(idealEdge), surface));
	FineSpots all = guide.spots;
	all.push_back(guide.found);
	guide.growth =
		growthBy(all, surface, run.workers) / growthBy(guide.spots, surface, run.workers);
}

} // namespace gpr
