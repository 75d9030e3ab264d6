// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vcg_extras/core/report_rows.h>

#include <cstring>
#include <gtest/gtest.h>
#include <set>
#include <string>

namespace gpr_test {

using gpr::CleanCounts;
using gpr::CountRow;

TEST(ReportRows, EveryCountOfTheCleaningHasOneRow)
{
	// All members except the last are counts.
	constexpr std::size_t num =
		(sizeof(CleanCounts) - sizeof(CleanCounts::longestJunction)) / sizeof(std::int64_t);
	std::int64_t values[num];
	for (std::size_t i = 0; i < num; ++i)
		values[i] = std::int64_t(i + 2);
	CleanCounts counts;
	std::memcpy(static_cast<void*>(&counts), values, sizeof values);
	const std::vector<CountRow> rows = describe(counts);
	ASSERT_EQ(rows.size(), num);
	std::set<std::string> keys, words;
	for (std::size_t i = 0; i < num; ++i) {
		EXPECT_EQ(rows[i].count, values[i]) << rows[i].key;
		EXPECT_TRUE(keys.insert(rows[i].key).second) << rows[i].key;
		if (!rows[i].isTold()) continue;
		EXPECT_TRUE(words.insert(rows[i].words()).second) << rows[i].key;
	}
}

TEST(ReportRows, OnlyWhatHappenedIsTold)
{
	CleanCounts counts;
	for (const CountRow& row : describe(counts))
		EXPECT_FALSE(row.isTold()) << row.key;
	counts.weldedVertices = 1;
	counts.sewnEdges      = 2;
	counts.longEdgesSplit = 3; // in JSON only: no change of the input's surface
	std::string told;
	for (const CountRow& row : describe(counts)) {
		if (row.isTold()) told += std::to_string(row.count) + " " + row.words() + "; ";
	}
	EXPECT_EQ(told, "1 vertex welded; 2 edges of seams sewn; ");
}

} // namespace gpr_test
