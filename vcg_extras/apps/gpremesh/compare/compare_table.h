// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_COMPARE_COMPARE_TABLE_H
#define VCG_EXTRAS_APPS_GPREMESH_COMPARE_COMPARE_TABLE_H

#include "compare_record.h"

namespace gpr::app {

/// The comparison as words: a row per figure, a column for the input and for each method.
struct FigureTable {
	struct Row {
		std::string              label;
		std::vector<std::string> cells;
	};
	std::vector<std::string> head; ///< of the cells
	std::vector<Row>         rows;
};

FigureTable figureTable(const CompareRecord& record);

/// Sentences for the reader of the table: the methods, the measurement of distances, failures and
/// changes.
std::vector<std::string> explanations(const CompareRecord& record);

/// Table and explanations for a terminal of 110 columns.
std::string compareText(const CompareRecord& record);

} // namespace gpr::app

#endif
