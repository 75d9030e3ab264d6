// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "failed_attempts.h"

#include <algorithm>

namespace gpr {

namespace {

/// A search changes the corners of a face and those beyond its edges, and looks at the faces round
/// these.
constexpr int ringNum = 3;

} // namespace

bool FailedAttempts::isKnown(const HalfEdgeMesh& m, int f) const
{
	const auto found = failedAt_.find(keyOf(m, f));
	if (found == failedAt_.end()) return false;
	std::vector<int> near = verticesOf(m, {f});
	for (int ring = 0; ring < ringNum; ++ring)
		near = verticesOf(m, facesRound(m, near));
	return std::all_of(near.begin(), near.end(),
					   [&](int v) { return changedAt_[v] <= found->second; });
}

FailedAttempts::Key FailedAttempts::keyOf(const HalfEdgeMesh& m, int f)
{
	Key key = {m.origin[3 * f], m.origin[3 * f + 1], m.origin[3 * f + 2]};
	std::sort(key.begin(), key.end());
	return key;
}

} // namespace gpr
