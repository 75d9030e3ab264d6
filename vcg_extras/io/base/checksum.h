// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_IO_BASE_CHECKSUM_H
#define VCG_EXTRAS_IO_BASE_CHECKSUM_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace gpr::app {

/// FNV-1a over words of eight bytes. Data added in parts have the same sum only if all parts but
/// the last have lengths that are multiples of eight.
class Checksum {
public:
	void add(const char* data, std::size_t num)
	{
		constexpr std::uint64_t prime = 1099511628211u;
		for (std::size_t i = 0; i < num; i += 8) {
			std::uint64_t word = 0;
			std::memcpy(&word, data + i, std::min<std::size_t>(8, num - i));
			value_ = (value_ ^ word) * prime;
			value_ ^= value_ >> 29; // else the upper bits of a word never reach the lower bits
		}
	}
	std::uint64_t value() const { return value_; }

private:
	std::uint64_t value_ = 14695981039346656037u;
};

} // namespace gpr::app

#endif
