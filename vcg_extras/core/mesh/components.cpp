// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "components.h"

namespace gpr {

Components findComponents(const HalfEdgeMesh& m, Workers& workers)
{
	Components       found;
	std::vector<int> stack;
	int              visitedNum = 0;
	found.ofFace.assign(std::size_t(m.faceNum), -1);
	const auto visit = [&](int f) {
		if (found.ofFace[std::size_t(f)] >= 0) return;
		found.ofFace[std::size_t(f)] = found.num;
		stack.push_back(f);
	};
	for (int f = 0; f < m.faceNum; ++f) {
		if (found.ofFace[std::size_t(f)] >= 0) continue;
		visit(f);
		while (!stack.empty()) {
			const int g = stack.back();
			stack.pop_back();
			if ((++visitedNum & 0xffff) == 0) workers.poll();
			for (int h = 3 * g; h < 3 * g + 3; ++h) {
				if (m.opposite[h] >= 0) visit(m.opposite[h] / 3);
			}
		}
		++found.num;
	}
	return found;
}

} // namespace gpr
