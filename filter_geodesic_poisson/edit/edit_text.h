// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef FILTER_GEODESIC_POISSON_EDIT_TEXT_H
#define FILTER_GEODESIC_POISSON_EDIT_TEXT_H

namespace gpr_filter {

/// The name of the tool in menu and toolbar.
constexpr const char* kEditName = "Geodesic Poisson Remeshing";
constexpr const char* kEditDescription =
	"Remeshes the current layer while you move a slider. The layer stays as it is until Apply.";
constexpr const char* kEditIcon = ":/gpremesh/edit_icon.png";

} // namespace gpr_filter

#endif
