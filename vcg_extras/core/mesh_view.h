// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_MESH_VIEW_H
#define VCG_EXTRAS_CORE_MESH_VIEW_H

#include "vec.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace gpr {

/// A view of the input mesh, without ownership; the engine never writes to the arrays.
/// Positions are triples of float or double, triangles are triples of vertex indices. Any stride
/// and alignment is possible: a view can lie on the vertex array of a vcg mesh or on a mapped file.
struct MeshView {
	const void*         positions           = nullptr;
	bool                doublePrecision     = false;
	std::size_t         positionStrideBytes = 0; ///< between two consecutive positions
	std::size_t         vertexNum           = 0;
	const void*         triangles           = nullptr; ///< std::int32_t
	std::size_t         triangleStrideBytes = 3 * sizeof(std::int32_t);
	std::size_t         faceNum             = 0;
	const std::uint8_t* selected = nullptr; ///< per vertex, or null; for FeatureRegion::Selection
	/// Three a face, or null: not 0 if the edge from this corner to the next is a feature line, as
	/// at a seam of the texture. Edges of the result follow feature lines.
	const std::uint8_t* line = nullptr;
	/// Per face, or null: the label of its region. Region borders are feature lines, and faces of
	/// the result have labels: RemeshResult::region.
	const std::int32_t* region = nullptr;
	/// By label, or null: names of the regions in notes.
	const std::vector<std::string>* regionNames = nullptr;
	/// Per vertex, or null for all: not 0 if BoundaryMode::Keep keeps the vertex of the border.
	const std::uint8_t* keptBorder = nullptr;
	/// Per face, or null: not 0 if selected; for RemeshOptions::selectedOnly.
	const std::uint8_t* selectedFace = nullptr;
	/// Per vertex, or null: the local size, mesh units, above 0.
	const float* wantedEdge = nullptr;
	/// For half of a symmetric mesh: the axis perpendicular to the mirror plane; else -1. The
	/// mirror plane is at 0: the border of the cut lies on the plane, all else above.
	int mirrorAxis = -1;

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
			double d[3];
			std::memcpy(d, at, sizeof d);
			return {d[0], d[1], d[2]};
		}
		float f[3];
		std::memcpy(f, at, sizeof f);
		return {double(f[0]), double(f[1]), double(f[2])};
	}

	/// The vertices of a face.
	std::array<std::int32_t, 3> triangle(std::size_t face) const
	{
		std::array<std::int32_t, 3> corner;
		std::memcpy(corner.data(), static_cast<const char*>(triangles) + face * triangleStrideBytes,
					sizeof corner);
		return corner;
	}
	/// The vertex of corner c, which is corner c % 3 of face c / 3.
	std::int32_t vertexOf(std::size_t c) const { return triangle(c / 3)[c % 3]; }

	/// The unit normal of a face times twice its area.
	Vec3d faceCross(std::size_t face) const
	{
		const std::array<std::int32_t, 3> t = triangle(face);
		const Vec3d                       a = position(std::size_t(t[0]));
		return cross(position(std::size_t(t[1])) - a, position(std::size_t(t[2])) - a);
	}

	/// Whether faces have different labels.
	bool hasManyRegions() const
	{
		return region != nullptr &&
			   std::any_of(region, region + faceNum,
						   [this](std::int32_t label) { return label != region[0]; });
	}

	bool anySelected() const
	{
		return selected != nullptr && std::any_of(selected, selected + vertexNum,
												  [](std::uint8_t mark) { return mark != 0; });
	}
};

/// A point of the input: a face and the barycentric weights of its three corners.
struct BarycentricPoint {
	std::int32_t face      = -1;
	float        weight[3] = {1, 0, 0};

	static BarycentricPoint ofCorner(std::size_t face, std::size_t corner)
	{
		return {std::int32_t(face), {float(corner == 0), float(corner == 1), float(corner == 2)}};
	}
	static BarycentricPoint ofMiddle(std::size_t face)
	{
		constexpr float third = 1 / 3.0f;
		return {std::int32_t(face), {third, third, third}};
	}
};

/// A triangle mesh that owns its arrays, in the frame of the input.
struct TriangleMesh {
	std::vector<Vec3d>        positions;
	std::vector<std::int32_t> triangles; ///< three indices a face

	std::size_t vertexNum() const { return positions.size(); }
	std::size_t faceNum() const { return triangles.size() / 3; }
	MeshView    view() const { return MeshView(positions, triangles); }
};

/// A copy of the positions and triangles.
inline TriangleMesh triangleMeshOf(const MeshView& mesh)
{
	TriangleMesh copy;
	copy.positions.reserve(mesh.vertexNum);
	copy.triangles.reserve(3 * mesh.faceNum);
	for (std::size_t v = 0; v < mesh.vertexNum; ++v)
		copy.positions.push_back(mesh.position(v));
	for (std::size_t c = 0; c < 3 * mesh.faceNum; ++c)
		copy.triangles.push_back(mesh.vertexOf(c));
	return copy;
}

/// A mesh with marks as in MeshView; empty: no such marks.
struct MarkedMesh : TriangleMesh {
	std::vector<std::uint8_t> selected;   ///< per vertex
	std::vector<float>        wantedEdge; ///< per vertex
	std::vector<std::uint8_t> line;       ///< three a face
	std::vector<std::int32_t> region;     ///< per face

	MeshView view() const
	{
		MeshView v   = TriangleMesh::view();
		v.selected   = selected.empty() ? nullptr : selected.data();
		v.wantedEdge = wantedEdge.empty() ? nullptr : wantedEdge.data();
		v.line       = line.empty() ? nullptr : line.data();
		v.region     = region.empty() ? nullptr : region.data();
		return v;
	}
};

} // namespace gpr

#endif
