// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "memory.h"

#include <malloc.h>

namespace gpr::web {

double freeBytes()
{
	constexpr double addressSpace = 4294967296.0; // of 32 bits; the link's MAXIMUM_MEMORY
	const auto       used         = static_cast<unsigned>(mallinfo().uordblks);
	return addressSpace - used;
}

} // namespace gpr::web
