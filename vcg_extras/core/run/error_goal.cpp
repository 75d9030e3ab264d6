// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "error_goal.h"

#include <vcg_extras/core/base/box.h>
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
/// What the last trial adds at least, where another count has met the goal.
constexpr double lastGrowth = 1.1;
/// What the finer places themselves need.
constexpr double leastGrowth = 1.03;
/// A trial that keeps to so much of the goal or more is near enough to the smallest count.
constexpr double nearEnough = 0.9;
/// Counts of which one meets the goal and one does not are near enough at this quotient.
constexpr double nearCounts = 1.08;
/// A count tried is at most so many times the last one, or its inverse.
constexpr double largestGrowth = 4, largestShrink = 3;
/// Power of the largest error with which the count falls: the few places that would be beyond the
/// goal are made finer by the next trial. Two trials that meet it tell the power, up to the other.
constexpr double       fallOfCount = 2, steepestFall = 6;
constexpr std::int64_t minCount = 4;

class CountSearch {
public:
	CountSearch(const ErrorGoal& goal, const std::function<ErrorTrial(std::int64_t)>& trial) :
			goal_(goal), trial_(trial)
	{
	}

	std::int64_t run()
	{
		std::int64_t next = clamped(double(goal_.start));
		for (int left = goal_.maxTrials - 1; left >= 0 && next > 0; --left) {
			const ErrorTrial t     = trial_(next);
			const bool       meets = t.error <= goal_.largest;
			// Topology needs more than what was asked for: there is nothing below.
			const bool isLeast = t.vertexNum > next || next <= minCount;
			if (meets) {
				keepFewer(t);
				next = isLeast ? 0 : fewerThan(t);
			}
			else {
				missed_ = std::max(missed_, t.vertexNum);
				next    = moreThan(t, left);
			}
		}
		return met_.vertexNum;
	}

private:
	const ErrorGoal&                               goal_;
	const std::function<ErrorTrial(std::int64_t)>& trial_;
	ErrorTrial                                     met_;        ///< vertexNum 0: none
	std::int64_t                                   missed_ = 0; ///< the largest count that did not
	double                                         fall_   = fallOfCount;

	std::int64_t clamped(double n) const
	{
		const double most = double(goal_.most);
		return std::int64_t(std::max(double(minCount), std::min(std::ceil(n), most)));
	}

	void keepFewer(const ErrorTrial& t)
	{
		if (met_.vertexNum > 0 && t.vertexNum >= met_.vertexNum) return;
		if (met_.vertexNum > 0 && t.error > met_.error) fall_ = fallBetween(met_, t);
		met_ = t;
	}

	static double fallBetween(const ErrorTrial& more, const ErrorTrial& fewer)
	{
		const double counts = double(more.vertexNum) / double(fewer.vertexNum);
		const double errors = fewer.error / std::max(more.error, 1e-6 * fewer.error);
		return std::clamp(portable::log(counts) / portable::log(errors), fallOfCount, steepestFall);
	}

	/// After a count that met the goal; 0 where that is near enough to the smallest. The places
	/// made finer so far will serve the smaller count as well.
	std::int64_t fewerThan(const ErrorTrial& t) const
	{
		const double n = double(met_.vertexNum);
		if (t.error >= nearEnough * goal_.largest) return 0;
		if (missed_ > 0 && n <= nearCounts * double(missed_)) return 0;
		const double ratio  = std::max(t.error / goal_.largest, 1e-6);
		const double wanted = n * std::max(portable::pow(ratio, fall_), 1 / largestShrink);
		return clamped(std::max(wanted, std::sqrt(n * double(missed_))));
	}

	/// After a count that missed the goal: so many more that triangles elsewhere stay as they are.
	/// Where much of the area is beyond the goal, triangles are too large everywhere: the larger an
	/// error the fewer there are of it, about exponentially.
	std::int64_t moreThan(const ErrorTrial& t, int left) const
	{
		const double n = double(t.vertexNum);
		if (n == 0 || t.vertexNum >= goal_.most) return 0;
		const double share   = std::min(0.5, std::max(t.share, 1e-12));
		const double byArea  = portable::log(shareForSpots) / portable::log(share);
		const double bySpots = std::max(std::max(1.0, byArea) * t.growth, leastGrowth);
		if (met_.vertexNum > 0)
			return between(t, left == 1 ? std::max(bySpots, lastGrowth) : bySpots);
		// The last trial shall meet it, though that may be with too many.
		const double byError = left == 1 ? lastCaution * t.error / goal_.largest * t.growth : 0;
		return clamped(std::min(std::max(bySpots, byError), largestGrowth) * n);
	}

	/// No more than what smaller triangles at the places beyond the goal ask for, though a trial
	/// may be lost by that: the counts may be far from each other.
	std::int64_t between(const ErrorTrial& t, double growth) const
	{
		const double low = double(t.vertexNum), high = double(met_.vertexNum);
		if (high <= nearCounts * low || high <= low + 1) return 0;
		return clamped(std::min(growth * low, std::sqrt(low * high)));
	}
};

bool isFinite(const Vec3d& p)
{
	return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

} // namespace

std::int64_t searchCount(const ErrorGoal&                               goal,
						 const std::function<ErrorTrial(std::int64_t)>& trial)
{
	return CountSearch(goal, trial).run();
}

MeshExtent extentOf(const MeshView& mesh)
{
	MeshExtent  extent;
	Box<double> box;
	for (std::size_t f = 0; f < mesh.faceNum; ++f) {
		Vec3d corner[3];
		bool  usable = true;
		for (int k = 0; k < 3 && usable; ++k) {
			const std::int32_t v = mesh.vertexOf(3 * f + std::size_t(k));
			usable               = v >= 0 && std::size_t(v) < mesh.vertexNum;
			if (usable) corner[k] = mesh.position(std::size_t(v));
			usable = usable && isFinite(corner[k]);
		}
		if (!usable) continue;
		extent.area += 0.5 * length(cross(corner[1] - corner[0], corner[2] - corner[0]));
		for (const Vec3d& p : corner)
			box.add(p);
	}
	extent.diagonal = box.diagonal();
	return extent;
}

} // namespace gpr
