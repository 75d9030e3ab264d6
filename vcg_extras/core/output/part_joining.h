// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OUTPUT_PART_JOINING_H
#define VCG_EXTRAS_CORE_OUTPUT_PART_JOINING_H

#include <vcg_extras/core/input/selected_part.h>
#include <vcg_extras/core/mesh_view.h>
#include <vcg_extras/core/options.h>
#include <vcg_extras/core/results.h>

namespace gpr {

/// The options for remeshing the selected faces as a mesh whose border stays, vertex by vertex.
RemeshOptions optionsInside(const RemeshOptions& options);

/// Joins the remeshed selection to the rest: first the unselected faces in their order, then the
/// new faces; both share the vertices of the seam. `made` is a result of status Ok with
/// optionsInside; `options` are the user's. Throws Failure if the seam does not fit. Cost: linear
/// in the input.
RemeshResult joinPart(const MeshView& input, const SelectedPart& part, const RemeshOptions& options,
					  RemeshResult made);

} // namespace gpr

#endif
