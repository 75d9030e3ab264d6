// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_BASE_PAGE_POOL_H
#define VCG_EXTRAS_CORE_BASE_PAGE_POOL_H

#include <cstddef>
#include <mutex>
#include <vector>

namespace gpr {

/// Huge pages that large arrays have given back, for the next ones. The system clears each page
/// that it hands out, which takes as long as many a stage does with it; what the process had before
/// need not be cleared. Memory is asked of the system only after as much was returned to it, as
/// long as there is some: so the process never has more than its arrays at their peak.
class PagePool {
public:
	static constexpr std::size_t pageBytes = std::size_t(2) << 20;

	/// What the system is asked for: blocks of whole pages, at addresses that are multiples of
	/// pageBytes. map returns nullptr where there is no memory.
	struct System {
		void* (*map)(std::size_t bytes);
		void (*unmap)(void* block, std::size_t bytes);
	};

	explicit PagePool(const System& system) : system_(system) {}
	~PagePool() { returnAll(); }
	PagePool(const PagePool&)            = delete;
	PagePool& operator=(const PagePool&) = delete;

	/// Room for so many bytes, of unknown content; throws std::bad_alloc. Any thread may call.
	void* take(std::size_t bytes);
	/// bytes: as they were asked for.
	void give(void* block, std::size_t bytes);
	/// All that is not in use goes back to the system.
	void returnAll();

private:
	struct Block {
		char*       begin;
		std::size_t bytes;
	};

	System             system_;
	std::mutex         mutex_;
	std::vector<Block> free_; ///< ascending by address; those side by side are joined

	char* takeFree(std::size_t bytes);
	void  returnSome(std::size_t bytes);
};

} // namespace gpr

#endif
