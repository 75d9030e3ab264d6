// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_BASE_PAGES_H
#define VCG_EXTRAS_CORE_BASE_PAGES_H

#include <cstddef>
#include <cstdint>

namespace gpr {

/// Memory for a large array, in huge pages where the system offers them (see page_pool.h); throws
/// std::bad_alloc. bytes: the same when it is released.
/// This file is the only place of the engine that talks to the operating system.
void* allocatePages(std::size_t bytes);
void  releasePages(void* memory, std::size_t bytes);

/// Gives memory back to the system that was released but is kept for later, where that can be
/// asked for: before a stage that needs much. Cost: some milliseconds.
void returnReleasedMemory();

/// Memory that this process may still take without that of others being moved to a disk; 0 where
/// it is unknown.
std::int64_t availableMemoryBytes();

} // namespace gpr

#endif
