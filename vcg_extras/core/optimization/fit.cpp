// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fit.h"

#include "curve_fit.h"
#include "fold_repair.h"
#include "worst_distances.h"

#include <vcg_extras/core/base/sort_unique.h>
#include <vcg_extras/core/base/symmetric_matrix.h>
#include <vcg_extras/core/base/triangle.h>
#include <vcg_extras/core/mesh/crossing_faces.h>
#include <vcg_extras/core/surface/cells.h>
#include <vcg_extras/core/surface/normal_agreement.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace gpr {

namespace {

/// Jacobi steps of a round; more change nothing to speak of.
constexpr int stepNum = 6;
/// Length of a step over that of Newton's for the vertex alone, and share of the last one kept.
constexpr float stepLength = 0.7f;
constexpr float momentum   = 0.7f;
/// μ: pull to where the round began.
constexpr float pullBack = 0.02f;
/// A step is at most this share of the vertex' shortest edge.
constexpr float longestStep = 0.15f;
/// A round moves a vertex at most this share of the mean edge round it.
constexpr float farthestMove = 0.3f;
/// Sum of 1/(2·area) times this: curvature of the conformal energy round a vertex.
constexpr float conformalStiffness = 1.1547005f;
/// E = this · (a² + b² + c²) / (2·area).
constexpr float conformalScale = 0.28867513f;
/// Squared edge of an equilateral triangle over its area.
constexpr float squaredEdgePerArea = 2.3094011f;

/// A face must not turn by more than 60° in a round,
constexpr float turnCosine = 0.5f;
/// nor agree less with the surface's normals than this if it did before.
constexpr float leastAgreement = 0.3f;
/// What counts as a poorer angle: rounding is not.
constexpr float poorer = 0.9999f;
/// Moves are halved so many times, then taken back.
constexpr int halvings = 5;
/// Rounds of shortening moves; then all are taken back.
constexpr int mostShortenings = 64;
/// Passes over the whole result at the end; each puts vertices back for good.
constexpr int mostTakeBacks = 32;

Vec3f faceCross(const Vec3f& a, const Vec3f& b, const Vec3f& c)
{
	return cross(b - a, c - a);
}

float cosineBetween(const Vec3f& a, const Vec3f& b)
{
	const float scale = length(a) * length(b);
	return scale > 0 ? dot(a, b) / scale : -1.0f;
}

/// Moves on trial: mesh.position is always from + shift.
class Moves {
public:
	Moves(const Surface& surface, float leastAngle, ResultMesh& result, Workers& workers) :
			surface_(surface), leastAngle_(leastAngle), r_(result), m_(result.mesh),
			workers_(workers), from_(m_.vertexNum)
	{
		std::copy(m_.position.data(), m_.position.data() + m_.vertexNum, from_.data());
	}

	const Vec3f& from(int v) const { return from_[v]; }
	const Vec3f& shift(int v) const { return shift_[v]; }
	Vec3f        at(int v) const { return from_[v] + shift_[v]; }
	void         swapShifts(Buffer<Vec3f>& other) { shift_.swap(other); }

	/// Makes the present places the start of new moves.
	void start()
	{
		makeRoom();
		workers_.forRange(m_.vertexNum, [&](std::size_t begin, std::size_t end) {
			for (std::size_t v = begin; v < end; ++v) {
				from_[v]  = m_.position[v];
				shift_[v] = Vec3f();
			}
		});
	}

	/// Moves from where all began, or `start` was called last, to the present places, whoever moved
	/// the vertices.
	void takeOver()
	{
		makeRoom();
		workers_.forRange(m_.vertexNum, [&](std::size_t begin, std::size_t end) {
			for (std::size_t v = begin; v < end; ++v)
				shift_[v] = m_.position[v] - from_[v];
		});
	}

	/// Puts all vertices where their moves end.
	void apply()
	{
		workers_.forRange(m_.vertexNum, [&](std::size_t begin, std::size_t end) {
			for (std::size_t v = begin; v < end; ++v)
				m_.position[v] = at(int(v));
		});
	}

	/// Shortens the moves of bad faces until there are none. False if that did not end.
	bool shortenBad()
	{
		normal_ = smoothNormals(surface_, r_, workers_);
		return shortenFrom(
			workers_.collect<int>(m_.faceNum, [&](std::size_t begin, std::size_t end, auto& out) {
				for (std::size_t f = begin; f < end; ++f) {
					if (isBad(int(f))) out.push_back(int(f));
				}
			}));
	}

