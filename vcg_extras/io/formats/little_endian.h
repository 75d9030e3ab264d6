// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_IO_FORMATS_LITTLE_ENDIAN_H
#define VCG_EXTRAS_IO_FORMATS_LITTLE_ENDIAN_H

#include <cstdint>
#include <cstring>

namespace gpr::app {

/// Puts the bytes of a value in little endian order on every machine, and goes on behind them.
template <class Bits, class T>
void putLittleEndian(T value, char*& at)
{
	static_assert(sizeof(Bits) == sizeof(T), "the same size");
	Bits bits;
	std::memcpy(&bits, &value, sizeof bits);
	for (std::size_t i = 0; i < sizeof bits; ++i)
		*at++ = char(bits >> (8 * i) & 0xff);
}

} // namespace gpr::app

#endif
