// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_BASE_RUN_CONTEXT_H
#define VCG_EXTRAS_CORE_BASE_RUN_CONTEXT_H

#include "stage_clock.h"
#include "workers.h"

#include <vcg_extras/core/mesh_view.h>
#include <vcg_extras/core/options.h>

#include <algorithm>
#include <string>
#include <vector>

namespace gpr {

/// The common state of a run's steps: input, options, threads, clock and notes.
struct RunContext {
	const MeshView&          input;
	const RemeshOptions&     options; ///< with a seed
	Workers&                 workers;
	StageClock               clock;
	std::vector<std::string> notes;       ///< sentences for the user
	std::vector<std::string> capsReached; ///< loops that reached their cap

	/// Adds a note for the user, unless the note is empty or was added before.
	void tell(const std::string& note) { addOnce(note, notes); }
	/// Adds a loop that reached its cap, once.
	void tellCap(const std::string& loop) { addOnce(loop, capsReached); }

private:
	static void addOnce(const std::string& text, std::vector<std::string>& all)
	{
		if (text.empty() || std::find(all.begin(), all.end(), text) != all.end()) return;
		all.push_back(text);
	}
};

} // namespace gpr

#endif
