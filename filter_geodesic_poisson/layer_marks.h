// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef FILTER_GEODESIC_POISSON_LAYER_MARKS_H
#define FILTER_GEODESIC_POISSON_LAYER_MARKS_H

// What a layer's texture, colour and quality say to the engine where the user asks for it.

#include "filter_rows.h"
#include "meshlab_api.h"

#include <cstdint>
#include <string>
#include <vector>

namespace gpr_filter {

/// Labels of faces, as gpr::MeshView has them.
struct LayerRegions {
	std::vector<std::int32_t> label; ///< one a face; empty: there are none
	std::vector<std::string>  names; ///< by label, or empty
};

/// The regions that the faces of a layer tell. Throws Refusal where the layer lacks the attribute,
/// or where a quality is no whole number.
LayerRegions regionsOf(const MeshModel& layer, RegionSource source);

/// The quality of the vertices as wanted edge lengths, mesh units. Throws Refusal where the layer
/// has no quality, or where one is not above 0.
std::vector<float> wantedSizesOf(const MeshModel& layer);

} // namespace gpr_filter

#endif
