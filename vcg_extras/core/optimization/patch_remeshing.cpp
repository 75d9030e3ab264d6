// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch_remeshing.h"

#include "angle_mending.h"
#include "exact_count.h"
#include "fold_repair.h"
#include "patch_changer.h"

#include <vcg_extras/core/mesh/crossing_faces.h>
#include <vcg_extras/core/mesh/face_quality.h>
#include <vcg_extras/core/mesh/mesh_edit.h>
#include <vcg_extras/core/mesh/vain_tries.h>
#include <vcg_extras/core/surface/normal_agreement.h>

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
/// Above so many crossing faces the triangles are larger than the surface is thick.
constexpr std::size_t mostCrossing = 60;
/// On the mean the surface may come to lie this share of the farthest away, or of before.
constexpr float mostRms = 0.5f, mostRmsGrowth = 1.3f;
/// Where faces are taken apart the surface may come to lie this share of an edge away, or as far as
/// before; no face may come to agree less with its normals than this, or than before.
constexpr float farthestApart = 0.1f, leastAgreementApart = 0.3f;
/// A change must leave at most this share of the cost.
constexpr float mostLeft = 0.8f;

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

class PatchRemesher : PatchChanger {
public:
	PatchRemesher(const Surface& surface, const BoundaryCurves& curves, float angle,
				  ResultMesh& result, Workers& workers, const CellsOfFaces& cells) :
			PatchChanger(surface, curves, angle, result, workers, cells, mostNew),
			tries_(m_.vertexNum + mostNew)
	{
	}

	/// Treats poor faces, then those that cross others, or did before edges were flipped. Leaves
	/// dead faces in the mesh. Returns the number of changes.
	int run(const std::vector<int>& crossing, bool inPairs)
	{
		const std::vector<int> vertices = verticesOf(m_, crossing);
		mendPoor(inPairs);
		if (crossing.size() <= mostCrossing) mendCrossing(crossing, vertices, inPairs);
		return changeNum_;
	}

	/// Of the changes, pairs, and those that took faces apart.
	int pairNum() const { return pairNum_; }
	int apartNum() const { return apartNum_; }

private:
	/// Every change may bring in a vertex; pairs are tried for poor faces and for crossing ones.
	static constexpr int mostNew = mostTries + 4 * pairTries;

	/// What a patch was like before a trial.
	struct Before {
		Snapshot snapshot;
		Quality  quality;
		float    off; ///< so far the surface may come to lie from it
		float    leastAngle;
		int      crossingNum; ///< pairs; only counted where faces are taken apart

		const std::vector<int>& faces() const { return snapshot.backup.faces(); }
	};

	/// How a patch lies on the surface, and among its neighbours.
	struct State {
		Distance distance;
		float    rms;
		int      crossingNum;
	};

	int       triesLeft_ = mostTries, pairsLeft_ = pairTries;
	int       changeNum_ = 0, pairNum_ = 0, apartNum_ = 0;
	bool      isCrossing_ = false; ///< what is treated: faces that cross others, or poor ones
	VainTries tries_;
	std::vector<int> near_; ///< what the faces round the one that is treated may cross

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

	/// First these faces, then all round their vertices: changes give faces other numbers.
	void mendCrossing(std::vector<int> faces, const std::vector<int>& vertices, bool inPairs)
	{
		isCrossing_ = true;
		pairsLeft_  = pairTries;
		for (int round = 0; round < mostRounds; ++round) {
			const int before = changeNum_;
			for (int f : faces)
				treat(f);
			if (inPairs && changeNum_ == before) {
				for (int f : faces)
					treatTwice(f);
			}
			if (changeNum_ == before) break;
			faces = facesRound(m_, livingOf(vertices));
		}
	}

	int kindOfTry(bool isPair) const { return 2 * int(isCrossing_) + int(isPair); }

	/// The patch to be changed for f, once it is known what that may cross; empty where f is not to
	/// be treated.
	std::vector<int> takeUp(int f, bool isPair)
	{
		if (isDeadFace(m_, f) || (!isCrossing_ && smallestAngle(m_, f) >= angle_)) return {};
		const int kind = kindOfTry(isPair);
		if (tries_.isVain(m_, f, kind)) return {};
		workers_.poll();
		std::vector<int> patch = patchFor(f, isPair);
		near_ = facesNear(m_, facesRound(m_, patch), meanEdge(m_.origin[3 * f]), workers_);
		if (!isCrossing_ || countCrossingPairs(m_, {f}, near_) > 0) return patch;
		tries_.noteVain(m_, f, kind);
		return {};
	}

	/// All vertices that a change at f may concern, or two in a row.
	std::vector<int> patchFor(int f, bool isPair) const
	{
		std::vector<int> patch = patchRound(f);
		if (!isPair) return patch;
		const std::vector<int> ring = verticesOf(m_, facesRound(m_, patch));
		return verticesOf(m_, facesRound(m_, ring));
	}

