// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_PAGES_H
#define VCG_EXTRAS_CORE_PAGES_H

#include <cstddef>

namespace gpr {

/// Memory for a large array, in huge pages where the system offers them; throws std::bad_alloc.
/// The only place of the engine that talks to the operating system.
void* allocatePages(std::size_t bytes);
void  releasePages(void* memory, std::size_t bytes);

} // namespace gpr

#endif
