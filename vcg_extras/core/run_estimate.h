// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_RUN_ESTIMATE_H
#define VCG_EXTRAS_CORE_RUN_ESTIMATE_H

#include "mesh_view.h"
#include "options.h"
#include "parameters.h"

#include <string>

namespace gpr {

/// What a run will take, about.
struct RunEstimate {
	double vertexNum = 0; ///< of the result, or samples
	double seconds   = 0; ///< wall time on a machine of the year 2022 that does nothing else
	double bytes     = 0; ///< of memory at most, without the caller's mesh
};

/// Foresees time and memory of a tool's run from the sizes of mesh and result, within a factor of
/// two or three for most meshes; those with many non-manifold edges, or with results so coarse that
/// parts of them touch, take longer. Never throws; what is refused later is estimated all the same.
/// Cost: none to speak of; linear where an edge length or an error is asked for.
RunEstimate estimateRun(const MeshView& input, const RemeshOptions& options,
						Tool tool = RemeshTool) noexcept;

/// "about 12 s and 0.7 GB of memory".
std::string estimateText(const RunEstimate& estimate);

} // namespace gpr

#endif