	void treat(int f)
	{
		if (triesLeft_ == 0 || takeUp(f, false).empty()) return;
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
		if (pairsLeft_ == 0) return;
		const std::vector<int> round = takeUp(f, true);
		if (round.empty()) return;
		--pairsLeft_;
		const Before           before = lookAt(round);
		const State            state  = stateOf(before);
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
			takeBack(before.snapshot);
		}
		if (best.empty())
			tries_.noteVain(m_, f, kindOfTry(true));
		else
			keep(best, round);
	}

	/// Where the second change is made: at the sharpest face, or at f once more if it still crosses
	/// others, else at the next one that does.
	int nextFace(int f, const Before& before) const
	{
		const std::vector<int> faces = facesNow(before);
		if (isCrossing_) {
			if (!isDeadFace(m_, f) && countCrossingPairs(m_, {f}, near_) > 0) return f;
			for (int g : faces) {
				if (countCrossingPairs(m_, {g}, near_) > 0) return g;
			}
		}
		return sharpestFirst(m_, faces).front();
	}

	Before lookAt(const std::vector<int>& patch) const
	{
		const std::vector<int> faces  = facesRound(m_, patch);
		const float            share  = isCrossing_ ? farthestApart : farthestOff;
		const int              number = isCrossing_ ? countCrossingPairs(m_, faces, near_) : 0;
		return {remember(patch), patchQuality(faces), share * longestMeanEdge(patch),
				leastAngleOf(faces), number};
	}

	void keep(const std::vector<Operation>& ops, const std::vector<int>& patch)
	{
		for (int v : makeForGood(ops, patch))
			tries_.noteChange(v);
		++changeNum_;
		pairNum_ += ops.size() == 2;
		apartNum_ += isCrossing_;
	}

	std::vector<int> facesNow(const Before& before) const
	{
		return facesRound(m_, patchNow(before.snapshot));
	}

	/// By how much a change lowers the cost; 0 where it is refused, or is no more than a gain
	/// known. What lay there before is only measured where a change pays; it is made anew then.
	float attempt(const Operation& op, float known)
	{
		const Before before = lookAt(patchOf(op));
		float        gain   = make(op) ? gainOver(before) : 0;
		takeBack(before.snapshot);
		if (gain <= known) return 0;
		const State state = stateOf(before);
		make(op);
		if (!mayReplace(before, state)) gain = 0;
		takeBack(before.snapshot);
		return gain;
	}

	/// The same of a change that follows on another one, both together.
	float attemptAfter(const Operation& op, const Before& before, const State& state, float known)
	{
		const Snapshot between = remember(patchOf(op));
		float          gain    = make(op) ? gainOver(before) : 0;
		if (gain > known && !mayReplace(before, state)) gain = 0;
		takeBack(between);
		return gain;
	}

	/// 0 where the patch has not got better by far.
	float gainOver(const Before& before) const
	{
		const std::vector<int> faces = facesNow(before);
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

	/// Needs the patch as it was.
	State stateOf(const Before& before) const
	{
		const std::vector<int>& faces = before.faces();
		return {distanceFrom(faces, faces, before.off), rmsFrom(faces, faces),
				countCrossingPairs(m_, faces, near_)};
	}

	/// Whether the patch as it is now may replace what was in that state before. No more is
	/// measured than tells.
	bool mayReplace(const Before& before, const State& state) const
	{
		const std::vector<int>  faces   = facesNow(before);
		const std::vector<int>& ofCells = before.faces();
		return keepsDistance(faces, ofCells, before.off, state.distance) &&
			   rmsFrom(faces, ofCells) <=
				   std::max(mostRmsGrowth * state.rms, mostRms * before.off) &&
			   countCrossingPairs(m_, faces, near_) <= state.crossingNum;
	}

	float longestMeanEdge(const std::vector<int>& vertices) const
	{
		float longest = 0;
		for (int v : vertices)
			longest = std::max(longest, meanEdge(v));
		return longest;
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

/// One go at a mesh, from how it is to how it is with the count made good.
struct PatchRun {
	const Surface&        surface;
	const BoundaryCurves& curves;
	float                 angleDeg;
	std::int64_t          targetNum;
	const Cells&          cells;
	const LeftOver&       left;
	const ResultMesh&     start;
	bool                  isChanged = false, isBetter = false, hasPairs = false;

	void run(bool inPairs, ResultMesh& result, Workers& workers)
	{
		const float   angle = angleDeg * radians;
		CellsOfFaces  own{cells, {}, left.largestGap};
		PatchRemesher remesher(surface, curves, angle, result, workers, own);
		isChanged = remesher.run(left.crossing, inPairs) > 0;
		hasPairs  = remesher.pairNum() > 0;
		if (!isChanged) return;
		const bool isExact =
			targetNum == 0 || changeCount(surface, curves, targetNum, result, workers);
		own.cell = cellsAfterCompaction(result.mesh, start.mesh.faceNum);
		compactResult(result, workers);
		if (!isExact) return;
		mendAngles(surface, curves, angleDeg, result, workers, own);
		isBetter = shapeOf(surface, result, angle, workers)
					   .beats(shapeOf(surface, start, angle, workers), remesher.apartNum() > 0);
	}
};

} // namespace

bool remeshPoorPatches(const Surface& surface, const BoundaryCurves& curves, float angleDeg,
					   std::int64_t targetNum, ResultMesh& result, Workers& workers,
					   std::unique_ptr<Cells>& cells, const LeftOver& left)
{
	const std::size_t num  = findPoorFaces(result.mesh, angleDeg * radians, workers).size();
	const float       most = mostPoorShare * float(result.mesh.faceNum);
	if (num == 0 && left.crossing.empty()) return false;
	if (num > std::max(mostPoor, std::size_t(most))) return false;
	if (cells == nullptr) cells.reset(new Cells(surface, result, workers));
	const ResultMesh start = copyResult(result, workers);
	for (bool inPairs : {true, false}) {
		PatchRun trial = {surface, curves, angleDeg, targetNum, *cells, left, start};
		trial.run(inPairs, result, workers);
		if (trial.isBetter) return true;
		if (trial.isChanged) result = copyResult(start, workers);
		if (!trial.hasPairs) break;
	}
	return false;
}

} // namespace gpr
