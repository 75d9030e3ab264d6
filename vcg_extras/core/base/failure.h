// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_BASE_FAILURE_H
#define VCG_EXTRAS_CORE_BASE_FAILURE_H

#include <vcg_extras/core/results.h>

#include <cstdint>
#include <string>
#include <utility>

namespace gpr {

/// Thrown inside the engine where a run cannot go on; the facade makes a result without a mesh of
/// it.
struct Failure {
	Status       status;
	std::string  message;               ///< a sentence for the user
	std::int64_t smallestVertexNum = 0; ///< with CountTooSmall: what to ask for instead
	std::int64_t smallestFaceNum   = 0; ///< the same where faces are counted; 0: not known
	std::int64_t nextFaceNum       = 0; ///< another number that the message names; 0: none

	Failure(Status s, std::string m, std::int64_t smallest = 0, std::int64_t smallestFaces = 0) :
			status(s), message(std::move(m)), smallestVertexNum(smallest),
			smallestFaceNum(smallestFaces)
	{
	}
};

} // namespace gpr

#endif
