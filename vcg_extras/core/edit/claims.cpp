// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "claims.h"

#include <algorithm>
#include <cstdlib>

namespace gpr {

namespace {

/// Rings of vertices round a face with the same owner, and how many of these may change.
constexpr int ringNum = 4, changingRings = 2;
/// With more vertices in the rings, as round a vertex with thousands of neighbours, the face is
/// tried alone: a walk over the rings would take longer than the trial.
constexpr std::size_t mostVertices = 500;

} // namespace

int Claims::claim(const HalfEdgeMesh& m, int face)
{
	reached_.clear();
	work_ = 0;
	++visit_;
	bool       isTaken = false;
	const auto isWide  = [&] { return reached_.size() > mostVertices; };
	const auto reach   = [&](int v) {
        ++work_;
        if (visitOf_[v] == visit_) return;
        visitOf_[v] = visit_;
        isTaken     = isTaken || std::abs(owner_[v]) >= first_;
        reached_.push_back(v);
	};
	for (int h = 3 * face; h < 3 * face + 3; ++h)
		reach(m.origin[h]);
	std::size_t begin = 0, changingNum = 0;
	for (int ring = 0; ring < ringNum && !isTaken && !isWide(); ++ring) {
		const std::size_t end = reached_.size();
		if (ring == changingRings) changingNum = end;
		for (; begin < end && !isTaken && !isWide(); ++begin)
			forEachNeighbour(m, reached_[begin], reach);
	}
	if (isWide()) return everything;
	if (isTaken) return 0;
	const int name = next_++;
	for (std::size_t i = 0; i < reached_.size(); ++i)
		owner_[reached_[i]] = i < changingNum ? name : -name;
	return name;
}

bool Claims::allow(int claim, const std::vector<int>& patch) const
{
	return claim == everything ||
		   std::all_of(patch.begin(), patch.end(), [&](int v) { return owner_[v] == claim; });
}

} // namespace gpr
