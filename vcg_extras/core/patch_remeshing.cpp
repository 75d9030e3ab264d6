// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch_remeshing.h"

#include "angle_mending.h"
#include "crossing_faces.h"
#include "curve_slide.h"
#include "edge_middle.h"
#include "exact_count.h"
#include "fold_repair.h"
#include "mesh_edit.h"
#include "patch_mover.h"
#include "poor_faces.h"
#include "sort_unique.h"
#include "vain_tries.h"

#include <algorithm>

namespace gpr {

namespace {

/// Rounds over all poor faces.
constexpr int mostRounds = 6;
/// Above so many poor faces, or this share of all, the triangles are too large for the surface.
constexpr std::size_t mostPoor      = 100;
constexpr float       mostPoorShare = 0.001f;
/// Faces that are tried, in all rounds; also the most vertices that come in.
constexpr int mostTries = 200;
/// Two changes in a row are tried where at most so many faces are left poor, for each of them once:
/// it takes some hundred trials.
constexpr std::size_t mostPoorForPairs = 8;
constexpr int         pairTries        = 12;
/// Passes of flips and moves after a split or collapse.
constexpr int settlePasses = 2;
/// On the mean the surface may come to lie this share of the farthest away, or of before.
constexpr float mostRms = 0.5f, mostRmsGrowth = 1.3f;
/// Where faces are taken apart the surface may come to lie this share of an edge away, or as far as
/// before; no face may come to agree less with its normals than this, or than before.
constexpr float farthestApart = 0.1f, leastAgreementApart = 0.3f;
/// A change must leave at most this share of the cost.
constexpr float mostLeft = 0.8f;

/// A change of the number of vertices.
struct Operation {
	/// Attach: split, and the apex collapsed into the new vertex.
	enum Kind { None, Split, Attach, Collapse, CollapseBack } kind = None;
	int halfEdge = -1; ///< collapsed from its origin to its target, or back

	bool isCollapse() const { return kind == Collapse || kind == CollapseBack; }
	bool isSplit() const { return kind == Split || kind == Attach; }
};

/// Faces that look against the surface.
int flippedNum(const Surface& surface, const ResultMesh& result, Workers& workers)
{
	const Buffer<Vec3f> normal = normalsWithoutLips(surface, result, workers);
	return workers.sum<int>(result.mesh.faceNum, [&](std::size_t begin, std::size_t end) {
		int num = 0;
		for (std::size_t f = begin; f < end; ++f)
			num += faceAgreement(result.mesh, normal, int(f)) < 0;
		return num;
	});
}

/// What a mesh is like that has poor angles.
struct Shape {
	double lack;  ///< Σ(1 - angle / limit)² over the faces below the limit
	float  least; ///< angle
	int    flippedNum;

	/// Or is as good, if that is enough.
	bool beats(const Shape& other, bool asGoodWillDo) const
	{
		const bool hasLess = asGoodWillDo ? lack <= other.lack : lack < other.lack;
		return hasLess && least >= other.least && flippedNum <= other.flippedNum;
	}
};

Shape shapeOf(const Surface& surface, const ResultMesh& result, float angle, Workers& workers)
{
	Shape shape = {0, angle, flippedNum(surface, result, workers)};
	for (int f : findPoorFaces(result.mesh, angle, workers)) {
		const float  own  = smallestAngle(result.mesh, f);
		const double lack = 1 - double(own) / angle;
		shape.lack += lack * lack;
		shape.least = std::min(shape.least, own);
	}
	return shape;
}

class PatchRemesher : PatchMover {
public:
	PatchRemesher(const Surface& surface, const BoundaryCurves& curves, float angle,
				  ResultMesh& result, Workers& workers, const CellsOfFaces& cells) :
			PatchMover(surface, curves, angle, result, workers, cells, mostNew),
			tries_(m_.vertexNum + mostNew)
	{
	}

	/// Treats poor faces, then those that cross others, all of them near some vertices. Leaves dead
	/// faces in the mesh. Returns the number of changes.
	int run(const std::vector<int>& crossing, bool inPairs)
	{
		mendPoor(inPairs);
		mendCrossing(crossing, inPairs);
		return changeNum_;
	}

