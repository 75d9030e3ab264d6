// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_EDIT_GOAL_H
#define VCG_EXTRAS_CORE_EDIT_GOAL_H

#include "acceptance.h"
#include "patch_editor.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace gpr {

/// The limits at which a search ends although bad faces are left.
struct Budget {
	int          rounds     = 8;    ///< passes over all bad faces
	float        maxLeft    = 1;    ///< another round needs at most this share of bad faces left
	std::int64_t attempts   = 2000; ///< faces to try
	bool         limitsWork = true; ///< whether the work of all searches is limited
};

/// The goal of a search.
struct Goal {
	std::function<bool(int face)>  isBad; ///< called in parallel
	std::function<float(int face)> faceCost;
	float maxLeft = 0.995f, minGain = 0; ///< a change leaves at most this share of cost, less this
	float collapseCost = 0; ///< a collapse must gain this much more than other operations
	float contactCost  = 0; ///< cost of a contact of a face; 0: contacts are not looked for
	std::vector<Operation::Kind>          operations;
	std::function<bool(const Operation&)> make;        ///< in place of PatchEditor::make, or null
	std::vector<float>                    stepLengths; ///< of moves, in mean edges
	bool       settles    = true;  ///< the mesh round a change settles by moves and flips
	bool       takesFirst = false; ///< every helpful operation is kept, not only the best
	bool       inPairs    = false; ///< two operations in a row; not with a limit on contacts
	bool       mayCrowd   = false; ///< vertices of curves may crowd
	Acceptance limits;
	Budget     budget;
};

} // namespace gpr

#endif
