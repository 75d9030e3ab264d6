// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <tests/support/random_source.h>
#include <vcg_extras/core/base/page_pool.h>
#include <vcg_extras/core/base/pages.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <gtest/gtest.h>
#include <new>
#include <vector>

namespace gpr::test {

namespace {

constexpr std::size_t page = PagePool::pageBytes;

/// A system that only counts; no test writes to its memory.
std::size_t    mappedBytes = 0;
std::uintptr_t nextAddress = page;
bool           isFull      = false;

void* mapNothing(std::size_t bytes)
{
	if (isFull) return nullptr;
	void* const block = reinterpret_cast<void*>(nextAddress);
	nextAddress += bytes + page; // never side by side
	mappedBytes += bytes;
	return block;
}

void unmapNothing(void*, std::size_t bytes)
{
	mappedBytes -= bytes;
}

struct PagePoolTest : testing::Test {
	PagePool pool{{mapNothing, unmapNothing}};

	PagePoolTest() { mappedBytes = 0, isFull = false; }
};

} // namespace

TEST_F(PagePoolTest, HandsOutAgainWhatWasGivenBack)
{
	void* const block = pool.take(3 * page);
	pool.give(block, 3 * page);
	EXPECT_EQ(pool.take(3 * page), block);
	EXPECT_EQ(mappedBytes, 3 * page);
}

TEST_F(PagePoolTest, CutsLargeBlocksAndJoinsThemAgain)
{
	char* const whole = static_cast<char*>(pool.take(6 * page));
	pool.give(whole, 6 * page);
	void* const a = pool.take(2 * page);
	void* const b = pool.take(page + 1); // two pages
	void* const c = pool.take(2 * page);
	EXPECT_EQ(a, whole);
	EXPECT_EQ(b, whole + 2 * page);
	EXPECT_EQ(c, whole + 4 * page);
	pool.give(a, 2 * page);
	pool.give(c, 2 * page);
	pool.give(b, page + 1);
	EXPECT_EQ(pool.take(6 * page), whole);
	EXPECT_EQ(mappedBytes, 6 * page);
}

TEST_F(PagePoolTest, ReturnsToTheSystemWhatItDoesNotNeed)
{
	pool.give(pool.take(4 * page), 4 * page);
	EXPECT_EQ(mappedBytes, 4 * page);
	pool.returnAll();
	EXPECT_EQ(mappedBytes, 0u);
}

TEST_F(PagePoolTest, TellsThatThereIsNoMemory)
{
	isFull = true;
	EXPECT_THROW(pool.take(page), std::bad_alloc);
	isFull = false;
	EXPECT_NE(pool.take(page), nullptr);
}

/// Blocks in use never overlap, and the pool never has more pages than the blocks had at their
/// peak.
TEST_F(PagePoolTest, NeverHasMoreThanThePeak)
{
	struct Used {
		char*       begin;
		std::size_t bytes;
	};
	for (unsigned seed = 1; seed <= 20; ++seed) {
		Random            random(seed);
		std::vector<Used> used;
		std::size_t       inUse = 0, peak = 0;
		for (int i = 0; i < 300; ++i) {
			if (used.empty() || random.chance(0.5)) {
				const std::size_t bytes = std::size_t(1 + random.below(9)) * page;
				char* const       begin = static_cast<char*>(pool.take(bytes));
				for (const Used& u : used)
					ASSERT_TRUE(begin + bytes <= u.begin || u.begin + u.bytes <= begin);
				used.push_back({begin, bytes});
				inUse += bytes;
			}
			else {
				const auto at = used.begin() + random.below(int(used.size()));
				pool.give(at->begin, at->bytes);
				inUse -= at->bytes;
				used.erase(at);
			}
			peak = std::max(peak, inUse);
			ASSERT_LE(mappedBytes, peak) << seed << " " << i;
			ASSERT_GE(mappedBytes, inUse);
		}
		for (const Used& u : used)
			pool.give(u.begin, u.bytes);
		pool.returnAll();
		ASSERT_EQ(mappedBytes, 0u);
	}
}

/// The system's own pages, to their last byte.
TEST(Pages, LargeBlocksAreAlignedAndCanBeWritten)
{
	constexpr std::size_t bytes = 3 * page + 5;
	for (int i = 0; i < 3; ++i) {
		void* const block = allocatePages(bytes);
#if defined(__linux__) && !defined(__SANITIZE_ADDRESS__)
		EXPECT_EQ(reinterpret_cast<std::uintptr_t>(block) % page, 0u);
#endif
		std::memset(block, i, bytes);
		releasePages(block, bytes);
	}
	returnReleasedMemory();
}

} // namespace gpr::test
