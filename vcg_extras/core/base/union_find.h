// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_BASE_UNION_FIND_H
#define VCG_EXTRAS_CORE_BASE_UNION_FIND_H

#include <algorithm>

namespace gpr {

/// Disjoint sets of numbers, as a table of parents: an array, or a map that has all of them. A root
/// is its own parent. Shortens the way by path halving.
template <class Table>
int rootOf(Table& parent, int x)
{
	while (parent[x] != x)
		x = parent[x] = parent[parent[x]];
	return x;
}

/// Joins two sets. Their root is the smaller one of both, so that the order of calls does not
/// matter.
template <class Table>
void joinSets(Table& parent, int a, int b)
{
	const int rootA = rootOf(parent, a), rootB = rootOf(parent, b);
	parent[std::max(rootA, rootB)] = std::min(rootA, rootB);
}

} // namespace gpr

#endif