	/// Crossings are only new where vertices have moved since `start`. False where none has.
	bool expectCrossingsWhereMoved()
	{
		mayCross_.assign(m_.faceNum, 0);
		for (int f = 0; f < m_.faceNum; ++f)
			mayCross_[f] = hasMoved(f);
		return std::find(mayCross_.begin(), mayCross_.end(), char(1)) != mayCross_.end();
	}

	/// Takes the moves of faces back that cross others or look against the surface where the
	/// anchors are now, and shortens those that this makes bad. False if there are none.
	bool takeBackOffenders()
	{
		normal_                = smoothNormals(surface_, r_, workers_);
		std::vector<int> faces = findCrossingFaces(m_, mayCross_, workers_);
		crossing_.insert(crossing_.end(), faces.begin(), faces.end());
		const std::vector<int> flipped = findFlipped();
		faces.insert(faces.end(), flipped.begin(), flipped.end());
		faces.erase(std::remove_if(faces.begin(), faces.end(), [&](int f) { return !hasMoved(f); }),
					faces.end());
		if (faces.empty()) return false;
		// Only what is changed from here on needs to be looked at again.
		mayCross_.assign(m_.faceNum, 0);
		shortenFrom(badAmong(facesRound(m_, shorten(faces, 0))));
		return true;
	}

	/// Faces that crossed others at some time.
	const std::vector<int>& everCrossing() const { return crossing_; }

	void takeAllBack()
	{
		shift_.fill(Vec3f());
		mayCross_.clear();
		apply();
	}

private:
	const Surface& surface_;
	float          leastAngle_;
	ResultMesh&    r_;
	HalfEdgeMesh&  m_;
	Workers&       workers_;
	Buffer<Vec3f>  from_;
	Buffer<Vec3f>  shift_;  ///< empty until there are moves
	Buffer<Vec3f>  normal_; ///< of the surface at the vertices
	/// Faces, of which one at least takes part in a crossing not known yet; empty: all.
	std::vector<char> mayCross_;
	std::vector<int>  crossing_;

	void makeRoom()
	{
		if (shift_.empty()) shift_.reset(m_.vertexNum);
	}

	bool hasMoved(int f) const
	{
		const int* c = &m_.origin[3 * f];
		return !(shift_[c[0]] == Vec3f() && shift_[c[1]] == Vec3f() && shift_[c[2]] == Vec3f());
	}

	bool isBad(int f) const
	{
		if (!hasMoved(f)) return false;
		const int*  c    = &m_.origin[3 * f];
		const Vec3f then = faceCross(from_[c[0]], from_[c[1]], from_[c[2]]);
		const Vec3f now  = faceCross(at(c[0]), at(c[1]), at(c[2]));
		if (cosineBetween(now, then) < turnCosine) return true;
		const Vec3f wanted    = normal_[c[0]] + normal_[c[1]] + normal_[c[2]];
		const float agreement = cosineBetween(now, wanted);
		if (agreement < leastAgreement && agreement < poorer * cosineBetween(then, wanted))
			return true;
		const float angle = smallestAngle(at(c[0]), at(c[1]), at(c[2]));
		return angle < leastAngle_ &&
			   angle < poorer * smallestAngle(from_[c[0]], from_[c[1]], from_[c[2]]);
	}

	std::vector<int> badAmong(std::vector<int> faces) const
	{
		faces.erase(std::remove_if(faces.begin(), faces.end(), [&](int f) { return !isBad(f); }),
					faces.end());
		return faces;
	}

	bool shortenFrom(std::vector<int> bad)
	{
		for (int i = 0; i < mostShortenings; ++i) {
			if (bad.empty()) return true;
			bad = badAmong(facesRound(m_, shorten(bad, i < halvings ? 0.5f : 0.0f)));
		}
		if (bad.empty()) return true;
		takeAllBack();
		return false;
	}

	/// Shortens the moves of the faces' corners; returns those.
	std::vector<int> shorten(const std::vector<int>& faces, float factor)
	{
		std::vector<int> vertices = verticesOf(m_, faces);
		for (int v : vertices) {
			shift_[v]      = shift_[v] * factor;
			m_.position[v] = at(v);
		}
		for (std::size_t i = 0; !mayCross_.empty() && i < vertices.size(); ++i)
			forEachOutgoing(m_, vertices[i], [&](int h) { mayCross_[h / 3] = 1; });
		return vertices;
	}

