// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "angle_mending.h"

#include "crossing_faces.h"
#include "curve_slide.h"
#include "face_tree.h"
#include "fold_repair.h"
#include "mesh_edit.h"
#include "poor_faces.h"
#include "walk.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace gpr {

namespace {

constexpr float radians = 3.14159265f / 180;
/// Angles are wanted this much larger than asked for, so that none ends just below.
constexpr float margin = 1.06f;
/// Rounds over all poor faces.
constexpr int mostRounds = 8;
/// Moves of a vertex with one step length.
constexpr int mostMoves = 4;
/// Trials that end with crossing faces; then nothing is changed.
constexpr int mostTrials = 4;
/// Above so many poor faces, or this share of all, the triangles are hopelessly large for the
/// surface, and changes one by one mend nothing.
constexpr std::size_t mostPoor      = 500;
constexpr float       mostPoorShare = 0.01f;
/// Faces that are tried in all, and one more for so many faces of the mesh: what takes long on a
/// rough surface is hopeless mostly, and the sharpest come first.
constexpr std::int64_t mostTries       = 2000;
constexpr std::int64_t facesForOneMore = 2000;
/// Vertices of the input that are looked at in a cell.
constexpr int mostInCell = 64;
/// Lengths of steps, of the mean edge round the vertex.
constexpr float stepShares[] = {0.16f, 0.08f, 0.04f, 0.02f};
/// A vertex of a curve slides at most this share of the way to the next one at once.
constexpr float longestSlide = 0.5f;
/// A vertex ends within this share of that edge from where it was,
constexpr float farthestMove = 0.5f;
/// and where the surface's normal there has at least this cosine with the one before.
constexpr float leastNormalCosine = 0.5f;
/// The diagonals of a flip lie at most this share of an edge apart: so much moves the surface.
constexpr float largestGap = 0.5f;
/// The surface round a change may come to lie this share of an edge away, or as far as before.
constexpr float farthestOff = 0.05f;
/// No face may come to agree less with the surface's normals than this, or than before.
constexpr float leastAgreement = 0.6f;
/// A change must lower the cost to this share.
constexpr float leastGain = 0.995f;

std::vector<int> sharpestFirst(const HalfEdgeMesh& m, std::vector<int> faces)
{
	std::stable_sort(faces.begin(), faces.end(),
					 [&](int f, int g) { return smallestAngle(m, f) < smallestAngle(m, g); });
	return faces;
}

class AngleMender {
public:
	AngleMender(const Surface& surface, const BoundaryCurves& curves, float angle,
				ResultMesh& result, Workers& workers, const Cells& cells) :
			surface_(surface),
			curves_(curves), angle_(angle), r_(result), m_(result.mesh), workers_(workers),
			cells_(cells)
	{
	}

	/// False if not all could be tried, or if there was no end of crossing faces and nothing is
	/// changed.
	bool run()
	{
		start_       = copyResult(r_, workers_);
		startNormal_ = smoothNormals(surface_, r_, workers_);
		blocked_.assign(m_.vertexNum, 0);
		for (int trial = 0; trial < mostTrials; ++trial) {
			mendAll();
			if (!blockNewlyCrossing()) return triesLeft_ > 0;
			r_ = copyResult(start_, workers_);
		}
		return false;
	}

private:
	const Surface&        surface_;
	const BoundaryCurves& curves_;
	float                 angle_;
	ResultMesh&           r_;
	HalfEdgeMesh&         m_;
	Workers&              workers_;
	const Cells&          cells_; ///< of the start
	ResultMesh            start_;
	Buffer<Vec3f>         startNormal_, normal_; ///< of the surface at the vertices
	/// Whether the fourth power of what angles lack is their cost, which presses the worst one, in
	/// place of the second: what is stuck by the one may move on by the other.
	bool              worstFirst_ = false;
	std::vector<char> touched_; ///< vertices that moved or whose faces were flipped
	std::vector<char> blocked_; ///< vertices that are left alone
	std::vector<int>  poor_;    ///< faces, ascending
	std::int64_t      triesLeft_ = 0;
	std::vector<int>  changed_; ///< vertices touched since these were looked for

