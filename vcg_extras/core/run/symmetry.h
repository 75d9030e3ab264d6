// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_RUN_SYMMETRY_H
#define VCG_EXTRAS_CORE_RUN_SYMMETRY_H

#include "remeshing.h"

namespace gpr {

/// Makes a symmetric mesh of a symmetric surface: finds the plane and compares the surface with its
/// mirror image (input/mirror_half.h), remeshes the half above the plane (remeshInput), joins the
/// half with the mirrored half (output/mirror_joining.h), and checks the whole. Throws Failure if
/// the surface is not symmetric or the count is not possible.
void remeshSymmetric(const Call& call, RemeshResult& out);

} // namespace gpr

#endif
