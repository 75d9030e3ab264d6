// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "face_sets.h"

#include <vcg_extras/core/base/sort_unique.h>
#include <vcg_extras/core/mesh/mesh_edit.h>

#include <algorithm>

namespace gpr {

std::vector<int> markedFaces(const std::vector<char>& marked)
{
	std::vector<int> faces;
	for (std::size_t f = 0; f < marked.size(); ++f) {
		if (marked[f]) faces.push_back(int(f));
	}
	return faces;
}

std::vector<int> widened(const HalfEdgeMesh& m, std::vector<int> faces, int rings)
{
	for (int ring = 0; ring < rings; ++ring)
		faces = facesRound(m, verticesOf(m, faces));
	return faces;
}

std::vector<int> facesBetween(const HalfEdgeMesh& m, const std::vector<int>& vertices)
{
	// A face comes once for each corner among the vertices: three times if it lies between.
	std::vector<int> faces;
	for (int v : vertices)
		forEachOutgoing(m, v, [&](int h) { faces.push_back(h / 3); });
	std::sort(faces.begin(), faces.end());
	std::size_t num = 0;
	for (std::size_t i = 2; i < faces.size(); ++i) {
		if (faces[i - 2] == faces[i]) faces[num++] = faces[i];
	}
	faces.resize(num);
	return faces;
}

HalfEdgeMesh facesAlone(const HalfEdgeMesh& from, const std::vector<int>& faces,
						const std::vector<int>& vertices)
{
	HalfEdgeMesh to;
	to.vertexNum     = int(vertices.size());
	to.faceNum       = int(faces.size());
	to.meetsAtPlaces = from.meetsAtPlaces;
	reserve(to, to.vertexNum, to.faceNum);
	for (int v = 0; v < to.vertexNum; ++v) {
		to.position[v] = from.position[vertices[std::size_t(v)]];
		to.outgoing[v] = -1;
	}
	for (int h = 0; h < to.halfEdgeNum(); ++h) {
		const int v    = from.origin[3 * faces[std::size_t(h / 3)] + h % 3];
		to.origin[h]   = placeIn(vertices, v);
		to.opposite[h] = -1;
	}
	return to;
}

} // namespace gpr
