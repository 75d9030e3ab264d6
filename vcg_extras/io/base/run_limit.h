// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_IO_BASE_RUN_LIMIT_H
#define VCG_EXTRAS_IO_BASE_RUN_LIMIT_H

#include "stopwatch.h"

#include <vcg_extras/core/progress.h>

namespace gpr::app {

/// When a run of the program has to end early: at a signal, or when its time is up.
class RunLimit {
public:
	/// No limit but signals.
	RunLimit() = default;
	/// seconds: since the clock's start; 0 = no limit.
	RunLimit(const Stopwatch& clock, double seconds) : clock_(clock), seconds_(seconds) {}

	/// The reason why the run has to end, as a sentence; null while the run may go on.
	const char* reason() const;
	/// Throws AppError (Stopped) with the reason, if any.
	void check() const;
	/// Tells a share of the work, if somebody listens. Throws as check().
	void tell(const ProgressCallback& progress, double share, const char* phrase) const;
	/// Time left for the engine, more than 0; 0 = no limit.
	double secondsLeft() const;

private:
	Stopwatch clock_;
	double    seconds_ = 0;
};

} // namespace gpr::app

#endif
