// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_source.h"

#include "precision.h"

#include <utility>

namespace gpr::app {

bool isSewn(const RemeshOptions& options)
{
	return options.sew && !options.selectedOnly;
}

MeshSource::MeshSource(InputMesh input, const RemeshOptions& options) : mesh(std::move(input))
{
	texture = takeTexture(mesh.attributes, mesh.view(), isSewn(options));
}

MeshView MeshSource::view() const
{
	MeshView view = mesh.view();
	if (texture != nullptr && texture->hasSeams()) view.line = texture->seams().data();
	return view;
}

RemeshOptions MeshSource::withPlaces(const RemeshOptions& options) const
{
	RemeshOptions all           = options;
	all.surfacePointsOfVertices = needsPoints();
	all.surfacePointsOfFaces    = needsPointsOfFaces();
	return all;
}

bool needsDoubleOutput(const InputMesh& input, const RemeshResult& result)
{
	return input.doublePrecision ||
		   !floatResolves(largestCoordinate(result.mesh.view()), result.report.quality.meanEdgeLen);
}

} // namespace gpr::app
