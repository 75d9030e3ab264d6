// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "local_search.h"

#include <vcg_extras/core/mesh/face_contact.h>

#include <algorithm>
#include <iterator>

namespace gpr {

namespace {

/// Most faces to try at the same time, and most faces to look at for these. Both decide the order
/// of changes, so they do not depend on the number of threads.
constexpr std::size_t mostAtOnce = 32, mostLookedAt = 128;

/// Whether operations change single patches only: neither the count nor the assignment.
bool keepCount(const std::vector<Operation::Kind>& kinds)
{
	return std::all_of(kinds.begin(), kinds.end(), [](Operation::Kind kind) {
		return kind == Operation::Move || kind == Operation::Flip;
	});
}

} // namespace

LocalSearch::LocalSearch(const Surface& surface, const BoundaryCurves& curves,
						 Assignment* assignment, std::int64_t& work, ResultMesh& result,
						 Workers& workers, int spareVertexNum) :
		editor_(surface, curves, result, workers, spareVertexNum),
		m_(result.mesh), assignment_(assignment), workers_(workers), work_(work),
		spare_(spareVertexNum)
{
}

bool LocalSearch::run(const Goal& goal)
{
	goal_     = &goal;
	attempts_ = goal.budget.attempts;
	failed_   = FailedAttempts(m_.vertexNum + spare_);

	if (goal.contactCost > 0) takeSpace(); // isBad may look for contacts
	std::vector<int> bad = findBad(goal);
	if (bad.empty() || isExhausted()) return bad.empty();
	if (looksForContacts()) takeSpace();
	for (int round = 0; round < goal.budget.rounds && !bad.empty(); ++round) {
		touched_.clear();
		improveAll(worstFirst(bad));
		if (isExhausted()) return findBad(goal).empty();
		if (touched_.empty()) break;
		// Only faces bad before, or changed, can be bad now.
		std::vector<int>       candidates;
		const std::vector<int> changed = facesRound(m_, touched_);
		std::sort(bad.begin(), bad.end());
		std::set_union(bad.begin(), bad.end(), changed.begin(), changed.end(),
					   std::back_inserter(candidates));
		const std::size_t before = bad.size();
		bad.clear();
		std::copy_if(candidates.begin(), candidates.end(), std::back_inserter(bad),
					 [&](int f) { return !isDeadFace(m_, f) && goal.isBad(f); });
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
	order.reserve(faces.size());
	for (int f : faces)
		order.push_back({isDeadFace(m_, f) ? 0.0f : -goal_->faceCost(f), f});
	std::sort(order.begin(), order.end());
	for (std::size_t i = 0; i < faces.size(); ++i)
		faces[i] = order[i].second;
	return faces;
}

bool LocalSearch::looksForContacts() const
{
	return goal_->limits.contacts || goal_->contactCost > 0;
}

void LocalSearch::takeSpace()
{
	if (space_ == nullptr) space_ = std::make_unique<FacesInSpace>(m_, workers_);
}

bool LocalSearch::hasContact(int f) const
{
	return countTouchingPairs(m_, {f}, space_->near(boxOfFace(m_, f))) > 0;
}

// ---- several faces at the same time

/// Contacts may be with any face, and pairs of operations reach far.
bool LocalSearch::takesSeveral() const
{
	return keepCount(goal_->operations) && !goal_->inPairs && !looksForContacts();
}

bool LocalSearch::mayImprove(int f) const
{
	return !isDeadFace(m_, f) && !failed_.isKnown(m_, f);
}

void LocalSearch::improveAll(const std::vector<int>& faces)
{
	if (takesSeveral() && claims_ == nullptr) claims_.reset(new Claims(m_.vertexNum + spare_));
	std::deque<int> waiting(faces.begin(), faces.end());
	while (!waiting.empty() && !isExhausted()) {
		workers_.poll();
		improve(takeSome(waiting));
	}
}

/// Takes the first faces whose claims do not meet.
LocalSearch::Batch LocalSearch::takeSome(std::deque<int>& waiting)
{
	Batch            batch;
	std::vector<int> later;
	const bool       isSeveral = takesSeveral();
	if (isSeveral) claims_->clear();
	for (std::size_t i = 0; i < mostLookedAt && !waiting.empty() && batch.face.size() < mostAtOnce;
		 ++i) {
		const int f = waiting.front();
		waiting.pop_front();
		if (!mayImprove(f)) continue;
		const int claim = isSeveral ? claims_->claim(m_, f) : Claims::everything;
		if (isSeveral) work_ -= claims_->work();
		const bool isAlone = claim == Claims::everything;
		if (claim == 0 || (isAlone && !batch.face.empty())) {
			later.push_back(f);
		}
		else {
			batch.face.push_back(f);
			batch.claim.push_back(claim);
		}
		if (isAlone) break;
	}
	waiting.insert(waiting.begin(), later.begin(), later.end());
	return batch;
}

void LocalSearch::improve(const Batch& batch)
{
	std::vector<FaceTrials> trials;
	for (int claim : batch.claim) {
		FacesInSpace* space = looksForContacts() ? space_.get() : nullptr;
		trials.emplace_back(TrialRoom{editor_, workers_, assignment_, space, claims_.get(), claim,
									  work_, attempts_},
							*goal_);
	}
	if (trials.size() == 1)
		trials.front().improve(batch.face.front());
	else
		workers_.forTasks(trials.size(),
						  [&](std::size_t i, int) { trials[i].improve(batch.face[i]); });
	const std::int64_t work = work_, attempts = attempts_;
	for (std::size_t i = 0; i < trials.size(); ++i) {
		work_ -= work - trials[i].workLeft();
		attempts_ -= attempts - trials[i].attemptsLeft();
		note(batch.face[i], trials[i]);
	}
}

void LocalSearch::note(int f, const FaceTrials& trials)
{
	for (const FaceTrials::Kept& change : trials.kept()) {
		for (const Operation& op : change.operations)
			editor_.countDone(op);
		work_ -= failed_.noteChange(m_, change.patch);
		touched_.insert(touched_.end(), change.patch.begin(), change.patch.end());
		++changeNum_;
	}
	if (trials.hasFailed()) failed_.noteFailure(m_, f);
}

} // namespace gpr
