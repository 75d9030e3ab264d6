// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machine.h"

#include <emscripten.h>
#include <malloc.h>

// clang-format off
EM_JS(int, wantedThreadNum, (), {
	return Module["threadNum"];
});
// clang-format on

namespace gpr::web {

double freeBytes()
{
	constexpr double addressSpace = 4294967296.0; // of 32 bits; the link's MAXIMUM_MEMORY
	const auto       used         = static_cast<unsigned>(mallinfo().uordblks);
	return addressSpace - used;
}

int threadNum()
{
#ifdef __EMSCRIPTEN_PTHREADS__
	return wantedThreadNum();
#else
	return 1;
#endif
}

} // namespace gpr::web
