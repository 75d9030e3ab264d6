// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "face_trials.h"

#include <vcg_extras/core/mesh/face_contact.h>
#include <vcg_extras/core/mesh/face_quality.h>
#include <vcg_extras/core/surface/surface_gap.h>

#include <algorithm>

namespace gpr {

namespace {

/// The most changes at a face before the next face has its turn.
constexpr int maxChanges = 6;
/// Passes of flips and moves after a change; a third pass finds next to nothing.
constexpr int settlePasses = 2;
/// Rings round a face that two operations in a row may change: twice the reach of an operation with
/// its settling.
constexpr int pairRings = 3;
/// A settling step must lower the cost to this share: less gain is not worth a step.
constexpr float settleShare = 0.995f;
/// Work of four actions: collecting, remembering and restoring a face of a patch; finding the
/// places of a step; testing a pair of faces for an intersection; measuring the gap of a face. By
/// measurement, a unit of work takes 8 to 40 ns on all models.
constexpr std::int64_t workOfPatchFace = 10, workOfStep = 50, workOfPair = 3, workOfGap = 15;
/// Moves of a vertex with one step length.
constexpr int maxMoves = 4;

} // namespace

// ---- trials

void FaceTrials::improve(int f)
{
	for (int change = 0; change < maxChanges; ++change) {
		if (isDeadFace(m_, f) || !goal_.isBad(f)) return;
		--room_.attempts;
		hasFailed_ = !(goal_.takesFirst ? takeEach(f) : takeBest(f));
		if (hasFailed_ || isExhausted()) return;
	}
}

bool FaceTrials::isExhausted() const
{
	return room_.attempts <= 0 || (goal_.budget.limitsWork && room_.work <= 0);
}

/// Whether an operation with this patch is possible and changes no claim of other trials.
bool FaceTrials::mayChange(const std::vector<int>& patch) const
{
	return !patch.empty() && (room_.claims == nullptr || room_.claims->allow(room_.claim, patch));
}

/// Keeps each helpful operation in turn.
bool FaceTrials::takeEach(int f)
{
	bool isBetter = false;
	for (const Operation& op : operationsAt(m_, f, goal_.operations)) {
		const std::vector<int> patch = editor_.patchOf(op);
		if (!mayChange(patch) || attempt(op, lookAt(op, patch), 0) == 0) continue;
		keep({op});
		isBetter = true;
		if (!goal_.isBad(f)) break;
	}
	return isBetter;
}

bool FaceTrials::takeBest(int f)
{
	const std::vector<Operation> best = goal_.inPairs ? bestPair(f) : bestSingle(f);
	if (!best.empty()) keep(best);
	return !best.empty();
}

std::vector<Operation> FaceTrials::bestSingle(int f)
{
	std::vector<Operation> best;
	float                  bestGain = 0;
	for (const Operation& op : operationsAt(m_, f, goal_.operations)) {
		const std::vector<int> patch = editor_.patchOf(op);
		if (!mayChange(patch)) continue;
		float gain = attempt(op, lookAt(op, patch), bestGain);
		if (op.isCollapse()) gain -= goal_.collapseCost;
		if (gain <= bestGain) continue;
		bestGain = gain;
		best     = {op};
	}
	return best;
}

/// The first face with the largest cost. faces: ascending, at least one.
int FaceTrials::costliest(const std::vector<int>& faces) const
{
	return *std::max_element(faces.begin(), faces.end(),
							 [&](int f, int g) { return goal_.faceCost(f) < goal_.faceCost(g); });
}

/// Finds the best pair of operations: two in a row may help if no single operation does. The second
/// is at the worst face after the first.
std::vector<Operation> FaceTrials::bestPair(int f)
{
	std::vector<Operation> best;
	float                  bestGain = 0;
	Before                 before   = lookAt(editor_.remember(ringsRound(f, pairRings)));
	for (const Operation& first : operationsAt(m_, f, goal_.operations)) {
		room_.workers.poll();
		if (make(first)) {
			const int next = costliest(facesNow(before));
			for (const Operation& second : operationsAt(m_, next, goal_.operations)) {
				const PatchEditor::Snapshot between = editor_.remember(editor_.patchOf(second));
				float                       gain    = make(second) ? gainOver(before) : 0;
				if (gain > bestGain && !keepsLimits(before)) gain = 0;
				editor_.undo(between);
				if (gain <= bestGain) continue;
				bestGain = gain;
				best     = {first, second};
			}
		}
		editor_.undo(before.snapshot);
	}
	return best;
}

FaceTrials::Before FaceTrials::lookAt(const Operation& op, const std::vector<int>& patch)
{
	const bool isBareFlip = op.kind == Operation::Flip && !goal_.settles;
	Before     before =
		lookAt(isBareFlip ? editor_.rememberFlip(op.halfEdge) : editor_.remember(patch));
	before.keepsFaces = isBareFlip || op.kind == Operation::Move;
	return before;
}

FaceTrials::Before FaceTrials::lookAt(PatchEditor::Snapshot snapshot)
{
	Before before(std::move(snapshot));
	before.triangles = trianglesOf(m_, before.faces());
	before.cost      = costOf(before.faces());
	before.worst     = worstOf(before.faces());
	for (int v : before.snapshot.backup.vertices())
		before.meanEdge = std::max(before.meanEdge, editor_.meanEdge(v));
	if (limitsGaps()) before.seeds = seedsOf(before.faces());
	room_.work -= workOfPatchFace * std::int64_t(before.faces().size());
	return before;
}

/// The fall of cost by an operation; 0 if the operation is refused or gains no more than `known`.
/// The mesh is as before afterwards.
float FaceTrials::attempt(const Operation& op, Before before, float known)
{
	float gain = make(op) ? gainOver(before) : 0;
	if (gain > known && !keepsLimits(before)) gain = 0;
	const bool isLimited = goal_.limits.contacts && gain > known;
	const int  contacts  = isLimited ? contactNum(facesNow(before)) : 0;
	editor_.undo(before.snapshot);
	// Nearly all changes leave no contacts, so those before are only counted if some are left.
	return contacts > 0 && contacts > contactNum(before.faces()) ? 0 : gain;
}

std::vector<int> FaceTrials::facesNow(const Before& before) const
{
	if (before.keepsFaces) return before.faces();
	return facesRound(m_, editor_.patchNow(before.snapshot));
}

float FaceTrials::gainOver(const Before& before)
{
	const std::vector<int> faces = facesNow(before);
	const float            now   = costOf(faces);
	const bool             pays  = now < goal_.maxLeft * before.cost - goal_.minGain;
	return pays && keepsWorst(faces, before.worst) ? before.cost - now : 0;
}

bool FaceTrials::keepsLimits(Before& before)
{
	const std::vector<int> faces = facesNow(before);
	if (before.distance == nullptr)
		before.distance = distanceOf(before.faces(), before.triangles, before.meanEdge);
	if (!keepsDistance(before.distance.get(), faces)) return false;
	return !limitsGaps() || keepsGap(before, faces);
}

/// Null if distances are not limited.
std::unique_ptr<PatchDistance> FaceTrials::distanceOf(const std::vector<int>& faces,
													  const Triangles& triangles, float edge)
{
	const Acceptance& limits = goal_.limits;
	if (!(limits.distance < HUGE_VALF) || room_.assignment == nullptr) return nullptr;
	auto distance = std::make_unique<PatchDistance>(*room_.assignment, faces, triangles,
													limits.distance * edge, limits.guarded);
	room_.work -= distance->work();
	return distance;
}

bool FaceTrials::keepsDistance(const PatchDistance* distance, const std::vector<int>& faces)
{
	if (distance == nullptr) return true;
	room_.work -= distance->work();
	return distance->isKeptBy(trianglesOf(m_, faces));
}

/// Whether the patch keeps its gap to the surface. Gaps take long to measure, and nearly all trials
/// end earlier. So the gap before the trial is only measured if the new gap is larger than allowed.
bool FaceTrials::keepsGap(const Before& before, const std::vector<int>& faces)
{
	const float allowed = goal_.limits.gap * goal_.limits.gap;
	const float now     = squaredGapOf(trianglesOf(m_, faces), seedsOf(faces), allowed);
	return now <= allowed || now <= squaredGapOf(before.triangles, before.seeds, allowed);
}

std::vector<std::array<int, 3>> FaceTrials::seedsOf(const std::vector<int>& faces) const
{
	const auto below = [&](int h) { return editor_.result().vertex[m_.origin[h]].point.face; };
	std::vector<std::array<int, 3>> seeds;
	seeds.reserve(faces.size());
	for (int f : faces)
		seeds.push_back({below(3 * f), below(3 * f + 1), below(3 * f + 2)});
	return seeds;
}

/// The largest squared gap of the triangles, or `allowed` if no gap is larger.
float FaceTrials::squaredGapOf(const Triangles&                       triangles,
							   const std::vector<std::array<int, 3>>& seeds, float allowed)
{
	float largest = allowed;
	for (std::size_t i = 0; i < triangles.size(); ++i)
		largest = gapFromTriangle(editor_.surface().mesh, triangles[i], seeds[i], largest).squared;
	room_.work -= workOfGap * std::int64_t(triangles.size());
	return largest;
}

// ---- measures

float FaceTrials::costOf(const std::vector<int>& faces)
{
	room_.work -= std::int64_t(faces.size());
	float cost = 0;
	for (int f : faces)
		cost += goal_.faceCost(f);
	if (goal_.contactCost > 0) cost += goal_.contactCost * float(contactNum(faces));
	return cost;
}

FaceTrials::Worst FaceTrials::worstOf(const std::vector<int>& faces)
{
	const Acceptance& limits = goal_.limits;
	Worst             worst;
	for (int f : faces) {
		if (limits.agreement > -1) {
			const float own = std::min(editor_.agreement(f), editor_.agreementAtCreases(f));
			worst.agreement = std::min(worst.agreement, own);
			worst.invertedNum += own < 0;
		}
		if (limits.angle > 0) worst.angle = std::min(worst.angle, smallestAngle(m_, f));
	}
	room_.work -= 4 * std::int64_t(faces.size());
	return worst;
}

bool FaceTrials::keepsWorst(const std::vector<int>& faces, const Worst& before)
{
	const Acceptance& limits = goal_.limits;
	const Worst       now    = worstOf(faces);
	return now.invertedNum <= before.invertedNum &&
		   now.agreement >= std::min(limits.agreement, before.agreement) &&
		   now.angle >= std::min(limits.angle, before.angle);
}

int FaceTrials::contactNum(const std::vector<int>& faces)
{
	room_.workers.poll();
	const std::vector<int> near  = room_.space->near(boxOfFaces(m_, faces));
	std::int64_t           pairs = 0;
	const int              num   = countTouchingPairs(m_, faces, near, &pairs);
	room_.work -= workOfPair * pairs + std::int64_t(near.size());
	return num;
}

/// The corners of f and the vertices within ringNum rings round the corners.
std::vector<int> FaceTrials::ringsRound(int f, int ringNum)
{
	std::vector<int> vertices = verticesOf(m_, widened(m_, {f}, ringNum));
	room_.work -= workOfPatchFace * std::int64_t(vertices.size());
	return vertices;
}

// ---- changes

bool FaceTrials::make(const Operation& op)
{
	if (op.kind == Operation::Move) return moveToBest(m_.origin[op.halfEdge]);
	if (op.kind == Operation::Flip && goal_.limits.gentleFlips &&
		!(editor_.mayFlip(op.halfEdge) && editor_.isGentleFlip(op.halfEdge)))
		return false;
	const std::vector<int> patch     = editor_.patchOf(op);
	const int              vertexNum = m_.vertexNum;
	if (!(goal_.make ? goal_.make(op) : editor_.make(op))) return false;
	if (goal_.settles) settle(editor_.patchNow(patch, vertexNum));
	return true;
}

void FaceTrials::settle(const std::vector<int>& patch)
{
	int              changeNum = 0;
	std::vector<int> failedAt(patch.size(), -1); // changes before the last move that failed
	for (int pass = 0; pass < settlePasses; ++pass) {
		const int before = changeNum;
		if (patch.size() > 4) {
			for (int f : facesRound(m_, patch)) {
				for (int h = 3 * f; h < 3 * f + 3; ++h)
					changeNum += flipIfBetter(h, patch);
			}
		}
		for (std::size_t i = 0; i < patch.size(); ++i) {
			if (failedAt[i] == changeNum) continue; // nothing is new for this vertex
			if (moveToBest(patch[i]))
				++changeNum;
			else
				failedAt[i] = changeNum;
		}
		if (changeNum == before) return;
	}
}

/// Returns whether h was flipped. patch: ascending.
bool FaceTrials::flipIfBetter(int h, const std::vector<int>& patch)
{
	if (m_.opposite[h] < 0) return false;
	for (int v : editor_.cornersAt(h)) {
		if (!std::binary_search(patch.begin(), patch.end(), v)) return false;
	}
	const std::vector<int> pair = {std::min(h, m_.opposite[h]) / 3,
								   std::max(h, m_.opposite[h]) / 3};
	const float            cost = costOf(pair);
	if (cost == 0 || !editor_.mayFlip(h)) return false;
	if (goal_.limits.gentleFlips && !editor_.isGentleFlip(h)) return false;
	const Worst before = worstOf(pair);
	editor_.flip(h);
	if (costOf(pair) < settleShare * cost && keepsWorst(pair, before)) return true;
	editor_.flip(nextInFace(h));
	return false;
}

bool FaceTrials::moveToBest(int v)
{
	if (!editor_.mayMove(v, goal_.mayCrowd)) return false;
	float cost = costOf(facesRound(m_, {v}));
	if (cost == 0) return false;
	const float edge   = editor_.meanEdge(v);
	bool        better = false;
	for (float length : goal_.stepLengths) {
		for (int move = 0; move < maxMoves; ++move) {
			if (!stepFrom(v, length * edge, cost)) break;
			better = true;
		}
	}
	return better;
}

/// Moves v by a step to the place with the least cost of its faces; false if no place is better.
bool FaceTrials::stepFrom(int v, float reach, float& cost)
{
	const std::vector<int>         faces = facesRound(m_, {v});
	const PatchEditor::VertexState start = editor_.stateOf(v);
	PatchEditor::VertexState       best  = start;
	bool                           found = false;
	std::optional<StepLimits> before; // measured at the first better place: most steps find none
	room_.work -= workOfStep;
	for (const PatchEditor::VertexState& next : editor_.statesAround(v, reach, goal_.mayCrowd)) {
		if (!editor_.isNearStart(v, next, goal_.limits.move, goal_.limits.normalTurn)) continue;
		editor_.put(v, next);
		const float now = costOf(faces);
		if (!(now < settleShare * cost)) continue;
		if (!before) {
			editor_.put(v, start);
			before = {worstOf(faces),
					  distanceOf(faces, trianglesOf(m_, faces), editor_.meanEdge(v))};
			editor_.put(v, next);
		}
		if (!keepsWorst(faces, before->worst) || !keepsDistance(before->distance.get(), faces))
			continue;
		cost  = now;
		best  = next;
		found = true;
	}
	editor_.put(v, best);
	return found;
}

// ---- kept operations

std::vector<int> FaceTrials::patchOf(const std::vector<Operation>& ops)
{
	if (ops.size() == 1) return editor_.patchOf(ops.front());
	return ringsRound(ops.front().halfEdge / 3, pairRings);
}

void FaceTrials::keep(const std::vector<Operation>& ops)
{
	const PatchEditor::Snapshot before    = editor_.remember(patchOf(ops));
	const std::vector<int>&     faces     = before.backup.faces();
	const Triangles             triangles = trianglesOf(m_, faces);
	for (const Operation& op : ops)
		make(op);
	const std::vector<int> patch = editor_.patchNow(before);
	const std::vector<int> now   = facesRound(m_, patch);
	for (std::size_t i = 0; room_.assignment != nullptr && i < faces.size(); ++i) {
		if (isDeadFace(m_, faces[i])) room_.assignment->transfer(faces[i], triangles[i], m_, now);
	}
	if (room_.space != nullptr) room_.space->follow(now);
	kept_.push_back({ops, patch});
}

} // namespace gpr
