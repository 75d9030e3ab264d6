// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OUTPUT_PART_JOINING_H
#define VCG_EXTRAS_CORE_OUTPUT_PART_JOINING_H

#include <vcg_extras/core/input/selected_part.h>
#include <vcg_extras/core/mesh_view.h>
#include <vcg_extras/core/options.h>
#include <vcg_extras/core/results.h>

namespace gpr {

/// The options with which the selected faces are remeshed as a mesh of their own: its border stays,
/// vertex by vertex.
RemeshOptions optionsInside(const RemeshOptions& options);

/// Puts what was made of the selected faces in their place: first the faces that are not selected,
/// in their order, then the new ones. Both share the vertices of the seam. `made` is a result of
/// status Ok with optionsInside; `options` are the caller's. Throws Failure where the seam does not
/// fit. Cost: linear in the input.
RemeshResult joinPart(const MeshView& input, const SelectedPart& part, const RemeshOptions& options,
					  RemeshResult made);

} // namespace gpr

#endif
