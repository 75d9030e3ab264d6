// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "local_refinement.h"

#include "face_goals.h"

#include <vcg_extras/core/base/sort_unique.h>
#include <vcg_extras/core/base/triangle.h>
#include <vcg_extras/core/edit/constraint.h>
#include <vcg_extras/core/edit/local_search.h>
#include <vcg_extras/core/mesh/face_contact.h>
#include <vcg_extras/core/mesh/face_quality.h>
#include <vcg_extras/core/surface/local_nearest.h>
#include <vcg_extras/core/surface/nearest_on_mesh.h>

#include <algorithm>
#include <array>
#include <utility>

namespace gpr {

namespace {

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

/// An edge as its ends, the smaller one first, because splits renumber half-edges.
using Edge = std::pair<int, int>;

struct Split {
	Edge     edge;
	FarPoint point; ///< the farthest point for the edge
};

int longestEdgeOf(const HalfEdgeMesh& m, int f)
{
	int   longest = 3 * f;
	float squared = 0;
	for (int h = 3 * f; h < 3 * f + 3; ++h) {
		const float own = squaredLength(m.edgeVector(h));
		if (own <= squared) continue;
		squared = own;
		longest = h;
	}
	return longest;
}

int edgeToSplit(const HalfEdgeMesh& m, const SurfacePoint& at)
{
	const int                  h      = 3 * at.face;
	const auto                 corner = [&](int k) { return m.position[m.origin[h + k]]; };
	const std::array<float, 3> weight = weightsAt(at.position, corner(0), corner(1), corner(2));
	for (int k = 0; k < 3; ++k) {
		const float ofCornerBeyond = weight[std::size_t(k + 2) % 3];
		if (m.isCurveEdge(h + k) && ofCornerBeyond < besideEdge) return h + k;
	}
	return longestEdgeOf(m, at.face);
}

/// The edges to split, each edge once, in the order of the ends.
std::vector<Split> splitsFor(const HalfEdgeMesh& m, const std::vector<FarPoint>& points,
							 Workers& workers)
{
	const NearestOnMesh tree(m, workers);
	std::vector<Split>  splits(points.size());
	workers.forEach(points.size(), [&](int i) {
		const FarPoint& point = points[i];
		const int       h     = edgeToSplit(m, tree.nearest(point.position));
		splits[i]             = {std::minmax(int(m.origin[h]), m.target(h)), point};
	});
	std::stable_sort(splits.begin(), splits.end(), [](const Split& a, const Split& b) {
		if (a.edge != b.edge) return a.edge < b.edge;
		return a.point.distance > b.point.distance;
	});
	const auto isSame = [](const Split& a, const Split& b) { return a.edge == b.edge; };
	splits.erase(std::unique(splits.begin(), splits.end(), isSame), splits.end());
	return splits;
}

class Refinement {
public:
	Refinement(const Surface& surface, const BoundaryCurves& curves, ResultMesh& result,
			   Workers& workers, int mostNew) :
			editor_(surface, curves, result, workers, mostNew),
			m_(result.mesh), space_(result.mesh, workers)
	{
	}

	/// The work of the tests for contacts, in faces and pairs of faces.
	std::int64_t work() const { return work_; }

	void split(const Split& wanted)
	{
		for (const Edge& edge : edgesToTry(wanted.edge)) {
			for (const Place place : {Place::AtPoint, Place::OnSurface, Place::OnEdge}) {
				if (trySplit(edge, place, wanted.point)) return;
			}
		}
	}

private:
	PatchEditor         editor_;
	const HalfEdgeMesh& m_;
	/// A split keeps these limits, or the smallest angle there was before.
	const Acceptance limits_ = acceptanceOf(Driver::Refinement);
	FacesInSpace     space_;
	std::int64_t     work_ = 0;

	/// The place of a new vertex. A place on the edge is always sound; later rounds move the
	/// vertex.
	enum class Place { AtPoint, OnSurface, OnEdge };

	/// The faults that a split must not add.
	struct Faults {
		int   invertedNum = 0, pairNum = 0;
		float angle = HUGE_VALF; ///< smallest angle

		bool exceed(const Faults& before, float limit) const
		{
			return invertedNum > before.invertedNum || pairNum > before.pairNum ||
				   angle < std::min(before.angle, limit);
		}
	};

	/// An edge, then the other edges of its faces, for an edge of a curve that admits no vertex
	/// because the samples of the curve would be too close to each other.
	std::vector<Edge> edgesToTry(const Edge& edge) const
	{
		std::vector<Edge> edges = {edge};
		const int         h     = m_.findEdge(edge.first, edge.second);
		if (h < 0) return edges;
		for (int side : {h, int(m_.opposite[h])}) {
			if (side < 0) continue;
			for (int other : {nextInFace(side), prevInFace(side)})
				edges.push_back(std::minmax(int(m_.origin[other]), m_.target(other)));
		}
		return edges;
	}

