// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "face_sets.h"

#include "sparse_array.h"

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

bool hasOnlyMarked(const HalfEdgeMesh& m, int v, const std::vector<char>& marked)
{
	return !anyOutgoing(m, v, [&](int h) { return !marked[h / 3]; });
}

std::vector<int> facesBetween(const HalfEdgeMesh& m, const std::vector<int>& vertices)
{
	const SparseArray<int> place = placesIn(vertices, m.vertexNum);
	std::vector<int>       faces;
	for (std::size_t i = 0; i < vertices.size(); ++i) {
		// Each face once, from its corner with the first place.
		const auto isLater = [&](int v) { return place[v] > int(i); };
		forEachOutgoing(m, vertices[i], [&](int h) {
			if (isLater(m.target(h)) && isLater(m.apex(h))) faces.push_back(h / 3);
		});
	}
	std::sort(faces.begin(), faces.end());
	return faces;
}

HalfEdgeMesh facesAlone(const HalfEdgeMesh& from, const std::vector<int>& faces,
						const std::vector<int>& vertices)
{
	const SparseArray<int> place = placesIn(vertices, from.vertexNum);
	HalfEdgeMesh           to;
	to.vertexNum     = int(vertices.size());
	to.faceNum       = int(faces.size());
	to.meetsAtPlaces = from.meetsAtPlaces;
	reserve(to, to.vertexNum, to.faceNum);
	for (int v = 0; v < to.vertexNum; ++v) {
		to.position[v] = from.position[vertices[v]];
		to.outgoing[v] = -1;
	}
	for (int h = 0; h < to.halfEdgeNum(); ++h) {
		const int v    = from.origin[3 * faces[h / 3] + h % 3];
		to.origin[h]   = place[v];
		to.opposite[h] = -1;
	}
	return to;
}

HalfEdgeMesh cutOut(const HalfEdgeMesh& from, const std::vector<int>& faces,
					const std::vector<int>& vertices)
{
	HalfEdgeMesh           to      = facesAlone(from, faces, vertices);
	const SparseArray<int> place   = placesIn(faces, from.faceNum);
	const auto             renamed = [&](int h) {
        const int f = h < 0 ? -1 : place[h / 3];
        return f < 0 ? -1 : 3 * f + h % 3;
	};
	to.mirrorAxis = from.mirrorAxis;
	for (int h = 0; h < to.halfEdgeNum(); ++h)
		to.opposite[h] = renamed(from.opposite[3 * faces[h / 3] + h % 3]);
	for (int v = 0; v < to.vertexNum; ++v)
		to.outgoing[v] = renamed(from.outgoing[vertices[v]]);
	return to;
}

} // namespace gpr
