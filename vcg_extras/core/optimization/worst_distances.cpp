// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "worst_distances.h"

#include "constraint.h"

#include <vcg_extras/core/base/triangle.h>
#include <vcg_extras/core/mesh/face_quality.h>
#include <vcg_extras/core/surface/face_tree.h>
#include <vcg_extras/core/surface/normal_agreement.h>
#include <vcg_extras/core/surface/surface_point.h>

#include <algorithm>
#include <cmath>

namespace gpr {

namespace {

/// Faces that are drawn closer in a round: those beyond this share of the largest distance, and so
/// many at most.
constexpr float       worstShare = 0.75f;
constexpr std::size_t mostFaces  = 300;
/// Distances below this share of the mean edge are near enough.
constexpr float nearShare = 0.1f;
/// Moves at a face in a round.
constexpr int mostMoves = 6;
/// So much farther than what is near may a vertex get that was nearer.
constexpr float farthestOff = 2;
/// A move must lessen the distance to this share.
constexpr float leastGain = 0.96f;
/// Of the way that would close the gap if nothing else changed: as little as will do.
constexpr float wayShares[] = {0.25f, 0.5f, 1};
/// A vertex moves at most this share of an edge at once.
constexpr float longestMove = 0.3f;
/// Points of the lattice along an edge, less one.
constexpr int latticeSteps = 4;
/// Faces of the input from which the next one is looked for, on the way to the nearest.
constexpr int mostHops = 64;
/// A face does not turn by more than this in a move, nor agree less with the surface's normals.
constexpr float turnCosine     = 0.5f;
constexpr float leastAgreement = 0.3f;

/// Weights of the corners of a triangle at the point q of it.
void weightsAt(const Vec3f& q, const Vec3f& a, const Vec3f& b, const Vec3f& c, float* weight)
{
	const Vec3f n       = cross(b - a, c - a);
	const float squared = squaredLength(n) + 1e-30f;
	weight[1]           = dot(cross(q - a, c - a), n) / squared;
	weight[2]           = dot(cross(b - a, q - a), n) / squared;
	weight[0]           = 1 - weight[1] - weight[2];
}

/// Where a triangle and the surface lie farthest apart.
struct Gap {
	float squared; ///< length; at first what is near enough
	Vec3f way;     ///< from the triangle to the surface
	Vec3f at;      ///< where on the triangle
};

/// By the area of the faces, as if they were equilateral.
float meanEdge(const HalfEdgeMesh& m)
{
	double area = 0;
	for (int f = 0; f < m.faceNum; ++f)
		area += 0.5 * double(length(m.faceCross(f)));
	return float(std::sqrt(area / std::max(1, m.faceNum) * (4 / std::sqrt(3.0))));
}

class WorstDistances {
public:
	WorstDistances(const Surface& surface, const Cells& cells, float leastAngle, ResultMesh& result,
				   Workers& workers) :
			surface_(surface),
			s_(surface.mesh), cells_(cells), leastAngle_(leastAngle),
			near_(nearShare * meanEdge(result.mesh)), r_(result), m_(result.mesh),
			workers_(workers), normal_(smoothNormals(surface, result, workers)),
			anchor_(m_.vertexNum), gap_(m_.faceNum)
	{
		for (int v = 0; v < m_.vertexNum; ++v)
			anchor_[v] = r_.vertex[v].anchor;
	}

	/// Returns the largest distance left.
	float run(int rounds)
	{
		const Buffer<char> isFar = findFarVertices();
		workers_.forRange(m_.faceNum, [&](std::size_t begin, std::size_t end) {
			for (std::size_t f = begin; f < end; ++f)
				gap_[f] = isSuspect(isFar, int(f)) ? gapAt(int(f)).squared : gapFromSurface(int(f));
		});
		for (int round = 0; round < rounds; ++round) {
			bool        better = false;
			const float goal   = squaredGoal();
			for (int f : facesBeyond(goal)) {
				workers_.poll();
				better = drawCloser(f, goal) || better;
			}
			if (!better) break;
		}
		return std::sqrt(largestKnown());
	}

private:
	const Surface&      surface_;
	const HalfEdgeMesh& s_; ///< of the surface
	const Cells&        cells_;
	float               leastAngle_, near_;
	ResultMesh&         r_;
	HalfEdgeMesh&       m_;
	Workers&            workers_;
	Buffer<Vec3f>       normal_; ///< of the surface at the result's vertices
	Buffer<Anchor>      anchor_; ///< the nearest points of the surface, of vertices that moved
	Buffer<float>       gap_;    ///< per face: the squared length, or what is near enough

