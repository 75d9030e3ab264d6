// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_BASE_COUNTING_SORT_H
#define VCG_EXTRAS_CORE_BASE_COUNTING_SORT_H

#include "buffer.h"
#include "workers.h"

#include <algorithm>

namespace gpr {

/// Sorts the values make(0), ..., make(itemNum - 1) into buckets. `start` gets bucketNum + 1
/// entries; `sorted` gets the values bucket by bucket, ascending within each. Values with a
/// negative bucketOf(value) are left out. Equal values must be indistinguishable. Cost: linear with
/// small buckets, parallel. Threads fill a bucket in any order; sorting each bucket makes the
/// result unique.
template <class Value, class Make, class BucketOf>
void sortIntoBuckets(std::size_t itemNum, std::size_t bucketNum, const Make& make,
					 const BucketOf& bucketOf, Workers& workers, Buffer<int>& start,
					 Buffer<Value>& sorted)
{
	start.reset(bucketNum + 1);
	workers.forEach(bucketNum + 1, [&](int b) { start[b] = 0; });
	workers.forEach(itemNum, [&](int i) {
		const int b = bucketOf(make(i));
		if (b >= 0) __atomic_fetch_add(&start[b], 1, __ATOMIC_RELAXED);
	});
	// Each start[b] is a count now. sumUp makes it the end of bucket b, and the filling below
	// lowers it to the beginning.
	const int total  = workers.sumUp(start.data(), bucketNum);
	start[bucketNum] = total;
	sorted.reset(total);
	workers.forEach(itemNum, [&](int i) {
		const Value value = make(i);
		const int   b     = bucketOf(value);
		if (b < 0) return;
		const int place = __atomic_sub_fetch(&start[b], 1, __ATOMIC_RELAXED);
		sorted[place]   = value;
	});
	workers.forEach(bucketNum, [&](int b) {
		if (start[b + 1] - start[b] > 1) {
			std::sort(sorted.data() + start[b], sorted.data() + start[b + 1]);
		}
	});
}

/// Sorts the numbers 0 .. itemNum-1 into buckets.
template <class BucketOf>
void sortIntoBuckets(std::size_t itemNum, std::size_t bucketNum, const BucketOf& bucketOf,
					 Workers& workers, Buffer<int>& start, Buffer<int>& item)
{
	sortIntoBuckets(
		itemNum, bucketNum, [](int i) { return i; }, bucketOf, workers, start, item);
}

/// Sorts the values make(0), ..., make(itemNum - 1). bucketOf(value) must rise with the value.
template <class Value, class Make, class BucketOf>
Buffer<Value> sortedByBuckets(std::size_t itemNum, std::size_t bucketNum, const Make& make,
							  const BucketOf& bucketOf, Workers& workers)
{
	Buffer<int>   start;
	Buffer<Value> sorted;
	sortIntoBuckets(itemNum, bucketNum, make, bucketOf, workers, start, sorted);
	return sorted;
}

} // namespace gpr

#endif
