// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "failed_attempts.h"

#include <algorithm>

namespace gpr {

namespace {

/// A search changes the corners of a face and the vertices beyond its edges, and looks at the faces
/// round these vertices.
constexpr int ringNum = 3;

} // namespace

std::int64_t FailedAttempts::noteChange(const HalfEdgeMesh& m, std::vector<int> ring)
{
	std::int64_t work = 0;
	++now_;
	for (int v : ring)
		changedAt_[v] = now_;
	for (int num = 0; num < ringNum; ++num) {
		std::vector<int> next;
		for (int v : ring) {
			forEachNeighbour(m, v, [&](int w) {
				++work;
				if (changedAt_[w] != now_) next.push_back(w);
				changedAt_[w] = now_;
			});
		}
		ring.swap(next);
	}
	return work;
}

bool FailedAttempts::isKnown(const HalfEdgeMesh& m, int f) const
{
	const Key  key   = keyOf(m, f);
	const auto found = failedAt_.find(key);
	if (found == failedAt_.end()) return false;
	return std::all_of(key.begin(), key.end(),
					   [&](int v) { return changedAt_[v] <= found->second; });
}

FailedAttempts::Key FailedAttempts::keyOf(const HalfEdgeMesh& m, int f)
{
	Key key = {m.origin[3 * f], m.origin[3 * f + 1], m.origin[3 * f + 2]};
	std::sort(key.begin(), key.end());
	return key;
}

} // namespace gpr
