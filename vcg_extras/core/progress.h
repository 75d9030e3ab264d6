// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_PROGRESS_H
#define VCG_EXTRAS_CORE_PROGRESS_H

#include <atomic>
#include <functional>

namespace gpr {

/// A function that the engine calls from the caller's thread, at most about every 50 ms, with the
/// share of the work done in [0, 1] and a short verb phrase. Returning false cancels the run: the
/// engine ends with Status::Cancelled and exports nothing.
using ProgressCallback = std::function<bool(double share, const char* phrase)>;

/// A flag that any thread may set to true to cancel a run, sooner than by a callback.
using StopRequest = std::atomic<bool>;

} // namespace gpr

#endif
