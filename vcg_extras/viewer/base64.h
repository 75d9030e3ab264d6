// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_VIEWER_BASE64_H
#define VCG_EXTRAS_VIEWER_BASE64_H

#include <string>
#include <string_view>

namespace gpr::app {

/// Base64 of bytes, by RFC 4648.
std::string base64(std::string_view bytes);

} // namespace gpr::app

#endif
