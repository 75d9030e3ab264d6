// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "local_search.h"

#include <vcg_extras/core/base/sort_unique.h>
#include <vcg_extras/core/mesh/face_contact.h>
#include <vcg_extras/core/mesh/face_quality.h>
#include <vcg_extras/core/surface/surface_gap.h>

#include <algorithm>
#include <iterator>

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

LocalSearch::LocalSearch(const Surface& surface, const BoundaryCurves& curves,
						 Assignment* assignment, std::int64_t& work, ResultMesh& result,
						 Workers& workers, int spareVertexNum) :
		editor_(surface, curves, result, workers, spareVertexNum),
		m_(result.mesh), assignment_(assignment), workers_(workers), work_(work),
		isChanged_(std::size_t(m_.faceNum) + 2 * std::size_t(spareVertexNum), 0),
		spare_(spareVertexNum)
{
}

// ---- the rounds

bool LocalSearch::run(const Goal& goal)
{
	goal_     = &goal;
	attempts_ = goal.budget.attempts;
	failed_   = FailedAttempts(m_.vertexNum + spare_);

	if (looksForContacts() && boxes_ == nullptr) boxes_.reset(new FaceBoxes(m_, workers_));
	std::vector<int> bad = findBad(goal);
	if (isExhausted()) return bad.empty();
	for (int round = 0; round < goal.budget.rounds && !bad.empty(); ++round) {
		touched_.clear();
		for (int f : worstFirst(bad)) {
			workers_.poll();
			improveAt(f);
			if (isExhausted()) return findBad(goal).empty();
		}
		if (touched_.empty()) break;
		// Only faces bad before, or changed, can be bad now.
		std::vector<int>       candidates;
		const std::vector<int> changed = facesRound(m_, touched_);
		std::sort(bad.begin(), bad.end());
		std::set_union(bad.begin(), bad.end(), changed.begin(), changed.end(),
					   std::back_inserter(candidates));
		const std::size_t before = bad.size();
		bad                      = stillBad(candidates);
		if (float(bad.size()) > goal.budget.maxLeft * float(before)) break;
	}
	return true;
}

bool LocalSearch::isExhausted() const
{
	return attempts_ <= 0 || (goal_->budget.limitsWork && work_ <= 0);
}

std::vector<int> LocalSearch::findBad(const Goal& goal) const
{
	return workers_.collectIf(m_.faceNum,
							  [&](int f) { return !isDeadFace(m_, f) && goal.isBad(f); });
}

std::vector<int> LocalSearch::worstFirst(std::vector<int> faces) const
{
	std::vector<std::pair<float, int>> order;
	for (int f : faces)
		order.push_back({isDeadFace(m_, f) ? 0.0f : -goal_->faceCost(f), f});
	std::sort(order.begin(), order.end());
	for (std::size_t i = 0; i < faces.size(); ++i)
		faces[i] = order[i].second;
	return faces;
}

std::vector<int> LocalSearch::stillBad(const std::vector<int>& faces) const
{
	std::vector<int> bad;
	std::copy_if(faces.begin(), faces.end(), std::back_inserter(bad),
				 [&](int f) { return !isDeadFace(m_, f) && goal_->isBad(f); });
	return bad;
}

void LocalSearch::improveAt(int f)
{
	for (int change = 0; change < maxChanges; ++change) {
		if (isDeadFace(m_, f) || failed_.isKnown(m_, f)) return;
		if (!goal_->isBad(f)) return;
		if (looksForContacts()) lookForIntersections(f);
		--attempts_;
		const bool isBetter = goal_->takesFirst ? takeEach(f) : takeBest(f);
		if (!isBetter) {
			failed_.noteFailure(m_, f);
			return;
		}
		if (isExhausted()) return;
	}
}

/// Keeps each helpful operation in turn.
bool LocalSearch::takeEach(int f)
{
	bool isBetter = false;
	for (const Operation& op : operationsAt(m_, f, goal_->operations)) {
		const std::vector<int> patch = editor_.patchOf(op);
		if (patch.empty() || attempt(op, lookAt(op, patch), 0) == 0) continue;
		keep({op});
		isBetter = true;
		if (!goal_->isBad(f)) break;
	}
	return isBetter;
}

bool LocalSearch::takeBest(int f)
{
	const std::vector<Operation> best = goal_->inPairs ? bestPair(f) : bestSingle(f);
	if (!best.empty()) keep(best);
	return !best.empty();
}

// ---- trials

