// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <tests/support/random_source.h>
#include <vcg_extras/core/guard/sparse_array.h>

#include <gtest/gtest.h>
#include <map>

namespace gpr::test {

namespace {

TEST(SparseArray, HasWhatWasSetLast)
{
	Random             random(1);
	const int          num = 100000;
	SparseArray<int>   array(num, -1);
	std::map<int, int> expected;
	for (int i = 0; i < 3000; ++i) {
		const int at = i % 2 == 0 ? random.below(num) : 512 * 7 + random.below(1024);
		array.set(at, i);
		expected[at] = i;
	}
	for (int i = 0; i < num; ++i) {
		const auto found = expected.find(i);
		ASSERT_EQ(array[i], found == expected.end() ? -1 : found->second) << i;
	}
}

TEST(SparseArray, HoldsTheLastIndexOfAnyNumber)
{
	for (int num : {1, 511, 512, 513}) {
		SparseArray<float> array(num, 2.5f);
		array.set(num - 1, 7);
		EXPECT_EQ(array[num - 1], 7);
		EXPECT_EQ(array[0], num == 1 ? 7 : 2.5f);
	}
}

TEST(SparseArray, PlacesInAList)
{
	const SparseArray<int> place = placesIn({900, 3, 5}, 1000);
	EXPECT_EQ(place[900], 0);
	EXPECT_EQ(place[3], 1);
	EXPECT_EQ(place[5], 2);
	EXPECT_EQ(place[4], -1);
}

} // namespace

} // namespace gpr::test
