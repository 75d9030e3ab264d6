// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_RUN_ESTIMATE_H
#define VCG_EXTRAS_CORE_RUN_ESTIMATE_H

#include "mesh_view.h"
#include "options.h"
#include "parameters.h"

#include <string>

namespace gpr {

/// The expected size, time and memory of a run.
struct RunEstimate {
	double vertexNum = 0; ///< vertices of the result, or samples
	double seconds   = 0; ///< wall time on an idle machine of the year 2022
	double bytes     = 0; ///< peak memory without the input
};

/// Estimates time and memory of a run from the sizes of input and result, within a factor of two or
/// three for most meshes. Many non-manifold edges, or results so coarse that parts touch, take
/// longer. Never throws; estimates also runs that will be refused. Cost: constant; linear with a
/// target edge length or error.
RunEstimate estimateRun(const MeshView& input, const RemeshOptions& options,
						Tool tool = RemeshTool) noexcept;

/// "about 12 s and 0.7 GB of memory".
std::string estimateText(const RunEstimate& estimate);

} // namespace gpr

#endif
