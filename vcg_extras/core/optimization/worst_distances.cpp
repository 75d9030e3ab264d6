// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "worst_distances.h"

#include "terms.h"

#include <vcg_extras/core/base/triangle.h>
#include <vcg_extras/core/edit/constraint.h>
#include <vcg_extras/core/edit/move_guard.h>
#include <vcg_extras/core/mesh/face_quality.h>
#include <vcg_extras/core/surface/local_nearest.h>
#include <vcg_extras/core/surface/nearest_on_mesh.h>
#include <vcg_extras/core/surface/normal_agreement.h>
#include <vcg_extras/core/surface/surface_gap.h>
#include <vcg_extras/core/surface/walk.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace gpr {

namespace {

/// Faces moved in a round: faces beyond this share of the largest distance, and at most this many.
constexpr float       worstShare = 0.75f;
constexpr std::size_t maxFaces = 300, maxFacesToGoal = 3000;
/// Smaller distances count as near, as a share of the mean edge.
constexpr float nearShare = 0.1f;
/// Moves at a face in a round.
constexpr int maxMoves = 6;
/// Largest distance of a vertex after a move, in near distances, unless the vertex was farther
/// before.
constexpr float farthestOff = 2;
/// The distance after a move must be at most this share.
constexpr float minGain = 0.96f;
/// Shares of the move that would close the gap; the smallest sufficient share is taken.
constexpr float wayShares[] = {0.25f, 0.5f, 1};
/// A vertex moves at most this share of an edge at once.
constexpr float longestMove = 0.3f;

class WorstDistances {
public:
	WorstDistances(const Surface& surface, const ClosestFaceMap& map, float minAngle, float goal,
				   ResultMesh& result, Workers& workers) :
			surface_(surface),
			s_(surface.mesh), hasGoal_(goal > 0),
			near_(hasGoal_ ? goal : nearShare * meanEdgeByArea(result.mesh, workers)),
			limits_(acceptanceOf(Driver::WorstDistances, minAngle)), r_(result), m_(result.mesh),
			workers_(workers), normal_(smoothNormals(surface, result, workers)),
			point_(m_.vertexNum), hasMoved_(m_.vertexNum, 0), gaps_(surface, map, m_, point_, near_)
	{
		for (int v = 0; v < m_.vertexNum; ++v)
			point_[v] = r_.vertex[v].point;
	}

	/// Returns the largest distance left.
	float run(int rounds)
	{
		gap_ = gaps_.measureAll(workers_);
		for (int f = 0; f < m_.faceNum; ++f) {
			if (isAtSmoothBorder(f)) gap_[f] = near_ * near_;
		}
		for (int round = 0; round < rounds; ++round) {
			bool        better = false;
			const float goal   = squaredGoal();
			for (int f : facesBeyond(goal)) {
				workers_.poll();
				better = drawCloser(f, goal) || better;
			}
			if (!better) break;
		}
		moveRecords();
		return std::sqrt(largestKnown());
	}

	/// Returns the points that stay farther than near.
	std::vector<FarPoint> drawTo(const std::vector<FarPoint>& points)
	{
		gap_ = gaps_.measureAll(workers_);
		const NearestOnMesh tree(m_, workers_);
		std::vector<int>    face(points.size());
		workers_.forEach(points.size(),
						 [&](int i) { face[i] = tree.nearest(points[i].position).face; });
		std::vector<FarPoint> left;
		for (std::size_t i = 0; i < points.size(); ++i) {
			workers_.poll();
			const FarPoint& p      = points[i];
			const bool      isNear = p.isOfSurface ? drawToSurfacePoint(p.position, face[i])
												   : drawToSurface(p.position, face[i]);
			if (!isNear) left.push_back(p);
		}
		moveRecords();
		return left;
	}

private:
	const Surface&       surface_;
	const HalfEdgeMesh&  s_;       ///< of the surface
	bool                 hasGoal_; ///< near is the goal, and vertices may leave their lines
	float                near_;
	Acceptance           limits_; ///< of a move, for faces
	ResultMesh&          r_;
	HalfEdgeMesh&        m_;
	Workers&             workers_;
	Buffer<Vec3f>        normal_; ///< of the surface at the result's vertices
	Buffer<SurfacePoint> point_;  ///< nearest surface points of the vertices
	Buffer<char>         hasMoved_;
	SurfaceGaps          gaps_;
	Buffer<float>        gap_; ///< per face: squared distance, or the near distance squared

