// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "distance_histogram.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace gpr {

namespace {

static_assert(std::numeric_limits<float>::is_iec559, "bins are made of the bits of a float");

/// The bits of a float's fraction, of 23, left out of the bin's number.
constexpr int droppedBits = 12;

/// The bits of a float. Floats of at least 0 are in the order of their bits.
std::uint32_t bitsOf(float value)
{
	std::uint32_t bits;
	std::memcpy(&bits, &value, sizeof bits);
	return bits;
}

std::size_t binOf(double distance)
{
	if (!(distance >= double(std::numeric_limits<float>::min()))) return 0;
	const double most = double(std::numeric_limits<float>::max());
	return bitsOf(float(std::min(distance, most))) >> droppedBits;
}

/// The largest float of a bin; bin 0 is for 0.
double upperEnd(std::size_t bin)
{
	if (bin == 0) return 0;
	const std::uint32_t bits = std::uint32_t(bin) << droppedBits | ((1u << droppedBits) - 1);
	float               value;
	std::memcpy(&value, &bits, sizeof value);
	return double(value);
}

} // namespace

DistanceHistogram::DistanceHistogram() :
		weight_((bitsOf(std::numeric_limits<float>::max()) >> droppedBits) + 1)
{
}

void DistanceHistogram::add(double distance, std::int64_t weight)
{
	weight_[binOf(distance)].fetch_add(weight, std::memory_order_relaxed);
}

double DistanceHistogram::p999(double largest) const
{
	std::int64_t total = 0;
	for (const std::atomic<std::int64_t>& w : weight_)
		total += w;
	if (total <= 0) return 0;
	std::int64_t mayBeFarther = total / 1000;
	std::size_t  bin          = weight_.size() - 1;
	for (; weight_[bin] <= mayBeFarther; --bin)
		mayBeFarther -= weight_[bin];
	return std::min(upperEnd(bin), largest);
}

} // namespace gpr
