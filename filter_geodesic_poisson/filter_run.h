// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef FILTER_GEODESIC_POISSON_FILTER_RUN_H
#define FILTER_GEODESIC_POISSON_FILTER_RUN_H

// The common work of the adapters of all versions when a filter is applied.

#include "filter_rows.h"
#include "meshlab_api.h"
#include "run_figures.h"

#include <functional>
#include <string>
#include <vector>

namespace gpr_filter {

/// The masks of MeshModel that a layer must have for any of the filters.
constexpr int kPreCondition = MeshModel::MM_FACENUMBER;
/// The masks of MeshModel that a filter changes.
int postConditionOf(Filter filter);

/// How a run ended.
struct RunOutcome {
	bool done = false; ///< false: the document is unchanged
	/// A line or sentence each: after a success for the log, else for the user and the log.
	std::vector<std::string> lines;
	Figures                  figures; ///< for programs; empty after a failure
};

/// Takes a line for the host's log.
using LogLine = std::function<void(const std::string&)>;

/// Applies filters in turn.
class FilterRunner {
public:
	/// Applies a filter to the document's current layer; before the work `log` gets the estimate of
	/// time and memory. Never throws. A call from within the progress callback of another call is
	/// refused: the host's progress bar handles events, so Apply can be pressed again while a
	/// filter runs.
	RunOutcome run(Filter filter, MeshDocument& document, const RichParameterList& list,
				   vcg::CallBackPos* progress, const LogLine& log) noexcept;

private:
	bool _running = false;
};

/// Sentences as a text of HTML, of which a plain reader sees next to nothing.
QString asHtml(const std::vector<std::string>& sentences, const char* separator);

} // namespace gpr_filter

#endif
