// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef FILTER_GEODESIC_POISSON_FILTER_TEXT_H
#define FILTER_GEODESIC_POISSON_FILTER_TEXT_H

#include "filter_rows.h"

namespace gpr_filter {

/// The name and the description of a filter, in UTF-8.
struct FilterText {
	/// Menu entry and key in .mlx scripts: public, changes with a changelog line only.
	const char* name;
	/// Name in PyMeshLab and of the script in mlx/; unused by MeshLab 2020.09.
	const char* pythonName;
	/// The text at the top of the dialog: two paragraphs of HTML and the references.
	const char* info;
};

const FilterText& textOf(Filter filter);

/// The type of a parameter in all versions of MeshLab, and in their .mlx scripts.
const char* scriptType(gpr::ParameterKind kind);

} // namespace gpr_filter

#endif
