// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "pages.h"

#include <cstdlib>
#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace gpr {

namespace {

constexpr std::size_t hugePageBytes = std::size_t(2) << 20;
constexpr std::size_t cacheLine     = 64;

std::size_t roundUp(std::size_t n, std::size_t step)
{
	return (n + step - 1) / step * step;
}

} // namespace

void* allocatePages(std::size_t bytes)
{
	const bool        large     = bytes >= 2 * hugePageBytes;
	const std::size_t alignment = large ? hugePageBytes : cacheLine;
	const std::size_t rounded   = roundUp(bytes + 1, alignment);
#if defined(_WIN32)
	void* memory = _aligned_malloc(rounded, alignment);
#else
	void* memory = std::aligned_alloc(alignment, rounded);
#endif
	if (memory == nullptr) throw std::bad_alloc();
#if defined(__linux__) && defined(MADV_HUGEPAGE)
	if (large) madvise(memory, rounded, MADV_HUGEPAGE);
#endif
	return memory;
}

void releasePages(void* memory, std::size_t)
{
#if defined(_WIN32)
	_aligned_free(memory);
#else
	std::free(memory);
#endif
}

} // namespace gpr
