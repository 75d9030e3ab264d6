// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_BASE_FAILURE_H
#define VCG_EXTRAS_CORE_BASE_FAILURE_H

#include <vcg_extras/core/results.h>

#include <string>
#include <utility>

namespace gpr {

/// Thrown inside the engine where a run cannot go on; the facade makes a RemeshResult of it.
struct Failure {
	Status      status;
	std::string message; ///< a sentence for the user

	Failure(Status s, std::string m) : status(s), message(std::move(m)) {}
};

} // namespace gpr

#endif
