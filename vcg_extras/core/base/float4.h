// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_BASE_FLOAT4_H
#define VCG_EXTRAS_CORE_BASE_FLOAT4_H

#include <vcg_extras/core/vec.h>

#include <cmath>

namespace gpr {

/// Four floats with lane-wise sum and product, by one instruction each on compilers with vectors
/// (GCC and Clang). Each lane follows IEEE like a single float, so that results have the same bits
/// without vectors. GPR_SCALAR_LANES builds without vectors.
class Float4 {
public:
	Float4() : Float4(0, 0, 0, 0) {}
	Float4(float a, float b, float c, float d) : lane_{a, b, c, d} {}
	explicit Float4(const Vec3f& v) : Float4(v.x, v.y, v.z, 0) {}

	float operator[](int i) const { return lane_[i]; }
	Vec3f xyz() const { return {lane_[0], lane_[1], lane_[2]}; }

#if defined(__GNUC__) && !defined(GPR_SCALAR_LANES)
	friend Float4 operator*(const Float4& a, const Float4& b)
	{
		return Float4(a.lane_ * b.lane_);
	}
	friend Float4 operator*(const Float4& a, float b)
	{
		return Float4(a.lane_ * b);
	}
	friend Float4 operator-(const Float4& a, const Float4& b)
	{
		return Float4(a.lane_ - b.lane_);
	}
	Float4& operator+=(const Float4& b)
	{
		lane_ += b.lane_;
		return *this;
	}

private:
	using Lanes = float __attribute__((vector_size(16)));
	explicit Float4(Lanes lanes) : lane_(lanes) {}
	Lanes lane_;
#else
	friend Float4 operator*(const Float4& a, const Float4& b)
	{
		return {a[0] * b[0], a[1] * b[1], a[2] * b[2], a[3] * b[3]};
	}
	friend Float4 operator*(const Float4& a, float b)
	{
		return a * Float4(b, b, b, b);
	}
	friend Float4 operator-(const Float4& a, const Float4& b)
	{
		return {a[0] - b[0], a[1] - b[1], a[2] - b[2], a[3] - b[3]};
	}
	Float4& operator+=(const Float4& b)
	{
		for (int i = 0; i < 4; ++i)
			lane_[i] += b.lane_[i];
		return *this;
	}

private:
	float lane_[4];
#endif
};

inline Float4 operator+(Float4 a, const Float4& b)
{
	return a += b;
}

// The products of 3-vectors take the first three lanes. Compilers make a single instruction of a
// vector that is put together from lanes of two vectors.

inline float dot(const Float4& a, const Float4& b)
{
	const Float4 product = a * b;
	return product[0] + product[1] + product[2];
}
inline float length(const Float4& a)
{
	return std::sqrt(dot(a, a));
}
inline Float4 cross(const Float4& a, const Float4& b)
{
	const auto turned = [](const Float4& v) { return Float4(v[1], v[2], v[0], v[3]); };
	return turned(a * turned(b) - turned(a) * b);
}

} // namespace gpr

#endif