	// ---- distances

	Vec3f corner(int f, int k) const { return m_.position[m_.origin[3 * f + k]]; }

	static Vec3f nearestIn(const HalfEdgeMesh& m, int f, const Vec3f& p)
	{
		const int* c = &m.origin[3 * f];
		return nearestOnTriangle(p, m.position[c[0]], m.position[c[1]], m.position[c[2]]);
	}

	/// The point of a mesh nearest to p, as far as it gets ever nearer on the way from `face`,
	/// which is then the one that it lies in; or one within the root of `enough`.
	static Vec3f nearestOn(const HalfEdgeMesh& m, const Vec3f& p, float enough, int& face)
	{
		Vec3f nearest = nearestIn(m, face, p);
		for (int hop = 0; hop < mostHops; ++hop) {
			if (squaredLength(nearest - p) <= enough) break;
			const int from = face;
			for (int k = 0; k < 3; ++k) {
				forEachOutgoing(m, m.origin[3 * from + k], [&](int h) {
					const Vec3f q = nearestIn(m, h / 3, p);
					if (squaredLength(q - p) >= squaredLength(nearest - p)) return;
					nearest = q;
					face    = h / 3;
				});
			}
			if (face == from) break;
		}
		return nearest;
	}

	static void widen(const Vec3f& onTriangle, const Vec3f& onSurface, Gap& gap)
	{
		const Vec3f way     = onSurface - onTriangle;
		const float squared = squaredLength(way);
		if (squared > gap.squared) gap = {squared, way, onTriangle};
	}

	/// The vertices of the input in f's cell, from where the result comes nearest to them.
	void lookFromSurface(int f, Gap& gap) const
	{
		for (const int* i = cells_.begin(f); i != cells_.end(f); ++i) {
			int         face = f;
			const Vec3f p    = s_.position[*i];
			widen(nearestOn(m_, p, gap.squared, face), p, gap);
		}
	}

	/// A lattice of points on f.
	void lookFromTriangle(int f, Gap& gap) const
	{
		const Vec3f a = corner(f, 0), b = corner(f, 1), c = corner(f, 2);
		int         face = anchorFace(f, 0);
		for (int i = 0; i <= latticeSteps; ++i) {
			for (int k = 0; i + k <= latticeSteps; ++k) {
				const float x = float(i) / latticeSteps, y = float(k) / latticeSteps;
				const Vec3f p = a * (1 - x - y) + b * x + c * y;
				widen(p, nearestFromCorners(f, p, gap.squared, face), gap);
			}
		}
	}

	int anchorFace(int f, int k) const { return anchor_[m_.origin[3 * f + k]].face; }

	/// On the way from a face to the nearest one a rim may lie; then another way may not cross it.
	Vec3f nearestFromCorners(int f, const Vec3f& p, float enough, int& face) const
	{
		Vec3f nearest = nearestOn(s_, p, enough, face);
		for (int k = 0; k < 3 && squaredLength(nearest - p) > enough; ++k) {
			int         other = anchorFace(f, k);
			const Vec3f q     = nearestOn(s_, p, enough, other);
			if (squaredLength(q - p) >= squaredLength(nearest - p)) continue;
			nearest = q;
			face    = other;
		}
		return nearest;
	}

	Gap nearEnough() const { return {near_ * near_, Vec3f(), Vec3f()}; }

	Gap gapAt(int f) const
	{
		Gap gap = nearEnough();
		lookFromTriangle(f, gap);
		lookFromSurface(f, gap);
		return gap;
	}

