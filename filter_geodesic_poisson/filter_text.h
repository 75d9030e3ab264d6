// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef FILTER_GEODESIC_POISSON_FILTER_TEXT_H
#define FILTER_GEODESIC_POISSON_FILTER_TEXT_H

#include <QString>

namespace gpr_filter {

/// Menu entry and key in .mlx scripts: public, changes with a changelog line only.
QString remeshName();

/// Name in PyMeshLab and of the script in mlx/; MeshLab 2020.09 does not ask for it.
QString remeshPythonName();

/// The text at the top of the dialog: two paragraphs of HTML and the references.
QString remeshInfo();

} // namespace gpr_filter

#endif
