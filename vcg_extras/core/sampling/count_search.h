// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_SAMPLING_COUNT_SEARCH_H
#define VCG_EXTRAS_CORE_SAMPLING_COUNT_SEARCH_H

#include <cstdint>

namespace gpr {

/// A count is looked for whose mesh has an error no larger than this.
struct ErrorGoal {
	double       largest   = 0; ///< mesh units
	std::int64_t start     = 0; ///< count that is tried first
	std::int64_t most      = 0; ///< larger counts are not tried
	int          maxTrials = 5;
};

/// What a trial came to; vertexNum differs from what was asked for where topology needs more, and
/// by what came in at single places.
struct ErrorTrial {
	std::int64_t vertexNum = 0;
	double       error     = 0;
	double       share     = 0; ///< of the area, that is beyond the goal
	double       growth    = 1; ///< what smaller triangles there ask for, over the count
	std::int64_t addedNum  = 0; ///< vertices that came in where the mesh was beyond the goal

	/// Before vertices came in.
	std::int64_t evenNum() const { return vertexNum - addedNum; }
};

/// Looks for the smallest count that meets the goal. Errors are about exponentially distributed,
/// and go with 1 / count: so the share of vertices that came in at single places tells with which
/// count a twentieth would. Fewer triangles with more vertices at single places would be less
/// regular, and hardly fewer in all. A count that meets the goal is lowered to that. A count that
/// misses the goal at few places is tried again with a few percent more, since a trial is expected
/// to make triangles smaller where the trials before it missed the goal. Where more than 1 % of the
/// area misses it, the count is raised so that this much is left.
class CountSearch {
public:
	explicit CountSearch(const ErrorGoal& goal) : goal_(goal), left_(goal.maxTrials) {}

	const ErrorGoal& goal() const { return goal_; }
	/// The count of the first trial.
	std::int64_t first() const { return clamped(double(goal_.start)); }
	/// The count to try after a trial of the count `asked`; 0 where the search is over.
	std::int64_t after(std::int64_t asked, const ErrorTrial& trial);
	/// The least count, without what came in, that met the goal; 0 if none did.
	std::int64_t found() const { return met_.evenNum(); }

private:
	ErrorGoal    goal_;
	int          left_;                  ///< trials
	ErrorTrial   met_;                   ///< vertexNum 0: none
	std::int64_t missed_        = 0;     ///< the largest count that did not
	bool         hasJustMissed_ = false; ///< the trial before

	std::int64_t clamped(double n) const;
	double       exponentAtGoal(const ErrorTrial& trial) const;
	std::int64_t fewerThan(const ErrorTrial& trial) const;
	std::int64_t moreThan(const ErrorTrial& trial) const;
	std::int64_t between(const ErrorTrial& trial, double growth) const;
};

} // namespace gpr

#endif
