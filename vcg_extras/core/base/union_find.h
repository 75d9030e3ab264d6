// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_BASE_UNION_FIND_H
#define VCG_EXTRAS_CORE_BASE_UNION_FIND_H

#include <algorithm>

namespace gpr {

/// Finds the root of x in disjoint sets of numbers. The table of parents is an array, or a map with
/// all numbers. A root is its own parent. Shortens paths by halving.
template <class Table>
int rootOf(Table& parent, int x)
{
	while (parent[x] != x)
		x = parent[x] = parent[parent[x]];
	return x;
}

/// Joins two sets. The root is the smaller root of both, so that the order of calls does not
/// matter.
template <class Table>
void joinSets(Table& parent, int a, int b)
{
	const int rootA = rootOf(parent, a), rootB = rootOf(parent, b);
	parent[std::max(rootA, rootB)] = std::min(rootA, rootB);
}

} // namespace gpr

#endif
