// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_RUN_GUARDED_RESULT_H
#define VCG_EXTRAS_CORE_RUN_GUARDED_RESULT_H

#include "prepared.h"

#include <vcg_extras/core/base/run_context.h>
#include <vcg_extras/core/mesh/face_contact.h>
#include <vcg_extras/core/surface/result_mesh.h>

namespace gpr {

/// Looks for self-intersections of the finished result, exactly and touching included; what is
/// known of them is not looked for again. Where the input has none nearby, patches around them are
/// made anew by guarded collapses of the input (run/patch_filling.h), with as many vertices. Where
/// pairs are left all the same, the components that have them are made anew in this way. Where the
/// collapses end above the count it is taken if the options allow another one. Else the run is
/// refused (Failure) or, where the input intersects itself, the result stays as it was. Writes
/// report.audit.guarded, the target and, where vertices were made, the largest fit distance. Cost:
/// a pass over the result's faces where it has none; else that of the collapses, and a pass over
/// the input's faces.
void removeContacts(RunContext& run, Prepared& p, KnownContacts& contacts, ResultMesh& result);

} // namespace gpr

#endif
