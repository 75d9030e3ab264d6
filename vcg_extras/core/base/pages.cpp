// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "pages.h"

#include "page_pool.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>

#if defined(__GLIBC__)
#include <malloc.h>
#endif
#if defined(__linux__)
#include <sys/mman.h>
#include <sys/resource.h>
#elif defined(_WIN32)
#include <windows.h>
#elif defined(__APPLE__)
#include <sys/sysctl.h>
#endif

namespace gpr {

namespace {

constexpr std::size_t cacheLine = 64;

#if defined(__linux__)

/// The number after a word at the begin of a line in a table of the system; 0 if there is none.
std::int64_t numberInTable(const char* path, const char* name)
{
	const std::unique_ptr<std::FILE, int (*)(std::FILE*)> table(
		std::fopen(path, "r"), [](std::FILE* f) { return std::fclose(f); });
	char line[256];
	while (table && std::fgets(line, sizeof line, table.get()) != nullptr) {
		const std::size_t length = std::strlen(name);
		if (std::strncmp(line, name, length) == 0) return std::atoll(line + length);
	}
	return 0;
}

/// The bytes left below a limit, at most `most`; without a limit `most`.
std::int64_t leftOf(std::int64_t limit, std::int64_t used, std::int64_t most)
{
	return limit > 0 ? std::min(most, std::max<std::int64_t>(1, limit - used)) : most;
}

std::int64_t addressSpaceLimit()
{
	struct rlimit limit;
	if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return 0;
	return std::int64_t(std::min<rlim_t>(limit.rlim_cur, rlim_t(1) << 62));
}

#endif

} // namespace

std::int64_t availableMemoryBytes()
{
#if defined(__linux__)
	constexpr std::int64_t kilobyte = 1024; // the unit of these tables
	const auto             used     = [](const char* name) {
        return kilobyte * numberInTable("/proc/self/status", name);
	};
	std::int64_t bytes = kilobyte * numberInTable("/proc/meminfo", "MemAvailable:");
	if (bytes == 0) return 0;
	// The limits of a container and of the shell.
	bytes = leftOf(numberInTable("/sys/fs/cgroup/memory.max", ""), used("VmRSS:"), bytes);
	return leftOf(addressSpaceLimit(), used("VmSize:"), bytes);
#elif defined(_WIN32)
	MEMORYSTATUSEX status;
	status.dwLength = sizeof status;
	return GlobalMemoryStatusEx(&status) ? std::int64_t(status.ullAvailPhys) : 0;
#elif defined(__APPLE__)
	// The system has no single figure for free memory.
	std::int64_t bytes = 0;
	std::size_t  size  = sizeof bytes;
	return sysctlbyname("hw.memsize", &bytes, &size, nullptr, 0) == 0 ? bytes : 0;
#else
	return 0;
#endif
}

#if defined(__linux__)

namespace {

void unmapPages(void* block, std::size_t bytes)
{
	munmap(block, bytes);
}

/// Maps pages at a multiple of the huge page size. The system aligns to small pages only: maps more
/// and unmaps both ends.
void* mapPages(std::size_t bytes)
{
	constexpr std::size_t page = PagePool::pageBytes;
	void* const           memory =
		mmap(nullptr, bytes + page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
	if (memory == MAP_FAILED) return nullptr;
	char* const       begin  = static_cast<char*>(memory);
	const std::size_t before = (page - reinterpret_cast<std::uintptr_t>(begin) % page) % page;
	if (before > 0) unmapPages(begin, before);
	unmapPages(begin + before + bytes, page - before);
#if defined(MADV_HUGEPAGE)
	madvise(begin + before, bytes, MADV_HUGEPAGE);
#endif
	return begin + before;
}

/// Never destroyed: static objects may release arrays at the very end.
PagePool& pool()
{
	static PagePool* const pool = new PagePool({mapPages, unmapPages});
	return *pool;
}

/// A sanitizer sees accesses beyond an array only if each array has memory of its own.
#if defined(__SANITIZE_ADDRESS__)
constexpr bool isSanitized = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
constexpr bool isSanitized = true;
#else
constexpr bool isSanitized = false;
#endif
#else
constexpr bool isSanitized = false;
#endif

bool isForPool(std::size_t bytes)
{
	return !isSanitized && bytes >= 2 * PagePool::pageBytes;
}

} // namespace

#endif

void* allocatePages(std::size_t bytes)
{
#if defined(__linux__)
	if (isForPool(bytes)) return pool().take(bytes);
#endif
	const std::size_t rounded = (bytes / cacheLine + 1) * cacheLine;
#if defined(_WIN32)
	void* memory = _aligned_malloc(rounded, cacheLine);
#else
	void* memory = std::aligned_alloc(cacheLine, rounded);
#endif
	if (memory == nullptr) throw std::bad_alloc();
	return memory;
}

void returnReleasedMemory()
{
#if defined(__linux__)
	pool().returnAll();
#endif
#if defined(__GLIBC__)
	malloc_trim(0);
#endif
}

void releasePages(void* memory, [[maybe_unused]] std::size_t bytes)
{
#if defined(__linux__)
	if (isForPool(bytes)) return pool().give(memory, bytes);
#endif
#if defined(_WIN32)
	_aligned_free(memory);
#else
	std::free(memory);
#endif
}

} // namespace gpr
