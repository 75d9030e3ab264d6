// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "goal_refinement.h"

#include "face_goals.h"

#include <vcg_extras/core/base/box.h>
#include <vcg_extras/core/base/sort_unique.h>
#include <vcg_extras/core/base/triangle.h>
#include <vcg_extras/core/edit/constraint.h>
#include <vcg_extras/core/edit/local_search.h>
#include <vcg_extras/core/surface/certified_distance.h>
#include <vcg_extras/core/surface/local_nearest.h>
#include <vcg_extras/core/surface/nearest_on_mesh.h>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>
#include <vector>

namespace gpr {

namespace {

/// Share of the goal as limit of the search, which leaves out some places close to the limit. With
/// .97 results have 4 % more vertices on the mean, with .99 more meshes miss the goal.
constexpr double limitShare = 0.985;
/// The largest share of faces split in a round. A larger share means that triangles are too large
/// everywhere.
constexpr double mostSplit = 0.1;
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

/// A point lies beside an edge if the barycentric weight of the opposite corner is smaller.
constexpr float besideEdge = 0.15f;
/// A walk has reached a far point of the surface if the rest is at most this share of the distance.
/// For a far point of the result, the walk must end at most this factor of the distance from the
/// point.
constexpr float reachedShare = 0.2f, foundShare = 1.01f;
/// A split must bring its far point to at most this share of the distance.
constexpr float settledShare = 0.6f;
/// The share of the height over the surface that vertices keep. The fit leaves vertices off the
/// surface, with triangles on both sides; smaller triangles need smaller heights. Shares of 0.5 and
/// 1 take twice the rounds.
constexpr float heightKept = 0.7f;
/// Share of the allowed distance. Vertices of the input beyond the share get no farther while
/// angles are raised.
constexpr float guardedShare = 0.7f;
/// Rounds against the largest distances.
constexpr int worstRounds = 2;

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

/// The edge of f to split for a point: a feature or border edge if the point lies beside such an
/// edge, else the longest edge.
int edgeToSplit(const HalfEdgeMesh& m, int f, const Vec3f& point)
{
	const auto [a, b, c]              = m.corners(f);
	const std::array<float, 3> weight = weightsAt(point, a, b, c);
	for (int k = 0; k < 3; ++k) {
		const float ofCornerBeyond = weight[std::size_t(k + 2) % 3];
		if (m.isCurveEdge(3 * f + k) && ofCornerBeyond < besideEdge) return 3 * f + k;
	}
	return std::max({3 * f, 3 * f + 1, 3 * f + 2}, [&](int g, int h) {
		return squaredLength(m.edgeVector(g)) < squaredLength(m.edgeVector(h));
	});
}

/// Splits edges at far points by the trials of a local search.
class Refinement {
public:
	Refinement(const Surface& surface, const BoundaryCurves& curves,
			   const std::vector<FarPoint>& points, std::int64_t& work, int mostNew,
			   ResultMesh& result, Workers& workers) :
			search_(surface, curves, nullptr, work, result, workers, mostNew),
			editor_(search_.editor()), m_(result.mesh), oldVertexNum_(m_.vertexNum),
			farthest_(std::size_t(m_.faceNum))
	{
		const NearestOnMesh tree(m_, workers);
		std::vector<int>    face(points.size());
		workers.forEach(points.size(),
						[&](int i) { face[i] = tree.nearest(points[i].position).face; });
		for (std::size_t i = 0; i < points.size(); ++i) {
			FarPoint& farthest = farthest_[face[i]];
			faceNum_ += farthest.distance == 0;
			if (points[i].distance > farthest.distance) farthest = points[i];
		}
	}

	/// The number of faces with points.
	int faceNum() const { return faceNum_; }

	/// Splits an edge of each face with a point. An edge of a curve may admit no vertex, because
	/// the samples of the curve would be too close to each other; then the other edges are tried.
	void run()
	{
		Goal goal = splitFaces([this](int f) { return isOpen(f); });
		for (bool isAnyEdge : {false, true}) {
			for (bool isAtPoint : {true, false}) {
				goal.make = [=](const Operation& op) {
					return makeSplit(op, isAnyEdge, isAtPoint);
				};
				search_.run(goal);
			}
		}
	}

private:
	LocalSearch           search_;
	PatchEditor&          editor_;
	const HalfEdgeMesh&   m_;
	const int             oldVertexNum_;
	std::vector<FarPoint> farthest_; ///< per face; without a distance if the face has no point
	int                   faceNum_ = 0;