	std::vector<int> findFlipped()
	{
		return workers_.collect<int>(m_.faceNum,
									 [&](std::size_t begin, std::size_t end, auto& out) {
										 for (std::size_t f = begin; f < end; ++f) {
											 if (faceAgreement(m_, normal_, int(f)) < 0)
												 out.push_back(int(f));
										 }
									 });
	}
};

/// The squared distance of a round's cells from the triangles, as a function of the vertices'
/// shifts: ½ Σ_ij s_i K_ij s_j - Σ_i f_i s_i. K_ij is kept for every vertex and every edge.
class DistanceForm {
public:
	explicit DistanceForm(const HalfEdgeMesh& mesh) :
			m_(mesh), edge_(mesh.halfEdgeNum()), own_(mesh.vertexNum), force_(mesh.vertexNum)
	{
		numberEdges();
	}

	void assemble(const Surface& surface, const Cells& cells, Workers& workers)
	{
		workers.forRange(joint_.size(), [&](std::size_t begin, std::size_t end) {
			std::fill(joint_.data() + begin, joint_.data() + end, SymmetricMatrix());
		});
		workers.forRange(m_.vertexNum, [&](std::size_t begin, std::size_t end) {
			for (std::size_t v = begin; v < end; ++v)
				assembleVertex(surface, cells, int(v));
		});
	}

	const SymmetricMatrix& own(int v) const { return own_[v]; }
	const Vec3f&           force(int v) const { return force_[v]; }
	/// Of the edge that h is a half of.
	const SymmetricMatrix& joint(int h) const { return joint_[edge_[h]]; }

private:
	const HalfEdgeMesh&     m_;
	Buffer<int>             edge_; ///< per half-edge: number of its edge
	Buffer<SymmetricMatrix> own_;
	Buffer<SymmetricMatrix> joint_; ///< per edge
	Buffer<Vec3f>           force_;

	/// Numbers the edges in the order of their lower half-edges.
	void numberEdges()
	{
		int num = 0;
		for (int h = 0; h < m_.halfEdgeNum(); ++h) {
			const int g = m_.opposite[h];
			edge_[h]    = g >= 0 && g < h ? edge_[g] : num++;
		}
		joint_.reset(num);
	}

	/// An edge is summed up by its lower vertex, which sees both faces: nothing is written twice.
	void assembleVertex(const Surface& surface, const Cells& cells, int v)
	{
		SymmetricMatrix own;
		Vec3f           force;
		forEachOutgoing(m_, v, [&](int h) {
			const int       next = m_.target(h), last = m_.apex(h);
			const Vec3f     p = m_.position[v], q = m_.position[next], r = m_.position[last];
			SymmetricMatrix withNext, withLast;
			for (const int* i = cells.begin(h / 3); i != cells.end(h / 3); ++i) {
				const PackedWeights w    = cells.weights(*i);
				const float         b[3] = {w.first(), w.second(), w.third()};
				const float bp = b[h % 3], bq = b[nextInFace(h) % 3], br = b[prevInFace(h) % 3];
				const Vec3f n     = surface.normal[*i].unpack();
				const float off   = dot(n, surface.mesh.position[*i] - p * bp - q * bq - r * br);
				const float share = cells.area(*i) * bp;
				force += n * (share * off);
				own.addOuter(n, share * bp);
				withNext.addOuter(n, share * bq);
				withLast.addOuter(n, share * br);
			}
			if (v < next) joint_[edge_[h]] += withNext;
			if (v < last) joint_[edge_[prevInFace(h)]] += withLast;
		});
		own_[v]   = own;
		force_[v] = force;
	}
};

class Fitter {
public:
	Fitter(const Surface& surface, const BoundaryCurves& curves, const FitSettings& settings,
		   ResultMesh& result, Workers& workers) :
			surface_(surface),
			curves_(curves), settings_(settings), r_(result), m_(result.mesh), workers_(workers),
			moves_(surface, settings.leastAngleDeg * radians, result, workers), next_(m_.vertexNum),
			velocity_(m_.vertexNum), mass_(m_.vertexNum), squaredEdge_(m_.vertexNum),
			free_(m_.vertexNum)
	{
	}

