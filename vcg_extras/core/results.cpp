// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "results.h"

namespace gpr {

const char* statusName(Status status)
{
	constexpr const char* names[] = {"ok",
									 "bad options",
									 "unusable input",
									 "count too small",
									 "promise broken",
									 "out of memory",
									 "cancelled",
									 "out of time",
									 "internal error"}; // by Status
	return names[int(status)];
}

} // namespace gpr
