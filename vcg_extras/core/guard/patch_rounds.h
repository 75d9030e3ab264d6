// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_GUARD_PATCH_ROUNDS_H
#define VCG_EXTRAS_CORE_GUARD_PATCH_ROUNDS_H

#include "input_contacts.h"
#include "patch_part.h"

#include <vector>

namespace gpr {

/// The outcome of making patches anew.
struct PatchOutcome {
	bool isCapped = false;       ///< patches were left out, since the work would be too much
	std::vector<FacePair> pairs; ///< remaining contacts, without contacts of the input
};

/// Makes patches of a result anew (PatchFilling) round contacts. A contact joins the patches of its
/// two faces. Each patch is cut out and filled by itself; patches that would change the same faces
/// take turns, all others are filled in parallel. A patch that does not fit grows; a patch of most
/// of its component is left for making the component anew. Round remaining contacts larger patches
/// are made. The size of the working surface bounds the work; the largest patches come first. The
/// same patches are filled together for any number of threads. Cost: linear in the patches, and for
/// each turn a pass over the result.
PatchOutcome fillPatches(const MakingOfVertices& making, const InputContacts& ofInput,
						 const std::vector<FacePair>& pairs, ResultMesh& result, Workers& workers);

} // namespace gpr

#endif
