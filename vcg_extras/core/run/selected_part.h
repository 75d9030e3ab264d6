// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_RUN_SELECTED_PART_H
#define VCG_EXTRAS_CORE_RUN_SELECTED_PART_H

#include <vcg_extras/core/mesh_view.h>
#include <vcg_extras/core/options.h>
#include <vcg_extras/core/results.h>

#include <functional>

namespace gpr {

/// The run that remeshes the selected part as a mesh of its own.
using PartRun = std::function<RemeshResult(const MeshView& part, const RemeshOptions& options)>;

/// Remeshes the selected faces (MeshView::selectedFace) and puts the result in their place: the
/// part is cut out, remeshed with a border that stays, and joined to the other faces along the
/// vertices of its border. The other faces come out as they were, in their order, before the new
/// ones; vertices in no face are dropped. Throws Failure where nothing is selected or where the
/// seam cannot be kept: an edge at which more than two faces meet, or one that cleaning removed.
/// Cost: that of the run, and linear in the whole mesh, O(S log S) for the S edges of the seam.
RemeshResult remeshSelected(const MeshView& input, const RemeshOptions& options,
							const PartRun& run);

} // namespace gpr

#endif
