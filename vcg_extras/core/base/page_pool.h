// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_BASE_PAGE_POOL_H
#define VCG_EXTRAS_CORE_BASE_PAGE_POOL_H

#include <cstddef>
#include <mutex>
#include <vector>

namespace gpr {

/// A pool of huge pages for large arrays, which reuses released pages. The system clears each fresh
/// page, which takes as long as many a stage's work on the page; reused pages need no clearing.
/// Before the pool maps new memory, it returns the same number of bytes to the system, as long as
/// free blocks remain: the process never has more than its arrays at their peak.
class PagePool {
public:
	static constexpr std::size_t pageBytes = std::size_t(2) << 20;

	/// The calls of the system: blocks of whole pages, at addresses that are multiples of
	/// pageBytes. map returns nullptr without memory.
	struct System {
		void* (*map)(std::size_t bytes);
		void (*unmap)(void* block, std::size_t bytes);
	};

	explicit PagePool(const System& system) : system_(system) {}
	~PagePool() { returnAll(); }
	PagePool(const PagePool&)            = delete;
	PagePool& operator=(const PagePool&) = delete;

	/// Takes a block of unknown content; throws std::bad_alloc. Any thread may call.
	void* take(std::size_t bytes);
	/// Puts a block back. bytes: as in the call of take.
	void give(void* block, std::size_t bytes);
	/// Returns all free blocks to the system.
	void returnAll();

private:
	struct Block {
		char*       begin;
		std::size_t bytes;
	};

	System             system_;
	std::mutex         mutex_;
	std::vector<Block> free_; ///< ascending by address; adjacent blocks are joined

	char* takeFree(std::size_t bytes);
	void  returnSome(std::size_t bytes);
};

} // namespace gpr

#endif
