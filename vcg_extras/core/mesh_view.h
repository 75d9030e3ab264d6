// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_MESH_VIEW_H
#define VCG_EXTRAS_CORE_MESH_VIEW_H

#include "vec.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace gpr {

/// Non-owning view of the caller's triangle mesh; the engine never writes to it.
/// Positions are triples of float or double with any stride, so that a view can lie directly on
/// the vertex array of a vcg mesh; triangles are 3·faceNum vertex indices.
struct MeshView {
	const void*         positions           = nullptr;
	bool                doublePrecision     = false;
	std::size_t         positionStrideBytes = 0; ///< distance of two consecutive positions
	std::size_t         vertexNum           = 0;
	const std::int32_t* triangles           = nullptr;
	std::size_t         faceNum             = 0;
	const float*        quality  = nullptr; ///< per vertex, or null; for SizingSource::Quality
	const std::uint8_t* selected = nullptr; ///< per vertex, or null; for FeatureRegion::Selection
	/// Three a face, or null: not 0 where the edge from that corner to the next is a line, like a
	/// seam of the texture, that edges of the result shall follow.
	const std::uint8_t* line = nullptr;
	/// Per face, or null: not 0 where it is selected; for RemeshOptions::selectedOnly.
	const std::uint8_t* selectedFace = nullptr;

	MeshView() = default;
	template <class S>
	MeshView(const std::vector<Vec3<S>>& p, const std::vector<std::int32_t>& t) :
			positions(p.data()), doublePrecision(sizeof(S) == sizeof(double)),
			positionStrideBytes(sizeof(Vec3<S>)), vertexNum(p.size()), triangles(t.data()),
			faceNum(t.size() / 3)
	{
	}

	Vec3d position(std::size_t v) const
	{
		const char* at = static_cast<const char*>(positions) + v * positionStrideBytes;
		if (doublePrecision) {
			const double* d = reinterpret_cast<const double*>(at);
			return {d[0], d[1], d[2]};
		}
		const float* f = reinterpret_cast<const float*>(at);
		return {double(f[0]), double(f[1]), double(f[2])};
	}
};

/// A point of the caller's surface: face index and barycentric weights of its three corners.
struct SurfacePoint {
	std::int32_t face      = -1;
	float        weight[3] = {1, 0, 0};
};

/// An owned triangle mesh in the caller's frame.
struct TriangleMesh {
	std::vector<Vec3d>        positions;
	std::vector<std::int32_t> triangles; ///< 3 indices a face

	std::size_t vertexNum() const { return positions.size(); }
	std::size_t faceNum() const { return triangles.size() / 3; }
	MeshView    view() const { return MeshView(positions, triangles); }
};

} // namespace gpr

#endif
