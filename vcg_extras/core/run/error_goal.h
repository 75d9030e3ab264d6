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

/// What a trial came to; vertexNum differs from what was asked for where topology needs more, and
/// by what came in at single places.
struct ErrorTrial {
	std::int64_t vertexNum = 0;
	double       error     = 0;
	double       share     = 0; ///< of the area, that is beyond the goal
	double       growth    = 1; ///< what smaller triangles there ask for, over the count
	std::int64_t addedNum  = 0; ///< vertices that came in where the mesh was beyond the goal

	/// Before vertices came in.
	std::int64_t evenNum() const { return vertexNum - addedNum; }
};

/// Looks for the smallest count that meets the goal. Errors are about exponentially distributed,
/// and go with 1 / count: so the share of vertices that came in at single places tells with which
/// count a twentieth would. Fewer triangles with more vertices at single places would be less
/// regular, and hardly fewer in all. A count that meets the goal is lowered to that. One that
/// misses it at few places is tried again with a few percent more, since a trial is expected to
/// make triangles smaller where the ones before it missed the goal. Where more than 1 % of the area
/// misses it, the count is raised so that this much is left. Returns the least count, without what
/// came in, that met it; 0 if none did.
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
