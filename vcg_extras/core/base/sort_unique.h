// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_BASE_SORT_UNIQUE_H
#define VCG_EXTRAS_CORE_BASE_SORT_UNIQUE_H

#include <algorithm>
#include <numeric>
#include <vector>

namespace gpr {

/// Sorts a list and removes duplicates. Cost: O(n log n).
template <class T>
void sortUnique(std::vector<T>& list)
{
	std::sort(list.begin(), list.end());
	list.erase(std::unique(list.begin(), list.end()), list.end());
}

/// As sortUnique, for numbers in [0, end). Cost: linear if there are many numbers.
inline void sortUniqueBelow(int end, std::vector<int>& list)
{
	constexpr std::size_t fewest = 16; // a sort takes longer than a pass over 16 marks a number
	if (fewest * list.size() < std::size_t(end)) return sortUnique(list);
	std::vector<char> isIn(std::size_t(end), 0);
	for (int i : list)
		isIn[i] = 1;
	list.clear();
	for (int i = 0; i < end; ++i) {
		if (isIn[i]) list.push_back(i);
	}
}

/// The place of a value in a sorted list; -1 if the list has no such value. Cost: O(log n).
template <class T>
int placeIn(const std::vector<T>& sorted, const T& value)
{
	const auto found = std::lower_bound(sorted.begin(), sorted.end(), value);
	return found != sorted.end() && *found == value ? int(found - sorted.begin()) : -1;
}

/// The numbers 0, ..., n - 1, as of things that keep their numbers or are sets of their own.
inline std::vector<int> numbersBelow(std::size_t n)
{
	std::vector<int> numbers(n);
	std::iota(numbers.begin(), numbers.end(), 0);
	return numbers;
}

/// The first number in [0, n) that passes the test; n if none does. All numbers behind must pass
/// too. Cost: O(log n).
template <class Test>
int firstOf(int n, const Test& test)
{
	int low = 0, high = n;
	while (low < high) {
		const int middle = low + (high - low) / 2;
		if (test(middle))
			high = middle;
		else
			low = middle + 1;
	}
	return low;
}

} // namespace gpr

#endif
