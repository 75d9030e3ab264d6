// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_PYTHON_DISTANCE_CALL_H
#define VCG_EXTRAS_PYTHON_DISTANCE_CALL_H

#include "arrays.h"

#include <nanobind/nanobind.h>

namespace gpr::python {

/// Distances of two surfaces from each other, measured and proven as `gpremesh compare` does it: a
/// dictionary with status and message, and one for each direction, "a_to_b" and "b_to_a", with rms,
/// mean, p999, largest, lower and upper in mesh units. sampleNum points are spread over each
/// surface; 0 takes ten for each face of b. Runs without the interpreter's lock.
nb::dict measureDistance(const Positions& positionsOfA, const Triangles& trianglesOfA,
						 const Positions& positionsOfB, const Triangles& trianglesOfB,
						 std::int64_t sampleNum, int threads, nb::object progress);

} // namespace gpr::python

#endif
