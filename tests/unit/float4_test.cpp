// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Operations on four floats have the bits of operations on each float. Built twice: with the
// compiler's vectors, and without (GPR_SCALAR_LANES).

#include <vcg_extras/core/base/float4.h>

#include <cstdint>
#include <cstring>
#include <gtest/gtest.h>
#include <random>

namespace gpr::test {

namespace {

std::uint32_t bitsOf(float x)
{
	std::uint32_t bits;
	std::memcpy(&bits, &x, sizeof bits);
	return bits;
}

} // namespace

TEST(Float4, HasTheBitsOfSingleFloats)
{
	std::mt19937                          random(7);
	std::uniform_real_distribution<float> number(-3, 3);
	for (int i = 0; i < 1000; ++i) {
		float a[4], b[4], expected[4];
		for (int k = 0; k < 4; ++k) {
			a[k]        = number(random);
			b[k]        = number(random);
			expected[k] = a[k] + b[k] * b[k] * a[0];
		}
		const Float4 x(a[0], a[1], a[2], a[3]), y(b[0], b[1], b[2], b[3]);
		Float4       sum = x;
		sum += y * y * a[0];
		for (int k = 0; k < 4; ++k)
			EXPECT_EQ(bitsOf(sum[k]), bitsOf(expected[k]));
	}
	EXPECT_EQ(Float4()[3], 0);
}

} // namespace gpr::test
