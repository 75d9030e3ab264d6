// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "error_goal.h"

#include <vcg_extras/core/base/box.h>

#include <algorithm>
#include <cmath>

namespace gpr {

namespace {

/// The error falls with this power of the count on most surfaces: between that of creases (½) and
/// that of smooth ground (1).
constexpr double usualPower = 0.75;
/// Counts of which one meets the goal and one does not are near enough at this quotient.
constexpr double nearEnough = 1.03;
/// Between two counts tried, a new one keeps this share of the way (of logarithms) from both.
constexpr double minShare = 0.15;
/// A count tried is at most this many times the last one, or its inverse.
constexpr double       largestJump = 8;
constexpr std::int64_t minCount    = 4;

class CountSearch {
public:
	CountSearch(const ErrorGoal& goal, const std::function<ErrorTrial(std::int64_t)>& trial) :
			goal_(goal), trial_(trial)
	{
	}

	std::int64_t run()
	{
		std::int64_t next = clamped(goal_.start);
		for (int i = 0; i < goal_.maxTrials && next > 0; ++i) {
			const ErrorTrial t            = trial_(next);
			const bool       meets        = t.error <= goal_.largest;
			(meets ? meeting_ : missing_) = t;
			// Topology needs more than what was asked for: there is nothing below.
			const bool floor = t.vertexNum > next;
			if (meets && (floor || next <= minCount)) break;
			next = nextCount(t);
		}
		return meeting_.vertexNum;
	}

private:
	const ErrorGoal&                               goal_;
	const std::function<ErrorTrial(std::int64_t)>& trial_;
	ErrorTrial meeting_, missing_; ///< nearest to each other so far; vertexNum 0: none

	std::int64_t clamped(std::int64_t n) const
	{
		return std::max(minCount, std::min(n, goal_.most));
	}

	/// 0 where the search is over.
	std::int64_t nextCount(const ErrorTrial& last) const
	{
		if (meeting_.vertexNum > 0 && missing_.vertexNum > 0) return between();
		if (missing_.vertexNum >= goal_.most) return 0;
		// The side of the goal that the last one was on is passed by a little.
		const double past   = last.error <= goal_.largest ? 0.95 : 1.05;
		const double factor = past * std::pow(last.error / goal_.largest, 1 / usualPower);
		const double jump   = std::min(largestJump, std::max(1 / largestJump, factor));
		return clamped(std::int64_t(std::ceil(jump * double(last.vertexNum))));
	}

	std::int64_t between() const
	{
		const double low = std::log(double(missing_.vertexNum));
		const double way = std::log(double(meeting_.vertexNum)) - low;
		if (way <= std::log(nearEnough) || meeting_.vertexNum <= missing_.vertexNum + 1) return 0;
		const double fall  = std::log(missing_.error) - std::log(std::max(meeting_.error, 1e-300));
		const double share = std::log(missing_.error / goal_.largest) / fall;
		const double safe  = std::min(1 - minShare, std::max(minShare, share));
		const auto   n     = std::int64_t(std::lround(std::exp(low + safe * way)));
		return std::max(missing_.vertexNum + 1, std::min(n, meeting_.vertexNum - 1));
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
