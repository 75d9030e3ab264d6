// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch_mover.h"

#include "constraint.h"
#include "crease_sides.h"
#include "fold_repair.h"

#include <vcg_extras/core/base/triangle.h>
#include <vcg_extras/core/mesh/face_quality.h>
#include <vcg_extras/core/mesh/mesh_edit.h>
#include <vcg_extras/core/surface/face_tree.h>
#include <vcg_extras/core/surface/normal_agreement.h>
#include <vcg_extras/core/surface/surface_point.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace gpr {

namespace {

/// Angles are wanted this much larger than asked for, so that none ends just below.
constexpr float margin = 1.06f;
/// Moves of a vertex with one step length.
constexpr int mostMoves = 4;
/// Vertices of the input that are looked at in a cell.
constexpr int mostInCell = 256;
/// Lengths of steps, of the mean edge round the vertex.
constexpr float stepShares[] = {0.16f, 0.08f, 0.04f, 0.02f};
/// A vertex of a curve slides at most this share of the way to the next one at once.
constexpr float longestSlide = 0.5f;
/// A vertex ends within this share of that edge from where it was,
constexpr float farthestMove = 0.5f;
/// and where the surface's normal there has at least this cosine with the one before.
constexpr float leastNormalCosine = 0.5f;
/// The diagonals of a flip lie at most this share of an edge apart: so much moves the surface.
constexpr float largestDiagonalGap = 0.5f;
/// Distances above this share of the largest one count singly: a finger's tip must not be cut off
/// because another one beside it is. Smaller ones only count by the largest of them.
constexpr float guardedShare = 0.7f;
/// No face may come to agree less with the surface's normals than this, or than before.
constexpr float leastAgreement = 0.6f;
/// A change must lower the cost to this share.
constexpr float leastGain = 0.995f;

/// Finds how far points lie from some faces, those near each other in a row fast: the face that was
/// the nearest last time is tried first, and mostly is near enough.
class NearestFace {
public:
	NearestFace(const HalfEdgeMesh& m, const std::vector<int>& faces) : m_(m), face_(faces) {}

	/// From the nearest of the faces, or from one that is near enough.
	float squaredDistance(const Vec3f& p, float enough)
	{
		float nearest = face_.empty() ? HUGE_VALF : squaredFrom(face_[last_], p);
		for (std::size_t i = 0; i < face_.size() && nearest > enough; ++i) {
			const float squared = squaredFrom(face_[i], p);
			if (squared >= nearest) continue;
			nearest = squared;
			last_   = i;
		}
		return nearest;
	}

private:
	const HalfEdgeMesh&     m_;
	const std::vector<int>& face_;
	std::size_t             last_ = 0;

	float squaredFrom(int f, const Vec3f& p) const
	{
		const int* c = &m_.origin[3 * f];
		return squaredLength(
			nearestOnTriangle(p, m_.position[c[0]], m_.position[c[1]], m_.position[c[2]]) - p);
	}
};

} // namespace

PatchMover::PatchMover(const Surface& surface, const BoundaryCurves& curves, float angle,
					   ResultMesh& result, Workers& workers, const CellsOfFaces& cells, int spare) :
		surface_(surface),
		curves_(curves), angle_(angle), r_(result), m_(result.mesh), workers_(workers),
		cells_(cells), faceNum_(m_.faceNum), startPosition_(std::size_t(m_.vertexNum + spare)),
		startNormal_(normalsWithoutLips(surface, result, workers)),
		normal_(std::size_t(m_.vertexNum + spare)), blocked_(m_.vertexNum + spare, 0)
{
	reserve(m_, m_.vertexNum + spare, m_.faceNum + 2 * spare);
	startNormal_.resize(normal_.size());
	std::copy(m_.position.data(), m_.position.data() + m_.vertexNum, startPosition_.data());
	resetNormals();
}

void PatchMover::resetNormals()
{
	std::copy(startNormal_.begin(), startNormal_.end(), normal_.begin());
}

bool PatchMover::Quality::beats(const Quality& other) const
{
	return cost < leastGain * other.cost && agreement >= std::min(leastAgreement, other.agreement);
}

void PatchMover::addFace(int f, Quality& sum) const
{
	const float lack = std::max(0.0f, 1 - smallestAngle(m_, f) / (margin * angle_));
	sum.cost += worstFirst_ ? lack * lack * lack * lack : lack * lack;
	sum.agreement = std::min(sum.agreement, faceAgreement(m_, normal_, f));
	if (!m_.hasCreases()) return;
	for (int h = 3 * f; h < 3 * f + 3; ++h)
		sum.agreement = std::min(sum.agreement, creaseAgreement(surface_, curves_, r_, h));
}

