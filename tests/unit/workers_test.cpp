// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vcg_extras/core/base/buffer.h>
#include <vcg_extras/core/base/counting_sort.h>
#include <vcg_extras/core/base/workers.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <gtest/gtest.h>
#include <numeric>
#include <stdexcept>
#include <string>
#include <thread>

namespace gpr::test {

namespace {

class WorkersOf : public ::testing::TestWithParam<int> {
protected:
	Workers workers{GetParam(), nullptr};
};

TEST_P(WorkersOf, RangesCoverEveryIndexOnce)
{
	for (std::size_t n : {0u, 1u, 2u, 63u, 4096u, 100001u}) {
		std::vector<std::atomic<int>> seen(n);
		workers.forRange(n, [&](std::size_t begin, std::size_t end) {
			for (std::size_t i = begin; i < end; ++i)
				++seen[i];
		});
		for (std::size_t i = 0; i < n; ++i)
			ASSERT_EQ(seen[i], 1) << i << " of " << n;
	}
}

TEST_P(WorkersOf, TasksKnowTheirWorker)
{
	std::vector<std::atomic<int>> seen(1000);
	std::atomic<bool>             inRange{true};
	workers.forTasks(seen.size(), [&](std::size_t task, int worker) {
		++seen[task];
		if (worker < 0 || worker >= workers.threadNum()) inRange = false;
	});
	EXPECT_TRUE(inRange);
	for (const auto& s : seen)
		ASSERT_EQ(s, 1);
	EXPECT_EQ(workers.threadNum(), GetParam());
}

/// Sums of floating-point numbers depend on their order; the order must not depend on threads.
TEST_P(WorkersOf, SumsHaveTheSameBits)
{
	const auto body = [](std::size_t begin, std::size_t end) {
		double s = 0;
		for (std::size_t i = begin; i < end; ++i)
			s += std::sin(double(i)) * 1e-3;
		return s;
	};
	Workers      one(1, nullptr);
	const double alone = one.sum<double>(1000003, body);
	for (int i = 0; i < 20; ++i)
		ASSERT_EQ(workers.sum<double>(1000003, body), alone);
	EXPECT_EQ(workers.sum<double>(0, body), 0.0);
}

TEST_P(WorkersOf, CollectKeepsTheOrder)
{
	const std::vector<int> even =
		workers.collect<int>(50000, [](std::size_t b, std::size_t e, auto& out) {
			for (std::size_t i = b; i < e; ++i) {
				if (i % 2 == 0) out.push_back(int(i));
			}
		});
	ASSERT_EQ(even.size(), 25000u);
	for (std::size_t i = 0; i < even.size(); ++i)
		ASSERT_EQ(even[i], int(2 * i));
}

/// Few items may be expensive, as the disks of the sizes are.
TEST_P(WorkersOf, CollectCutsFewItemsIntoSmallPiecesOrPiecesAsAsked)
{
	const auto lengths = [](std::size_t b, std::size_t e, auto& out) { out.push_back(int(e - b)); };
	const std::vector<int> own = workers.collect<int>(1500, lengths);
	EXPECT_GE(own.size(), 60u);
	EXPECT_EQ(std::accumulate(own.begin(), own.end(), 0), 1500);
	EXPECT_EQ(workers.collect<int>(1500, lengths, 1000), (std::vector<int>{1000, 500}));
}

TEST_P(WorkersOf, CollectManyJoinsAsCollectDoes)
{
	const auto thirds = [](std::size_t b, std::size_t e, auto& out) {
		for (std::size_t i = b; i < e; ++i) {
			if (i % 3 == 0) out.push_back(int(i));
		}
	};
	for (std::size_t n : {0u, 1u, 4096u, 50000u}) {
		const std::vector<int> few  = workers.collect<int>(n, thirds);
		const Buffer<int>      many = workers.collectMany<int>(n, thirds);
		EXPECT_EQ(few, std::vector<int>(many.begin(), many.end()));
	}
}

TEST_P(WorkersOf, SumUpAddsAllThatCameBefore)
{
	for (std::size_t n : {0u, 1u, 16384u, 16385u, 100003u}) {
		std::vector<int> value(n);
		for (std::size_t i = 0; i < n; ++i)
			value[i] = int(i % 7) - 2;
		std::vector<int> sums = value;
		const int        last = workers.sumUp(sums.data(), n);
		int              sum  = 0;
		for (std::size_t i = 0; i < n; ++i)
			ASSERT_EQ(sums[i], sum += value[i]) << i << " of " << n;
		EXPECT_EQ(last, sum);
	}
}

TEST_P(WorkersOf, ExceptionsComeOutAndTheNextLoopRuns)
{
	for (std::size_t thrower : {0u, 499u, 999u}) {
		EXPECT_THROW(workers.forTasks(1000,
									  [&](std::size_t task, int) {
										  if (task == thrower) throw std::runtime_error("task");
									  }),
					 std::runtime_error);
		std::atomic<int> ran{0};
		workers.forTasks(100, [&](std::size_t, int) { ++ran; });
		EXPECT_EQ(ran, 100);
	}
}

TEST_P(WorkersOf, ManyShortLoopsEnd)
{
	std::atomic<long> total{0};
	for (int i = 0; i < 5000; ++i)
		workers.forTasks(3, [&](std::size_t task, int) { total += long(task); });
	EXPECT_EQ(total, 15000);
}

TEST_P(WorkersOf, SortIntoBucketsIsTheStableSort)
{
	const auto  bucketOf = [](std::size_t i) { return int(i * 7919 % 101) - 1; }; // -1: left out
	Buffer<int> start, item;
	sortIntoBuckets(20000, 100, bucketOf, workers, start, item);
	ASSERT_EQ(start.size(), 101u);
	EXPECT_EQ(start[0], 0);
	EXPECT_EQ(start[100], int(item.size()));
	std::size_t expected = 0;
	for (int b = 0; b < 100; ++b) {
		for (int i = start[b]; i < start[b + 1]; ++i) {
			ASSERT_EQ(bucketOf(std::size_t(item[i])), b);
			if (i > start[b]) {
				ASSERT_LT(item[i - 1], item[i]);
			}
			++expected;
		}
	}
	EXPECT_EQ(expected, item.size());
}

TEST_P(WorkersOf, SortedByBucketsIsTheSort)
{
	using Pair = std::array<int, 2>;
	for (std::size_t n : {0u, 1u, 5u, 50000u}) {
		const auto make = [](std::size_t i) {
			return Pair{int(i * 7919 % 101), int(i * 104729 % 1009)};
		};
		std::vector<Pair> expected;
		for (std::size_t i = 0; i < n; ++i)
			expected.push_back(make(i));
		std::sort(expected.begin(), expected.end());
		const Buffer<Pair> sorted = sortedByBuckets<Pair>(
			n, 101, make, [](const Pair& p) { return p[0]; }, workers);
		EXPECT_EQ(std::vector<Pair>(sorted.begin(), sorted.end()), expected);
	}
}

INSTANTIATE_TEST_SUITE_P(Threads, WorkersOf, ::testing::Values(1, 2, 3, 4));

TEST(Workers, ZeroTakesOnePerCore)
{
	Workers workers(0, nullptr);
	EXPECT_GE(workers.threadNum(), 1);
}

TEST(Workers, RefusingInTheCallbackThrowsCancelledInTheCaller)
{
	for (int threads : {1, 3}) {
		int     asked = 0;
		Workers workers(threads, [&](double, const char*) { return ++asked < 3; });
		EXPECT_THROW(workers.forTasks(1000,
									  [](std::size_t, int) {
										  std::this_thread::sleep_for(std::chrono::milliseconds(3));
									  }),
					 CancelledError);
		EXPECT_EQ(asked, 3);
	}
}

TEST(Workers, ProgressNeverFallsBackAndNamesTheStage)
{
	double      last = 0;
	std::string phrase;
	Workers     workers(2, [&](double share, const char* p) {
        EXPECT_GE(share, last);
        EXPECT_LE(share, 0.5001);
        last   = share;
        phrase = p;
        return true;
    });
	workers.enterStage("Counting", 0, 0.5);
	for (int loop = 0; loop < 3; ++loop) {
		workers.forTasks(30, [](std::size_t, int) {
			std::this_thread::sleep_for(std::chrono::milliseconds(5));
		});
	}
	EXPECT_EQ(phrase, "Counting");
	EXPECT_GT(last, 0.1);
}

TEST(Buffer, ResizesKeepingWhatFits)
{
	Buffer<int> b(5, 7);
	b[4] = 9;
	b.resize(1000000); // large enough for pages of its own
	EXPECT_EQ(b.size(), 1000000u);
	EXPECT_EQ(b[3], 7);
	EXPECT_EQ(b[4], 9);
	b.resize(2);
	EXPECT_EQ(b.size(), 2u);
	EXPECT_EQ(b[1], 7);
}

TEST(Buffer, MovesItsMemory)
{
	Buffer<int> a(3, 1);
	const int*  memory = a.data();
	Buffer<int> b(std::move(a));
	EXPECT_EQ(b.data(), memory);
	Buffer<int> c(9, 2);
	c = std::move(b);
	EXPECT_EQ(c.data(), memory);
	EXPECT_EQ(c.size(), 3u);
	c.release();
	EXPECT_TRUE(c.empty());
	EXPECT_EQ(c.begin(), c.end());
}

/// Long tasks learn of a failure or of a stop in any thread.
TEST(Workers, LongTasksEndWithTheirLoop)
{
	for (int threads : {1, 2, 3}) {
		StopRequest stop{false};
		Workers     workers(threads, nullptr, 0, &stop);
		EXPECT_THROW(workers.forTasks(8,
									  [&](std::size_t, int worker) {
										  Workers inner(workers, worker);
										  inner.forEach(1'000'000'000, [&](int i) {
											  if (i == 100'000) stop = true;
										  });
									  }),
					 CancelledError)
			<< threads;
	}
}

TEST(Buffer, OfNothingIsEmpty)
{
	Buffer<double> b(0);
	EXPECT_TRUE(b.empty());
	b.fill(1);
	b.resize(3);
	EXPECT_EQ(b.size(), 3u);
}

TEST(Buffer, MoreThanThereIsIsRefused)
{
	EXPECT_THROW(Buffer<char>(std::size_t(1) << 60), std::bad_alloc);
}

} // namespace

} // namespace gpr::test
