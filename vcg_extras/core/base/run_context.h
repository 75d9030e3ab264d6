// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_RUN_RUN_CONTEXT_H
#define VCG_EXTRAS_CORE_RUN_RUN_CONTEXT_H

#include "stage_clock.h"
#include "workers.h"

#include <vcg_extras/core/mesh_view.h>
#include <vcg_extras/core/options.h>
#include <vcg_extras/core/report.h>

#include <string>
#include <vector>

namespace gpr {

/// What the parts of a run share: input and options, the threads, and where they tell what happens.
struct RunContext {
	const MeshView&           input;
	RemeshOptions             options;
	Workers&                  workers;
	RemeshReport&             report;
	std::vector<std::string>& notes;
	StageClock                clock;
};

/// A part of a run: the context's members by their short names.
class RunPart {
protected:
	explicit RunPart(RunContext& run) :
			run_(run), input_(run.input), options_(run.options), workers_(run.workers),
			report_(run.report), notes_(run.notes), clock_(run.clock)
	{
	}

	RunContext&               run_;
	const MeshView&           input_;
	const RemeshOptions&      options_;
	Workers&                  workers_;
	RemeshReport&             report_;
	std::vector<std::string>& notes_;
	StageClock&               clock_;
};

} // namespace gpr

#endif