	/// Blocks what touched faces cross now. False if no face crosses another that did not before.
	bool blockNewlyCrossing()
	{
		const std::vector<char> changed = touchedFaces();
		if (std::find(changed.begin(), changed.end(), char(1)) == changed.end()) return false;
		const std::vector<int> now = findCrossingFaces(m_, changed, workers_);
		if (now.empty()) return false;
		const std::vector<int> before = findCrossingFaces(start_.mesh, changed, workers_);
		bool                   found  = false;
		for (int f : now) {
			const bool isOld = std::binary_search(before.begin(), before.end(), f);
			for (int k = 0; k < 3; ++k) {
				const int v = m_.origin[3 * f + k];
				if (isOld && !touched_[v]) continue;
				found       = true;
				blocked_[v] = 1;
			}
		}
		return found;
	}

	/// A mark per face: whether a corner of it is touched. Flips do not change which faces these
	/// are.
	std::vector<char> touchedFaces() const
	{
		std::vector<char> faces(m_.faceNum, 0);
		for (int v = 0; v < m_.vertexNum; ++v) {
			if (touched_[v]) forEachOutgoing(m_, v, [&](int h) { faces[h / 3] = 1; });
		}
		return faces;
	}

	void mendAll()
	{
		triesLeft_ = mostTries + m_.faceNum / facesForOneMore;
		touched_.assign(m_.vertexNum, 0);
		poor_   = findPoorFaces(m_, angle_, workers_);
		normal_ = Buffer<Vec3f>(startNormal_.size());
		std::copy(startNormal_.begin(), startNormal_.end(), normal_.begin());
		for (bool worstFirst : {false, true, false}) {
			worstFirst_ = worstFirst;
			mendByRounds();
		}
	}

	void mendByRounds()
	{
		for (int round = 0; round < mostRounds; ++round) {
			lookAgain();
			bool better = false;
			for (int f : sharpestFirst(m_, poor_)) {
				workers_.poll();
				if (smallestAngle(m_, f) >= angle_) continue;
				if (triesLeft_ == 0) return;
				--triesLeft_;
				better = mend(f) || better;
			}
			if (!better) return;
		}
	}

	/// Only faces that were poor, or that changed, can be poor now.
	void lookAgain()
	{
		const std::vector<int> round = facesRound(m_, changed_);
		std::vector<int>       faces;
		std::set_union(poor_.begin(), poor_.end(), round.begin(), round.end(),
					   std::back_inserter(faces));
		changed_.clear();
		poor_.clear();
		for (int f : faces) {
			if (smallestAngle(m_, f) < angle_) poor_.push_back(f);
		}
	}

	void touch(int v)
	{
		touched_[v] = 1;
		changed_.push_back(v);
	}

	bool mend(int f)
	{
		bool better = false;
		for (int v : patchCorners(f))
			better = moveToBest(v) || better;
		for (int k = 0; k < 3 && smallestAngle(m_, f) < angle_; ++k)
			better = flipAndMove(3 * f + k) || better;
		return better;
	}

	/// Corners of f and of the faces beyond its edges.
	std::vector<int> patchCorners(int f) const
	{
		std::vector<int> corners(&m_.origin[3 * f], &m_.origin[3 * f] + 3);
		for (int h = 3 * f; h < 3 * f + 3; ++h) {
			if (m_.opposite[h] >= 0) corners.push_back(m_.apex(m_.opposite[h]));
		}
		return corners;
	}

	/// What faces lack in angle, and how well they lie on the surface.
	struct Quality {
		float cost      = 0;
		float agreement = 1;

		bool beats(const Quality& other) const
		{
			return cost < leastGain * other.cost &&
				   agreement >= std::min(leastAgreement, other.agreement);
		}
	};

	void addFace(int f, Quality& sum) const
	{
		const float lack = std::max(0.0f, 1 - smallestAngle(m_, f) / (margin * angle_));
		sum.cost += worstFirst_ ? lack * lack * lack * lack : lack * lack;
		sum.agreement = std::min(sum.agreement, faceAgreement(m_, normal_, f));
	}

