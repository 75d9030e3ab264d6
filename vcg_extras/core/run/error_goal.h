// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_RUN_ERROR_GOAL_H
#define VCG_EXTRAS_CORE_RUN_ERROR_GOAL_H

#include <vcg_extras/core/mesh_view.h>

#include <cstdint>
#include <functional>

namespace gpr {

/// A count is looked for whose mesh has an error no larger than this.
struct ErrorGoal {
	double       largest   = 0;
	std::int64_t start     = 0; ///< count that is tried first
	std::int64_t most      = 0; ///< larger counts are not tried
	int          maxTrials = 16;
};

/// What a trial came to; vertexNum differs from what was asked for where topology needs more.
struct ErrorTrial {
	std::int64_t vertexNum = 0;
	double       error     = 0;
};

/// Looks for the smallest count that meets the goal: by the power law through the last counts tried
/// on either side, or of what is usual where there is but one, until counts that meet it and that
/// miss it are within 3 % of each other. The error of a mesh is not quite monotonic in its count;
/// so what is found is a count that meets the goal next to one that does not. Returns the least
/// count that met it; 0 if none did up to goal.most or within goal.maxTrials.
std::int64_t searchCount(const ErrorGoal&                               goal,
						 const std::function<ErrorTrial(std::int64_t)>& trial);

/// Area and diagonal of a mesh as given, mesh units; faces with indices out of range or corners
/// that are not finite are left out.
struct MeshExtent {
	double area     = 0;
	double diagonal = 0;
};
MeshExtent extentOf(const MeshView& mesh);

} // namespace gpr

#endif
