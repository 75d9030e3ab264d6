// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_WEB_MEMORY_H
#define VCG_EXTRAS_WEB_MEMORY_H

namespace gpr::web {

/// The memory that the browser can still give, bytes.
double freeBytes();

} // namespace gpr::web

#endif
