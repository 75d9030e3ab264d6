// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Operations on four floats have the bits of operations on each float. Built twice: with the
// compiler's vectors, and without (GPR_SCALAR_LANES).

#include <vcg_extras/core/base/symmetric_matrix.h>

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

void expectSameBits(const Vec3f& a, const Vec3f& b)
{
	EXPECT_EQ(bitsOf(a.x), bitsOf(b.x));
	EXPECT_EQ(bitsOf(a.y), bitsOf(b.y));
	EXPECT_EQ(bitsOf(a.z), bitsOf(b.z));
}

/// Vectors with random coordinates from -3 to 3.
class RandomVectors {
public:
	explicit RandomVectors(unsigned seed) : random_(seed) {}

	Vec3f operator()() { return Vec3f(number_(random_), number_(random_), number_(random_)); }

private:
	std::mt19937                          random_;
	std::uniform_real_distribution<float> number_{-3, 3};
};

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

TEST(Float4, ProductsHaveTheBitsOfTheProductsOfVectors)
{
	RandomVectors vector(8);
	for (int i = 0; i < 1000; ++i) {
		const Vec3f  a = vector(), b = vector();
		const Float4 x(a), y(b);
		EXPECT_EQ(bitsOf(dot(x, y)), bitsOf(dot(a, b)));
		EXPECT_EQ(bitsOf(length(x)), bitsOf(length(a)));
		expectSameBits((x + y).xyz(), a + b);
		expectSameBits((x - y).xyz(), a - b);
		expectSameBits(cross(x, y).xyz(), cross(a, b));
	}
}

TEST(SymmetricLanes, HaveTheBitsOfTheMatrix)
{
	RandomVectors vector(9);
	for (int i = 0; i < 1000; ++i) {
		const Vec3f    n = vector(), v = vector();
		SymmetricLanes lanes = SymmetricLanes::outer(n) * 2;
		lanes += SymmetricLanes::outer(v);
		const SymmetricMatrix matrix = lanes.matrix();
		EXPECT_EQ(bitsOf(matrix.xz), bitsOf(n.x * n.z * 2 + v.x * v.z));
		EXPECT_EQ(bitsOf(matrix.yy), bitsOf(n.y * n.y * 2 + v.y * v.y));
		EXPECT_EQ(bitsOf(matrix.zz), bitsOf(n.z * n.z * 2 + v.z * v.z));
		expectSameBits((lanes * Float4(v)).xyz(), matrix * v);
	}
}

} // namespace gpr::test
