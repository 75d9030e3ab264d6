// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_GUARD_PATCH_ROUNDS_H
#define VCG_EXTRAS_CORE_GUARD_PATCH_ROUNDS_H

#include "input_contacts.h"
#include "patch_part.h"

#include <vector>

namespace gpr {

/// What was made in patches.
struct PatchOutcome {
	bool isCapped = false;       ///< patches were left out, since the work would be too much
	std::vector<FacePair> pairs; ///< that are left, without the input's own
};

/// Makes patches of a result anew (PatchFilling) around pairs of faces that touch. Patches that
/// a pair joins are one patch. Each is cut out and filled by itself; those that would change the
/// same faces take turns, the others are filled in parallel. One that does not fit grows, until it
/// is most of its component, which then is left to be made anew as a whole. Around pairs that are
/// left larger patches are made. The work is bounded by the size of the input; the largest patches
/// come first. Which patches are filled together depends on no number of threads. Cost: that of the
/// patches, and for each turn a pass over the result.
PatchOutcome fillPatches(const MakingOfVertices& making, const InputContacts& ofInput,
						 const std::vector<FacePair>& pairs, ResultMesh& result, Workers& workers);

} // namespace gpr

#endif
