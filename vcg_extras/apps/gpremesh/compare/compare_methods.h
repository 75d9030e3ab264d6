// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_COMPARE_COMPARE_METHODS_H
#define VCG_EXTRAS_APPS_GPREMESH_COMPARE_COMPARE_METHODS_H

#include "compare_record.h"

#include <vcg_extras/io/mesh/mesh_data.h>

#include <functional>

namespace gpr::app {

/// Which methods are compared, and how often each is run.
struct CompareWishes {
	RemeshOptions options; ///< of the engine; the paper preset is laid over them for a second run
	int           runNum    = 1;     ///< rounds in which every method is run once
	bool          isotropic = false; ///< vcglib's isotropic remeshing too
};

/// Is told what is being done, with the share of all work before it; throws to stop.
using CompareProgress = std::function<void(double share, const std::string& phrase)>;

/// Runs every method on the mesh, in alternation, and measures what they made: the paper's Table 1
/// for any mesh. Quadric Edge Collapse gets the number of faces of the default path's result,
/// isotropic remeshing its mean edge length. A method that fails is recorded with its reason; only
/// the default path's failure throws AppError. Cost: the methods', and some seconds a million faces
/// for each method's distances.
CompareRecord compareMethods(const InputMesh& input, const CompareWishes& wishes,
							 const CompareProgress& progress);

} // namespace gpr::app

#endif
