// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_GUARD_PATCH_CHANGES_H
#define VCG_EXTRAS_CORE_GUARD_PATCH_CHANGES_H

#include "input_contacts.h"
#include "patch_filling.h"
#include "patch_part.h"

#include <vector>

namespace gpr {

/// Removes contacts of a patch by flips and by moves of vertices on the surface, so that no
/// vertices have to be made anew. Patches with too many contacts for the work are left alone.
/// marked: per face of the part, the faces of the patch. Returns whether fewer contacts are left;
/// `out` then has the changed patch. Otherwise part and `out` stay as they were.
/// work: of the search, see LocalSearch.
bool changePatch(const MakingOfVertices& making, const InputContacts& ofInput, PatchPart& part,
				 const std::vector<char>& marked, std::int64_t work, Workers& workers,
				 FilledPart& out);

} // namespace gpr

#endif
