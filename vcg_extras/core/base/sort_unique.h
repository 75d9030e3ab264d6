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

/// The place of a value in a sorted list; -1 if the list has no such value. Cost: O(log n).
template <class T>
int placeIn(const std::vector<T>& sorted, const T& value)
{
	const auto found = std::lower_bound(sorted.begin(), sorted.end(), value);
	return found != sorted.end() && *found == value ? int(found - sorted.begin()) : -1;
}

} // namespace gpr

#endif
