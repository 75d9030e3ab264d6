// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_SAMPLING_COUNT_SEARCH_H
#define VCG_EXTRAS_CORE_SAMPLING_COUNT_SEARCH_H

#include <cstdint>

namespace gpr {

/// The error bound of a search for a count, and its limits.
struct ErrorGoal {
	double       largest   = 0; ///< mesh units
	std::int64_t start     = 0; ///< the first count to try
	std::int64_t most      = 0; ///< the largest count to try
	int          maxTrials = 5;
};

/// The outcome of a trial. vertexNum differs from the requested count if topology needs more
/// vertices, and by the vertices added at single places.
struct ErrorTrial {
	std::int64_t vertexNum = 0;
	double       error     = 0;
	double       share     = 0; ///< of the area that misses the error bound
	std::int64_t addedNum  = 0; ///< vertices added where the mesh missed the bound

	/// The number without added vertices.
	std::int64_t evenNum() const { return vertexNum - addedNum; }
};

/// Searches for the smallest count whose mesh meets the error bound. Errors follow about an
/// exponential distribution and scale with 1 / count. So the share of vertices added at single
/// places tells the count with a share of a twentieth. A smaller count with more added vertices
/// would be less regular, and hardly smaller in all.
///
/// A count that meets the bound is lowered to this share. A count that misses the bound at few
/// places is raised a little: samples lie elsewhere in the next trial. If more than 1 % of
/// the area misses the bound, the count is raised until 1 % is left.
class CountSearch {
public:
	explicit CountSearch(const ErrorGoal& goal) : goal_(goal), left_(goal.maxTrials) {}

	/// The count of the first trial.
	std::int64_t first() const { return clamped(double(goal_.start)); }
	/// The count to try after a trial of the count `asked`; 0 if the search is over.
	std::int64_t after(std::int64_t asked, const ErrorTrial& trial);
	/// The smallest count that met the bound, without added vertices; 0 if none did.
	std::int64_t found() const { return met_.evenNum(); }

private:
	ErrorGoal    goal_;
	int          left_;                  ///< trials
	ErrorTrial   met_;                   ///< vertexNum 0: none
	std::int64_t missed_        = 0;     ///< the largest count that missed the bound, not by chance
	bool         hasJustMissed_ = false; ///< whether the last trial missed the bound

	std::int64_t clamped(double n) const;
	double       exponentAtGoal(const ErrorTrial& trial) const;
	std::int64_t fewerThan(const ErrorTrial& trial) const;
	std::int64_t moreThan(const ErrorTrial& trial) const;
	std::int64_t between(const ErrorTrial& trial, double growth) const;
};

} // namespace gpr

#endif
