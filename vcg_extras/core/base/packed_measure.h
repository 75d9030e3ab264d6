// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_BASE_PACKED_MEASURE_H
#define VCG_EXTRAS_CORE_BASE_PACKED_MEASURE_H

#include <cstdint>
#include <cstring>

namespace gpr {

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