	/// Of the changes, pairs, and those that took faces apart.
	int pairNum() const { return pairNum_; }
	int apartNum() const { return apartNum_; }

private:
	void mendPoor(bool inPairs)
	{
		std::vector<int> poor = findPoorFaces(m_, angle_, workers_);
		for (int round = 0; round < mostRounds && !poor.empty(); ++round) {
			const int before = changeNum_;
			for (int f : sharpestFirst(m_, poor))
				treat(f);
			if (inPairs && changeNum_ == before && poor.size() <= mostPoorForPairs) {
				for (int f : sharpestFirst(m_, poor))
					treatTwice(f);
			}
			if (changeNum_ == before) break;
			poor = findPoorFaces(m_, angle_, workers_);
		}
	}

	void mendCrossing(const std::vector<int>& vertices, bool inPairs)
	{
		isCrossing_ = true;
		pairsLeft_  = pairTries;
		for (int round = 0; round < mostRounds; ++round) {
			const int              before = changeNum_;
			const std::vector<int> faces  = facesRound(m_, livingOf(vertices));
			for (int f : faces)
				treat(f);
			if (inPairs && changeNum_ == before) {
				for (int f : faces)
					treatTwice(f);
			}
			if (changeNum_ == before) break;
		}
	}

	/// A change and two in a row bring in a vertex each.
	static constexpr int mostNew = mostTries + 4 * pairTries;

	/// A patch as it was before a trial.
	struct Before {
		PatchBackup        backup;
		std::vector<Place> places;
		int                vertexNum; ///< of the mesh
		Quality            quality;
		float              off; ///< so far the surface may come to lie from it
		float              leastAngle;
		int                crossingNum; ///< pairs; only counted where faces are taken apart
	};

	/// How a patch lies on the surface, and among its neighbours.
	struct State {
		Distance distance;
		float    rms;
		int      crossingNum;
	};

	int         triesLeft_ = mostTries, pairsLeft_ = pairTries;
	int         changeNum_ = 0, pairNum_ = 0, apartNum_ = 0;
	bool        isCrossing_ = false; ///< what is treated: faces that cross others, or poor ones
	EditScratch scratch_;
	VainTries   tries_;
	std::vector<int> near_; ///< what the faces round the one that is treated may cross

	/// Of crossing faces only near_ tells.
	bool mayNeedTreatment(int f) const
	{
		return !isDeadFace(m_, f) && (isCrossing_ || smallestAngle(m_, f) < angle_);
	}

	bool needsTreatment(int f) const
	{
		return !isCrossing_ || countCrossingPairs(m_, {f}, near_) > 0;
	}

	int kindOfTry(bool isPair) const { return 2 * int(isCrossing_) + int(isPair); }

	void treat(int f)
	{
		if (triesLeft_ == 0 || !mayNeedTreatment(f)) return;
		if (tries_.isVain(m_, f, kindOfTry(false))) return;
		workers_.poll();
		findNear(patchRound(f), f);
		if (!needsTreatment(f)) return;
		--triesLeft_;
		Operation best;
		float     bestGain = 0;
		for (const Operation& op : operationsAt(f)) {
			const float gain = attempt(op, bestGain);
			if (gain <= bestGain) continue;
			bestGain = gain;
			best     = op;
		}
		if (best.kind == Operation::None)
			tries_.noteVain(m_, f, kindOfTry(false));
		else
			keep({best}, patchOf(best));
	}

	/// What no change alone mends two can: the second one at the face that the first one leaves
	/// sharpest.
	void treatTwice(int f)
	{
		if (pairsLeft_ == 0 || !mayNeedTreatment(f)) return;
		if (tries_.isVain(m_, f, kindOfTry(true))) return;
		const std::vector<int> round = withRings(patchRound(f), 2);
		findNear(round, f);
		if (!needsTreatment(f)) return;
		--pairsLeft_;
		const Before           before = remember(round);
		const State            state  = stateOf(before.backup.faces(), before);
		std::vector<Operation> best;
		float                  bestGain = 0;
		for (const Operation& first : operationsAt(f)) {
			workers_.poll();
			if (make(first)) {
				for (const Operation& second : operationsAt(nextFace(f, before))) {
					const float gain = attemptAfter(second, before, state, bestGain);
					if (gain <= bestGain) continue;
					bestGain = gain;
					best     = {first, second};
				}
			}
			takeBack(before);
		}
		if (best.empty())
			tries_.noteVain(m_, f, kindOfTry(true));
		else
			keep(best, round);
	}

