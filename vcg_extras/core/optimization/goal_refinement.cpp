// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "goal_refinement.h"

#include "local_refinement.h"

#include <vcg_extras/core/base/angle.h>
#include <vcg_extras/core/base/box.h>
#include <vcg_extras/core/surface/certified_distance.h>

#include <limits>
#include <vector>

namespace gpr {

namespace {

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
class FallingNumber {
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

Refined refineToGoal(const Surface& surface, const BoundaryCurves& curves, double goal,
					 ResultMesh& result, Workers& workers)
{
	const double          limit = provable * goal;
	const FarPointSearch  search(surface, limit, workers);
	FallingNumber         pointNum;
	std::vector<FarPoint> points;
	Refined               refined;
	for (int round = 0; round < mostRounds; ++round) {
		points            = search.next(result, points);
		refined.keepsGoal = points.empty();
		if (!pointNum.goesOn(points.size())) break;
		LocalRefinement settings;
		settings.minAngle = (round < roundsForAngles ? angleAtFirst : angleLater) * radians;
		settings.maxGap   = float(limit);
		settings.mostNew  = int(mostAdded * result.mesh.vertexNum);
		const int more    = refineAt(surface, curves, points, settings, result, workers);
		if (more == 0) break;
		refined.addedNum += more;
	}
	return refined;
}

} // namespace gpr
