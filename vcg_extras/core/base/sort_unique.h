// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_BASE_SORT_UNIQUE_H
#define VCG_EXTRAS_CORE_BASE_SORT_UNIQUE_H

#include <algorithm>
#include <vector>

namespace gpr {

/// Sorts a list and removes duplicates. Cost: O(n log n).
template <class T>
void sortUnique(std::vector<T>& list)
{
	std::sort(list.begin(), list.end());
	list.erase(std::unique(list.begin(), list.end()), list.end());
}

} // namespace gpr

#endif
