// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_VIEWER_BASE64_H
#define VCG_EXTRAS_VIEWER_BASE64_H

#include <string>
#include <string_view>
#include <vector>

namespace gpr::app {

/// Base64 of bytes, by RFC 4648.
std::string base64(std::string_view bytes);

/// The bytes of the values as they lie in memory.
template <class Value>
std::string base64Of(const std::vector<Value>& values)
{
	const auto* const bytes = reinterpret_cast<const char*>(values.data());
	return base64({bytes, values.size() * sizeof(Value)});
}

} // namespace gpr::app

#endif