	/// Without a look from the triangle.
	float gapFromSurface(int f) const
	{
		Gap gap = nearEnough();
		lookFromSurface(f, gap);
		return gap.squared;
	}

	/// The largest of the faces' gaps; any that is larger than `bound` will do.
	float largestGap(const std::vector<int>& faces, float bound) const
	{
		float largest = 0;
		for (int f : faces) {
			largest = std::max(largest, gapAt(f).squared);
			if (largest > bound) break;
		}
		return largest;
	}

	float edgeOf(int f) const
	{
		const Vec3f a = corner(f, 0), b = corner(f, 1), c = corner(f, 2);
		return (length(b - a) + length(c - b) + length(a - c)) / 3;
	}

	// ---- the worst faces

	/// Vertices that are not near the surface.
	Buffer<char> findFarVertices() const
	{
		Buffer<char> isFar(m_.vertexNum);
		workers_.forRange(m_.vertexNum, [&](std::size_t begin, std::size_t end) {
			for (std::size_t v = begin; v < end; ++v)
				isFar[v] = isFarVertex(int(v));
		});
		return isFar;
	}

	bool isSuspect(const Buffer<char>& isFar, int f) const
	{
		const int* c = &m_.origin[3 * f];
		return isFar[c[0]] || isFar[c[1]] || isFar[c[2]];
	}

	bool isFarVertex(int v) const
	{
		const Vec3f  p      = m_.position[v];
		const Anchor anchor = anchor_[v];
		if (squaredLength(p - anchor.position) <= near_ * near_) return false;
		int face = anchor.face;
		return squaredLength(nearestOn(s_, p, near_ * near_, face) - p) > near_ * near_;
	}

	/// What distances a round lowers, squared.
	float squaredGoal() const
	{
		return std::max(worstShare * worstShare * largestKnown(), near_ * near_);
	}

	float largestKnown() const { return *std::max_element(gap_.begin(), gap_.end()); }

	/// Farthest first.
	std::vector<int> facesBeyond(float goal) const
	{
		std::vector<int> faces;
		for (int f = 0; f < m_.faceNum; ++f) {
			if (gap_[f] > goal) faces.push_back(f);
		}
		std::stable_sort(faces.begin(), faces.end(),
						 [&](int f, int g) { return gap_[f] > gap_[g]; });
		if (faces.size() > mostFaces) faces.resize(mostFaces);
		return faces;
	}

	// ---- moves

	bool mayMove(int v) const { return constraintOf(r_, v) == Constraint::Free; }

	bool drawCloser(int f, float goal)
	{
		bool better = false;
		for (int move = 0; move < mostMoves && gap_[f] > goal; ++move) {
			if (!moveCorners(f)) break;
			better = true;
		}
		return better;
	}

	/// All corners together, or else one of them.
	bool moveCorners(int f)
	{
		const Gap gap = gapAt(f);
		if (gap.squared <= near_ * near_) return false;
		const int* c = &m_.origin[3 * f];
		if (tryMoves(f, gap, {c[0], c[1], c[2]})) return true;
		for (int k = 0; k < 3; ++k) {
			if (tryMoves(f, gap, {c[k]})) return true;
		}
		return false;
	}

	struct Move {
		int   vertex;
		Vec3f shift;
	};

	/// The shortest moves that take the triangle along the whole way, of those that may move.
	std::vector<Move> movesAlong(int f, const Gap& gap, const std::vector<int>& vertices) const
	{
		float weight[3];
		weightsAt(gap.at, corner(f, 0), corner(f, 1), corner(f, 2), weight);
		std::vector<Move> moves;
		float             sum = 0;
		for (int k = 0; k < 3; ++k) {
			const int  v      = m_.origin[3 * f + k];
			const bool wanted = std::find(vertices.begin(), vertices.end(), v) != vertices.end();
			if (!wanted || !mayMove(v) || !(weight[k] > 0.05f)) continue;
			moves.push_back({v, gap.way * weight[k]});
			sum += weight[k] * weight[k];
		}
		const float most = longestMove * edgeOf(f);
		for (Move& m : moves) {
			m.shift       = m.shift * (1 / sum);
			const float l = length(m.shift);
			if (l > most) m.shift = m.shift * (most / l);
		}
		return moves;
	}

