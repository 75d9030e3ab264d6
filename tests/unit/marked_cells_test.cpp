// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The quick test whether a box meets any of many boxes.

#include <tests/support/random_source.h>
#include <vcg_extras/core/mesh/space_grid.h>

#include <algorithm>
#include <gtest/gtest.h>

namespace gpr::test {

namespace {

/// A box with sides up to `most`, partly beyond the unit cube.
Box<float> someBox(Random& random, double most)
{
	const auto  within = [&](double low, double high) { return float(random.between(low, high)); };
	const Vec3f low(within(-0.1, 1.1), within(-0.1, 1.1), within(-0.1, 1.1));
	return {low, low + Vec3f(within(0, most), within(0, most), within(0, most))};
}

} // namespace

TEST(MarkedCells, MissNoBoxThatMeetsAMark)
{
	Random random(5);
	for (double most : {0.0, 0.012, 0.3}) {
		MarkedCells             cells({0, 0, 0}, 1);
		std::vector<Box<float>> marks;
		for (int i = 0; i < 1000; ++i) {
			marks.push_back(someBox(random, 0.02));
			cells.mark(marks.back());
		}
		int meetingNum = 0, passedOver = 0;
		for (int i = 0; i < 20000; ++i) {
			const Box<float> box   = someBox(random, most);
			const bool       meets = std::any_of(marks.begin(), marks.end(),
												 [&](const Box<float>& m) { return m.meets(box); });
			ASSERT_TRUE(cells.mayMeet(box) || !meets);
			meetingNum += meets;
			passedOver += !cells.mayMeet(box);
		}
		EXPECT_GT(meetingNum, 0);
		EXPECT_GT(passedOver, most < 0.1 ? 15000 : 0) << "boxes up to " << most;
	}
}

} // namespace gpr::test
