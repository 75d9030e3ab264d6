// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "count_search.h"

#include <vcg_extras/core/base/portable_math.h>

#include <algorithm>
#include <cmath>

namespace gpr {

namespace {

/// Share of the area that may be too far from the result if only the triangles at these places are
/// to become smaller. Where more is too far, all triangles are too large.
constexpr double shareForSpots = 0.01;
/// Beyond what would do if the error went with 1 / count, in the last trial.
constexpr double lastCaution = 1.15;
/// What the finer places themselves need.
constexpr double leastGrowth = 1.03;
/// Share of the vertices that shall come in at single places.
constexpr double shareToAdd = 0.05;
/// A count that would be lowered to no less than this is near enough to the smallest.
constexpr double nearEnough = 0.87;
/// Counts of which one meets the goal and one does not are near enough at this quotient.
constexpr double nearCounts = 1.08;
/// A count tried is at most so many times the last one, or its inverse.
constexpr double       largestGrowth = 4, largestShrink = 3;
constexpr std::int64_t minCount = 4;

} // namespace

std::int64_t CountSearch::after(std::int64_t asked, const ErrorTrial& t)
{
	--left_;
	const bool meets = t.error <= goal_.largest;
	// Topology needs more than what was asked for: there is nothing below.
	const bool   isLeast = t.evenNum() > asked || asked <= minCount;
	std::int64_t next    = 0;
	if (meets) {
		if (met_.vertexNum == 0 || t.vertexNum < met_.vertexNum) met_ = t;
		next = isLeast ? 0 : fewerThan(t);
	}
	else {
		missed_ = std::max(missed_, t.evenNum());
		next    = moreThan(t);
	}
	hasJustMissed_ = !meets;
	return left_ > 0 ? next : 0;
}

std::int64_t CountSearch::clamped(double n) const
{
	const double most = double(goal_.most);
	return std::int64_t(std::max(double(minCount), std::min(std::ceil(n), most)));
}

/// The exponent of the errors' distribution at the goal: the share that is beyond it is e^-x.
double CountSearch::exponentAtGoal(const ErrorTrial& t) const
{
	const double n = double(t.evenNum());
	if (t.addedNum > 0) return portable::log(double(t.vertexNum) / double(t.addedNum));
	// The largest of n errors.
	return portable::log(std::max(n, 2.0)) * goal_.largest /
		   std::max(t.error, 1e-6 * goal_.largest);
}

/// After a count that met the goal; 0 where that is near enough to the smallest.
std::int64_t CountSearch::fewerThan(const ErrorTrial& t) const
{
	const double n      = double(t.evenNum());
	const double wanted = n * portable::log(1 / shareToAdd) / exponentAtGoal(t);
	if (wanted >= nearEnough * n) return 0;
	if (missed_ > 0 && n <= nearCounts * double(missed_)) return 0;
	return clamped(std::max({wanted, n / largestShrink, std::sqrt(n * double(missed_))}));
}

/// After a count that missed the goal: so many more that triangles elsewhere stay as they are.
/// Where much of the area is beyond the goal, triangles are too large everywhere: the larger an
/// error the fewer there are of it, about exponentially.
std::int64_t CountSearch::moreThan(const ErrorTrial& t) const
{
	const double n = double(t.evenNum());
	if (n == 0 || t.evenNum() >= goal_.most) return 0;
	const double share   = std::min(0.5, std::max(t.share, 1e-12));
	const double byArea  = portable::log(shareForSpots) / portable::log(share);
	const double bySpots = std::max(std::max(1.0, byArea) * t.growth, leastGrowth);
	if (met_.vertexNum > 0) return between(t, bySpots);
	// The last trial shall meet it, though that may be with too many.
	const double byError = left_ == 1 ? lastCaution * t.error / goal_.largest * t.growth : 0;
	return clamped(std::min(std::max(bySpots, byError), largestGrowth) * n);
}

/// What smaller triangles at the places beyond the goal ask for. Where that misses it, too, half
/// way: the counts may be far from each other.
std::int64_t CountSearch::between(const ErrorTrial& t, double growth) const
{
	const double low = double(t.evenNum()), high = double(met_.evenNum());
	if (high <= nearCounts * low || high <= low + 1) return 0;
	const double half = std::sqrt(low * high);
	return clamped(hasJustMissed_ ? half : std::min(growth * low, half));
}

} // namespace gpr
