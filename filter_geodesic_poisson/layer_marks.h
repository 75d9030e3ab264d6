// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef FILTER_GEODESIC_POISSON_LAYER_MARKS_H
#define FILTER_GEODESIC_POISSON_LAYER_MARKS_H

// Regions and sizes from the texture, colour and quality of a layer.

#include "filter_rows.h"
#include "meshlab_api.h"

#include <cstdint>
#include <string>
#include <vector>

namespace gpr_filter {

/// Labels of faces in the form of gpr::MeshView.
struct LayerRegions {
	std::vector<std::int32_t> label; ///< a label for each face; empty without labels
	std::vector<std::string>  names; ///< by label, or empty
};

/// The regions that the faces of a layer tell. Throws Refusal if the layer lacks the attribute,
/// or if a quality is no whole number.
LayerRegions regionsOf(const MeshModel& layer, RegionSource source);

/// The quality of the vertices as wanted edge lengths, mesh units. Throws Refusal if the layer
/// has no quality, or if a quality is not above 0.
std::vector<float> wantedSizesOf(const MeshModel& layer);

} // namespace gpr_filter

#endif
