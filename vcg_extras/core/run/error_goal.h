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
	int          maxTrials = 5;
};

/// What a trial came to; vertexNum differs from what was asked for where topology needs more.
struct ErrorTrial {
	std::int64_t vertexNum = 0;
	double       error     = 0;
	double       share     = 0; ///< of the area, that is beyond the goal
	double       growth    = 1; ///< what smaller triangles there ask for, over the count
};

/// Looks for the smallest count that meets the goal. A trial is expected to make triangles smaller
/// where the ones before it missed the goal; so a count that misses it at few places is tried again
/// with a few percent more. Where more than 1 % of the area misses it, the count is raised so
/// that this much is left: errors are about exponentially distributed, and go with 1 / count. A
/// count that meets the goal by far is lowered, by the power of the error that the trials show.
/// Returns the least count that met it; 0 if none did.
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
