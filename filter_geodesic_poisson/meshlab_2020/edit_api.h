// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef FILTER_GEODESIC_POISSON_EDIT_API_H
#define FILTER_GEODESIC_POISSON_EDIT_API_H

// The parts of the window of MeshLab 2020.09 for the edit tool, beside meshlab_api.h. The program
// exports nothing of GLArea: only virtual functions, inline functions and fields may be used.

#include "meshlab_api.h"

#include <common/ml_shared_data_context.h>
#include <meshlab/glarea.h>
#include <string>

namespace gpr_filter {

inline void logLine(MeshDocument& document, const std::string& line)
{
	document.Log.Log(GLLogStream::FILTER, line);
}

inline QString fileOf(const MeshModel& layer)
{
	return layer.fullName();
}

/// Not drawn any more until its eye in the layer list is pressed.
inline void hideLayer(MeshModel& layer)
{
	layer.visible = false;
}

/// Sends a changed mesh to the graphics card anew.
inline void showChangedMesh(MLSceneGLSharedDataContext& context, int layer)
{
	MLRenderingData::RendAtts all;
	for (unsigned int i = 0; i < MLRenderingData::ATT_NAMES::enumArity(); ++i)
		all[MLRenderingData::ATT_NAMES(i)] = true;
	context.meshAttributesUpdated(layer, true, all);
	context.manageBuffers(layer);
}

} // namespace gpr_filter

#endif
