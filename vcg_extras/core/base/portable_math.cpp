// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "portable_math.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace gpr::portable {

namespace {

/// A number as a sum of two doubles, to more than 100 bits.
struct Exact {
	double high, low;
};

constexpr Exact quarterTurn = {1.5707963267948966, 6.123233995736766e-17};
constexpr Exact halfTurn    = {3.1415926535897931, 1.2246467991473532e-16};

constexpr int   stepNum                 = 8;
constexpr Exact arcTangent[stepNum + 1] = { // of k / stepNum
	{0, 0},
	{0.12435499454676144, -3.1253241424539383e-18},
	{0.24497866312686414, 1.0698755618734451e-17},
	{0.35877067027057225, -2.4623815582638635e-17},
	{0.46364760900080609, 2.2698777452961687e-17},
	{0.55859931534356244, -5.4556305485916264e-18},
	{0.64350110879328437, 1.5834785051444286e-17},
	{0.71882999962162453, -2.1478388444456983e-17},
	{0.78539816339744828, 3.061616997868383e-17}};

/// c[0] + c[1] x + c[2] x² + ...
template <std::size_t N>
double polynomial(const double (&c)[N], double x)
{
	double sum = c[N - 1];
	for (std::size_t i = N - 1; i-- > 0;)
		sum = c[i] + x * sum;
	return sum;
}

/// Series of the arc tangent for t of at most 1/16, without the first term, by powers of -t².
constexpr double coarseArcTangent[] = {1.0 / 3, 1.0 / 5, 1.0 / 7};
constexpr double fineArcTangent[]   = {1.0 / 3, 1.0 / 5, 1.0 / 7, 1.0 / 9, 1.0 / 11, 1.0 / 13};

/// Taylor series of x - sin(x) over x and of 1 - cos(x), by powers of -x² from the first on.
constexpr double sineSeries[] = {
	1.0 / 6,        1.0 / 120,        1.0 / 5040,          1.0 / 362880,
	1.0 / 39916800, 1.0 / 6227020800, 1.0 / 1307674368000, 1.0 / 355687428096000};

constexpr double cosineSeries[] = {1.0 / 2,
								   1.0 / 24,
								   1.0 / 720,
								   1.0 / 40320,
								   1.0 / 3628800,
								   1.0 / 479001600,
								   1.0 / 87178291200,
								   1.0 / 20922789888000,
								   1.0 / 6402373705728000};

/// Taylor series of exp from the second power on.
constexpr double exponentialSeries[] = {
	1.0 / 2,         1.0 / 6,          1.0 / 24,         1.0 / 120,     1.0 / 720,
	1.0 / 5040,      1.0 / 40320,      1.0 / 362880,     1.0 / 3628800, 1.0 / 39916800,
	1.0 / 479001600, 1.0 / 6227020800, 1.0 / 87178291200};

/// Series of log((1 + s) / (1 - s)) / s without the first term, by powers of s².
constexpr double logarithmSeries[] = {2.0 / 3,  2.0 / 5,  2.0 / 7,  2.0 / 9,  2.0 / 11,
									  2.0 / 13, 2.0 / 15, 2.0 / 17, 2.0 / 19, 2.0 / 21};

/// The first parts have 33 bits: their product with an integer below 2²⁰ is exact.
constexpr double quarterTurnParts[] = {1.5707963267341256, 6.077100506303966e-11,
									   2.0222662487959506e-21};
constexpr double logOf2Parts[]      = {0.69314718048553914, 7.4406171100123968e-11};

/// The index of the arc tangent in the table nearest to the arc tangent of a quotient from 0 to 1.
int stepOf(double quotient)
{
	return int(quotient * stepNum + 0.5);
}

/// Tangent of the rest of the angle after the arc tangent of step / stepNum is subtracted.
double tangentOfRest(double smaller, double larger, int step)
{
	const double c = step * (1.0 / stepNum);
	return (smaller - c * larger) / (larger + c * smaller);
}

/// a - b - c, if a is larger than b.
double differenceOf(const Exact& a, double b, double c)
{
	const double high = a.high - b;
	return high + ((a.high - high - b) + a.low - c);
}

/// The rest of an angle after the nearest multiple of a quarter turn is subtracted.
struct ReducedAngle {
	double rest;
	int    quarters; ///< 0 to 3
};

ReducedAngle reduced(double angle)
{
	const double quarters = std::floor(angle * (1 / quarterTurn.high) + 0.5);
	double       rest     = angle;
	for (double part : quarterTurnParts)
		rest -= quarters * part;
	return {rest, int(quarters) & 3};
}

/// The sine of an angle of some quarter turns and a rest: the sine or the cosine of the rest, which
/// is at most an eighth of a turn.
double sineOf(const ReducedAngle& a)
{
	const double x = a.rest, q = x * x;
	const double amount = a.quarters % 2 == 0 ? x - x * (q * polynomial(sineSeries, -q))
											  : 1 - q * polynomial(cosineSeries, -q);
	return a.quarters < 2 ? amount : -amount;
}

} // namespace

