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
/// Passes of flips and moves after a split or collapse.
constexpr int settlePasses = 2;
/// On the mean the surface may come to lie this share of the farthest away, or of before.
constexpr float mostRms = 0.5f, mostRmsGrowth = 1.3f;
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

/// Σ(1 - angle / limit)² over the faces below the limit.
double totalLack(const HalfEdgeMesh& m, float angle, Workers& workers)
{
	double sum = 0;
	for (int f : findPoorFaces(m, angle, workers)) {
		const double lack = 1 - double(smallestAngle(m, f)) / angle;
		sum += lack * lack;
	}
	return sum;
}

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

class PatchRemesher : PatchMover {
public:
	PatchRemesher(const Surface& surface, const BoundaryCurves& curves, float angle,
				  ResultMesh& result, Workers& workers, const CellsOfFaces& cells) :
			PatchMover(surface, curves, angle, result, workers, cells, mostTries),
			tries_(m_.vertexNum + mostTries)
	{
	}

	/// Leaves dead faces in the mesh. Returns the number of changes.
	int run()
	{
		std::vector<int> poor = findPoorFaces(m_, angle_, workers_);
		for (int round = 0; round < mostRounds && !poor.empty(); ++round) {
			const int before = changeNum_;
			for (int f : sharpestFirst(m_, poor))
				treat(f);
			if (changeNum_ == before) break;
			poor = findPoorFaces(m_, angle_, workers_);
		}
		return changeNum_;
	}

private:
	int              triesLeft_ = mostTries;
	int              changeNum_ = 0;
	EditScratch      scratch_;
	VainTries        tries_;
	std::vector<int> near_; ///< what the faces round the one that is treated may cross

	void treat(int f)
	{
		if (triesLeft_ == 0 || isDeadFace(m_, f) || smallestAngle(m_, f) >= angle_) return;
		if (tries_.isVain(m_, f)) return;
		workers_.poll();
		--triesLeft_;
		near_ = facesNear(m_, facesRound(m_, patchRound(f)), meanEdge(m_.origin[3 * f]), workers_);
		Operation best;
		float     bestGain = 0;
		for (const Operation& op : operationsAt(f)) {
			const float gain = attempt(op, false);
			if (gain <= bestGain) continue;
			bestGain = gain;
			best     = op;
		}
		if (best.kind == Operation::None) {
			tries_.noteVain(m_, f);
			return;
		}
		attempt(best, true);
		++changeNum_;
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

	/// Makes the change and lets what lies round it settle. Returns by how much that lowers the
	/// cost, 0 where it is refused, and takes it back unless it is to be kept.
	float attempt(const Operation& op, bool keep)
	{
		const int                vertexNum = m_.vertexNum;
		const PatchBackup        backup(m_, patchOf(op));
		const std::vector<Place> places = placesOf(backup.vertices());
		const Quality            before = patchQuality(backup.faces());
		const float              off    = farthestOff * longestMeanEdge(backup.vertices());

		if (!apply(op)) {
			if (m_.vertexNum > vertexNum) takeBack(backup, places);
			return 0;
		}
		std::vector<int> patch = livingOf(backup.vertices());
		if (op.isSplit()) patch.push_back(m_.vertexNum - 1);
		settle(patch);
		if (keep) {
			countChange(op, patch);
			return 0;
		}
		const std::vector<int> faces   = facesRound(m_, patch);
		const Quality          quality = patchQuality(faces);
		if (!(quality.cost < mostLeft * before.cost && quality.beats(before))) {
			takeBack(backup, places);
			return 0;
		}
		const State after = stateOf(faces, backup.faces(), off);
		takeBack(backup, places);
		return mayReplace(after, stateOf(backup.faces(), backup.faces(), off), off)
				   ? before.cost - quality.cost
				   : 0;
	}

	/// How a patch lies on the surface, and among its neighbours.
	struct State {
		Distance distance;
		float    rms;
		int      crossingNum;
	};

	/// Of some faces, by the cells of others.
	State stateOf(const std::vector<int>& faces, const std::vector<int>& ofCells, float off) const
	{
		return {distanceFrom(faces, ofCells, off), rmsFrom(faces, ofCells),
				countCrossingPairs(m_, faces, near_)};
	}

	static bool mayReplace(const State& after, const State& before, float off)
	{
		return after.distance.keeps(before.distance) &&
			   after.rms <= std::max(mostRmsGrowth * before.rms, mostRms * off) &&
			   after.crossingNum <= before.crossingNum;
	}

	std::vector<Place> placesOf(const std::vector<int>& vertices) const
	{
		std::vector<Place> places;
		for (int v : vertices)
			places.push_back(placeOf(v));
		return places;
	}

	void takeBack(const PatchBackup& backup, const std::vector<Place>& places)
	{
		backup.restore(m_);
		r_.vertex.resize(m_.vertexNum);
		for (std::size_t i = 0; i < places.size(); ++i)
			put(backup.vertices()[i], places[i]);
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

	void countChange(const Operation& op, const std::vector<int>& patch)
	{
		for (int v : patch)
			tries_.noteChange(v);
		r_.splitNum += op.isSplit();
		r_.collapseNum += op.kind != Operation::Split;
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

} // namespace

bool remeshPoorPatches(const Surface& surface, const BoundaryCurves& curves, float angleDeg,
					   std::int64_t targetNum, ResultMesh& result, Workers& workers,
					   std::unique_ptr<Cells>& cells, float largestGap)
{
	const float       angle = angleDeg * radians;
	const std::size_t num   = findPoorFaces(result.mesh, angle, workers).size();
	const float       most  = mostPoorShare * float(result.mesh.faceNum);
	if (num == 0 || num > std::max(mostPoor, std::size_t(most))) return false;
	if (cells == nullptr) cells.reset(new Cells(surface, result, workers));
	ResultMesh   before = copyResult(result, workers);
	CellsOfFaces own{*cells, {}, largestGap};
	if (PatchRemesher(surface, curves, angle, result, workers, own).run() == 0) return false;

	const bool isExact = targetNum == 0 || changeCount(surface, curves, targetNum, result, workers);
	own.cell           = cellsAfterCompaction(result.mesh, before.mesh.faceNum);
	compactResult(result, workers);
	if (isExact) {
		mendAngles(surface, curves, angleDeg, result, workers, own);
		if (totalLack(result.mesh, angle, workers) < totalLack(before.mesh, angle, workers) &&
			flippedNum(surface, result, workers) <= flippedNum(surface, before, workers))
			return true;
	}
	result = std::move(before);
	return false;
}

} // namespace gpr
