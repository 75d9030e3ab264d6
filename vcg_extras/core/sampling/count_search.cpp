// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "count_search.h"

#include <vcg_extras/core/base/portable_math.h>

#include <algorithm>
#include <cmath>

namespace gpr {

namespace {

/// If more than this share of the area misses the bound, all triangles are too large.
constexpr double mostBeyond = 0.01;
/// With a smaller share, a count missed the bound by chance, and smaller counts may meet the bound.
constexpr double leastShare = 0.001;
/// Growth of the count after a trial that missed the bound, at least, and for the last trial.
/// Single places that miss the bound depend on chance, so that their distances tell little.
constexpr double leastGrowth = 1.15, growthAtLast = 1.5;
/// Wanted share of vertices added at single places.
constexpr double shareToAdd = 0.05;
/// A count is near enough to the smallest if the next count is not below this share.
constexpr double nearEnough = 0.87;
/// The search ends between a count that meets and a count that misses the bound at this quotient.
constexpr double nearCounts = 1.08;
/// Largest change of the count from one trial to the next. After added vertices the count shrinks
/// less: far fewer vertices would miss the bound at very many places.
constexpr double largestGrowth = 4, largestShrink = 3, shrinkAfterAdded = 1.4;
/// The first count is a forecast. It is rarely below half of the needed count, because vertices are
/// added at places that miss the bound.
constexpr double growthAfterForecast = 2;
/// If more than this share of the area misses the bound, the count is far too small: as with thin
/// walls that the triangles are too wide for. The largest change of the count is then larger.
constexpr double       shareOfFarOff = 0.5, growthFromFarOff = 16;
constexpr std::int64_t minCount = 4;

} // namespace

std::int64_t CountSearch::after(std::int64_t asked, const ErrorTrial& t)
{
	--left_;
	const bool meets = t.error <= goal_.largest;
	// Topology needs more vertices than the requested count: no smaller count is possible.
	const bool   isLeast = t.evenNum() > asked || asked <= minCount;
	std::int64_t next    = 0;
	if (meets) {
		if (met_.vertexNum == 0 || t.vertexNum < met_.vertexNum) met_ = t;
		next = isLeast ? 0 : fewerThan(t);
	}
	else {
		if (t.share > leastShare) missed_ = std::max(missed_, t.evenNum());
		next = moreThan(t);
	}
	hasJustMissed_ = !meets;
	return left_ > 0 ? next : 0;
}

std::int64_t CountSearch::clamped(double n) const
{
	const double most = double(goal_.most);
	return std::int64_t(std::max(double(minCount), std::min(std::ceil(n), most)));
}

/// The exponent of the distribution of errors at the bound: a share e^-x misses the bound.
double CountSearch::exponentAtGoal(const ErrorTrial& t) const
{
	const double n = double(t.evenNum());
	if (t.addedNum > 0) return portable::log(double(t.vertexNum) / double(t.addedNum));
	// The largest of n errors.
	return portable::log(std::max(n, 2.0)) * goal_.largest /
		   std::max(t.error, 1e-6 * goal_.largest);
}

/// The next count after a count that met the bound; 0 if the count is near enough to the smallest.
std::int64_t CountSearch::fewerThan(const ErrorTrial& t) const
{
	const double n      = double(t.evenNum());
	const double wanted = n * portable::log(1 / shareToAdd) / exponentAtGoal(t);
	if (wanted >= nearEnough * n) return 0;
	if (missed_ > 0 && n <= nearCounts * double(missed_)) return 0;
	return clamped(std::max({wanted, n / (t.addedNum > 0 ? shrinkAfterAdded : largestShrink),
							 std::sqrt(n * double(missed_))}));
}

/// The next count after a count that missed the bound. If much of the area misses the bound,
/// triangles are too large everywhere: the number of errors falls about exponentially with their
/// size.
std::int64_t CountSearch::moreThan(const ErrorTrial& t) const
{
	const double n = double(t.evenNum());
	if (n == 0 || t.evenNum() >= goal_.most) return 0;
	const double share  = std::min(0.9, std::max(t.share, 1e-12));
	const double byArea = portable::log(mostBeyond) / portable::log(share);
	const double growth = std::max(byArea, leastGrowth);
	if (met_.vertexNum > 0) return between(t, growth);
	// The last trial must meet the bound, even with too many vertices.
	const double atLast  = left_ == 1 ? growthAtLast : 0;
	const bool   isFirst = left_ == goal_.maxTrials - 1;
	const double most    = t.share > shareOfFarOff ? growthFromFarOff
						   : isFirst               ? growthAfterForecast
												   : largestGrowth;
	return clamped(std::min(std::max(growth, atLast), most) * n);
}

/// The next count between two trials. If the last trial missed too, half way: the two counts may be
/// far apart.
std::int64_t CountSearch::between(const ErrorTrial& t, double growth) const
{
	const double low = double(t.evenNum()), high = double(met_.evenNum());
	if (high <= nearCounts * low || high <= low + 1) return 0;
	const double half = std::sqrt(low * high);
	return clamped(hasJustMissed_ ? half : std::min(growth * low, half));
}

} // namespace gpr
