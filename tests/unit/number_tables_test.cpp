// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <tests/support/random_source.h>
#include <vcg_extras/core/base/sort_unique.h>
#include <vcg_extras/core/input/edge_table.h>

#include <cstddef>
#include <gtest/gtest.h>
#include <vector>

namespace gpr::test {

namespace {

/// Few numbers are sorted, many are marked.
TEST(SortUniqueBelow, GivesTheSameForFewAndForMany)
{
	Random        random(1);
	constexpr int end = 1000;
	for (const int num : {0, 1, 20, 62, 63, 500, 5000}) {
		std::vector<int> list;
		list.reserve(std::size_t(num));
		for (int i = 0; i < num; ++i)
			list.push_back(int(random.between(0, end)));
		std::vector<int> wanted = list;
		sortUnique(wanted);
		sortUniqueBelow(end, list);
		EXPECT_EQ(list, wanted) << num;
	}
}

/// More edges at each vertex than lie beside its place: the others are elsewhere.
TEST(EdgeTable, FindsAllEdgesOfCrowdedVertices)
{
	constexpr int vertexNum = 2000, perVertex = 20;
	EdgeTable     table;
	for (const bool isKnown : {false, true}) {
		int number = 0;
		for (int a = 0; a < vertexNum; ++a) {
			for (int k = 1; k <= perVertex; ++k, ++number) {
				const int next = isKnown ? -2 : number;
				EXPECT_EQ(table.findOrPut(a, a + k, next), number);
				EXPECT_EQ(table.findOrPut(a + k, a, -2), number) << "the same edge";
			}
		}
	}
	EXPECT_EQ(table.size(), std::size_t(vertexNum * perVertex));
}

} // namespace

} // namespace gpr::test
