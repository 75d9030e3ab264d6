// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "goal_refinement.h"

#include "local_refinement.h"

#include <vcg_extras/core/base/box.h>
#include <vcg_extras/core/base/sort_unique.h>
#include <vcg_extras/core/edit/patch_distance.h>
#include <vcg_extras/core/surface/certified_distance.h>
#include <vcg_extras/core/surface/nearest_on_mesh.h>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace gpr {

namespace {

/// Share of the goal as limit of the search, which leaves out some places close to the limit. With
/// .97 results have 4 % more vertices on the mean, with .99 more meshes miss the goal.
constexpr double limitShare = 0.985;
/// The largest share of new vertices in a round. A larger share means that triangles are too large
/// everywhere.
constexpr double mostAdded = 0.15;
/// Each round halves triangles that are still too large. Six rounds suffice, except at thin spikes.
constexpr int mostRounds = 12;
/// A round is lost if it leaves more than this share of the points of an earlier round. The
/// refinement ends after mostLostRounds lost rounds in a row.
constexpr double mostLeft       = 0.9;
constexpr int    mostLostRounds = 2;
/// With more points left for each vertex, a later refinement would not help either: contacts or the
/// topology forbid new vertices there. With .1 a useful refinement is left out, and a part gets a
/// tenth more vertices.
constexpr double mostLost = 0.25;
/// The most points for each vertex that count as single places.
constexpr double mostSingle = 0.05;
/// The most far points for each vertex of the result. With more points all triangles are too large,
/// and the refinement ends. With a limit of one, some results get twice the vertices in twice the
/// time, because a new mesh is made. Without a limit, some parts take three times as long.
constexpr std::size_t mostPerVertex = 16;
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

/// Whether too many points are left for any later refinement.
bool isHopeless(std::size_t leftNum, const ResultMesh& result)
{
	return double(leftNum) > mostLost * result.mesh.vertexNum;
}

/// Per vertex of the surface: the face of the result on the same sheet that is nearest; or -1.
std::vector<int> nearestFaces(const Surface& surface, const ResultMesh& result, Workers& workers)
{
	const ClosestFaceMap map(surface, result, workers);
	std::vector<int>     face(std::size_t(surface.mesh.vertexNum), -1);
	for (int f = 0; f < result.mesh.faceNum; ++f) {
		for (const int* v = map.begin(f); v < map.end(f); ++v)
			face[*v] = f;
	}
	return face;
}

/// The faces at points; ascending. None if the points are more than single places.
std::vector<int> singlePlaces(const Surface& surface, const std::vector<FarPoint>& points,
							  const ResultMesh& result, Workers& workers)
{
	std::vector<int> faces;
	if (double(points.size()) > mostSingle * result.mesh.vertexNum) return faces;
	const NearestOnMesh    ofResult(result.mesh, workers), ofSurface(surface.mesh, workers);
	const std::vector<int> nearest = nearestFaces(surface, result, workers);
	for (const FarPoint& p : points) {
		const int corner = surface.mesh.origin[3 * ofSurface.nearest(p.position).face];
		// Another sheet may be nearer than the sheet of a point of the surface.
		const bool isKnown = p.isOfSurface && nearest[corner] >= 0;
		faces.push_back(isKnown ? nearest[corner] : ofResult.nearest(p.position).face);
	}
	sortUnique(faces);
	return faces;
}

/// Finds the points of surface and result with a distance above a limit, round by round.
class FarPointSearch {
public:
	FarPointSearch(const Surface& surface, double limit, Workers& workers) :
			input_(viewOf(surface.mesh), workers), limit_(limit), workers_(workers)
	{
	}

	/// The first search finds all points. Later searches look only at the points found before and
	/// near the faces that changed since: all other triangles keep their distances.
	const std::vector<FarPoint>& next(const ResultMesh& result)
	{
		const MeasuredSurface          made(viewOf(result.mesh), input_, workers_);
		const std::vector<int>         faces   = numbersBelow(std::size_t(result.mesh.faceNum));
		const std::vector<Box<double>> regions = regionsToSearch(trianglesOf(result.mesh, faces));
		points_.clear();
		append(placesBeyond(input_, made, limit_, workers_, regions), true, points_);
		append(placesBeyond(made, input_, limit_, workers_, regions), false, points_);
		return points_;
	}

private:
	MeasuredSurface       input_;
	double                limit_;
	Workers&              workers_;
	std::vector<FarPoint> points_; ///< found by the last search
	Triangles             last_;   ///< faces of the result in the last search

	/// Empty in the first search: everywhere.
	std::vector<Box<double>> regionsToSearch(Triangles now)
	{
		std::vector<Box<double>> regions;
		const Triangles          before = std::exchange(last_, std::move(now));
		if (before.empty()) return regions;
		for (const FarPoint& p : points_)
			regions.emplace_back(Vec3d(p.position), Vec3d(p.position));
		for (std::size_t f = 0; f < std::max(last_.size(), before.size()); ++f) {
			if (f < last_.size() && f < before.size() && last_[f] == before[f]) continue;
			for (const Triangles* faces : {&before, &std::as_const(last_)}) {
				if (f < faces->size()) regions.push_back(roundFace((*faces)[f]));
			}
		}
		return regions;
	}

	/// A region with all points within the limit of a face.
	Box<double> roundFace(const std::array<Vec3f, 3>& face) const
	{
		const Vec3d      reach(limit_, limit_, limit_);
		const Box<float> box = Box<float>::ofPoints(face);
		return {Vec3d(box.low) - reach, Vec3d(box.high) + reach};
	}
};

} // namespace

GoalRefinement refineToGoal(const Surface& surface, const BoundaryCurves& curves, double goal,
							ResultMesh& result, Workers& workers)
{
	const double          limit = limitShare * goal;
	FarPointSearch        search(surface, limit, workers);
	std::size_t           before = std::numeric_limits<std::size_t>::max(), fewestLeft = before;
	int                   lostRounds = 0;
	std::vector<FarPoint> left;
	lowerWorstDistances(surface, ClosestFaceMap(surface, result, workers), raisedAngle, facePasses,
						result, workers, float(limit));
	for (int round = 0; round < mostRounds; ++round) {
		const std::vector<FarPoint>& points = search.next(result);
		if (points.size() > mostPerVertex * std::size_t(result.mesh.vertexNum))
			return {GoalOutcome::OutOfReach, {}};
		if (points.empty()) return {GoalOutcome::Kept, {}};
		left = drawToPoints(points, surface, ClosestFaceMap(surface, result, workers), keptAngle,
							float(limit), result, workers);
		// Points that come back after each round need new vertices.
		const bool hasFallen = points.size() < before;
		before               = points.size();
		if (left.empty() && hasFallen) continue;
		if (left.empty()) left = points;
		lostRounds = double(left.size()) < mostLeft * double(fewestLeft) ? 0 : lostRounds + 1;
		fewestLeft = std::min(fewestLeft, left.size());
		if (lostRounds == mostLostRounds) {
			if (isHopeless(left.size(), result)) return {GoalOutcome::OutOfReach, {}};
			break;
		}
		const LocalRefinement settings = {raisedAngle, float(limit),
										  int(mostAdded * result.mesh.vertexNum)};
		if (refineAt(surface, curves, left, settings, result, workers) == 0) break;
	}
	return {GoalOutcome::Open, singlePlaces(surface, left, result, workers)};
}

} // namespace gpr
