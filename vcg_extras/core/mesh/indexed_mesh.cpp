// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "indexed_mesh.h"

#include <vector>

namespace gpr {

void dropUnusedVertices(IndexedMesh& mesh)
{
	std::vector<int> rename(mesh.vertexNum, -1);
	for (int i = 0; i < 3 * mesh.faceNum; ++i)
		rename[mesh.triangle[i]] = 0;
	int kept = 0;
	for (int v = 0; v < mesh.vertexNum; ++v) {
		if (rename[v] < 0) continue;
		rename[v]             = kept;
		mesh.position[kept++] = mesh.position[v];
	}
	mesh.vertexNum = kept;
	for (int i = 0; i < 3 * mesh.faceNum; ++i)
		mesh.triangle[i] = rename[mesh.triangle[i]];
}

} // namespace gpr
