// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_GUARD_CONTACT_REMOVAL_H
#define VCG_EXTRAS_CORE_GUARD_CONTACT_REMOVAL_H

#include "patch_filling.h"

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/face_contact.h>
#include <vcg_extras/core/report.h>
#include <vcg_extras/core/surface/result_mesh.h>

#include <cstdint>

namespace gpr {

/// What became of the self-intersections of a result.
struct ContactOutcome {
	/// Vertices of the result now; where it is refused, of the least mesh that has none.
	std::int64_t vertexNum = 0;
	/// Self-intersections are left: without them there would be more vertices than there may be.
	bool isRefused = false;
	bool hasMade   = false; ///< vertices were made here, in this call or in one before
	bool isCapped  = false; ///< patches were left out, since the work would be too much
};

/// Looks for self-intersections of the finished result, exactly and touching included; what is
/// known of them is not looked for again. Where the input has none nearby, patches around them are
/// made anew by guarded collapses of the input (patch_filling.h), with as many vertices. Where
/// pairs are left all the same, the components that have them are made anew in this way. Where the
/// collapses end above the count that is taken if making.mayEndAbove. Else the result is refused
/// or, where the input intersects itself, stays as it was. `figures` count what earlier calls made,
/// too. Cost: a pass over the result's faces where it has none; else that of the collapses, and a
/// pass over the input's faces.
ContactOutcome removeContacts(const MakingOfVertices& making, KnownContacts& contacts,
							  ResultMesh& result, GuardedFigures& figures, Workers& workers);

} // namespace gpr

#endif
