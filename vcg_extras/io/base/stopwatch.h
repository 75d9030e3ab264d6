// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_IO_BASE_STOPWATCH_H
#define VCG_EXTRAS_IO_BASE_STOPWATCH_H

#include <chrono>

namespace gpr::app {

/// Wall time since construction, plus the time passed before.
class Stopwatch {
public:
	explicit Stopwatch(double secondsBefore = 0) : before_(secondsBefore) {}

	double seconds() const
	{
		const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start_;
		return before_ + passed.count();
	}

private:
	double                                before_;
	std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// The parts of the program's time: the three parts make up the total.
struct RunTimes {
	double read   = 0; ///< from the program's start to the mesh in memory
	double remesh = 0; ///< the engine, from mesh in memory to mesh in memory
	double write  = 0; ///< from there to the mesh on the disk and all memory handed back
	double total() const { return read + remesh + write; }
};

} // namespace gpr::app

#endif
