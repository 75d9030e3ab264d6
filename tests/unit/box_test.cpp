// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vcg_extras/core/base/box.h>

#include <gtest/gtest.h>

namespace gpr::test {

namespace {

TEST(Box, IsEmptyAtFirstAndThenChangesNothing)
{
	const Box<float> empty;
	EXPECT_TRUE(empty.isEmpty());
	EXPECT_EQ(empty.diagonal(), 0);
	EXPECT_LT(empty.largestSide(), 0);
	Box<float> box({0, 0, 0}, {1, 2, 2});
	EXPECT_FALSE(box.meets(empty));
	box += empty;
	EXPECT_EQ(box.diagonal(), 3);
	EXPECT_EQ(box.largestSide(), 2);
}

TEST(Box, OfPointsTouchesTheOutermost)
{
	Box<double> box;
	box.add({1, -1, 5});
	EXPECT_FALSE(box.isEmpty());
	EXPECT_EQ(box.diagonal(), 0);
	box.add({-2, 3, 4});
	EXPECT_TRUE(box.low.x == -2 && box.low.y == -1 && box.low.z == 4);
	EXPECT_TRUE(box.high.x == 1 && box.high.y == 3 && box.high.z == 5);
}

TEST(Box, MeetsWhatItTouches)
{
	const Box<float> box({0, 0, 0}, {1, 1, 1});
	EXPECT_TRUE(box.meets({{1, 1, 1}, {2, 2, 2}}));
	EXPECT_TRUE(box.meets({{0.4f, 0.4f, 0.4f}, {0.5f, 0.5f, 0.5f}}));
	for (const Vec3f& away : {Vec3f(1.1f, 0, 0), Vec3f(0, 1.1f, 0), Vec3f(0, 0, -1.1f)})
		EXPECT_FALSE(box.meets({away, away + box.high * 0.5f - Vec3f(0, 0, 0.5f)}));
}

} // namespace

} // namespace gpr::test
