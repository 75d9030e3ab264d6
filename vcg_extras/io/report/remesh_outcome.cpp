// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh_outcome.h"

namespace gpr::app {

ExitCode exitCodeOf(Status status)
{
	switch (status) {
	case Status::Ok:
		return ExitCode::Done;
	case Status::BadOptions:
		return ExitCode::Usage;
	case Status::UnusableInput:
		return ExitCode::BadInput;
	case Status::CountTooSmall:
	case Status::PromiseBroken:
		return ExitCode::PromiseBroken;
	case Status::Cancelled:
	case Status::OutOfTime:
		return ExitCode::Stopped;
	case Status::OutOfMemory:
	case Status::InternalError:
		return ExitCode::Failure;
	}
	return ExitCode::Failure;
}

std::string sentenceOf(const RemeshResult& result)
{
	if (result.message.empty()) return "the remeshing failed without a sentence.";
	return result.message;
}

void requireMesh(const RemeshResult& result)
{
	if (result.status != Status::Ok) throw AppError(exitCodeOf(result.status), sentenceOf(result));
}

} // namespace gpr::app
