// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "normal_agreement.h"

namespace gpr {

float agreement(const Vec3f& a, const Vec3f& b)
{
	const float scale = length(a) * length(b);
	return scale > 0 ? dot(a, b) / scale : -1.0f;
}

Vec3f smoothNormal(const Surface& surface, const SurfacePoint& point)
{
	const int h = 3 * point.face;
	return normalized(surface.normal[surface.mesh.origin[h]].unpack() +
					  surface.normal[surface.mesh.origin[h + 1]].unpack() +
					  surface.normal[surface.mesh.origin[h + 2]].unpack());
}

Buffer<Vec3f> smoothNormals(const Surface& surface, const ResultMesh& result, Workers& workers)
{
	Buffer<Vec3f> normal(result.vertex.size());
	workers.forEach(normal.size(),
					[&](int v) { normal[v] = smoothNormal(surface, result.vertex[v].point); });
	return normal;
}

float normalAgreement(const HalfEdgeMesh& m, const Buffer<Vec3f>& smoothNormal, int face)
{
	const int* corner = &m.origin[3 * face];
	return agreement(m.faceCross(face),
					 smoothNormal[corner[0]] + smoothNormal[corner[1]] + smoothNormal[corner[2]]);
}

Vec3f withoutLip(const HalfEdgeMesh& m, const Buffer<Vec3f>& normal, int v, const Vec3f& own)
{
	Vec3f inside;
	forEachNeighbour(m, v, [&](int w) {
		if (!m.isBorderVertex(w)) inside += normal[w];
	});
	return dot(inside, own) < 0 ? normalized(inside) : own;
}

Buffer<Vec3f> normalsWithoutLips(const Surface& surface, const ResultMesh& result, Workers& workers)
{
	const HalfEdgeMesh& m      = result.mesh;
	Buffer<Vec3f>       normal = smoothNormals(surface, result, workers);
	workers.forEach(normal.size(), [&](int v) {
		if (m.outgoing[v] >= 0 && m.isBorderVertex(v))
			normal[v] = withoutLip(m, normal, v, normal[v]);
	});
	return normal;
}

int invertedFaceNum(const Surface& surface, const ResultMesh& result, Workers& workers)
{
	const Buffer<Vec3f> normal = normalsWithoutLips(surface, result, workers);
	return workers.sumEach<int>(result.mesh.faceNum, [&](int f, int& num) {
		num += normalAgreement(result.mesh, normal, f) < 0;
	});
}

} // namespace gpr