	// ---- distances

	float edgeOf(int f) const
	{
		const auto [a, b, c] = m_.corners(f);
		return (length(b - a) + length(c - b) + length(a - c)) / 3;
	}

	/// Whether a face lies at a smooth border. The surface ends elsewhere there, and no move would
	/// help.
	bool isAtSmoothBorder(int f) const
	{
		const int* c = &m_.origin[3 * f];
		return r_.hasSmoothBorder &&
			   (m_.isBorderVertex(c[0]) || m_.isBorderVertex(c[1]) || m_.isBorderVertex(c[2]));
	}

	// ---- far points

	/// The place on the result nearest to a point, among the faces round face f.
	SurfacePoint nearestAround(const Vec3f& p, int f) const
	{
		SurfacePoint nearest;
		float        squared = HUGE_VALF;
		const int*   c       = &m_.origin[3 * f];
		for (int g : facesRound(m_, {c[0], c[1], c[2]})) {
			const Corners face = m_.corners(g);
			const Vec3f   at   = nearestOnTriangle(p, face.a, face.b, face.c);
			const float   own  = squaredLength(at - p);
			if (own >= squared) continue;
			squared = own;
			nearest = {at, g};
		}
		return nearest;
	}

	/// Draws the result to a far point of the surface. False if the point stays farther than near.
	bool drawToSurfacePoint(const Vec3f& p, int f)
	{
		return drawTo(f, [&](int& face) -> Gap {
			const SurfacePoint at = nearestAround(p, face);
			face                  = at.face;
			return {squaredLength(p - at.position), p - at.position, at.position};
		});
	}

	/// Draws a far point of the result to the surface. False if the point stays farther than near.
	bool drawToSurface(const Vec3f& p, int f)
	{
		const Corners              start  = m_.corners(f);
		const std::array<float, 3> weight = weightsAt(p, start.a, start.b, start.c);
		return drawTo(f, [&](int& face) -> Gap {
			const auto [a, b, c] = m_.corners(face);
			const Vec3f at       = a * weight[0] + b * weight[1] + c * weight[2];
			int         seed     = point_[m_.origin[3 * face]].face;
			const Vec3f way      = nearestOnTheWay(s_, at, 0, seed) - at;
			return {squaredLength(way), way, at};
		});
	}

	/// Moves corners of a face until a gap is near. gapFrom(f): the gap now, for a point whose
	/// nearest face was f; sets f to the face of the gap.
	template <class GapFrom>
	bool drawTo(int f, const GapFrom& gapFrom)
	{
		for (int move = 0;; ++move) {
			const Gap gap = gapFrom(f);
			if (gap.squared <= near_ * near_) return true;
			const auto isCloser = [&] {
				int face = f;
				return gapFrom(face).squared <= minGain * minGain * gap.squared;
			};
			if (move == maxMoves || !moveSome(f, gap, isCloser)) return false;
		}
	}

	// ---- the worst faces

	/// The squared distance above which a round moves faces.
	float squaredGoal() const
	{
		const float nearSquared = near_ * near_;
		if (hasGoal_) return nearSquared;
		return std::max(worstShare * worstShare * largestKnown(), nearSquared);
	}

	float largestKnown() const { return *std::max_element(gap_.begin(), gap_.end()); }

