// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vcg_extras/core/base/angle.h>

#include <gtest/gtest.h>

namespace gpr::test {

TEST(AngleBetween, IsThatOfTheDirections)
{
	EXPECT_FLOAT_EQ(angleBetween({2, 0, 0}, {0, 3, 0}), float(pi / 2));
	EXPECT_FLOAT_EQ(angleBetween({1, 0, 0}, {-5, 0, 0}), float(pi));
	EXPECT_NEAR(angleBetween({1, 1e-4f, 0}, {1, 0, 0}), 1e-4, 1e-9);
}

/// Products with negative zeros are no angle of 180°.
TEST(AngleBetween, IsNoneWhereOneHasNoLength)
{
	for (float x : {-1.0f, 1.0f}) {
		for (float y : {-1.0f, 1.0f}) {
			for (float z : {-1.0f, 1.0f}) {
				EXPECT_EQ(angleBetween({0, 0, 0}, {x, y, z}), 0);
				EXPECT_EQ(angleBetween({x, y, z}, {0, 0, 0}), 0);
			}
		}
	}
}

} // namespace gpr::test
