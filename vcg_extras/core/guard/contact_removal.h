// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_GUARD_CONTACT_REMOVAL_H
#define VCG_EXTRAS_CORE_GUARD_CONTACT_REMOVAL_H

#include "patch_filling.h"

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/report.h>
#include <vcg_extras/core/surface/result_mesh.h>

#include <cstdint>

namespace gpr {

/// The outcome of removing self-intersections from a result.
struct ContactOutcome {
	/// Vertices of the result now. If refused: as reached by the collapses of whole components, if
	/// any.
	std::int64_t vertexNum = 0;
	/// Self-intersections are left: removing these would take more vertices than allowed, or other
	/// vertices at a kept border.
	bool isRefused = false;
	bool isCapped  = false; ///< patches were left out, since the work would be too much
};

/// Finds self-intersections of the finished result, exactly, touching faces included. Away from
/// self-intersections of the input, flips and moves remove the contacts of small patches
/// (patch_changes.h); other patches are made anew by guarded collapses of the input
/// (patch_filling.h), with as many vertices as before. If contacts are left, whole components with
/// contacts are made anew in the same way. If the collapses end above the number of vertices, the
/// new components are taken if making.mayEndAbove. Else the result is refused or, if the input
/// intersects itself, stays unchanged. figures: pairs found are added; of the made vertices those
/// count that the result has now, made in this call or an earlier call. Cost: a pass over the
/// result's faces if there are no contacts; else the collapses, and a pass over the input's faces.
ContactOutcome removeContacts(const MakingOfVertices& making, ResultMesh& result,
							  GuardedFigures& figures, Workers& workers);

/// Makes patches round some faces anew in the same way, with three times the vertices: where the
/// result is far from the input and no single change brings it nearer, as in folds that have become
/// tangled. A patch that would touch itself or its surroundings stays as it was. Cost: as
/// removeContacts, without whole components. False if patches were left out, since the work would
/// be too much.
bool makeFiner(MakingOfVertices making, const std::vector<int>& faces, ResultMesh& result,
			   Workers& workers);

} // namespace gpr

#endif
