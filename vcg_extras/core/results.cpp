// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "results.h"

#include <iterator>

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
	static_assert(std::size(names) == std::size_t(Status::InternalError) + 1);
	return names[int(status)];
}

} // namespace gpr