PatchMover::Quality PatchMover::ringQuality(int v) const
{
	Quality sum;
	forEachOutgoing(m_, v, [&](int h) { addFace(h / 3, sum); });
	return sum;
}

PatchMover::Quality PatchMover::patchQuality(const std::vector<int>& faces) const
{
	Quality sum;
	for (int f : faces)
		addFace(f, sum);
	return sum;
}

template <class Visit>
void PatchMover::forCellVertices(const std::vector<int>& ofCells, const Visit& visit) const
{
	for (int f : ofCells) {
		// Faces that came in since have no cells of their own.
		const int cell = f < faceNum_ ? cells_.of(f) : -1;
		if (cell >= 0 && !visitCell(cell, visit)) return;
		if (handedOn_.empty()) continue;
		const auto found = handedOn_.find(f);
		if (found == handedOn_.end()) continue;
		for (int other : found->second) {
			if (!visitCell(other, visit)) return;
		}
	}
}

template <class Visit>
bool PatchMover::visitCell(int cell, const Visit& visit) const
{
	const int*           first = cells_.cells.begin(cell);
	const std::ptrdiff_t num   = cells_.cells.end(cell) - first;
	for (std::ptrdiff_t k = 0; k < num; k += 1 + num / mostInCell) {
		if (!visit(surface_.mesh.position[first[k]])) return false;
	}
	return true;
}

void PatchMover::handCellsOn(int dead, int heir)
{
	std::vector<int> cells = std::move(handedOn_[dead]);
	handedOn_.erase(dead);
	if (dead < faceNum_ && cells_.of(dead) >= 0) cells.push_back(cells_.of(dead));
	std::vector<int>& all = handedOn_[heir];
	all.insert(all.end(), cells.begin(), cells.end());
}

float PatchMover::farthestFrom(const std::vector<int>& faces, const std::vector<int>& ofCells) const
{
	NearestFace near(m_, faces);
	float       farthest = 0;
	forCellVertices(ofCells, [&](const Vec3f& p) {
		farthest = std::max(farthest, near.squaredDistance(p, farthest));
		return true;
	});
	return std::sqrt(farthest);
}

bool PatchMover::Distance::keeps(const Distance& before) const
{
	constexpr double rounding = 1e-5;
	return farthest <= before.farthest && fourthPowers <= (1 + rounding) * before.fourthPowers;
}

PatchMover::Distance PatchMover::distanceFrom(const std::vector<int>& faces,
											  const std::vector<int>& ofCells, float enough) const
{
	return distanceFrom(faces, ofCells, enough, {HUGE_VALF, HUGE_VAL});
}

bool PatchMover::keepsDistance(const std::vector<int>& faces, const std::vector<int>& ofCells,
							   float enough, const Distance& before) const
{
	return distanceFrom(faces, ofCells, enough, before).keeps(before);
}

PatchMover::Distance PatchMover::distanceFrom(const std::vector<int>& faces,
											  const std::vector<int>& ofCells, float enough,
											  const Distance& most) const
{
	const bool  countsSingly  = cells_.largestGap > 0;
	const float large         = guardedShare * cells_.largestGap;
	const float squaredEnough = enough * enough;
	NearestFace near(m_, faces);
	Distance    distance = {std::sqrt(squaredEnough), 0};
	float       farthest = squaredEnough;
	forCellVertices(ofCells, [&](const Vec3f& p) {
		// Which face a vertex is near to does not matter where it neither is the farthest nor
		// counts singly, and that is nearly all of them.
		const float irrelevant = countsSingly ? std::min(farthest, large * large) : farthest;
		const float squared    = near.squaredDistance(p, std::max(squaredEnough, irrelevant));
		const float counted    = std::max({squared, squaredEnough, large * large});
		if (countsSingly) distance.fourthPowers += double(counted) * counted;
		if (squared > farthest) {
			farthest          = squared;
			distance.farthest = std::sqrt(squared);
		}
		return distance.keeps(most);
	});
	return distance;
}

float PatchMover::rmsFrom(const std::vector<int>& faces, const std::vector<int>& ofCells) const
{
	NearestFace near(m_, faces);
	float       sum = 0;
	int         num = 0;
	forCellVertices(ofCells, [&](const Vec3f& p) {
		sum += near.squaredDistance(p, 0);
		++num;
		return true;
	});
	return num > 0 ? std::sqrt(sum / float(num)) : 0.0f;
}

