// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh_outcome.h"

namespace gpr::app {

std::string sentenceOf(const Outcome& outcome)
{
	if (outcome.message.empty()) return "the remeshing failed without a sentence.";
	return outcome.message;
}

void requireDone(const Outcome& outcome)
{
	constexpr ExitCode codes[] = {
		ExitCode::Done,          ExitCode::Usage,         ExitCode::BadInput,
		ExitCode::PromiseBroken, ExitCode::PromiseBroken, ExitCode::Failure,
		ExitCode::Stopped,       ExitCode::Stopped,       ExitCode::Failure}; // by Status
	if (outcome.status != Status::Ok)
		throw AppError(codes[int(outcome.status)], sentenceOf(outcome));
}

} // namespace gpr::app
