// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_attributes.h"

#include "polygon.h"

namespace gpr::app {

bool isOneOf(const std::string& name, std::initializer_list<const char*> names)
{
	return std::any_of(names.begin(), names.end(), [&](const char* n) { return name == n; });
}

std::string withCommas(const std::vector<std::string>& words)
{
	std::string list;
	for (const std::string& word : words)
		list += (list.empty() ? "" : ", ") + word;
	return list;
}

std::string noteOfLost(const std::vector<std::string>& lost)
{
	return lost.empty() ? "" : "Not carried over: " + withCommas(lost) + ".";
}

namespace {

/// The names of texture coordinates in files of several programs.
constexpr const char* textureNames[][2] = {
	{"s", "t"}, {"u", "v"}, {"texture_u", "texture_v"}, {"texture_s", "texture_t"}};

} // namespace

CornerTexture textureOfVertices(const MeshAttributes& attributes, const MeshView& mesh)
{
	CornerTexture texture;
	for (const auto& names : textureNames) {
		const ValueColumn* u = attributes.ofVertex(names[0]);
		const ValueColumn* v = attributes.ofVertex(names[1]);
		if (u == nullptr || v == nullptr) continue;
		texture.uv.reserve(6 * mesh.faceNum);
		for (std::size_t c = 0; c < 3 * mesh.faceNum; ++c) {
			const auto vertex = std::size_t(mesh.vertexOf(c));
			texture.uv.push_back(float(u->values[vertex]));
			texture.uv.push_back(float(v->values[vertex]));
		}
		return texture;
	}
	return texture;
}

void dropTextureOfVertices(MeshAttributes& attributes)
{
	const auto isOfTexture = [](const ValueColumn& column) {
		for (const auto& names : textureNames) {
			if (column.name == names[0] || column.name == names[1]) return true;
		}
		return false;
	};
	auto& columns = attributes.ofVertices;
	columns.erase(std::remove_if(columns.begin(), columns.end(), isOfTexture), columns.end());
}

void TriangleOrder::add(const std::int64_t* corners, std::size_t cornerNum)
{
	const std::int64_t face = faceNum_++, first = cornerNum_;
	cornerNum_ += std::int64_t(cornerNum);
	if (cornerNum < 3) return;
	if (cornerNum > 3) {
		polygons_.push_back({face, first, {corners, corners + cornerNum}});
		return;
	}
	face_.push_back(face);
	for (int k = 0; k < 3; ++k)
		corner_.push_back(first + k);
}

void TriangleOrder::finish(const MeshView& positions)
{
	std::vector<Vec3d>       corners;
	std::vector<std::size_t> cut;
	for (const Polygon& polygon : polygons_) {
		corners.clear();
		for (const std::int64_t v : polygon.vertices)
			corners.push_back(positions.position(std::size_t(v)));
		cutPolygon(corners, cut);
		for (std::size_t i = 0; i < cut.size(); ++i) {
			if (i % 3 == 0) face_.push_back(polygon.face);
			corner_.push_back(polygon.firstCorner + std::int64_t(cut[i]));
		}
	}
	polygons_.clear();
}

std::vector<double> perTriangle(const std::vector<double>& perFace, const TriangleOrder& order)
{
	std::vector<double> values;
	values.reserve(order.face().size());
	for (const std::int64_t f : order.face())
		values.push_back(perFace[std::size_t(f)]);
	return values;
}

std::vector<float> cornersOfTriangles(const std::vector<float>& uvPerCorner,
									  const TriangleOrder&      order)
{
	std::vector<float> uv;
	uv.reserve(2 * order.corner().size());
	for (const std::int64_t c : order.corner()) {
		uv.push_back(uvPerCorner[2 * std::size_t(c)]);
		uv.push_back(uvPerCorner[2 * std::size_t(c) + 1]);
	}
	return uv;
}

} // namespace gpr::app
