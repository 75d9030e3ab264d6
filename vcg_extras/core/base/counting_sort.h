// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_BASE_COUNTING_SORT_H
#define VCG_EXTRAS_CORE_BASE_COUNTING_SORT_H

#include "buffer.h"
#include "workers.h"

#include <algorithm>

namespace gpr {

/// Sorts items 0 .. itemNum-1 into buckets. `start` gets bucketNum + 1 entries; `item` gets the
/// items bucket by bucket, ascending within each. Items with a negative bucketOf(i) are left out.
/// Cost: linear, parallel. Threads fill a bucket in any order; sorting each bucket makes the result
/// unique.
template <class BucketOf>
void sortIntoBuckets(std::size_t itemNum, std::size_t bucketNum, const BucketOf& bucketOf,
					 Workers& workers, Buffer<int>& start, Buffer<int>& item)
{
	start.reset(bucketNum + 1);
	workers.forEach(bucketNum + 1, [&](int b) { start[b] = 0; });
	workers.forEach(itemNum, [&](int i) {
		const int b = bucketOf(i);
		if (b >= 0) __atomic_fetch_add(&start[b], 1, __ATOMIC_RELAXED);
	});
	// Each start[b] is a count now. sumUp makes it the end of bucket b, and the filling below
	// lowers it to the beginning.
	const int total  = workers.sumUp(start.data(), bucketNum);
	start[bucketNum] = total;
	item.reset(total);
	workers.forEach(itemNum, [&](int i) {
		const int b = bucketOf(i);
		if (b < 0) return;
		const int place = __atomic_sub_fetch(&start[b], 1, __ATOMIC_RELAXED);
		item[place]     = i;
	});
	workers.forEach(bucketNum, [&](int b) {
		if (start[b + 1] - start[b] > 1) {
			std::sort(item.data() + start[b], item.data() + start[b + 1]);
		}
	});
}

/// Sorts the values make(0), ..., make(itemNum - 1). bucketOf(value) in [0, bucketNum) must rise
/// with the value. Equal values must be indistinguishable. Cost: linear with small buckets,
/// parallel.
template <class Value, class Make, class BucketOf>
Buffer<Value> sortedByBuckets(std::size_t itemNum, std::size_t bucketNum, const Make& make,
							  const BucketOf& bucketOf, Workers& workers)
{
	Buffer<int> start(bucketNum + 1, 0);
	workers.forEach(itemNum, [&](std::size_t i) {
		__atomic_fetch_add(&start[std::size_t(bucketOf(make(i)))], 1, __ATOMIC_RELAXED);
	});
	start[bucketNum] = workers.sumUp(start.data(), bucketNum);
	Buffer<Value> values(itemNum);
	workers.forEach(itemNum, [&](std::size_t i) {
		const Value value = make(i);
		values[std::size_t(
			__atomic_sub_fetch(&start[std::size_t(bucketOf(value))], 1, __ATOMIC_RELAXED))] = value;
	});
	workers.forEach(bucketNum, [&](std::size_t b) {
		std::sort(values.data() + start[b], values.data() + start[b + 1]);
	});
	return values;
}

} // namespace gpr

#endif