	void findNear(const std::vector<int>& patch, int f)
	{
		near_ = facesNear(m_, facesRound(m_, patch), meanEdge(m_.origin[3 * f]), workers_);
	}

	std::vector<int> withRings(std::vector<int> patch, int ringNum) const
	{
		for (int ring = 0; ring < ringNum; ++ring)
			patch = verticesOf(m_, facesRound(m_, patch));
		return patch;
	}

	/// Where the second change is made: at the sharpest face, or at f once more if it still crosses
	/// others, else at the next one that does.
	int nextFace(int f, const Before& before) const
	{
		const std::vector<int> faces = facesRound(m_, patchNow(before));
		if (isCrossing_) {
			if (!isDeadFace(m_, f) && countCrossingPairs(m_, {f}, near_) > 0) return f;
			for (int g : faces) {
				if (countCrossingPairs(m_, {g}, near_) > 0) return g;
			}
		}
		return sharpestFirst(m_, faces).front();
	}

	std::vector<Operation> operationsAt(int f) const
	{
		std::vector<Operation> all;
		for (int h = 3 * f; h < 3 * f + 3; ++h) {
			for (Operation::Kind kind : {Operation::Split, Operation::Attach, Operation::Collapse,
										 Operation::CollapseBack})
				all.push_back({kind, h});
		}
		return all;
	}

	/// All vertices whose faces an operation on f may change.
	std::vector<int> patchRound(int f) const
	{
		std::vector<int> patch;
		for (const Operation& op : operationsAt(f)) {
			const std::vector<int> one = patchOf(op);
			patch.insert(patch.end(), one.begin(), one.end());
		}
		return patch;
	}

	/// The vertices whose faces an operation, and what follows it, may change.
	std::vector<int> patchOf(const Operation& op) const
	{
		const int        h = op.halfEdge;
		std::vector<int> patch;
		if (op.isCollapse()) {
			addStar(op.kind == Operation::Collapse ? m_.origin[h] : m_.target(h), patch);
		}
		else {
			addQuadHalf(h, patch);
			if (m_.opposite[h] >= 0) addQuadHalf(m_.opposite[h], patch);
			if (op.kind == Operation::Attach) addStar(m_.apex(h), patch);
		}
		sortUnique(patch);
		return patch;
	}

	void addStar(int v, std::vector<int>& patch) const
	{
		patch.push_back(v);
		forEachNeighbour(m_, v, [&](int w) { patch.push_back(w); });
	}

	/// The corners of h's face, and those beyond its other edges.
	void addQuadHalf(int h, std::vector<int>& patch) const
	{
		for (int corner = 3 * (h / 3); corner < 3 * (h / 3) + 3; ++corner)
			patch.push_back(m_.origin[corner]);
		for (int side : {nextInFace(h), prevInFace(h)}) {
			if (m_.opposite[side] >= 0) patch.push_back(m_.apex(m_.opposite[side]));
		}
	}

	Before remember(const std::vector<int>& patch) const
	{
		PatchBackup   backup(m_, patch);
		const Quality quality = patchQuality(backup.faces());
		const float   off   = (isCrossing_ ? farthestApart : farthestOff) * longestMeanEdge(patch);
		const float   least = leastAngleOf(backup.faces());
		const int     crossingNum = isCrossing_ ? countCrossingPairs(m_, backup.faces(), near_) : 0;
		return {std::move(backup), placesOf(patch), m_.vertexNum, quality, off, least, crossingNum};
	}

	float leastAngleOf(const std::vector<int>& faces) const
	{
		float least = HUGE_VALF;
		for (int f : faces)
			least = std::min(least, smallestAngle(m_, f));
		return least;
	}

	/// The patch' vertices that are left, and those that came in.
	std::vector<int> patchNow(const Before& before) const
	{
		return livingSince(before.vertexNum, before.backup.vertices());
	}

	std::vector<int> livingSince(int vertexNum, const std::vector<int>& vertices) const
	{
		std::vector<int> patch = livingOf(vertices);
		for (int v = vertexNum; v < m_.vertexNum; ++v) {
			if (m_.outgoing[v] >= 0) patch.push_back(v);
		}
		return patch;
	}

