// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh_outcome.h"

namespace gpr::app {

namespace {

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
		break;
	}
	return ExitCode::Failure;
}

} // namespace

std::string sentenceOf(const Outcome& outcome)
{
	if (outcome.message.empty()) return "the remeshing failed without a sentence.";
	return outcome.message;
}

void requireDone(const Outcome& outcome)
{
	if (outcome.status != Status::Ok)
		throw AppError(exitCodeOf(outcome.status), sentenceOf(outcome));
}

} // namespace gpr::app
