// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef FILTER_GEODESIC_POISSON_MESHLAB_API_H
#define FILTER_GEODESIC_POISSON_MESHLAB_API_H

// What the shared sources need of MeshLab and what has another name or form in other versions:
// MeshLab 2020.09. The build chooses the folder, so that no source asks for the version.

#include <common/filter_parameter/rich_parameter_list.h>
#include <common/meshmodel.h>
#include <vector>

namespace gpr_filter {

using LengthParameter = RichAbsPerc;

/// All layers, in the order of the layer list.
inline std::vector<const MeshModel*> layersOf(const MeshDocument& document)
{
	return {document.meshList.begin(), document.meshList.end()};
}

inline void updateBoxAndNormals(MeshModel& layer)
{
	layer.UpdateBoxAndNormals();
}

/// Forgets pictures that are kept beside the mesh: none are here.
inline void dropTextures(MeshModel&) {}

} // namespace gpr_filter

#endif
