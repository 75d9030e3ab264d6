// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "page_pool.h"

#include <algorithm>
#include <limits>
#include <new>

namespace gpr {

namespace {

std::size_t wholePages(std::size_t bytes)
{
	return (bytes + PagePool::pageBytes - 1) / PagePool::pageBytes * PagePool::pageBytes;
}

} // namespace

void* PagePool::take(std::size_t bytes)
{
	const std::size_t                 wanted = wholePages(bytes);
	const std::lock_guard<std::mutex> lock(mutex_);
	if (char* const block = takeFree(wanted)) return block;
	returnSome(wanted);
	void* const block = system_.map(wanted);
	if (block == nullptr) throw std::bad_alloc();
	return block;
}

/// Takes the begin of the smallest block with enough bytes, or returns nullptr.
char* PagePool::takeFree(std::size_t bytes)
{
	auto best = free_.end();
	for (auto b = free_.begin(); b != free_.end(); ++b) {
		if (b->bytes >= bytes && (best == free_.end() || b->bytes < best->bytes)) best = b;
	}
	if (best == free_.end()) return nullptr;
	char* const begin = best->begin;
	best->begin += bytes;
	best->bytes -= bytes;
	if (best->bytes == 0) free_.erase(best);
	return begin;
}

void PagePool::give(void* block, std::size_t bytes)
{
	const Block                       given = {static_cast<char*>(block), wholePages(bytes)};
	const std::lock_guard<std::mutex> lock(mutex_);
	auto                              next = std::lower_bound(free_.begin(), free_.end(), given,
															  [](const Block& a, const Block& b) { return a.begin < b.begin; });
	next                                   = free_.insert(next, given);
	if (next + 1 != free_.end() && next->begin + next->bytes == (next + 1)->begin) {
		next->bytes += (next + 1)->bytes;
		free_.erase(next + 1);
	}
	if (next != free_.begin() && (next - 1)->begin + (next - 1)->bytes == next->begin) {
		(next - 1)->bytes += next->bytes;
		free_.erase(next);
	}
}

void PagePool::returnSome(std::size_t bytes)
{
	std::size_t left = bytes;
	while (left > 0 && !free_.empty()) {
		Block&            last = free_.back();
		const std::size_t part = std::min(left, last.bytes);
		last.bytes -= part;
		system_.unmap(last.begin + last.bytes, part);
		left -= part;
		if (last.bytes == 0) free_.pop_back();
	}
}

void PagePool::returnAll()
{
	const std::lock_guard<std::mutex> lock(mutex_);
	returnSome(std::numeric_limits<std::size_t>::max());
}

} // namespace gpr
