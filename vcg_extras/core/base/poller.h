// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_BASE_POLLER_H
#define VCG_EXTRAS_CORE_BASE_POLLER_H

#include "workers.h"

#include <algorithm>
#include <cstddef>

namespace gpr {

/// Asks at every 65,536th call whether to go on: for serial loops of millions, and from the calling
/// thread only.
class Poller {
public:
	explicit Poller(Workers& workers) : workers_(workers) {}

	void count()
	{
		if ((++callNum_ & 0xffff) == 0) workers_.poll();
	}

private:
	Workers&    workers_;
	std::size_t callNum_ = 0;
};

/// std::sort that can be cancelled; the values are in any order then.
template <class Iterator>
void sortPolled(Iterator begin, Iterator end, Workers& workers)
{
	Poller poller(workers);
	std::sort(begin, end, [&](const auto& a, const auto& b) {
		poller.count();
		return a < b;
	});
}

} // namespace gpr

#endif
