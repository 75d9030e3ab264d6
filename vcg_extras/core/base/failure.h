// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_BASE_FAILURE_H
#define VCG_EXTRAS_CORE_BASE_FAILURE_H

#include <vcg_extras/core/results.h>

#include <cstdint>
#include <string>
#include <utility>

namespace gpr {

/// An exception for a run that cannot go on; the facade turns the exception into a result without a
/// mesh.
struct Failure {
	Status       status;
	std::string  message;               ///< a sentence for the user
	std::int64_t smallestVertexNum = 0; ///< with CountTooSmall: the least possible count
	std::int64_t smallestFaceNum   = 0; ///< likewise for a target of faces; 0: not known

	Failure(Status s, std::string m, std::int64_t smallest = 0, std::int64_t smallestFaces = 0) :
			status(s), message(std::move(m)), smallestVertexNum(smallest),
			smallestFaceNum(smallestFaces)
	{
	}
};

} // namespace gpr

#endif
