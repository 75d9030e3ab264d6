// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_BASE_PORTABLE_MATH_H
#define VCG_EXTRAS_CORE_BASE_PORTABLE_MATH_H

/// Functions with the same bits on every system. Functions of the system's mathematical library
/// differ in the last bit, and the last bit decides between two equally good changes of a mesh.
/// These functions use only +, -, *, /, which IEEE 754 fixes to the bit, and exact functions of the
/// standard library (floor, frexp, ldexp). The methods are common: the argument is reduced to a
/// short interval, on which the Taylor series is cut off below the rounding. An ulp is the distance
/// between two neighbouring numbers at the result. Error bounds are relative to the exact result;
/// portable_math_test compares with long double. Cost: 20 to 60 operations.
namespace gpr::portable {

/// The angle with this sine and cosine, in radians from 0 to π. Both may be scaled by the same
/// positive number. 0 if both are 0 or if a value is NaN. Needs: sine at least 0, both finite, and
/// their sum finite. Error: below 0.51 ulp of float, below 1.5 ulp of double.
float  angle(float sine, float cosine);
double angle(double sine, double cosine);

/// Sine and cosine of an angle in radians. Needs: from -100 to 100. Error: below 2 ulp.
double sin(double angle);
double cos(double angle);

/// Exponential function. Needs: x from -700 to 700; clamps other values. Error: below 1 ulp.
double exp(double x);

/// Natural logarithm. Needs: x above 0 and finite. Error: below 1 ulp.
double log(double x);

/// x to the power of y, as exp(y log x). Needs: x above 0 and finite, |y log x| at most 700. Error:
/// below 2 + 2 |y log x| ulp. Exactly 1 if y is 0 or x is 1.
double pow(double x, double y);

} // namespace gpr::portable

#endif