std::vector<Operation> LocalSearch::bestSingle(int f)
{
	std::vector<Operation> best;
	float                  bestGain = 0;
	for (const Operation& op : operationsAt(m_, f, goal_->operations)) {
		const std::vector<int> patch = editor_.patchOf(op);
		if (patch.empty()) continue;
		float gain = attempt(op, lookAt(op, patch), bestGain);
		if (op.isCollapse()) gain -= goal_->collapseCost;
		if (gain <= bestGain) continue;
		bestGain = gain;
		best     = {op};
	}
	return best;
}

/// Finds the best pair of operations: two in a row may help if no single operation does. The second
/// is at the worst face after the first.
std::vector<Operation> LocalSearch::bestPair(int f)
{
	std::vector<Operation> best;
	float                  bestGain = 0;
	Before                 before   = lookAt(editor_.remember(ringsRound(f, pairRings)));
	for (const Operation& first : operationsAt(m_, f, goal_->operations)) {
		workers_.poll();
		if (make(first)) {
			const int next = worstFirst(facesNow(before)).front();
			for (const Operation& second : operationsAt(m_, next, goal_->operations)) {
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

LocalSearch::Before LocalSearch::lookAt(const Operation& op, const std::vector<int>& patch)
{
	const bool isBareFlip = op.kind == Operation::Flip && !goal_->settles;
	Before     before =
		lookAt(isBareFlip ? editor_.rememberFlip(op.halfEdge) : editor_.remember(patch));
	before.keepsFaces = isBareFlip || op.kind == Operation::Move;
	return before;
}

LocalSearch::Before LocalSearch::lookAt(PatchEditor::Snapshot snapshot)
{
	Before before(std::move(snapshot));
	before.triangles = trianglesOf(m_, before.faces());
	before.cost      = costOf(before.faces());
	before.worst     = worstOf(before.faces());
	for (int v : before.snapshot.backup.vertices())
		before.meanEdge = std::max(before.meanEdge, editor_.meanEdge(v));
	if (limitsGaps()) before.seeds = seedsOf(before.faces());
	if (intersectsHere_) before.intersections = intersectionNum(before.faces());
	work_ -= workOfPatchFace * std::int64_t(before.faces().size());
	return before;
}

/// The fall of cost by an operation; 0 if the operation is refused or gains no more than `known`.
/// The mesh is as before afterwards.
float LocalSearch::attempt(const Operation& op, Before before, float known)
{
	float gain = make(op) ? gainOver(before) : 0;
	if (gain > known && !keepsLimits(before)) gain = 0;
	editor_.undo(before.snapshot);
	return gain;
}

std::vector<int> LocalSearch::facesNow(const Before& before) const
{
	if (before.keepsFaces) return before.faces();
	return facesRound(m_, editor_.patchNow(before.snapshot));
}

float LocalSearch::gainOver(const Before& before)
{
	const std::vector<int> faces = facesNow(before);
	const float            now   = costOf(faces);
	const bool             pays  = now < goal_->maxLeft * before.cost - goal_->minGain;
	return pays && keepsWorst(faces, before.worst) ? before.cost - now : 0;
}

bool LocalSearch::keepsLimits(Before& before)
{
	const std::vector<int> faces = facesNow(before);
	if (before.distance == nullptr)
		before.distance = distanceOf(before.faces(), before.triangles, before.meanEdge);
	if (!keepsDistance(before.distance.get(), faces)) return false;
	if (limitsGaps() && !keepsGap(before, faces)) return false;
	return !goal_->limits.contacts || intersectionNum(faces) <= before.intersections;
}

/// Null if distances are not limited.
std::unique_ptr<PatchDistance> LocalSearch::distanceOf(const std::vector<int>& faces,
													   const Triangles& triangles, float edge)
{
	const Acceptance& limits = goal_->limits;
	if (!(limits.distance < HUGE_VALF) || assignment_ == nullptr) return nullptr;
	const PatchDistance::Settings  settings = {limits.distance * edge, limits.guarded};
	std::unique_ptr<PatchDistance> distance(
		new PatchDistance(*assignment_, faces, triangles, settings));
	work_ -= distance->work();
	return distance;
}

bool LocalSearch::keepsDistance(const PatchDistance* distance, const std::vector<int>& faces)
{
	if (distance == nullptr) return true;
	work_ -= distance->work();
	return distance->isKeptBy(trianglesOf(m_, faces));
}

/// Whether the patch keeps its gap to the surface. Gaps take long to measure, and nearly all trials
/// end earlier. So the gap before the trial is only measured if the new gap is larger than allowed.
bool LocalSearch::keepsGap(const Before& before, const std::vector<int>& faces)
{
	const float allowed = goal_->limits.gap * goal_->limits.gap;
	const float now     = squaredGapOf(trianglesOf(m_, faces), seedsOf(faces), allowed);
	return now <= allowed || now <= squaredGapOf(before.triangles, before.seeds, allowed);
}

std::vector<std::array<int, 3>> LocalSearch::seedsOf(const std::vector<int>& faces) const
{
	const auto below = [&](int h) { return editor_.result().vertex[m_.origin[h]].point.face; };
	std::vector<std::array<int, 3>> seeds;
	for (int f : faces)
		seeds.push_back({below(3 * f), below(3 * f + 1), below(3 * f + 2)});
	return seeds;
}

/// The largest squared gap of the triangles, or `allowed` if no gap is larger.
float LocalSearch::squaredGapOf(const Triangles&                       triangles,
								const std::vector<std::array<int, 3>>& seeds, float allowed)
{
	float largest = allowed;
	for (std::size_t i = 0; i < triangles.size(); ++i)
		largest = gapFromTriangle(editor_.surface().mesh, triangles[i], seeds[i], largest).squared;
	work_ -= workOfGap * std::int64_t(triangles.size());
	return largest;
}

// ---- measures

float LocalSearch::costOf(const std::vector<int>& faces)
{
	work_ -= std::int64_t(faces.size());
	float cost = 0;
	for (int f : faces)
		cost += goal_->faceCost(f);
	if (goal_->contactCost > 0) cost += goal_->contactCost * float(intersectionNum(faces));
	return cost;
}

LocalSearch::Worst LocalSearch::worstOf(const std::vector<int>& faces)
{
	const Acceptance& limits = goal_->limits;
	Worst             worst;
	for (int f : faces) {
		if (limits.agreement > -1) {
			const float own = std::min(editor_.agreement(f), editor_.agreementAtCreases(f));
			worst.agreement = std::min(worst.agreement, own);
			worst.invertedNum += own < 0;
		}
		if (limits.angle > 0) worst.angle = std::min(worst.angle, smallestAngle(m_, f));
	}
	work_ -= 4 * std::int64_t(faces.size());
	return worst;
}

bool LocalSearch::keepsWorst(const std::vector<int>& faces, const Worst& before)
{
	const Acceptance& limits = goal_->limits;
	const Worst       now    = worstOf(faces);
	return now.invertedNum <= before.invertedNum &&
		   now.agreement >= std::min(limits.agreement, before.agreement) &&
		   now.angle >= std::min(limits.angle, before.angle);
}

bool LocalSearch::hasContact(int f) const
{
	return countTouchingPairs(m_, {f}, facesMeeting(boxOfFace(m_, f))) > 0;
}

int LocalSearch::intersectionNum(const std::vector<int>& faces)
{
	std::int64_t pairs = 0;
	const int    num   = countTouchingPairs(m_, faces, near_, &pairs);
	work_ -= workOfPair * pairs + std::int64_t(near_.size());
	return num;
}

void LocalSearch::lookForIntersections(int f)
{
	findNear(f);
	intersectsHere_ =
		goal_->limits.contacts && intersectionNum(facesRound(m_, ringsRound(f, 1))) > 0;
}

/// Finds the faces that a patch round f may intersect.
void LocalSearch::findNear(int f)
{
	const float margin = editor_.meanEdge(m_.origin[3 * f]);
	const Vec3f reach{margin, margin, margin};
	Box<float>  box = boxOfFaces(m_, facesRound(m_, ringsRound(f, 1)));
	box.low         = box.low - reach;
	box.high        = box.high + reach;
	near_           = facesMeeting(box);
	work_ -= std::int64_t(changedFaces_.size() + near_.size());
}

std::vector<int> LocalSearch::facesMeeting(const Box<float>& box) const
{
	std::vector<int> faces = boxes_->meeting(box);
	for (int g : changedFaces_) {
		if (!isDeadFace(m_, g) && boxOfFace(m_, g).meets(box)) faces.push_back(g);
	}
	sortUnique(faces);
	return faces;
}

/// The corners of f and the vertices within ringNum rings round the corners.
std::vector<int> LocalSearch::ringsRound(int f, int ringNum)
{
	std::vector<int> vertices = verticesOf(m_, {f});
	for (int ring = 0; ring < ringNum; ++ring)
		vertices = verticesOf(m_, facesRound(m_, vertices));
	work_ -= workOfPatchFace * std::int64_t(vertices.size());
	return vertices;
}

// ---- changes

bool LocalSearch::make(const Operation& op)
{
	if (op.kind == Operation::Move) return moveToBest(m_.origin[op.halfEdge]);
	if (op.kind == Operation::Flip && goal_->limits.gentleFlips &&
		!(editor_.mayFlip(op.halfEdge) && editor_.isGentleFlip(op.halfEdge)))
		return false;
	const std::vector<int> patch     = editor_.patchOf(op);
	const int              vertexNum = m_.vertexNum;
	if (!editor_.make(op)) return false;
	if (!goal_->settles) return true;
	std::vector<int> left;
	for (int v : patch) {
		if (m_.outgoing[v] >= 0) left.push_back(v);
	}
	for (int v = vertexNum; v < m_.vertexNum; ++v) {
		if (m_.outgoing[v] >= 0) left.push_back(v);
	}
	settle(left);
	return true;
}

void LocalSearch::settle(const std::vector<int>& patch)
{
	for (int pass = 0; pass < settlePasses; ++pass) {
		if (patch.size() > 4) {
			for (int f : facesRound(m_, patch)) {
				for (int h = 3 * f; h < 3 * f + 3; ++h)
					flipIfBetter(h, patch);
			}
		}
		for (int v : patch)
			moveToBest(v);
	}
}

/// patch: ascending.
void LocalSearch::flipIfBetter(int h, const std::vector<int>& patch)
{
	if (m_.opposite[h] < 0) return;
	for (int v : editor_.cornersAt(h)) {
		if (!std::binary_search(patch.begin(), patch.end(), v)) return;
	}
	const std::vector<int> pair = {std::min(h, m_.opposite[h]) / 3,
								   std::max(h, m_.opposite[h]) / 3};
	const float            cost = costOf(pair);
	if (cost == 0 || !editor_.mayFlip(h)) return;
	if (goal_->limits.gentleFlips && !editor_.isGentleFlip(h)) return;
	const Worst before = worstOf(pair);
	editor_.flip(h);
	if (!(costOf(pair) < settleShare * cost && keepsWorst(pair, before))) editor_.flipBack(h);
}

bool LocalSearch::moveToBest(int v)
{
	if (!editor_.mayMove(v, goal_->mayCrowd)) return false;
	float cost = costOf(facesRound(m_, {v}));
	if (cost == 0) return false;
	const float edge   = editor_.meanEdge(v);
	bool        better = false;
	for (float length : goal_->stepLengths) {
		for (int move = 0; move < maxMoves; ++move) {
			if (!stepFrom(v, length * edge, cost)) break;
			better = true;
		}
	}
	return better;
}

/// Moves v by a step to the place with the least cost of its faces; false if no place is better.
bool LocalSearch::stepFrom(int v, float reach, float& cost)
{
	const std::vector<int>         faces = facesRound(m_, {v});
	const PatchEditor::VertexState start = editor_.stateOf(v);
	PatchEditor::VertexState       best  = start;
	bool                           found = false;
	StepLimits before; // measured at the first better place: most steps find none
	work_ -= workOfStep;
	for (const PatchEditor::VertexState& next : editor_.statesAround(v, reach, goal_->mayCrowd)) {
		if (!editor_.isNearStart(v, next, goal_->limits.move, goal_->limits.normalTurn)) continue;
		editor_.put(v, next);
		const float now = costOf(faces);
		if (!(now < settleShare * cost)) continue;
		if (!before.isKnown) {
			editor_.put(v, start);
			before.isKnown  = true;
			before.worst    = worstOf(faces);
			before.distance = distanceOf(faces, trianglesOf(m_, faces), editor_.meanEdge(v));
			editor_.put(v, next);
		}
		if (!keepsWorst(faces, before.worst) || !keepsDistance(before.distance.get(), faces))
			continue;
		cost  = now;
		best  = next;
		found = true;
	}
	editor_.put(v, best);
	return found;
}

// ---- kept operations

std::vector<int> LocalSearch::patchOf(const std::vector<Operation>& ops)
{
	if (ops.size() == 1) return editor_.patchOf(ops.front());
	return ringsRound(ops.front().halfEdge / 3, pairRings);
}

void LocalSearch::keep(const std::vector<Operation>& ops)
{
	const PatchEditor::Snapshot before    = editor_.remember(patchOf(ops));
	const std::vector<int>&     faces     = before.backup.faces();
	const Triangles             triangles = trianglesOf(m_, faces);
	for (const Operation& op : ops) {
		make(op);
		editor_.countDone(op);
	}
	const std::vector<int> patch = editor_.patchNow(before);
	const std::vector<int> now   = facesRound(m_, patch);
	for (std::size_t i = 0; assignment_ != nullptr && i < faces.size(); ++i) {
		if (isDeadFace(m_, faces[i])) assignment_->transfer(faces[i], triangles[i], m_, now);
	}
	note(patch, now);
	++changeNum_;
}

void LocalSearch::note(const std::vector<int>& patch, const std::vector<int>& faces)
{
	failed_.noteChange(m_, patch);
	touched_.insert(touched_.end(), patch.begin(), patch.end());
	for (int f : faces) {
		if (!isChanged_[f]) changedFaces_.push_back(f);
		isChanged_[f] = 1;
	}
}

} // namespace gpr