float PatchMover::leastAngleOf(const std::vector<int>& faces) const
{
	float least = HUGE_VALF;
	for (int f : faces)
		least = std::min(least, smallestAngle(m_, f));
	return least;
}

float PatchMover::meanEdge(int v) const
{
	float sum = 0;
	int   num = 0;
	forEachNeighbour(m_, v, [&](int w) {
		sum += length(m_.position[w] - m_.position[v]);
		++num;
	});
	return sum / float(num);
}

PatchMover::Place PatchMover::placeOf(int v) const
{
	return {m_.position[v], normal_[v], r_.vertex[v]};
}

Vec3f PatchMover::normalAt(int v, const Anchor& anchor) const
{
	const Vec3f own = smoothNormal(surface_, anchor);
	return m_.isBorderVertex(v) ? withoutLip(m_, normal_, v, own) : own;
}

void PatchMover::put(int v, const Place& p)
{
	m_.position[v] = p.position;
	normal_[v]     = p.normal;
	r_.vertex[v]   = p.record;
}

bool PatchMover::mayMove(int v) const
{
	const ResultVertex& r = r_.vertex[v];
	if (r.isCorner || r.isPinned || blocked_[v]) return false;
	return m_.isCurveVertex(v) == (r.curve >= 0);
}

bool PatchMover::moveToBest(int v)
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
	return better;
}

bool PatchMover::step(int v, float reach, float edge, Quality& quality)
{
	const std::vector<int>  faces  = facesRound(m_, {v});
	const float             enough = farthestOff * edge;
	const Place             start  = placeOf(v);
	std::optional<Distance> before; // measured only where a place is better: most steps find none
	Place                   best  = start;
	bool                    found = false;
	for (const Place& next : placesRound(v, reach, edge)) {
		put(v, next);
		const Quality q = ringQuality(v);
		if (!q.beats(quality)) continue;
		if (!before) {
			put(v, start);
			before = distanceFrom(faces, faces, enough);
			put(v, next);
		}
		if (!keepsDistance(faces, faces, enough, *before)) continue;
		quality = q;
		best    = next;
		found   = true;
	}
	put(v, best);
	return found;
}

template <class Offer>
void PatchMover::offerSlides(int v, float reach, const Offer& offer) const
{
	const SlideRoom room = slideRoom(r_, curves_, v);
	for (float by : {-reach, reach}) {
		if (reach > longestSlide * (by < 0 ? room.backward : room.forward)) continue;
		if (slideKeepsToCurve(r_, curves_, v, room, by) &&
			slideKeepsSpacing(r_, curves_, v, room, by))
			offer(slid(surface_, curves_, r_.vertex[v], by));
	}
}

std::vector<PatchMover::Place> PatchMover::placesRound(int v, float reach, float edge) const
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

PatchMover::Place PatchMover::movedTo(int v, const ResultVertex& record) const
{
	const Vec3f offset = m_.position[v] - r_.vertex[v].anchor.position;
	return {record.anchor.position + offset, normalAt(v, record.anchor), record};
}

bool PatchMover::isNearStart(int v, const Place& place, float edge) const
{
	const Vec3f& normal = startNormal_[v];
	if (dot(place.normal, normal) < leastNormalCosine * length(place.normal) * length(normal))
		return false;
	return length(place.position - startPosition_[v]) <= farthestMove * edge;
}

float PatchMover::gapOfDiagonals(int h) const
{
	const int   g = m_.opposite[h];
	const Vec3f a = m_.position[m_.origin[h]], b = m_.position[m_.target(h)];
	const Vec3f c = m_.position[m_.apex(h)], d = m_.position[m_.apex(g)];
	const Vec3f n = normalized(cross(b - a, d - c));
	return std::abs(dot(n, c - a));
}

bool PatchMover::maySpareFace(int v) const
{
	return m_.isBorderVertex(v) || m_.valence(v) > 4;
}

bool PatchMover::mayFlip(int h) const
{
	if (m_.opposite[h] < 0 || !canFlip(m_, h)) return false;
	if (!maySpareFace(m_.origin[h]) || !maySpareFace(m_.target(h))) return false;
	for (int v : cornersAt(h)) {
		if (blocked_[v]) return false;
	}
	return gapOfDiagonals(h) <= largestDiagonalGap * meanEdge(m_.origin[h]);
}

std::array<int, 4> PatchMover::cornersAt(int h) const
{
	return {m_.origin[h], m_.target(h), m_.apex(h), m_.apex(m_.opposite[h])};
}

} // namespace gpr
