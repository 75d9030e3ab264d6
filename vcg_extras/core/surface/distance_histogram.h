// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_SURFACE_DISTANCE_HISTOGRAM_H
#define VCG_EXTRAS_CORE_SURFACE_DISTANCE_HISTOGRAM_H

#include <atomic>
#include <cstdint>
#include <vector>

namespace gpr {

/// The p99.9 of any number of distances, which are counted and not kept. The bins are the leading
/// bits of a float: 2048 for each power of two, over all floats. Weights are integers, so the order
/// in which distances come never shows in the result. Memory: 4 MB, however many distances.
class DistanceHistogram {
public:
	DistanceHistogram();

	/// Counts a distance, in any unit. weight >= 0: 1 for evenly spread points, else the share of
	/// the area that belongs to the point; all weights together stay below 2^63. Several threads
	/// may call add at once.
	void add(double distance, std::int64_t weight = 1);

	/// The smallest distance not exceeded by 99.9 % of the weight, as the upper end of its bin: at
	/// most 0.05 % too large, and never above `largest`, the largest distance added. Exact if all
	/// distances are equal; 0 without any weight. Distances below 1e-38 count as 0. Cost: a pass
	/// over the bins, below a millisecond.
	double p999(double largest) const;

private:
	std::vector<std::atomic<std::int64_t>> weight_; ///< of each bin
};

} // namespace gpr

#endif