	/// Makes a change and lets what lies round it settle. Where that cannot be, returns false; the
	/// mesh is to be taken back then.
	bool make(const Operation& op)
	{
		const std::vector<int> patch     = patchOf(op);
		const int              vertexNum = m_.vertexNum;
		if (!apply(op)) return false;
		settle(livingSince(vertexNum, patch));
		return true;
	}

	void keep(const std::vector<Operation>& ops, const std::vector<int>& patch)
	{
		const int                vertexNum = m_.vertexNum;
		const std::vector<int>   faces     = facesRound(m_, patch);
		const std::vector<Vec3f> centres   = centresOf(faces);
		for (const Operation& op : ops) {
			make(op);
			r_.splitNum += op.isSplit();
			r_.collapseNum += op.kind != Operation::Split;
		}
		pairNum_ += ops.size() == 2;
		apartNum_ += isCrossing_;
		const std::vector<int> now = livingSince(vertexNum, patch);
		for (int v : now)
			tries_.noteChange(v);
		for (std::size_t i = 0; i < faces.size(); ++i) {
			if (isDeadFace(m_, faces[i]))
				handCellsOn(faces[i], nearestOf(facesRound(m_, now), centres[i]));
		}
		++changeNum_;
	}

	std::vector<Vec3f> centresOf(const std::vector<int>& faces) const
	{
		std::vector<Vec3f> centres;
		for (int f : faces) {
			const int* c = &m_.origin[3 * f];
			centres.push_back((m_.position[c[0]] + m_.position[c[1]] + m_.position[c[2]]) *
							  (1.0f / 3));
		}
		return centres;
	}

	int nearestOf(const std::vector<int>& faces, const Vec3f& p) const
	{
		const std::vector<Vec3f> centres = centresOf(faces);
		const auto               nearer  = [&](const Vec3f& a, const Vec3f& b) {
            return squaredLength(a - p) < squaredLength(b - p);
		};
		return faces[std::size_t(std::min_element(centres.begin(), centres.end(), nearer) -
								 centres.begin())];
	}

	/// By how much a change lowers the cost; 0 where it is refused, or is no more than a gain
	/// known.
	float attempt(const Operation& op, float known)
	{
		const Before before = remember(patchOf(op));
		const float  gain   = make(op) ? gainOver(before) : 0;
		if (gain <= known) {
			takeBack(before);
			return 0;
		}
		const State after = stateOf(facesRound(m_, patchNow(before)), before);
		takeBack(before);
		return mayReplace(after, stateOf(before.backup.faces(), before), before.off) ? gain : 0;
	}

	/// The same of a change that follows on another one, both together.
	float attemptAfter(const Operation& op, const Before& before, const State& state, float known)
	{
		const Before between = remember(patchOf(op));
		float        gain    = make(op) ? gainOver(before) : 0;
		if (gain > known && !mayReplace(before, state)) gain = 0;
		takeBack(between);
		return gain;
	}

	/// 0 where the patch has not got better by far.
	float gainOver(const Before& before) const
	{
		const std::vector<int> faces = facesRound(m_, patchNow(before));
		const Quality          now   = patchQuality(faces);
		if (isCrossing_) return gainApart(faces, now, before);
		if (!(now.cost < mostLeft * before.quality.cost && now.beats(before.quality))) return 0;
		return before.quality.cost - now.cost;
	}

	/// The pairs that cross no more, and where these are as many, the better the shapes the more.
	float gainApart(const std::vector<int>& faces, const Quality& now, const Before& before) const
	{
		if (leastAngleOf(faces) < std::min(angle_, before.leastAngle)) return 0;
		if (now.agreement < std::min(leastAgreementApart, before.quality.agreement)) return 0;
		const int fewer = before.crossingNum - countCrossingPairs(m_, faces, near_);
		return fewer > 0 ? float(fewer) + 0.5f / (1 + now.cost) : 0;
	}

