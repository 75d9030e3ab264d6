// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "result_mesh.h"

#include <vcg_extras/core/mesh/mesh_edit.h>

#include <algorithm>
#include <cmath>

namespace gpr {

float sizeAt(const Surface& surface, const SurfacePoint& at)
{
	if (surface.size.empty()) return 1;
	const HalfEdgeMesh& m = surface.mesh;
	const int           i = m.origin[3 * at.face], j = m.origin[3 * at.face + 1];
	const int           k       = m.origin[3 * at.face + 2];
	const Vec3f         a       = m.position[i];
	const Vec3f         n       = m.faceCross(at.face);
	const float         squared = squaredLength(n);
	if (!(squared > 0)) return std::min({surface.size[i], surface.size[j], surface.size[k]});
	const float wj = dot(cross(at.position - a, m.position[k] - a), n) / squared;
	const float wk = dot(cross(m.position[j] - a, at.position - a), n) / squared;
	const float b  = std::clamp(wj, 0.0f, 1.0f);
	const float c  = std::clamp(wk, 0.0f, 1.0f - b);
	return surface.size[i] * (1 - b - c) + surface.size[j] * b + surface.size[k] * c;
}

Buffer<float> sizesOf(const Surface& surface, const ResultMesh& result, Workers& workers)
{
	if (surface.size.empty()) return Buffer<float>();
	Buffer<float> size(result.vertex.size());
	workers.forEach(size.size(), [&](int v) { size[v] = sizeAt(surface, result.vertex[v].point); });
	return size;
}

std::int64_t ResultMesh::vertexNum() const
{
	if (mesh.mirrorAxis < 0) return mesh.vertexNum - copyNum;
	std::int64_t num = 0;
	for (int v = 0; v < mesh.vertexNum; ++v)
		num += mesh.multiplicity(mesh.position[v]);
	return num;
}

ResultMesh copyResult(const ResultMesh& result, Workers& workers)
{
	ResultMesh copy;
	static_cast<ResultFacts&>(copy) = result;
	copy.mesh                       = copyMesh(result.mesh, workers);
	copy.vertex                     = result.vertex;
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
