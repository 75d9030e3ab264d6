// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_BASE_PAGES_H
#define VCG_EXTRAS_CORE_BASE_PAGES_H

#include <cstddef>
#include <cstdint>

namespace gpr {

/// Allocates memory for a large array, in huge pages if the system has such pages (page_pool.h);
/// throws std::bad_alloc. releasePages needs the same `bytes`. The engine calls the operating
/// system in this file only.
void* allocatePages(std::size_t bytes);
void  releasePages(void* memory, std::size_t bytes);

/// Returns released memory that is kept for reuse to the system, if the system can do so. For use
/// before a stage that needs much memory. Cost: some milliseconds.
void returnReleasedMemory();

/// Memory that this process may still take without swapping of other processes; 0 if unknown.
std::int64_t availableMemoryBytes();

} // namespace gpr

#endif
