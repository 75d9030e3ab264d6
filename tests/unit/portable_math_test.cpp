// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vcg_extras/core/base/portable_math.h>
#include <vcg_extras/core/vec.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <gtest/gtest.h>
#include <limits>

namespace gpr::test {

namespace {

/// Without a long double wider than double, no comparison is possible.
constexpr bool hasWide = std::numeric_limits<long double>::digits >= 64;

constexpr int valueNum = 400000;

/// The same sequence on every system.
class Values {
public:
	/// From 0 to 1.
	double next()
	{
		state_ = state_ * 6364136223846793005u + 1442695040888963407u;
		return double(state_ >> 11) / 9007199254740992.0;
	}
	double between(double low, double high) { return low + (high - low) * next(); }
	/// Any power of two within these has the same chance.
	double ofAnySize(double lowPower, double highPower)
	{
		return std::exp2(between(lowPower, highPower));
	}

private:
	std::uint64_t state_ = 1;
};

/// The error over the distance of neighbouring numbers at the exact result.
template <class S>
double ulps(S value, long double exact)
{
	int exponent = 0;
	std::frexp(exact, &exponent);
	const int         least = std::numeric_limits<S>::min_exponent;
	const long double ulp =
		std::ldexp(1.0L, std::max(exponent, least) - std::numeric_limits<S>::digits);
	return double(std::abs(value - exact) / ulp);
}

std::uint64_t bitsOf(double x)
{
	std::uint64_t bits = 0;
	std::memcpy(&bits, &x, sizeof bits);
	return bits;
}

/// Largest error of an angle by float or double, for directions all round and for slight angles.
template <class S>
double worstAngle()
{
	Values values;
	double worst = 0;
	for (int i = 0; i < valueNum; ++i) {
		const S y = S(values.ofAnySize(-60, 10));
		const S x = S(i % 2 == 0 ? values.ofAnySize(-60, 10) : double(y) * values.between(-3, 3));
		for (S cosine : {x, -x})
			worst = std::max(worst, ulps(portable::angle(y, cosine),
										 std::atan2((long double) y, (long double) cosine)));
	}
	return worst;
}

} // namespace

TEST(PortableMath, AnglesOfFloatsAreThoseOfTheLibrary)
{
	if (!hasWide) GTEST_SKIP() << "long double is no wider than double";
	EXPECT_LT(worstAngle<float>(), 0.51);
}

TEST(PortableMath, AnglesOfDoublesAreThoseOfTheLibrary)
{
	if (!hasWide) GTEST_SKIP() << "long double is no wider than double";
	EXPECT_LT(worstAngle<double>(), 1.5);
}

TEST(PortableMath, AnglesAtTheEndsAreExact)
{
	for (float zero : {0.0f, -0.0f}) {
		EXPECT_EQ(portable::angle(0.0f, zero), 0);
		EXPECT_EQ(portable::angle(1.0f, zero), float(pi / 2));
		EXPECT_EQ(portable::angle(1.0, double(zero)), pi / 2);
	}
	EXPECT_EQ(portable::angle(0.0f, -2.0f), float(pi));
	EXPECT_EQ(portable::angle(0.0, -2.0), pi);
	EXPECT_EQ(portable::angle(0.0, 2.0), 0);
	EXPECT_EQ(portable::angle(3.0, 3.0), pi / 4);
	constexpr float none = std::numeric_limits<float>::quiet_NaN();
	EXPECT_EQ(portable::angle(none, 1.0f), 0);
	EXPECT_EQ(portable::angle(1.0f, none), 0);
}

/// Angles are compared with each other: a larger quotient must not give a smaller angle.
TEST(PortableMath, AnglesOfFloatsNeverFallWhereTheTangentRises)
{
	float last = 0;
	for (float y = 1e-3f; y < 2; y = std::nextafter(y, 4.0f) + 1e-6f) {
		const float now = portable::angle(y, 1.0f);
		ASSERT_GE(now, last) << y;
		last = now;
	}
}

TEST(PortableMath, SineAndCosineAreThoseOfTheLibrary)
{
	if (!hasWide) GTEST_SKIP() << "long double is no wider than double";
	Values values;
	double worst = 0;
	for (int i = 0; i < valueNum; ++i) {
		const double near = (i % 40 - 20) * (pi / 4) * (1 + values.between(-1, 1) * 1e-9);
		for (double x : {values.between(-8, 8), values.between(-100, 100), near}) {
			worst = std::max(worst, ulps(portable::sin(x), std::sin((long double) x)));
			worst = std::max(worst, ulps(portable::cos(x), std::cos((long double) x)));
		}
	}
	EXPECT_LT(worst, 2);
	EXPECT_EQ(portable::sin(0), 0);
	EXPECT_EQ(portable::cos(0), 1);
}

TEST(PortableMath, ExponentialIsThatOfTheLibrary)
{
	if (!hasWide) GTEST_SKIP() << "long double is no wider than double";
	Values values;
	double worst = 0;
	for (int i = 0; i < valueNum; ++i) {
		for (double x : {values.between(-700, 700), values.between(-2, 2)})
			worst = std::max(worst, ulps(portable::exp(x), std::exp((long double) x)));
	}
	EXPECT_LT(worst, 1);
	EXPECT_EQ(portable::exp(0), 1);
	EXPECT_EQ(portable::exp(1e9), portable::exp(700));
	EXPECT_EQ(portable::exp(-1e9), portable::exp(-700));
}

TEST(PortableMath, LogarithmIsThatOfTheLibrary)
{
	if (!hasWide) GTEST_SKIP() << "long double is no wider than double";
	Values values;
	double worst = 0;
	for (int i = 0; i < valueNum; ++i) {
		for (double x : {values.ofAnySize(-1060, 1023), values.between(0.3, 3),
						 1 + values.between(-1e-6, 1e-6)})
			worst = std::max(worst, ulps(portable::log(x), std::log((long double) x)));
	}
	EXPECT_LT(worst, 1);
	EXPECT_EQ(portable::log(1), 0);
}

TEST(PortableMath, PowersAreThoseOfTheLibrary)
{
	if (!hasWide) GTEST_SKIP() << "long double is no wider than double";
	Values values;
	for (int i = 0; i < valueNum; ++i) {
		const double x = values.ofAnySize(-20, 20), y = values.between(-9, 9);
		const double bound = 2 + 2 * std::abs(y * std::log(x));
		ASSERT_LT(ulps(portable::pow(x, y), std::pow((long double) x, (long double) y)), bound)
			<< x << " to the power of " << y;
	}
	EXPECT_EQ(portable::pow(0.5, 0), 1);
	EXPECT_EQ(portable::pow(0.5, 1), 0.5);
	EXPECT_EQ(portable::pow(1, 17.3), 1);
}

/// Recorded with g++ on x86-64; scripts/check/same_bytes compares whole results.
TEST(PortableMath, BitsAreThoseOfEverySystem)
{
	Values        values;
	std::uint64_t sum = 0;
	for (int i = 0; i < valueNum; ++i) {
		const double x = values.between(-20, 20), y = values.between(0, 20);
		for (double result :
			 {portable::angle(y, x), double(portable::angle(float(y), float(x))), portable::sin(x),
			  portable::cos(x), portable::exp(x), portable::log(y + 1e-9)})
			sum = (sum ^ bitsOf(result)) * 0x100000001b3u;
	}
	EXPECT_EQ(sum, 272860659022448395u);
}

} // namespace gpr::test
