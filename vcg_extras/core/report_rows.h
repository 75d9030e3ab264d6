// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_REPORT_ROWS_H
#define VCG_EXTRAS_CORE_REPORT_ROWS_H

#include "report.h"

#include <vector>

// The counts of a report with their names, so that log, summary and JSON speak of one event in the
// same words.

namespace gpr {

/// One count. `one` and `many` follow it in a sentence and are empty where only JSON has the count.
struct CountRow {
	const char*  key; ///< in JSON
	std::int64_t count;
	const char*  one  = "";
	const char*  many = "";

	/// Whether a log or a summary names the count.
	bool        isTold() const { return count != 0 && *many != 0; }
	const char* words() const { return count == 1 ? one : many; }
};

/// What cleaning did, in the order of the report's keys.
std::vector<CountRow> describe(const CleanCounts& cleaned);

} // namespace gpr

#endif
