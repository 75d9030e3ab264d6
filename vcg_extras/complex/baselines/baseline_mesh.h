// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_COMPLEX_BASELINES_BASELINE_MESH_H
#define VCG_EXTRAS_COMPLEX_BASELINES_BASELINE_MESH_H

// Conversion between flat arrays and a mesh of vcglib in float, as in MeshLab.

#include <vcg_extras/core/surface/triangle_tree.h>

#include <cstdint>
#include <vcg/complex/complex.h>
#include <vector>

namespace gpr::baselines {

/// Fills an empty mesh with the usable faces of a view and the vertices of these faces.
template <class Mesh>
void fillBaselineMesh(const MeshView& from, Mesh& to)
{
	using Allocator = vcg::tri::Allocator<Mesh>;
	std::vector<std::int32_t> number(from.vertexNum, -1), corners;
	std::int32_t              used = 0;
	for (std::size_t f = 0; f < from.faceNum; ++f) {
		const auto t = from.triangle(f);
		if (!isUsableFace(from, f)) continue;
		corners.insert(corners.end(), t.begin(), t.end());
		for (int k = 0; k < 3; ++k)
			number[t[k]] = 0;
	}
	for (std::int32_t& n : number)
		if (n == 0) n = used++;
	Allocator::AddVertices(to, std::size_t(used));
	for (std::size_t v = 0; v < from.vertexNum; ++v) {
		if (number[v] < 0) continue;
		const Vec3f p          = Vec3f(from.position(v));
		to.vert[number[v]].P() = vcg::Point3f(p.x, p.y, p.z);
	}
	Allocator::AddFaces(to, corners.size() / 3);
	for (std::size_t i = 0; i < corners.size(); ++i)
		to.face[i / 3].V(int(i % 3)) = &to.vert[number[corners[i]]];
}

/// A compact mesh as arrays.
template <class Mesh>
TriangleMesh arraysOfBaselineMesh(const Mesh& from)
{
	TriangleMesh to;
	to.positions.reserve(from.vert.size());
	for (const auto& v : from.vert)
		to.positions.emplace_back(v.cP()[0], v.cP()[1], v.cP()[2]);
	to.triangles.reserve(3 * from.face.size());
	for (const auto& f : from.face)
		for (int k = 0; k < 3; ++k)
			to.triangles.push_back(std::int32_t(f.cV(k) - from.vert.data()));
	return to;
}

} // namespace gpr::baselines

#endif
