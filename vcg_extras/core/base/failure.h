// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_BASE_FAILURE_H
#define VCG_EXTRAS_CORE_BASE_FAILURE_H

#include <vcg_extras/core/results.h>

#include <cstdint>
#include <string>
#include <utility>

namespace gpr {

/// The size of a mesh.
struct MeshSize {
	std::int64_t vertexNum = 0;
	std::int64_t faceNum   = 0;

	/// The size with more vertices inside the surface.
	MeshSize plus(std::int64_t num) const { return {vertexNum + num, faceNum + 2 * num}; }
};

/// An exception for a run that cannot go on; the facade turns the exception into a result without a
/// mesh.
struct Failure {
	Status      status;
	std::string message;  ///< a sentence for the user
	MeshSize    possible; ///< of a refused count: the least or nearest possible size; else empty

	Failure(Status s, std::string m, const MeshSize& p = {}) :
			status(s), message(std::move(m)), possible(p)
	{
	}
};

} // namespace gpr

#endif
