// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "goal_refinement.h"

#include "local_refinement.h"

#include <vcg_extras/core/base/angle.h>
#include <vcg_extras/core/base/box.h>
#include <vcg_extras/core/surface/certified_distance.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace gpr {

namespace {

/// Share of the goal as limit of the search: if no point is beyond the limit, the proof keeps the
/// goal.
constexpr double provable = 0.97;
/// The largest share of new vertices in a round. A larger share means that triangles are too large
/// everywhere.
constexpr double mostAdded = 0.15;
/// Each round halves triangles that are still too large. Six rounds suffice, except at thin spikes.
constexpr int mostRounds = 12;
/// Rounds in a row that may leave no fewer points than an earlier round.
constexpr int mostLostRounds = 2;
/// Passes over the faces beyond the goal, before the first round.
constexpr int facePasses = 2;
/// Smaller angles beside new vertices are raised. Moves to far points may leave smaller angles,
/// because vertices among small angles could not move otherwise.
constexpr float raisedAngle = 30 * radians, keptAngle = 20 * radians;

void append(const std::vector<FarPlace>& places, bool areOfSurface, std::vector<FarPoint>& points)
{
	for (const FarPlace& p : places)
		points.push_back({Vec3f(p.position), float(p.distance), areOfSurface});
}

/// Finds the points of surface and result with a distance above a limit.
class FarPointSearch {
public:
	FarPointSearch(const Surface& surface, double limit, Workers& workers) :
			input_(viewOf(surface.mesh), workers), limit_(limit), workers_(workers)
	{
	}

	/// Searches near the points found before, if these were few, then everywhere if no point is
	/// left there.
	std::vector<FarPoint> next(const ResultMesh& result, const std::vector<FarPoint>& before) const
	{
		std::vector<FarPoint> points;
		if (!before.empty() && before.size() <= fewPoints)
			points = find(result, regionsRound(before, reachInEdges * result.idealEdge));
		return points.empty() ? find(result, {}) : points;
	}

private:
	/// With more points, the test for near triangles takes as long as a full search.
	static constexpr std::size_t fewPoints = 64;
	/// Changes at a point stay within this distance of the point.
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

} // namespace

bool refineToGoal(const Surface& surface, const BoundaryCurves& curves, double goal,
				  ResultMesh& result, Workers& workers)
{
	const double          limit = provable * goal;
	const FarPointSearch  search(surface, limit, workers);
	std::vector<FarPoint> points;
	std::size_t           before = std::numeric_limits<std::size_t>::max(), fewestLeft = before;
	int                   lostRounds = 0;
	lowerWorstDistances(surface, ClosestFaceMap(surface, result, workers), raisedAngle, facePasses,
						result, workers, float(limit));
	for (int round = 0; round < mostRounds; ++round) {
		points = search.next(result, points);
		if (points.empty() || points.size() > std::size_t(result.mesh.vertexNum)) break;
		std::vector<FarPoint> left =
			drawToPoints(points, surface, ClosestFaceMap(surface, result, workers), keptAngle,
						 float(limit), result, workers);
		// Points that come back after each round need new vertices.
		const bool hasFallen = points.size() < before;
		before               = points.size();
		if (left.empty() && hasFallen) continue;
		if (left.empty()) left = points;
		lostRounds = left.size() < fewestLeft ? 0 : lostRounds + 1;
		fewestLeft = std::min(fewestLeft, left.size());
		if (lostRounds == mostLostRounds) break;
		const LocalRefinement settings = {raisedAngle, float(limit),
										  int(mostAdded * result.mesh.vertexNum)};
		if (refineAt(surface, curves, left, settings, result, workers) == 0) break;
	}
	return points.empty();
}

} // namespace gpr