	/// Whether f has a point, and no edge of f was split yet.
	bool isOpen(int f) const
	{
		const auto isOld = [&](int v) { return v < oldVertexNum_; };
		return f < int(farthest_.size()) && farthest_[f].distance > 0 &&
			   std::all_of(&m_.origin[3 * f], &m_.origin[3 * f] + 3, isOld);
	}

	/// Splits an edge, and moves the new vertex to the point of the face, or leaves the vertex in
	/// the middle of the edge. False if the point would stay far.
	bool makeSplit(const Operation& op, bool isAnyEdge, bool isAtPoint)
	{
		const int       f     = op.halfEdge / 3;
		const FarPoint& point = farthest_[f];
		if (!isAnyEdge && op.halfEdge != edgeToSplit(m_, f, point.position)) return false;
		if (!editor_.make(op)) return false;
		const int v = m_.vertexNum - 1;
		if (isAtPoint && !moveTo(point, v)) return false;
		const std::vector<int> faces = facesRound(m_, {v});
		for (int w : verticesOf(m_, faces))
			lower(w);
		return settles(point, faces);
	}

	/// Whether a far point of the surface comes much closer. Repeated halves of an edge beside a
	/// point that stays far would only crowd vertices. A far point of the result is gone.
	bool settles(const FarPoint& point, const std::vector<int>& faces) const
	{
		if (!point.isOfSurface) return true;
		const float wanted = settledShare * point.distance;
		return std::any_of(faces.begin(), faces.end(), [&](int f) {
			const auto [a, b, c] = m_.corners(f);
			const Vec3f at       = nearestOnTriangle(point.position, a, b, c);
			return squaredLength(at - point.position) <= wanted * wanted;
		});
	}

	bool isFree(int v) const { return constraintOf(editor_.result(), v) == Constraint::Free; }

	/// Moves v to the far point of the surface, or to the surface point nearest to a far point of
	/// the result. False if no walk reaches the point, or if angles would be too small.
	bool moveTo(const FarPoint& point, int v)
	{
		if (!isFree(v)) return false;
		const HalfEdgeMesh&      s     = editor_.surface().mesh;
		PatchEditor::VertexState there = editor_.stateOf(v);
		SurfacePoint&            at    = there.record.point;
		at.position                    = nearestOnTheWay(s, point.position, 0, at.face);
		const float most = (point.isOfSurface ? reachedShare : foundShare) * point.distance;
		if (length(at.position - point.position) > most) return false;
		there.position      = at.position;
		there.record.normal = s.faceNormal(at.face);
		editor_.put(v, there);
		return true;
	}

	/// Moves v towards the surface.
	void lower(int v)
	{
		if (!isFree(v)) return;
		PatchEditor::VertexState state = editor_.stateOf(v);
		const Vec3f&             below = state.record.point.position;
		state.position                 = below + (state.position - below) * heightKept;
		editor_.put(v, state);
	}
};

} // namespace

int refineAt(const Surface& surface, const BoundaryCurves& curves,
			 const std::vector<FarPoint>& points, float maxGap, int mostNew, ResultMesh& result,
			 Workers& workers, std::int64_t work)
{
	const int  before = result.mesh.vertexNum;
	Refinement refinement(surface, curves, points, work, mostNew, result, workers);
	if (refinement.faceNum() > mostNew) return 0;
	refinement.run();

	const ClosestFaceMap map(surface, result, workers);
	Assignment           assignment(surface, map, numbersBelow(std::size_t(result.mesh.faceNum)));
	std::int64_t         workOfAngles = workOf(Driver::PoorFaces, result.mesh.faceNum);
	LocalSearch          search(surface, curves, &assignment, workOfAngles, result, workers);
	Goal                 goal = smallAngles(search, raisedAngle);
	goal.limits.guarded       = guardedShare * maxGap;
	goal.limits.gap           = maxGap;
	search.run(goal);
	lowerWorstDistances(surface, map, raisedAngle, worstRounds, result, workers, maxGap);
	return result.mesh.vertexNum - before;
}

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
		const int mostNew = int(mostSplit * result.mesh.faceNum);
		if (lostRounds == mostLostRounds ||
			refineAt(surface, curves, left, float(limit), mostNew, result, workers) == 0) {
			if (isHopeless(left.size(), result)) return {GoalOutcome::OutOfReach, {}};
			break;
		}
	}
	return {GoalOutcome::Open, singlePlaces(surface, left, result, workers)};
}

} // namespace gpr
