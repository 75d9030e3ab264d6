// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_BASE_POLLER_H
#define VCG_EXTRAS_CORE_BASE_POLLER_H

#include "workers.h"

#include <algorithm>
#include <cstddef>

namespace gpr {

/// Polls the workers at every 65,536th call: for loops of millions of items in one thread.
class Poller {
public:
	/// worker: the thread that calls count.
	explicit Poller(Workers& workers, int worker = 0) : workers_(&workers), worker_(worker) {}

	void count()
	{
		if ((++callNum_ & 0xffff) == 0) workers_->pollFrom(worker_);
	}

private:
	Workers*    workers_;
	int         worker_;
	std::size_t callNum_ = 0;
};

/// std::sort that can be cancelled; the values are then in any order.
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
