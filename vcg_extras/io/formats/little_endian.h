// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_IO_FORMATS_LITTLE_ENDIAN_H
#define VCG_EXTRAS_IO_FORMATS_LITTLE_ENDIAN_H

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace gpr::app {

/// Puts the bytes of a number in little endian order on every machine, and moves on to the next
/// place.
template <class T>
void putLittleEndian(T value, char*& at)
{
	static_assert(sizeof(T) <= 8, "a number");
	using Bits = std::conditional_t<
		sizeof(T) == 8, std::uint64_t,
		std::conditional_t<sizeof(T) == 4, std::uint32_t,
						   std::conditional_t<sizeof(T) == 2, std::uint16_t, std::uint8_t>>>;
	Bits bits;
	std::memcpy(&bits, &value, sizeof bits);
	for (std::size_t i = 0; i < sizeof bits; ++i)
		*at++ = char(bits >> (8 * i) & 0xff);
}

} // namespace gpr::app

#endif
