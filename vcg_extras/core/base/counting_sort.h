// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_BASE_COUNTING_SORT_H
#define VCG_EXTRAS_CORE_BASE_COUNTING_SORT_H

#include "buffer.h"
#include "workers.h"

#include <algorithm>

namespace gpr {

/// Sorts items 0 .. itemNum-1 into buckets: start gets bucketNum + 1 entries, item the items bucket
/// by bucket, ascending within each. bucketOf(i) may be negative: such items are left out.
/// Cost: linear, parallel; the threads fill a bucket in any order, sorting it afterwards makes the
/// outcome unique.
template <class BucketOf>
void sortIntoBuckets(std::size_t itemNum, std::size_t bucketNum, const BucketOf& bucketOf,
					 Workers& workers, Buffer<int>& start, Buffer<int>& item)
{
	start.reset(bucketNum + 1);
	workers.forRange(bucketNum + 1, [&](std::size_t begin, std::size_t end) {
		for (std::size_t b = begin; b < end; ++b)
			start[b] = 0;
	});
	workers.forRange(itemNum, [&](std::size_t begin, std::size_t end) {
		for (std::size_t i = begin; i < end; ++i) {
			const int b = bucketOf(i);
			if (b >= 0) __atomic_fetch_add(&start[b], 1, __ATOMIC_RELAXED);
		}
	});
	// Now start[b] is a count; make it the end of bucket b, and let the filling below lower it to
	// the beginning.
	const int total  = workers.sumUp(start.data(), bucketNum);
	start[bucketNum] = total;
	item.reset(total);
	workers.forRange(itemNum, [&](std::size_t begin, std::size_t end) {
		for (std::size_t i = begin; i < end; ++i) {
			const int b = bucketOf(i);
			if (b < 0) continue;
			const int place = __atomic_sub_fetch(&start[b], 1, __ATOMIC_RELAXED);
			item[place]     = int(i);
		}
	});
	workers.forRange(bucketNum, [&](std::size_t begin, std::size_t end) {
		for (std::size_t b = begin; b < end; ++b) {
			if (start[b + 1] - start[b] > 1) {
				std::sort(item.data() + start[b], item.data() + start[b + 1]);
			}
		}
	});
}

} // namespace gpr

#endif
