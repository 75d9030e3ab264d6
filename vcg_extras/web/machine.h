// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_WEB_MACHINE_H
#define VCG_EXTRAS_WEB_MACHINE_H

namespace gpr::web {

/// The memory that the browser can still give, bytes.
double freeBytes();

/// How many threads may work: one, unless the module was built with threads.
int threadNum();

} // namespace gpr::web

#endif
