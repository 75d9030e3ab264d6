// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vain_tries.h"

#include <algorithm>

namespace gpr {

namespace {

/// Treatments move the corners of a face and of those beyond its edges, and look at what is round
/// the faces of these.
constexpr int ringNum = 3;

} // namespace

bool VainTries::isVain(const HalfEdgeMesh& m, int f, int kind) const
{
	const auto found = vainAt_.find(keyOf(m, f, kind));
	if (found == vainAt_.end()) return false;
	std::vector<int> near = verticesOf(m, {f});
	for (int ring = 0; ring < ringNum; ++ring)
		near = verticesOf(m, facesRound(m, near));
	return std::all_of(near.begin(), near.end(),
					   [&](int v) { return changedAt_[v] <= found->second; });
}

VainTries::Key VainTries::keyOf(const HalfEdgeMesh& m, int f, int kind)
{
	Key key = {m.origin[3 * f], m.origin[3 * f + 1], m.origin[3 * f + 2], kind};
	std::sort(key.begin(), key.begin() + 3);
	return key;
}

} // namespace gpr