float angle(float sine, float cosine)
{
	const float amount  = std::abs(cosine);
	const bool  isSteep = sine > amount;
	const float larger = isSteep ? sine : amount, smaller = isSteep ? amount : sine;
	const float quotient = smaller / larger;
	if (!(quotient >= 0)) return 0;
	const int    step  = stepOf(double(quotient));
	const double t     = tangentOfRest(double(smaller), double(larger), step);
	const double rest  = t - t * (t * t * polynomial(coarseArcTangent, -t * t));
	const double first = arcTangent[step].high + rest;
	const double acute = isSteep ? quarterTurn.high - first : first;
	return float(cosine < 0 ? halfTurn.high - acute : acute);
}

double angle(double sine, double cosine)
{
	const double amount  = std::abs(cosine);
	const bool   isSteep = sine > amount;
	const double larger = isSteep ? sine : amount, smaller = isSteep ? amount : sine;
	const double quotient = smaller / larger;
	if (!(quotient >= 0)) return 0;
	const int    step = stepOf(quotient);
	const double t    = tangentOfRest(smaller, larger, step);
	const double rest = t - t * (t * t * polynomial(fineArcTangent, -t * t));
	// One of the eight parts of the circle, counted from the nearest axis.
	const double table = arcTangent[step].high, correction = arcTangent[step].low + rest;
	if (isSteep) {
		return cosine < 0 ? -differenceOf({-quarterTurn.high, -quarterTurn.low}, table, correction)
						  : differenceOf(quarterTurn, table, correction);
	}
	return cosine < 0 ? differenceOf(halfTurn, table, correction) : table + correction;
}

double sin(double angle)
{
	return sineOf(reduced(angle));
}

double cos(double angle)
{
	const ReducedAngle a = reduced(angle);
	return sineOf({a.rest, (a.quarters + 1) & 3});
}

double exp(double x)
{
	const double limited   = std::min(700.0, std::max(-700.0, x));
	const double doublings = std::floor(limited * (1 / (logOf2Parts[0] + logOf2Parts[1])) + 0.5);
	const double rest      = limited - doublings * logOf2Parts[0] - doublings * logOf2Parts[1];
	const double growth    = rest + rest * rest * polynomial(exponentialSeries, rest);
	return std::ldexp(1 + growth, int(doublings));
}

double log(double x)
{
	constexpr double rootOfHalf = 0.70710678118654752;
	int              doublings  = 0;
	double           part       = std::frexp(x, &doublings);
	if (part < rootOfHalf) {
		part *= 2;
		--doublings;
	}
	const double f = part - 1, s = f / (2 + f);
	const double series = s * s * polynomial(logarithmSeries, s * s);
	return doublings * logOf2Parts[0] - ((s * (f - series) - doublings * logOf2Parts[1]) - f);
}

double pow(double x, double y)
{
	return exp(y * log(x));
}

} // namespace gpr::portable