	/// Whether the patch as it is now may replace what was in a state before: the same as below,
	/// but no more is measured than tells.
	bool mayReplace(const Before& before, const State& state) const
	{
		const std::vector<int>  faces   = facesRound(m_, patchNow(before));
		const std::vector<int>& ofCells = before.backup.faces();
		return keepsDistance(faces, ofCells, before.off, state.distance) &&
			   rmsFrom(faces, ofCells) <= mostRmsAfter(state, before.off) &&
			   countCrossingPairs(m_, faces, near_) <= state.crossingNum;
	}

	static float mostRmsAfter(const State& before, float off)
	{
		return std::max(mostRmsGrowth * before.rms, mostRms * off);
	}

	/// Of some faces, by the cells of those that were there before.
	State stateOf(const std::vector<int>& faces, const Before& before) const
	{
		const std::vector<int>& ofCells = before.backup.faces();
		return {distanceFrom(faces, ofCells, before.off), rmsFrom(faces, ofCells),
				countCrossingPairs(m_, faces, near_)};
	}

	static bool mayReplace(const State& after, const State& before, float off)
	{
		return after.distance.keeps(before.distance) && after.rms <= mostRmsAfter(before, off) &&
			   after.crossingNum <= before.crossingNum;
	}

	std::vector<Place> placesOf(const std::vector<int>& vertices) const
	{
		std::vector<Place> places;
		for (int v : vertices)
			places.push_back(placeOf(v));
		return places;
	}

	void takeBack(const Before& before)
	{
		before.backup.restore(m_);
		r_.vertex.resize(m_.vertexNum);
		for (std::size_t i = 0; i < before.places.size(); ++i)
			put(before.backup.vertices()[i], before.places[i]);
	}

	float longestMeanEdge(const std::vector<int>& vertices) const
	{
		float longest = 0;
		for (int v : vertices)
			longest = std::max(longest, meanEdge(v));
		return longest;
	}

	std::vector<int> livingOf(const std::vector<int>& vertices) const
	{
		std::vector<int> living;
		for (int v : vertices) {
			if (m_.outgoing[v] >= 0) living.push_back(v);
		}
		return living;
	}

	// ---- what is tried

	bool apply(const Operation& op)
	{
		const int h = op.halfEdge;
		if (op.kind == Operation::Split) return split(h);
		if (op.kind == Operation::Attach) return attach(h);
		if (m_.opposite[h] < 0) return collapseBorder(h, op.kind == Operation::Collapse);
		return collapseInside(op.kind == Operation::Collapse ? h : m_.opposite[h]);
	}

	bool split(int h)
	{
		const int    a = m_.origin[h], b = m_.target(h);
		ResultVertex middle;
		if (m_.opposite[h] < 0 && r_.keepsBorder) return false;
		const bool found = m_.isCurveEdge(h)
							   ? findMiddleOnCurve(surface_, curves_, r_, a, b, middle)
							   : findMiddle(surface_, r_, a, b, middle);
		if (!found) return false;
		const Vec3f height = (heightOf(a) + heightOf(b)) * 0.5f;
		const int   v      = m_.vertexNum++;
		r_.vertex.push_back(middle);
		m_.position[v] = startPosition_[v] = middle.anchor.position + height;
		if (m_.opposite[h] < 0)
			splitBorderEdge(m_, h, v);
		else
			splitEdge(m_, h, v);
		normal_[v] = startNormal_[v] = normalAt(v, middle.anchor);
		return true;
	}

	/// The apex into the middle of h: what lies between the two is too narrow for a triangle.
	bool attach(int h)
	{
		const int v = m_.apex(h);
		if (!mayGo(v) || !split(h)) return false;
		int toMiddle = -1;
		forEachOutgoing(m_, v, [&](int x) {
			if (m_.target(x) == m_.vertexNum - 1) toMiddle = x;
		});
		return m_.opposite[toMiddle] >= 0 && collapseInside(toMiddle);
	}

	/// How a vertex lies above its anchor.
	Vec3f heightOf(int v) const { return m_.position[v] - r_.vertex[v].anchor.position; }

	bool mayGo(int v) const
	{
		if (r_.vertex[v].isCorner || r_.vertex[v].isPinned) return false;
		return !m_.isCurveVertex(v) || mayLeaveCurve(r_, curves_, v);
	}

