// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_REPORT_ROWS_H
#define VCG_EXTRAS_CORE_REPORT_ROWS_H

#include "report.h"

#include <vector>

// The counts of a report with their names, so that log, summary and JSON name an event alike.

namespace gpr {

/// A count. `one` and `many` follow the count in a sentence and are empty for rows of JSON only.
struct CountRow {
	const char*  key; ///< in JSON
	std::int64_t count;
	const char*  one  = "";
	const char*  many = "";

	/// Whether a log or a summary names the count.
	bool        isTold() const { return count != 0 && *many != 0; }
	const char* words() const { return count == 1 ? one : many; }
};

/// The counts of cleaning, in the order of the report's keys.
std::vector<CountRow> describe(const CleanCounts& cleaned);

} // namespace gpr

#endif
