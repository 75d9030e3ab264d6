// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_BASE_PORTABLE_MATH_H
#define VCG_EXTRAS_CORE_BASE_PORTABLE_MATH_H

/// Functions that give the same bits on every system. Those of a system's mathematical library
/// differ in the last bit, and the last bit decides where two changes of a mesh are equally good.
/// Here only +, -, *, / are used, which IEEE 754 fixes to the bit, and functions of the standard
/// library whose result is exact (floor, frexp, ldexp). The methods are the common ones: the
/// argument is reduced to a short interval, where the Taylor series is cut off below the rounding.
/// An ulp is the distance between two neighbouring numbers at the result. Bounds of the error hold
/// for the exact result; portable_math_test compares with long double. Cost: 20 to 60 operations.
namespace gpr::portable {

/// The angle in radians, from 0 to π, whose sine and cosine are as these two, which may be
/// multiplied by any positive number; 0 where both are 0, or one is not a number.
/// Needs: sine at least 0, both finite, and their sum as well. Error: below 0.51 ulp of float,
/// below 1.5 ulp of double.
float  angle(float sine, float cosine);
double angle(double sine, double cosine);

/// Of an angle in radians. Needs: from -100 to 100. Error: below 2 ulp.
double sin(double angle);
double cos(double angle);

/// Needs: x from -700 to 700; beyond that the value at the end. Error: below 1 ulp.
double exp(double x);

/// Natural logarithm. Needs: x above 0 and finite. Error: below 1 ulp.
double log(double x);

/// x to the power of y, as exp(y log x). Needs: x above 0 and finite, |y log x| at most 700. Error:
/// below 2 + 2 |y log x| ulp. Exactly 1 where y is 0 or x is 1.
double pow(double x, double y);

} // namespace gpr::portable

#endif