	/// Splits an edge. False if faces would be inverted or intersect other faces, or if the point
	/// would stay far; then nothing changes.
	bool trySplit(const Edge& edge, Place place, const FarPoint& point)
	{
		const Operation op{Operation::Split, m_.findEdge(edge.first, edge.second)};
		if (op.halfEdge < 0) return false;
		const PatchEditor::Snapshot before      = editor_.remember(editor_.patchOf(op));
		const Faults                faultsOfOld = faultsOf(before.backup.faces());
		const bool                  isMade      = makeAndPlace(op, place, point);
		const std::vector<int>      faces       = facesRound(m_, editor_.patchNow(before));
		const Faults                faults      = isMade ? faultsOf(faces) : Faults();
		if (!isMade || faults.exceed(faultsOfOld, limits_.angle) || !settles(point, faces)) {
			editor_.undo(before);
			return false;
		}
		editor_.countDone(op);
		space_.follow(faces);
		return true;
	}

	/// Whether a far point of the surface comes much closer. Repeated halves of an edge beside a
	/// point that stays far would only crowd vertices. A far point of the result is gone.
	bool settles(const FarPoint& point, const std::vector<int>& faces) const
	{
		if (!point.isOfSurface) return true;
		const float wanted = settledShare * point.distance;
		return std::any_of(faces.begin(), faces.end(), [&](int f) {
			const Vec3f at =
				nearestOnTriangle(point.position, corner(f, 0), corner(f, 1), corner(f, 2));
			return squaredLength(at - point.position) <= wanted * wanted;
		});
	}

	Vec3f corner(int f, int k) const { return m_.position[m_.origin[3 * f + k]]; }

	bool makeAndPlace(const Operation& op, Place place, const FarPoint& point)
	{
		const Vec3f middle =
			(m_.position[m_.origin[op.halfEdge]] + m_.position[m_.target(op.halfEdge)]) * 0.5f;
		if (!editor_.make(op)) return false;
		const int v = m_.vertexNum - 1;
		if (place == Place::OnEdge) {
			moveTo(middle, v);
			return true;
		}
		if (place == Place::AtPoint && !moveTo(point, v)) return false;
		for (int w : verticesOf(m_, facesRound(m_, {v})))
			lower(w);
		return true;
	}

	Faults faultsOf(const std::vector<int>& faces)
	{
		Faults faults;
		for (int f : faces) {
			faults.invertedNum += editor_.agreement(f) < 0;
			faults.angle = std::min(faults.angle, smallestAngle(m_, f));
		}
		const std::vector<int> near = space_.near(boxOfFaces(m_, faces));
		faults.pairNum              = countTouchingPairs(m_, faces, near, &work_);
		work_ += std::int64_t(near.size());
		return faults;
	}

	bool isFree(int v) const { return constraintOf(editor_.result(), v) == Constraint::Free; }

	void moveTo(const Vec3f& position, int v)
	{
		PatchEditor::VertexState state = editor_.stateOf(v);
		state.position                 = position;
		editor_.put(v, state);
	}

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
		const Vec3f below = editor_.result().vertex[v].point.position;
		moveTo(below + (m_.position[v] - below) * heightKept, v);
	}
};

} // namespace

int refineAt(const Surface& surface, const BoundaryCurves& curves,
			 const std::vector<FarPoint>& points, const LocalRefinement& settings,
			 ResultMesh& result, Workers& workers)
{
	const int                before = result.mesh.vertexNum;
	const std::vector<Split> splits = splitsFor(result.mesh, points, workers);
	if (int(splits.size()) > settings.mostNew) return 0;
	Refinement refinement(surface, curves, result, workers, int(splits.size()));
	for (const Split& split : splits) {
		workers.poll();
		if (refinement.work() > settings.mostWork) break;
		refinement.split(split);
	}

	const ClosestFaceMap map(surface, result, workers);
	Assignment           assignment(surface, map, numbersBelow(std::size_t(result.mesh.faceNum)));
	std::int64_t         work = workOf(Driver::PoorFaces, result.mesh.faceNum);
	LocalSearch          search(surface, curves, &assignment, work, result, workers);
	Goal                 goal = smallAngles(search, settings.minAngle);
	goal.limits.guarded       = guardedShare * settings.maxGap;
	goal.limits.gap           = settings.maxGap;
	search.run(goal);
	lowerWorstDistances(surface, map, settings.minAngle, worstRounds, result, workers,
						settings.maxGap);
	return result.mesh.vertexNum - before;
}

} // namespace gpr
