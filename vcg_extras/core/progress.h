// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_PROGRESS_H
#define VCG_EXTRAS_CORE_PROGRESS_H

#include <atomic>
#include <functional>

namespace gpr {

/// Called from the thread that called the engine, at most about every 50 ms, with the share of the
/// work done in [0, 1] and a short verb phrase. Returning false cancels: the engine ends with
/// Status::Cancelled and exports nothing.
using ProgressCallback = std::function<bool(double share, const char* phrase)>;

/// Set to true by any thread, it ends a run as a callback does that returns false, and sooner.
using StopRequest = std::atomic<bool>;

} // namespace gpr

#endif
