// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "verdict.h"

#include <algorithm>
#include <utility>

namespace gpr {

namespace {

/// Beyond so many vertices a few more do not change whether every triangle has an area.
constexpr std::int64_t maxSearchedVertices = 64;
/// Each is a quarter more than the one before, so that the last is about four times the first.
constexpr int maxSearchedCounts = 8;

std::string text(std::int64_t n)
{
	return std::to_string(n);
}

Verdict accept(std::string note = "")
{
	return {Verdict::Kind::Accept, std::move(note), {}, 0};
}

Verdict refuse(std::string why, std::int64_t smallestVertexNum)
{
	return {Verdict::Kind::Refuse, std::move(why), {}, smallestVertexNum};
}

Verdict tryNext(const Attempt& next, std::string note = "")
{
	return {Verdict::Kind::TryNext, std::move(note), next, 0};
}

Verdict withoutFeatureLines(Attempt attempt, const std::string& fault)
{
	attempt.way = Way::WithoutFeatureLines;
	return tryNext(attempt, fault + ", so that there are none.");
}

Verdict withRaggedBorder(Attempt attempt)
{
	attempt.keepsRaggedBorder = true;
	return tryNext(attempt, "With a smooth border some triangles would have no area, so that it is "
							"not made smooth.");
}

Verdict withOpenSeams(Attempt attempt)
{
	attempt.leavesSeamsOpen = true;
	return tryNext(attempt, "With seams sewn some triangles would have no area, so that seams are "
							"left open.");
}

Verdict byTopology(Attempt attempt)
{
	attempt.way = Way::ByTopology;
	return tryNext(attempt);
}

Verdict nearestWithKept(const Request& request, const Attempt& attempt, std::int64_t reached)
{
	if (request.isTargetWish) {
		return accept("The result has " + text(reached) + " vertices instead of " +
					  text(attempt.asked) +
					  ", with those to be kept the nearest that could be reached.");
	}
	return refuse("The surface cannot be meshed with " + text(attempt.asked) +
					  " vertices that include the " + text(request.keptNum) +
					  " to be kept, but with " + text(reached) + ".",
				  reached);
}

Verdict refuseBelow(std::int64_t smallest, const Attempt& attempt)
{
	return refuse("The surface cannot be meshed with " + text(attempt.asked) +
					  " vertices; the smallest possible number is " + text(smallest) + ".",
				  smallest);
}

Verdict raiseTo(std::int64_t smallest, const Attempt& attempt)
{
	return tryNext({Way::WithoutFeatureLines, smallest, smallest, true, 0, 0,
					attempt.keepsRaggedBorder, attempt.leavesSeamsOpen},
				   "The result has " + text(smallest) + " vertices instead of " +
					   text(attempt.asked) + ", the smallest number that could be reached.");
}

/// Whether the number of vertices may differ from what was asked for.
bool mayDiffer(const Request& request)
{
	return request.isTargetWish || !request.exactCount;
}

bool isSearching(const Attempt& attempt)
{
	return attempt.searchedNum > 0;
}

bool leavesRoom(const Outcome& outcome)
{
	return !outcome.hasZeroAreas || outcome.vertexNum > maxSearchedVertices;
}

Verdict beginSearch(const Attempt& attempt, std::int64_t from)
{
	return tryNext({Way::WithoutFeatureLines, from, attempt.asked, attempt.isRaised, from, 1,
					attempt.keepsRaggedBorder, attempt.leavesSeamsOpen});
}

Verdict endSearchAt(const Request& request, const Attempt& attempt, std::int64_t found)
{
	if (found == attempt.asked) return accept();
	if (mayDiffer(request)) {
		return accept("The result has " + text(found) + " vertices instead of " +
					  text(attempt.asked) + ", with which some triangles would have no area.");
	}
	return refuse("With " + text(attempt.asked) +
					  " vertices some triangles would have no area; with " + text(found) +
					  " none has.",
				  found);
}

/// After the last count the first one is taken after all, unless even that is not what was asked
/// for.
Verdict goOnSearching(const Request& request, const Attempt& attempt)
{
	const bool isOver   = attempt.searchedNum == maxSearchedCounts;
	const bool isAnswer = mayDiffer(request) || attempt.searchedFrom == attempt.asked;
	if (isOver && !isAnswer) return refuseBelow(attempt.searchedFrom, attempt);
	Attempt next = attempt;
	next.way     = Way::WithoutFeatureLines;
	++next.searchedNum;
	next.vertexNum += std::max<std::int64_t>(1, attempt.vertexNum / 4);
	if (isOver) next.vertexNum = attempt.searchedFrom;
	return tryNext(next);
}

Verdict judgeAreas(const Request& request, const Attempt& attempt, const Outcome& outcome)
{
	if (!isSearching(attempt)) {
		return leavesRoom(outcome) ? accept() : beginSearch(attempt, outcome.vertexNum);
	}
	if (attempt.searchedNum > maxSearchedCounts) return accept();
	if (!outcome.hasZeroAreas) return endSearchAt(request, attempt, outcome.vertexNum);
	return goOnSearching(request, attempt);
}

/// Topology has the last word on the count: the one that it comes to is the smallest.
Verdict judgeSmallest(const Request& request, const Attempt& attempt, const Outcome& outcome)
{
	if (attempt.isRaised || isSearching(attempt)) return judgeAreas(request, attempt, outcome);
	if (request.isTargetWish) return raiseTo(outcome.vertexNum, attempt);
	if (leavesRoom(outcome)) return refuseBelow(outcome.vertexNum, attempt);
	return beginSearch(attempt, outcome.vertexNum);
}

} // namespace

Attempt firstAttempt(std::int64_t vertexNum)
{
	return {Way::WithFeatureLines, vertexNum, vertexNum, false, 0, 0, false};
}

Verdict judge(const Request& request, const Attempt& attempt, const Outcome& outcome)
{
	const bool misses = request.exactCount && outcome.vertexNum != attempt.vertexNum;
	if (outcome.hasFeatureLines && misses) {
		return withoutFeatureLines(
			attempt, "The number of vertices could not be reached with feature lines");
	}
	if (outcome.hasFeatureLines && outcome.hasZeroAreas) {
		return withoutFeatureLines(attempt, "With feature lines some triangles would have no area");
	}
	if (outcome.hasSmoothBorder && outcome.hasZeroAreas) return withRaggedBorder(attempt);
	if (outcome.isSewn && outcome.hasZeroAreas) return withOpenSeams(attempt);
	if (request.keptNum > 0)
		return misses ? nearestWithKept(request, attempt, outcome.vertexNum) : accept();
	if (!misses) return judgeAreas(request, attempt, outcome);
	if (attempt.way != Way::ByTopology) return byTopology(attempt);
	return judgeSmallest(request, attempt, outcome);
}

} // namespace gpr
