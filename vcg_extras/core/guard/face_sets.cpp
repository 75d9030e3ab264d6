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
	std::vector<int> faces     = facesRound(m, vertices);
	const auto       isOutside = [&](int f) {
        const int* corner = &m.origin[3 * f];
        return std::any_of(corner, corner + 3, [&](int v) { return placeIn(vertices, v) < 0; });
	};
	faces.erase(std::remove_if(faces.begin(), faces.end(), isOutside), faces.end());
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
