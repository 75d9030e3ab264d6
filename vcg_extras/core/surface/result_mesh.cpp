// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "result_mesh.h"

#include <vcg_extras/core/mesh/mesh_edit.h>

#include <algorithm>
#include <cmath>

namespace gpr {

ResultMesh copyResult(const ResultMesh& result, Workers& workers)
{
	ResultMesh copy;
	copy.mesh            = copyMesh(result.mesh, workers);
	copy.vertex          = result.vertex;
	copy.keepsBorder     = result.keepsBorder;
	copy.hasSmoothBorder = result.hasSmoothBorder;
	copy.idealEdge       = result.idealEdge;
	copy.flipNum         = result.flipNum;
	copy.splitNum        = result.splitNum;
	copy.collapseNum     = result.collapseNum;
	copy.byCollapseNum   = result.byCollapseNum;
	copy.leftoverNum     = result.leftoverNum;
	return copy;
}

void compactResult(ResultMesh& result, Workers& workers)
{
	Buffer<int> newIndex;
	compact(result.mesh, workers, newIndex);
	if (result.vertex.size() == std::size_t(result.mesh.vertexNum)) return;
	for (std::size_t v = 0; v < newIndex.size(); ++v) {
		if (newIndex[v] >= 0) result.vertex[newIndex[v]] = result.vertex[v];
	}
	result.vertex.resize(result.mesh.vertexNum);
}

float farthestFromSurface(const ResultMesh& r)
{
	float farthest = 0;
	for (int v = 0; v < r.mesh.vertexNum; ++v) {
		const Vec3f off = r.mesh.position[v] - r.vertex[v].point.position;
		farthest        = std::max(farthest, squaredLength(off));
	}
	return std::sqrt(farthest);
}

} // namespace gpr
