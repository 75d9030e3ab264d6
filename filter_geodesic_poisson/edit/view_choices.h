// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef FILTER_GEODESIC_POISSON_VIEW_CHOICES_H
#define FILTER_GEODESIC_POISSON_VIEW_CHOICES_H

namespace gpr_filter {

enum class PreviewPlace { OverOriginal, InPlaceOfOriginal };
enum class PreviewColour { None, Quality, Distance };
enum class OtherSide { Original, QuadricCollapse };

/// The wanted view of the user.
struct ViewChoices {
	PreviewPlace  place     = PreviewPlace::InPlaceOfOriginal;
	bool          faces     = true;
	bool          wireframe = true;
	PreviewColour colour    = PreviewColour::None;
	bool          isWiped   = false; ///< a line divides the view, the result is to its right
	double        wipeAt    = 0.5;   ///< of the view's width
	OtherSide     otherSide = OtherSide::Original;
};

} // namespace gpr_filter

#endif
