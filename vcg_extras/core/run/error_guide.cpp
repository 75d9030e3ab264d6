// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "error_guide.h"

#include <vcg_extras/core/mesh/face_quality.h>
#include <vcg_extras/core/optimization/local_refinement.h>
#include <vcg_extras/core/sampling/sizing.h>
#include <vcg_extras/core/surface/certified_distance.h>

#include <algorithm>
#include <cmath>
#include <limits>

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

/// Of the goal: what no point was found to be beyond is proven to keep to the goal.
constexpr double provable = 0.97;
/// Where a round would have more new vertices, over those that are there, triangles are too large
/// on the whole.
constexpr double mostAdded = 0.08;
/// Each round halves triangles that are still too large. Half a dozen are enough but at thin
/// spikes.
constexpr int mostRounds = 12;
/// Smaller angles are raised beside new vertices; at spikes that takes back what is gained.
constexpr float angleAtFirst = 30, angleLater = 15;
constexpr int   roundsForAngles = 4;

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

void append(const std::vector<FarPlace>& places, bool areOfSurface, std::vector<FarPoint>& points)
{
	for (const FarPlace& p : places)
		points.push_back({Vec3f(p.position), float(p.distance), areOfSurface});
}

/// Looks for points where the surface and a result are farther from each other than a limit.
class FarPointSearch {
public:
	FarPointSearch(const Surface& surface, double limit, Workers& workers) :
			input_(viewOf(surface.mesh), workers), limit_(limit), workers_(workers)
	{
	}

	/// Near those that were there before, if they were few; everywhere where none are left there.
	std::vector<FarPoint> next(const ResultMesh& result, const std::vector<FarPoint>& before) const
	{
		std::vector<FarPoint> points;
		if (!before.empty() && before.size() <= fewPoints)
			points = find(result, regionsRound(before, reachInEdges * result.idealEdge));
		return points.empty() ? find(result, {}) : points;
	}

private:
	/// With more of them it takes as long to tell whether a triangle is near some.
	static constexpr std::size_t fewPoints = 64;
	/// What changes with a point is within this of it.
	static constexpr float reachInEdges = 4;

	MeasuredSurface input_;
	double          limit_;
	Workers&        workers_;

	static std::vector<Box<double>> regionsRound(const std::vector<FarPoint>& points, float reach)
	{
		const Vec3d              corner(reach, reach, reach);
		std::vector<Box<double>> regions;
		for (const FarPoint& p : points) {
			const Vec3d at(p.position);
			regions.push_back({at - corner, at + corner});
		}
		return regions;
	}

	std::vector<FarPoint> find(const ResultMesh&               result,
							   const std::vector<Box<double>>& regions) const
	{
		const MeasuredSurface made(viewOf(result.mesh), input_, workers_);
		std::vector<FarPoint> points;
		append(placesBeyond(input_, made, limit_, workers_, regions), true, points);
		append(placesBeyond(made, input_, limit_, workers_, regions), false, points);
		return points;
	}
};

/// Whether rounds still get anywhere: the number of points falls.
class Progress {
public:
	bool goesOn(std::size_t pointNum)
	{
		if (pointNum < fewest_) {
			fewest_ = pointNum;
			lost_   = 0;
		}
		else
			++lost_;
		return pointNum > 0 && lost_ < mostLostRounds;
	}

private:
	static constexpr int mostLostRounds = 2;

	std::size_t fewest_ = std::numeric_limits<std::size_t>::max();
	int         lost_   = 0; ///< rounds since it fell
};

} // namespace

int refineToGoal(RunContext& run, const Surface& surface, const BoundaryCurves& curves,
				 ResultMesh& result)
{
	run.clock.enter(Stage::Fit);
	const double          limit = provable * run.guide->goal * surface.frame.scale;
	const FarPointSearch  search(surface, limit, run.workers);
	Progress              progress;
	std::vector<FarPoint> points;
	int                   added = 0;
	for (int round = 0; round < mostRounds; ++round) {
		points = search.next(result, points);
		if (!progress.goesOn(points.size())) break;
		LocalRefinement settings;
		settings.minAngle = (round < roundsForAngles ? angleAtFirst : angleLater) * radians;
		settings.maxGap   = float(limit);
		settings.mostNew  = int(mostAdded * result.mesh.vertexNum);
		const int more    = refineAt(surface, curves, points, settings, result, run.workers);
		if (more == 0) break;
		added += more;
	}
	return added;
}

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
