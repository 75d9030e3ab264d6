// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GPR_TESTS_GEODESICS_DISTANCE_CASES_H
#define GPR_TESTS_GEODESICS_DISTANCE_CASES_H

#include <vcg_extras/core/mesh_view.h>

#include <string>
#include <vector>

namespace gpr::test {

/// A surface for measuring distances, and the bands of the errors, as shares of the exact
/// distances.
struct DistanceCase {
	std::string  name;
	std::string  words; ///< for the page
	TriangleMesh mesh;
	double       percent    = 10;    ///< target that decides the disk radius
	double       maxMean    = 0.004; ///< mean error
	double       maxLargest = 0.06;  ///< largest error, either way
};

/// Surfaces made in code.
std::vector<DistanceCase> madeDistanceCases();
/// Models of the folder GPR_MODELS_DIR: name, words and bands, without the mesh.
std::vector<DistanceCase> modelDistanceCases();

} // namespace gpr::test

#endif