	Quality ringQuality(int v) const
	{
		Quality sum;
		forEachOutgoing(m_, v, [&](int h) { addFace(h / 3, sum); });
		return sum;
	}

	float squaredDistance(const Vec3f& p, int f) const
	{
		const int* c = &m_.origin[3 * f];
		return squaredLength(
			nearestOnTriangle(p, m_.position[c[0]], m_.position[c[1]], m_.position[c[2]]) - p);
	}

	/// How far the input's vertices in the cells of these faces lie from the nearest of them.
	float farthestFrom(const std::vector<int>& faces) const
	{
		float farthest = 0;
		for (int f : faces) {
			const std::ptrdiff_t num    = cells_.end(f) - cells_.begin(f),
								 stride = 1 + num / mostInCell;
			for (std::ptrdiff_t k = 0; k < num; k += stride) {
				const Vec3f p       = surface_.mesh.position[cells_.begin(f)[k]];
				float       nearest = squaredDistance(p, f);
				for (std::size_t i = 0; i < faces.size() && nearest > farthest; ++i)
					nearest = std::min(nearest, squaredDistance(p, faces[i]));
				farthest = std::max(farthest, nearest);
			}
		}
		return std::sqrt(farthest);
	}

	/// Of the faces' sum.
	Quality patchQuality(const std::vector<int>& faces) const
	{
		Quality sum;
		for (int f : faces)
			addFace(f, sum);
		return sum;
	}

	float meanEdge(int v) const
	{
		float sum = 0;
		int   num = 0;
		forEachNeighbour(m_, v, [&](int w) {
			sum += length(m_.position[w] - m_.position[v]);
			++num;
		});
		return sum / float(num);
	}

	/// A vertex with what moves along.
	struct Place {
		Vec3f        position, normal;
		ResultVertex record;
	};

	Place placeOf(int v) const { return {m_.position[v], normal_[v], r_.vertex[v]}; }

	void put(int v, const Place& p)
	{
		m_.position[v] = p.position;
		normal_[v]     = p.normal;
		r_.vertex[v]   = p.record;
	}

	bool mayMove(int v) const
	{
		const ResultVertex& r = r_.vertex[v];
		if (r.isCorner || r.isPinned || blocked_[v]) return false;
		return m_.isCurveVertex(v) == (r.curve >= 0);
	}

	bool moveToBest(int v)
	{
		if (!mayMove(v)) return false;
		Quality quality = ringQuality(v);
		if (quality.cost == 0) return false;
		const float edge   = meanEdge(v);
		bool        better = false;
		for (float share : stepShares) {
			for (int move = 0; move < mostMoves; ++move) {
				if (!step(v, share * edge, edge, quality)) break;
				better = true;
			}
		}
		if (better) touch(v);
		return better;
	}

	bool step(int v, float reach, float edge, Quality& quality)
	{
		const std::vector<int> faces = facesRound(m_, {v});
		const float            far   = std::max(farthestFrom(faces), farthestOff * edge);
		const Place            start = placeOf(v);
		Place                  best  = start;
		bool                   found = false;
		for (const Place& next : placesRound(v, reach, edge)) {
			put(v, next);
			const Quality q = ringQuality(v);
			if (!q.beats(quality) || farthestFrom(faces) > far) continue;
			quality = q;
			best    = next;
			found   = true;
		}
		put(v, best);
		return found;
	}

	/// Where v gets by a step of this length: along its curve, or over the surface.
	std::vector<Place> placesRound(int v, float reach, float edge) const
	{
		std::vector<Place> places;
		const auto         offer = [&](const ResultVertex& record) {
            const Place place = movedTo(v, record);
            if (isNearStart(v, place, edge)) places.push_back(place);
		};
		if (r_.vertex[v].curve >= 0) {
			offerSlides(v, reach, offer);
			return places;
		}
		for (const Vec3f& direction : compassDirections(r_.vertex[v].normal)) {
			ResultVertex record = r_.vertex[v];
			if (walk(surface_.mesh, record.anchor, direction * reach) != WalkEnd::Arrived) continue;
			record.normal = surface_.mesh.faceNormal(record.anchor.face);
			offer(record);
		}
		return places;
	}