	FitOutcome run()
	{
		FitOutcome outcome;
		outcome.capped = !fitSoundly(outcome.cells);
		if (settings_.worstRounds > 0 && outcome.cells != nullptr && !lowerWorst(*outcome.cells))
			outcome.capped = true;
		sortUnique(crossing_);
		outcome.crossing   = std::move(crossing_);
		outcome.farthest   = farthestFromAnchor(r_);
		outcome.largestGap = largestGap_;
		return outcome;
	}

private:
	const Surface&                surface_;
	const BoundaryCurves&         curves_;
	const FitSettings&            settings_;
	ResultMesh&                   r_;
	HalfEdgeMesh&                 m_;
	Workers&                      workers_;
	std::unique_ptr<DistanceForm> distance_; ///< while there are rounds
	Moves                         moves_;
	Buffer<Vec3f>                 next_, velocity_;
	Buffer<float>    mass_;        ///< Σ A_p b² of a vertex if the input were infinitely dense
	Buffer<float>    squaredEdge_; ///< of an equilateral triangle as large as the ones round it
	Buffer<char>     free_;
	std::vector<int> crossing_; ///< faces that crossed others at some time
	float            largestGap_ = 0;

	/// False if a round, or all together, had to be taken back.
	bool fitSoundly(std::unique_ptr<Cells>& cells)
	{
		Moves whole(surface_, settings_.leastAngleDeg * radians, r_, workers_);
		fitCurves(surface_, curves_, settings_.leastAngleDeg * radians, r_);
		const bool allKept = fitInRounds(cells);
		whole.takeOver();
		const bool isSound = takeBackOffenders(whole);
		crossing_          = whole.everCrossing();
		return isSound && allKept;
	}

	/// False if a round had to take all its moves back.
	bool fitInRounds(std::unique_ptr<Cells>& cells)
	{
		bool allKept = true;
		distance_.reset(new DistanceForm(m_));
		if (settings_.rounds > 0) cells.reset(new Cells(surface_, r_, workers_));
		for (int round = 0; round < settings_.rounds; ++round) {
			if (round > 0) cells->update(r_, workers_);
			distance_->assemble(surface_, *cells, workers_);
			startRound();
			for (int step = 0; step < stepNum; ++step)
				stepAll();
			moves_.apply();
			allKept = moves_.shortenBad() && allKept;
			followByAnchors();
		}
		// Before the search for crossing faces needs memory.
		distance_.reset();
		if (cells != nullptr) cells->keepListsOnly();
		return allKept;
	}

	/// False if there was no end to it and all moves were taken back.
	bool takeBackOffenders(Moves& whole)
	{
		for (int i = 0; i < mostTakeBacks; ++i) {
			if (!whole.takeBackOffenders()) return true;
			followByAnchors();
		}
		whole.takeAllBack();
		followByAnchors();
		return false;
	}

	/// False if what crosses others then could not be told from what does not.
	bool lowerWorst(const Cells& cells)
	{
		const float angle = settings_.leastAngleDeg * radians;
		Moves       last(surface_, angle, r_, workers_);
		largestGap_ =
			lowerWorstDistances(surface_, cells, angle, settings_.worstRounds, r_, workers_);
		last.takeOver();
		if (!last.expectCrossingsWhereMoved()) return true;
		// Anchors of vertices that stayed must stay: at a sharp edge they might walk round it.
		for (int v = 0; v < m_.vertexNum; ++v)
			free_[v] = free_[v] && !(last.shift(v) == Vec3f());
		followByAnchors();
		const bool isSound = takeBackOffenders(last);
		crossing_.insert(crossing_.end(), last.everCrossing().begin(), last.everCrossing().end());
		return isSound;
	}

	void startRound()
	{
		moves_.start();
		workers_.forRange(m_.vertexNum, [&](std::size_t begin, std::size_t end) {
			for (std::size_t v = begin; v < end; ++v)
				startVertex(int(v));
		});
	}

	void startVertex(int v)
	{
		float area    = 0;
		int   faceNum = 0;
		forEachOutgoing(m_, v, [&](int h) {
			area += length(m_.faceCross(h / 3)) / 2;
			++faceNum;
		});
		mass_[v]        = area / 6;
		squaredEdge_[v] = squaredEdgePerArea * area / float(faceNum);
		free_[v]        = isFree(r_, v) && r_.vertex[v].curve < 0 && !r_.vertex[v].isPinned;
		velocity_[v]    = Vec3f();
	}