	/// The entries of faces in gap_; empty if a face is farther than `squared`.
	std::vector<float> gapsWithin(const std::vector<int>& faces, float squared) const
	{
		std::vector<float> gaps;
		for (int f : faces) {
			const float gap = gaps_.gapAt(f, squared).squared;
			if (gap > squared) return {};
			gaps.push_back(isAtSmoothBorder(f) ? near_ * near_ : gap);
		}
		return gaps;
	}

	/// Faces beyond the squared distance `goal`, farthest first.
	std::vector<int> facesBeyond(float goal) const
	{
		std::vector<int> faces =
			workers_.collectIf(m_.faceNum, [&](int f) { return gap_[f] > goal; });
		std::stable_sort(faces.begin(), faces.end(),
						 [&](int f, int g) { return gap_[f] > gap_[g]; });
		const std::size_t most = hasGoal_ ? maxFacesToGoal : maxFaces;
		if (faces.size() > most) faces.resize(most);
		return faces;
	}

	// ---- moves

	/// Moves the records after the vertices. The records of vertices that leave a line stay on the
	/// line.
	void moveRecords()
	{
		for (int v = 0; v < m_.vertexNum; ++v) {
			if (hasMoved_[v] && constraintOf(r_, v) == Constraint::Free)
				followOnSurface(surface_, v, r_);
		}
	}

	/// Within a goal vertices of feature lines, and their corners, may leave their lines.
	bool mayMove(int v) const
	{
		const Constraint c = constraintOf(r_, v);
		if (c == Constraint::Free || !hasGoal_) return c == Constraint::Free;
		return c != Constraint::Surface && !m_.isBorderVertex(v) && !r_.vertex[v].isPinned;
	}

	bool drawCloser(int f, float goal)
	{
		bool better = false;
		for (int move = 0; move < maxMoves && gap_[f] > goal; ++move) {
			const Gap  gap      = gaps_.gapAt(f);
			const auto isCloser = [&] {
				return gaps_.isWithin(f, minGain * minGain * gap.squared);
			};
			if (gap.squared <= near_ * near_ || !moveSome(f, gap, isCloser)) break;
			better = true;
		}
		return better;
	}

	/// Moves all corners of a face, or one corner.
	template <class IsCloser>
	bool moveSome(int f, const Gap& gap, const IsCloser& isCloser)
	{
		const int* c = &m_.origin[3 * f];
		if (tryMoves(f, gap, {c[0], c[1], c[2]}, isCloser)) return true;
		for (int k = 0; k < 3; ++k) {
			if (tryMoves(f, gap, {c[k]}, isCloser)) return true;
		}
		return false;
	}

	struct Move {
		int   vertex;
		Vec3f shift;
	};

	/// The shortest moves of the movable vertices that move the triangle along the whole gap.
	std::vector<Move> movesAlong(int f, const Gap& gap, const std::vector<int>& vertices) const
	{
		const auto [a, b, c]              = m_.corners(f);
		const std::array<float, 3> weight = weightsAt(gap.at, a, b, c);
		std::vector<Move>          moves;
		float                      sum = 0;
		for (int k = 0; k < 3; ++k) {
			const int  v      = m_.origin[3 * f + k];
			const bool wanted = std::find(vertices.begin(), vertices.end(), v) != vertices.end();
			if (!wanted || !mayMove(v) || !(weight[k] > 0.05f)) continue;
			moves.push_back({v, gap.way * weight[k]});
			sum += weight[k] * weight[k];
		}
		const float most = longestMove * edgeOf(f);
		for (Move& m : moves)
			m.shift = shortened(m.shift * (1 / sum), most);
		return moves;
	}

