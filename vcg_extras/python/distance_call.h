// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_PYTHON_DISTANCE_CALL_H
#define VCG_EXTRAS_PYTHON_DISTANCE_CALL_H

#include "arrays.h"

#include <nanobind/nanobind.h>

namespace gpr::python {

/// Measures and proves the distances of two surfaces from each other, like `gpremesh compare`: a
/// dictionary with status and message, and for each direction, "a_to_b" and "b_to_a", a dictionary
/// with rms, mean, p999, largest, lower and upper in mesh units. sampleNum points are spread over
/// each surface; 0: ten for each face of b. Runs without the interpreter's lock.
nb::dict measureDistance(const Positions& positionsOfA, const Triangles& trianglesOfA,
						 const Positions& positionsOfB, const Triangles& trianglesOfB,
						 std::int64_t sampleNum, int threads, nb::object progress);

} // namespace gpr::python

#endif