	template <class Offer>
	void offerSlides(int v, float reach, const Offer& offer) const
	{
		const SlideRoom room = slideRoom(r_, curves_, v);
		for (float by : {-reach, reach}) {
			if (reach > longestSlide * (by < 0 ? room.backward : room.forward)) continue;
			if (slideKeepsToCurve(r_, curves_, v, room, by) &&
				slideKeepsSpacing(r_, curves_, v, room, by))
				offer(slid(surface_, curves_, r_.vertex[v], by));
		}
	}

	/// v as high above its anchor as it is now.
	Place movedTo(int v, const ResultVertex& record) const
	{
		const Vec3f offset = m_.position[v] - r_.vertex[v].anchor.position;
		return {record.anchor.position + offset, smoothNormal(surface_, record.anchor), record};
	}

	bool isNearStart(int v, const Place& place, float edge) const
	{
		const Vec3f& normal = startNormal_[v];
		if (dot(place.normal, normal) < leastNormalCosine * length(place.normal) * length(normal))
			return false;
		return length(place.position - start_.mesh.position[v]) <= farthestMove * edge;
	}

	/// How far apart the diagonals of the faces on both sides of h lie.
	float gapOfDiagonals(int h) const
	{
		const int   g = m_.opposite[h];
		const Vec3f a = m_.position[m_.origin[h]], b = m_.position[m_.target(h)];
		const Vec3f c = m_.position[m_.apex(h)], d = m_.position[m_.apex(g)];
		const Vec3f n = normalized(cross(b - a, d - c));
		return std::abs(dot(n, c - a));
	}

	/// Three faces round an inner vertex have an angle of 30° at the most where one is small.
	bool maySpareFace(int v) const { return m_.isBorderVertex(v) || m_.valence(v) > 4; }

	/// Flips h and lets the vertices round it move; keeps that only if it pays together.
	bool flipAndMove(int h)
	{
		if (m_.opposite[h] < 0 || !canFlip(m_, h)) return false;
		if (!maySpareFace(m_.origin[h]) || !maySpareFace(m_.target(h))) return false;
		const std::array<int, 4> corners{m_.origin[h], m_.target(h), m_.apex(h),
										 m_.apex(m_.opposite[h])};
		for (int v : corners) {
			if (blocked_[v]) return false;
		}
		const float edge = meanEdge(corners[0]);
		if (gapOfDiagonals(h) > largestGap * edge) return false;
		const std::vector<int> faces  = facesRound(m_, {corners.begin(), corners.end()});
		const Quality          before = patchQuality(faces);
		const float            far    = std::max(farthestFrom(faces), farthestOff * edge);
		std::array<Place, 4>   places;
		std::array<char, 4>    touched;
		for (int k = 0; k < 4; ++k) {
			places[k]  = placeOf(corners[k]);
			touched[k] = touched_[corners[k]];
		}
		flip(m_, h);
		for (int v : corners)
			moveToBest(v);
		if (patchQuality(faces).beats(before) && farthestFrom(faces) <= far) {
			for (int v : corners)
				touch(v);
			++r_.flipNum;
			return true;
		}
		for (int k = 0; k < 4; ++k) {
			put(corners[k], places[k]);
			touched_[corners[k]] = touched[k];
			changed_.push_back(corners[k]); // flipping back may exchange the faces' numbers
		}
		flip(m_, nextInFace(h));
		return false;
	}
};

} // namespace

bool mendAngles(const Surface& surface, const BoundaryCurves& curves, float angleDeg,
				ResultMesh& result, Workers& workers, std::unique_ptr<Cells> cells)
{
	const float       angle = angleDeg * radians;
	const std::size_t num   = findPoorFaces(result.mesh, angle, workers).size();
	const float       most  = mostPoorShare * float(result.mesh.faceNum);
	if (num == 0 || num > std::max(mostPoor, std::size_t(most))) return true;
	if (cells == nullptr) cells.reset(new Cells(surface, result, workers));
	return AngleMender(surface, curves, angle, result, workers, *cells).run();
}

} // namespace gpr
