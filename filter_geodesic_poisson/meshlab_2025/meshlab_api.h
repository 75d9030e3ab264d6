// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef FILTER_GEODESIC_POISSON_MESHLAB_API_H
#define FILTER_GEODESIC_POISSON_MESHLAB_API_H

// The parts of MeshLab with another name or form in other versions, for the shared sources: MeshLab
// 2025.07. The build chooses the folder, so no source asks for the version.

#include <common/ml_document/mesh_document.h>
#include <common/parameters/rich_parameter_list.h>
#include <vector>

namespace gpr_filter {

using LengthParameter = RichPercentage;

/// All layers, in the order of the layer list.
inline std::vector<const MeshModel*> layersOf(const MeshDocument& document)
{
	std::vector<const MeshModel*> layers;
	for (const MeshModel& layer : document.meshIterator()) {
		layers.push_back(&layer);
	}
	return layers;
}

inline void updateBoxAndNormals(MeshModel& layer)
{
	layer.updateBoxAndNormals();
}

/// Forgets pictures, which are kept beside the mesh, and their names.
inline void dropTextures(MeshModel& layer)
{
	layer.clearTextures();
	layer.cm.normalmaps.clear();
}

/// Gives a layer the textures of another layer.
inline void copyTextures(const MeshModel& from, MeshModel& to)
{
	for (const std::string& name : from.cm.textures) {
		to.addTexture(name, from.getTexture(name));
	}
	to.cm.normalmaps = from.cm.normalmaps;
}

} // namespace gpr_filter

#endif
