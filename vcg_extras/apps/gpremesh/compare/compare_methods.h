// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_COMPARE_COMPARE_METHODS_H
#define VCG_EXTRAS_APPS_GPREMESH_COMPARE_COMPARE_METHODS_H

#include "compare_record.h"

#include <vcg_extras/io/mesh/mesh_data.h>

#include <functional>

namespace gpr::app {

/// The methods to compare, and the number of runs.
struct CompareWishes {
	RemeshOptions options;  ///< of the engine; a second run takes the paper preset over these
							///< options
	int  runNum    = 1;     ///< rounds; each round runs every method once
	bool isotropic = false; ///< vcglib's isotropic remeshing too
};

/// Receives a phrase about the work, and the share of all work done before; throws to stop.
using CompareProgress = std::function<void(double share, const std::string& phrase)>;

/// Runs every method on the mesh, in alternation, and measures the results: the paper's Table 1 for
/// any mesh. Quadric Edge Collapse gets the number of faces of the default path's result, isotropic
/// remeshing its mean edge length. A failed method is recorded with the reason; only a failure of
/// the default path throws AppError. Cost: all methods, and some seconds per million faces for the
/// distances of each method.
CompareRecord compareMethods(const InputMesh& input, const CompareWishes& wishes,
							 const CompareProgress& progress);

} // namespace gpr::app

#endif