	bool collapseBorder(int h, bool forward)
	{
		const int v = forward ? m_.origin[h] : m_.target(h);
		if (r_.keepsBorder || !mayGo(v)) return false;
		if (!canCollapseAlongBorder(m_, v, forward, scratch_)) return false;
		collapseAlongBorder(m_, v, forward);
		return true;
	}

	bool collapseInside(int h)
	{
		if (!mayGo(m_.origin[h])) return false;
		if (!canCollapse(m_, h, scratch_) && !canCollapseAlongCrease(m_, h, scratch_)) return false;
		collapse(m_, h);
		return true;
	}

	void settle(const std::vector<int>& patch)
	{
		std::vector<int> sorted = patch;
		std::sort(sorted.begin(), sorted.end());
		for (int pass = 0; pass < settlePasses; ++pass) {
			for (int f : facesRound(m_, patch)) {
				for (int h = 3 * f; h < 3 * f + 3; ++h)
					flipIfBetter(h, sorted);
			}
			for (int v : patch)
				moveToBest(v);
		}
	}

	void flipIfBetter(int h, const std::vector<int>& patch)
	{
		const int g = m_.opposite[h];
		if (g < 0) return;
		for (int v : cornersAt(h)) {
			if (!std::binary_search(patch.begin(), patch.end(), v)) return;
		}
		const std::vector<int> pair   = {h / 3, g / 3};
		const Quality          before = patchQuality(pair);
		if (before.cost == 0 || !mayFlip(h)) return;
		flip(m_, h);
		if (!patchQuality(pair).beats(before)) flip(m_, nextInFace(h));
	}
};

/// For the faces that compaction leaves, the cells they had before; none if they came in since.
std::vector<int> cellsAfterCompaction(const HalfEdgeMesh& m, int cellNum)
{
	std::vector<int> cell;
	for (int f = 0; f < m.faceNum; ++f) {
		if (!isDeadFace(m, f)) cell.push_back(f < cellNum ? f : -1);
	}
	return cell;
}

/// What a run needs and what came of it.
struct PatchRun {
	const Surface&        surface;
	const BoundaryCurves& curves;
	float                 angleDeg;
	std::int64_t          targetNum;
	const Cells&          cells;
	const LeftOver&       left;
	bool                  isBetter = false;
	int                   pairNum  = 0;

	void run(bool inPairs, const Shape& before, ResultMesh& result, Workers& workers)
	{
		const float   angle = angleDeg * radians;
		const int     old   = result.mesh.faceNum;
		CellsOfFaces  own{cells, {}, left.largestGap};
		PatchRemesher remesher(surface, curves, angle, result, workers, own);
		isBetter = false;
		if (remesher.run(verticesOf(result.mesh, left.crossing), inPairs) == 0) return;
		pairNum = remesher.pairNum();
		const bool isExact =
			targetNum == 0 || changeCount(surface, curves, targetNum, result, workers);
		own.cell = cellsAfterCompaction(result.mesh, old);
		compactResult(result, workers);
		if (!isExact) return;
		mendAngles(surface, curves, angleDeg, result, workers, own);
		isBetter = shapeOf(surface, result, angle, workers).beats(before, remesher.apartNum() > 0);
	}
};

} // namespace

bool remeshPoorPatches(const Surface& surface, const BoundaryCurves& curves, float angleDeg,
					   std::int64_t targetNum, ResultMesh& result, Workers& workers,
					   std::unique_ptr<Cells>& cells, const LeftOver& left)
{
	const float       angle = angleDeg * radians;
	const std::size_t num   = findPoorFaces(result.mesh, angle, workers).size();
	const float       most  = mostPoorShare * float(result.mesh.faceNum);
	if (num == 0 && left.crossing.empty()) return false;
	if (num > std::max(mostPoor, std::size_t(most))) return false;
	if (cells == nullptr) cells.reset(new Cells(surface, result, workers));
	const ResultMesh start = copyResult(result, workers);
	const Shape      shape = shapeOf(surface, result, angle, workers);
	PatchRun         trial = {surface, curves, angleDeg, targetNum, *cells, left};
	for (bool inPairs : {true, false}) {
		trial.run(inPairs, shape, result, workers);
		if (trial.isBetter) return true;
		result = copyResult(start, workers);
		if (trial.pairNum == 0) break;
	}
	return false;
}

} // namespace gpr