	/// Squared length × area, as the first term of the energy has it: the balance of the two does
	/// not depend on size.
	float shapeWeight(int v) const
	{
		const float edge = squaredEdge_[v];
		return settings_.shapeWeight * edge * edge / squaredEdgePerArea;
	}

	void stepAll()
	{
		workers_.forRange(m_.vertexNum, [&](std::size_t begin, std::size_t end) {
			for (std::size_t v = begin; v < end; ++v)
				next_[v] = free_[v] ? stepFrom(int(v)) : Vec3f();
		});
		moves_.swapShifts(next_);
	}

	/// What a vertex' faces say about its shape.
	struct RingShape {
		Vec3f normal;                ///< area-weighted
		Vec3f force;                 ///< downhill
		float stiffness = 0;         ///< curvature of the energy in the tangent plane
		float shortest  = HUGE_VALF; ///< squared edge

		/// The face whose other corners lie at a and b from the vertex.
		void add(const Vec3f& a, const Vec3f& b)
		{
			const Vec3f n       = cross(a, b);
			const float inverse = 1 / (length(n) + 1e-30f);
			const float edges   = squaredLength(a) + squaredLength(b) + squaredLength(b - a);
			const float energy  = conformalScale * edges * inverse;
			normal += n;
			force += (a + b) * (2 * conformalScale * inverse);
			force += cross(n, b - a) * (energy * inverse * inverse);
			stiffness += conformalStiffness * inverse;
			shortest = std::min(shortest, squaredLength(a));
		}
	};

	/// Where v's shift gets to by one step. Both terms of the energy are summed up in one turn
	/// round v: reading the ring is what a step costs.
	Vec3f stepFrom(int v)
	{
		const Vec3f shift = moves_.shift(v), p = moves_.at(v);
		const float pull  = pullBack * mass_[v];
		const int   first = m_.outgoing[v];
		RingShape   ring;
		Vec3f       force = distance_->force(v) - distance_->own(v) * shift - shift * pull;
		Vec3f       a     = moves_.at(m_.target(first)) - p;
		int         h     = first;
		do {
			const int   in = prevInFace(h), last = m_.origin[in];
			const Vec3f b = moves_.at(last) - p;
			ring.add(a, b);
			force = force - distance_->joint(h) * moves_.shift(m_.target(h));
			// Behind the last border edge there is no half-edge that leaves v.
			if (m_.opposite[in] < 0) force = force - distance_->joint(in) * moves_.shift(last);
			a = b;
			h = m_.opposite[in];
		} while (h >= 0 && h != first);
		return stepAgainst(v, ring, force, pull);
	}

	/// The step for the forces found; only the tangential part of the shape's counts.
	Vec3f stepAgainst(int v, const RingShape& ring, Vec3f force, float pull)
	{
		const Vec3f normal = normalized(ring.normal);
		const float weight = shapeWeight(v);
		const float stiff  = ring.stiffness * weight;
		force += tangential(ring.force, normal) * weight;

		SymmetricMatrix matrix = distance_->own(v);
		matrix.addDiagonal(pull + stiff);
		matrix.addOuter(normal, -stiff);
		const Vec3f wanted = velocity_[v] * momentum + matrix.solve(force) * stepLength;
		velocity_[v]       = shortened(wanted, longestStep * std::sqrt(ring.shortest));
		return shortened(moves_.shift(v) + velocity_[v], farthestMove * std::sqrt(squaredEdge_[v]));
	}

	static Vec3f shortened(const Vec3f& v, float most)
	{
		const float l = length(v);
		return l > most ? v * (most / l) : v;
	}

	/// Anchors go where the vertices went, on the surface.
	void followByAnchors()
	{
		workers_.forRange(m_.vertexNum, [&](std::size_t begin, std::size_t end) {
			for (std::size_t v = begin; v < end; ++v) {
				if (!free_[v]) continue;
				ResultVertex& r = r_.vertex[v];
				walk(surface_.mesh, r.anchor,
					 tangential(m_.position[v] - r.anchor.position, r.normal));
				r.normal = surface_.mesh.faceNormal(r.anchor.face);
			}
		});
	}
};

} // namespace

FitOutcome fitToInput(const Surface& surface, const BoundaryCurves& curves,
					  const FitSettings& settings, ResultMesh& result, Workers& workers)
{
	return Fitter(surface, curves, settings, result, workers).run();
}

} // namespace gpr
