// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "results.h"

namespace gpr {

const char* statusName(Status status)
{
	switch (status) {
	case Status::Ok:
		return "ok";
	case Status::BadOptions:
		return "bad options";
	case Status::UnusableInput:
		return "unusable input";
	case Status::CountTooSmall:
		return "count too small";
	case Status::PromiseBroken:
		return "promise broken";
	case Status::OutOfMemory:
		return "out of memory";
	case Status::Cancelled:
		return "cancelled";
	case Status::OutOfTime:
		return "out of time";
	case Status::InternalError:
		return "internal error";
	}
	return "unknown";
}

} // namespace gpr
