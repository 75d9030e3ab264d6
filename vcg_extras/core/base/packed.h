// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_BASE_PACKED_H
#define VCG_EXTRAS_CORE_BASE_PACKED_H

#include <vcg_extras/core/vec.h>

#include <cstdint>
#include <cstring>

namespace gpr {

/// A unit vector in 32 bits, with 10 bits a coordinate and two marks. The direction is right to
/// about 0.1°, enough to distinguish flat and bent.
class PackedNormal {
public:
	PackedNormal() = default;
	explicit PackedNormal(const Vec3f& n) : bits_(pack(n.x) | pack(n.y) << 10 | pack(n.z) << 20) {}

	void markPointed() { bits_ |= pointedBit; }
	void markRough() { bits_ |= roughBit; }
	bool isPointed() const { return (bits_ & pointedBit) != 0; }
	bool isRough() const { return (bits_ & roughBit) != 0; }

	Vec3f unpack() const { return {part(0), part(10), part(20)}; }

private:
	static constexpr std::uint32_t pointedBit = std::uint32_t(1) << 30;
	static constexpr std::uint32_t roughBit   = std::uint32_t(1) << 31;

	std::uint32_t bits_;

	static std::uint32_t pack(float c) { return std::uint32_t(int(c * 511.0f) + 512) & 1023; }
	float part(int shift) const { return float(int(bits_ >> shift & 1023) - 512) * (1 / 511.0f); }
};

/// A number of at least 0 in 16 bits: a float without its sign and its last 15 bits, true to 0.2 %.
class PackedMeasure {
public:
	PackedMeasure() = default;
	explicit PackedMeasure(float x)
	{
		std::uint32_t bits;
		std::memcpy(&bits, &x, sizeof bits);
		upper_ = std::uint16_t((bits + 0x4000) >> 15);
	}

	float value() const
	{
		const std::uint32_t bits = std::uint32_t(upper_) << 15;
		float               x;
		std::memcpy(&x, &bits, sizeof x);
		return x;
	}

private:
	std::uint16_t upper_;
};

} // namespace gpr

#endif
