// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_COMPARE_COMPARE_TABLE_H
#define VCG_EXTRAS_APPS_GPREMESH_COMPARE_COMPARE_TABLE_H

#include "compare_record.h"

namespace gpr::app {

/// The comparison as words: one row a figure, one column a method, the input's before them.
struct FigureTable {
	struct Row {
		std::string              label;
		std::vector<std::string> cells;
	};
	std::vector<std::string> head; ///< of the cells
	std::vector<Row>         rows;
};

FigureTable figureTable(const CompareRecord& record);

/// What the reader of the table must know, one sentence or two each: the methods, how distances
/// were measured, what failed or changed.
std::vector<std::string> explanations(const CompareRecord& record);

/// Table and explanations for a terminal of 110 columns.
std::string compareText(const CompareRecord& record);

} // namespace gpr::app

#endif
