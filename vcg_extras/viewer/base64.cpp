// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base64.h"

#include <algorithm>
#include <cstdint>

namespace gpr::app {

std::string base64(std::string_view bytes)
{
	const char* const digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
	std::string       text;
	text.reserve(4 * (bytes.size() / 3 + 1));
	for (std::size_t i = 0; i < bytes.size(); i += 3) {
		const std::size_t num  = std::min<std::size_t>(3, bytes.size() - i);
		std::uint32_t     bits = 0;
		for (std::size_t k = 0; k < 3; ++k)
			bits = bits << 8 | (k < num ? static_cast<unsigned char>(bytes[i + k]) : 0u);
		for (std::size_t k = 0; k < 4; ++k)
			text += k <= num ? digits[bits >> (18 - 6 * k) & 63] : '=';
	}
	return text;
}

} // namespace gpr::app
