// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_COMPARE_COMPARE_OUTPUT_H
#define VCG_EXTRAS_APPS_GPREMESH_COMPARE_COMPARE_OUTPUT_H

#include "compare_methods.h"
#include "mesh_pictures.h"

// A comparison as text, as JSON and as a page.

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

/// The comparison as JSON text. The keys are public: they change with a changelog line.
std::string compareJson(const CompareRecord& record);

/// Whether the program was built with three.js, which draws in the viewer.
bool hasViewer();

/// The part of the page with a view of the meshes that a user can turn: the viewer's program,
/// three.js with its licence, and the meshes. Needs no other file. Needs hasViewer(). Cost: seven
/// searches of a nearest point for each shown triangle of each mesh, parallel; about 30 B of text
/// per triangle.
std::string viewerHtml(const MeshView& input, const CompareRecord& record);

/// Pictures with a caption.
struct CaptionedPictures {
	std::string  caption;
	MeshPictures pictures;
};

/// The comparison as an HTML page that needs no other file: contains the pictures and the viewer.
/// viewer: a piece of HTML, or empty.
std::string comparePage(const CompareRecord& record, const std::vector<CaptionedPictures>& pictures,
						const std::string& viewer);

} // namespace gpr::app

#endif