	bool tryMoves(int f, const Gap& gap, const std::vector<int>& vertices)
	{
		const std::vector<Move> moves = movesAlong(f, gap, vertices);
		if (moves.empty()) return false;
		std::vector<int> moving;
		moving.reserve(moves.size());
		for (const Move& m : moves)
			moving.push_back(m.vertex);
		const std::vector<int> faces  = facesRound(m_, moving);
		const float            before = largestGap(faces, HUGE_VALF);
		for (float share : wayShares) {
			if (tryMove(f, gap, moves, share, faces, before)) return true;
		}
		return false;
	}

	bool tryMove(int f, const Gap& gap, const std::vector<Move>& moves, float share,
				 const std::vector<int>& faces, float before)
	{
		std::vector<Shape> shapes;
		shapes.reserve(faces.size());
		for (int g : faces)
			shapes.push_back(shapeOf(g));
		std::vector<Place> places;
		bool               keepsNear = true;
		for (const Move& m : moves) {
			places.push_back(placeOf(m.vertex));
			const Place next = placeAfter(m.vertex, m.shift * share);
			keepsNear        = keepsNear && squaredOff(next) <= allowedOff(m.vertex);
			put(m.vertex, next);
		}
		if (keepsNear && areSound(faces, shapes) &&
			gapAt(f).squared <= leastGain * leastGain * gap.squared &&
			largestGap(faces, before) <= before) {
			for (int g : faces)
				gap_[g] = gapAt(g).squared;
			return true;
		}
		for (std::size_t i = 0; i < moves.size(); ++i)
			put(moves[i].vertex, places[i]);
		return false;
	}

	/// A vertex with what follows it.
	struct Place {
		Vec3f  position, normal;
		Anchor anchor;
	};

	Place placeOf(int v) const { return {m_.position[v], normal_[v], anchor_[v]}; }

	Place placeAfter(int v, const Vec3f& shift) const
	{
		Place place           = placeOf(v);
		place.position        = place.position + shift;
		place.anchor.position = nearestOn(s_, place.position, 0, place.anchor.face);
		place.normal          = smoothNormal(surface_, place.anchor);
		return place;
	}

	static float squaredOff(const Place& p)
	{
		return squaredLength(p.position - p.anchor.position);
	}

	/// A vertex must not be drawn off the surface to one that only seems to have no triangle near.
	float allowedOff(int v) const
	{
		const float allowed = farthestOff * farthestOff * near_ * near_;
		return std::max(allowed, squaredOff(placeAfter(v, Vec3f())));
	}

	void put(int v, const Place& place)
	{
		m_.position[v] = place.position;
		normal_[v]     = place.normal;
		anchor_[v]     = place.anchor;
	}

	/// What must not get worse by a move.
	struct Shape {
		Vec3f normal;
		float angle, agreement;
	};

	Shape shapeOf(int f) const
	{
		return {m_.faceNormal(f), smallestAngle(m_, f), faceAgreement(m_, normal_, f)};
	}

	bool areSound(const std::vector<int>& faces, const std::vector<Shape>& before) const
	{
		for (std::size_t i = 0; i < faces.size(); ++i) {
			const Shape now = shapeOf(faces[i]), &then = before[i];
			if (dot(now.normal, then.normal) < turnCosine) return false;
			if (now.angle < std::min(leastAngle_, then.angle)) return false;
			if (now.agreement < std::min(leastAgreement, then.agreement)) return false;
		}
		return true;
	}
};

} // namespace

float lowerWorstDistances(const Surface& surface, const Cells& cells, float leastAngle, int rounds,
						  ResultMesh& result, Workers& workers)
{
	return WorstDistances(surface, cells, leastAngle, result, workers).run(rounds);
}

} // namespace gpr
