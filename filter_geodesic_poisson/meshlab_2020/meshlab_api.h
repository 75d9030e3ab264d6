// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef FILTER_GEODESIC_POISSON_MESHLAB_API_H
#define FILTER_GEODESIC_POISSON_MESHLAB_API_H

// The parts of MeshLab with another name or form in other versions, for the shared sources: MeshLab
// 2020.09. The build chooses the folder, so no source asks for the version.

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

/// Forgets the names of pictures; the pictures themselves are not kept beside the mesh.
inline void dropTextures(MeshModel& layer)
{
	layer.cm.textures.clear();
	layer.cm.normalmaps.clear();
}

/// Gives a layer the textures of another layer.
inline void copyTextures(const MeshModel& from, MeshModel& to)
{
	to.cm.textures   = from.cm.textures;
	to.cm.normalmaps = from.cm.normalmaps;
}

} // namespace gpr_filter

#endif