	template <class IsCloser>
	bool tryMoves(int f, const Gap& gap, const std::vector<int>& vertices, const IsCloser& isCloser)
	{
		const std::vector<Move> moves = movesAlong(f, gap, vertices);
		if (moves.empty()) return false;
		std::vector<int> moving;
		moving.reserve(moves.size());
		for (const Move& m : moves)
			moving.push_back(m.vertex);
		const std::vector<int> faces   = facesRound(m_, moving);
		float                  largest = gap.squared;
		for (int g : faces)
			largest = std::max(largest, gap_[g]);
		for (float share : wayShares) {
			if (tryMove(moves, share, faces, largest, isCloser)) return true;
		}
		return false;
	}

	template <class IsCloser>
	bool tryMove(const std::vector<Move>& moves, float share, const std::vector<int>& faces,
				 float before, const IsCloser& isCloser)
	{
		std::vector<Corners> corners;
		std::vector<float>   agreed;
		for (int g : faces) {
			corners.push_back(m_.corners(g));
			agreed.push_back(normalAgreement(m_, normal_, g));
		}
		std::vector<Place> places;
		bool               keepsNear = true;
		for (const Move& m : moves) {
			places.push_back(placeOf(m.vertex));
			const Place next = placeAfter(m.vertex, m.shift * share);
			keepsNear        = keepsNear && squaredOff(next) <= allowedOff(m.vertex);
			put(m.vertex, next);
		}
		std::vector<float> gaps;
		if (keepsNear && areSound(faces, corners, agreed) && isCloser())
			gaps = gapsWithin(faces, before);
		for (std::size_t i = 0; i < gaps.size(); ++i)
			gap_[faces[i]] = gaps[i];
		if (!gaps.empty()) {
			for (const Move& m : moves)
				hasMoved_[m.vertex] = 1;
			return true;
		}
		for (std::size_t i = 0; i < moves.size(); ++i)
			put(moves[i].vertex, places[i]);
		return false;
	}

	/// The state of a vertex.
	struct Place {
		Vec3f        position, normal;
		SurfacePoint point;
	};

	Place placeOf(int v) const { return {m_.position[v], normal_[v], point_[v]}; }

	Place placeAfter(int v, const Vec3f& shift) const
	{
		Place place          = placeOf(v);
		place.position       = place.position + shift;
		place.point.position = nearestOnTheWay(s_, place.position, 0, place.point.face);
		place.normal         = smoothNormal(surface_, place.point);
		return place;
	}

	static float squaredOff(const Place& p) { return squaredLength(p.position - p.point.position); }

	/// The largest squared distance of a vertex from the surface after a move. The limit protects a
	/// vertex from input vertices that only seem to have no triangle near.
	float allowedOff(int v) const
	{
		const float off     = hasGoal_ ? 1 : farthestOff;
		const float allowed = off * off * near_ * near_;
		return std::max(allowed, squaredOff(placeAfter(v, Vec3f())));
	}

	void put(int v, const Place& place)
	{
		m_.position[v] = place.position;
		normal_[v]     = place.normal;
		point_[v]      = place.point;
	}

	bool areSound(const std::vector<int>& faces, const std::vector<Corners>& before,
				  const std::vector<float>& agreedBefore) const
	{
		for (std::size_t i = 0; i < faces.size(); ++i) {
			if (spoilsFace(limits_, before[i], m_.corners(faces[i]))) return false;
			const float agrees = normalAgreement(m_, normal_, faces[i]);
			if (spoilsAgreement(limits_, agreedBefore[i], agrees)) return false;
		}
		return true;
	}
};

} // namespace

float lowerWorstDistances(const Surface& surface, const ClosestFaceMap& map, float minAngle,
						  int rounds, ResultMesh& result, Workers& workers, float goal)
{
	return WorstDistances(surface, map, minAngle, goal, result, workers).run(rounds);
}

std::vector<FarPoint> drawToPoints(const std::vector<FarPoint>& points, const Surface& surface,
								   const ClosestFaceMap& map, float minAngle, float goal,
								   ResultMesh& result, Workers& workers)
{
	return WorstDistances(surface, map, minAngle, goal, result, workers).drawTo(points);
}

} // namespace gpr
