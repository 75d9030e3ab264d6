// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_BASE_RUN_CONTEXT_H
#define VCG_EXTRAS_CORE_BASE_RUN_CONTEXT_H

#include "stage_clock.h"
#include "workers.h"

#include <vcg_extras/core/mesh_view.h>
#include <vcg_extras/core/options.h>
#include <vcg_extras/core/report.h>

#include <algorithm>
#include <string>
#include <vector>

namespace gpr {

struct ErrorGuide; // run/error_guide.h
struct KeptInput;  // run/kept_input.h

/// What the parts of a run share: input and options, the threads, and where they tell what happens.
struct RunContext {
	const MeshView&           input;
	const RemeshOptions&      options; ///< with a seed
	Workers&                  workers;
	RemeshReport&             report;
	std::vector<std::string>& notes;
	StageClock                clock;
	ErrorGuide* guide = nullptr; ///< of a run towards a largest error; null: of any other
	KeptInput*  kept  = nullptr; ///< of the runs on this input; null: of a single run

	/// Tells of a loop that its bound ended; once, however often that happens.
	void tellCap(const char* loop)
	{
		std::vector<std::string>& caps = report.capsReached;
		if (std::find(caps.begin(), caps.end(), loop) == caps.end()) caps.push_back(loop);
	}
};

} // namespace gpr

#endif
