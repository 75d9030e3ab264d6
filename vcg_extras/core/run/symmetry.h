// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_RUN_SYMMETRY_H
#define VCG_EXTRAS_CORE_RUN_SYMMETRY_H

#include "remeshing.h"

namespace gpr {

/// A symmetric mesh of a symmetric surface: the plane is found and the surface compared with its
/// mirror image (input/mirror_half.h); the half above the plane is remeshed (remeshInput), joined
/// to its image (output/mirror_joining.h), and checked as a whole. Throws Failure where the surface
/// is not symmetric, or the count cannot be had.
void remeshSymmetric(const Call& call, RemeshResult& out);

} // namespace gpr

#endif
