// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "attribute_carry.h"

#include "precision.h"

#include <vcg_extras/core/carry_over.h>

#include <array>
#include <cmath>
#include <set>
#include <utility>

namespace gpr::app {

namespace {

bool isColour(const ValueColumn& column)
{
	return isOneOf(column.name, {"red", "green", "blue", "alpha", "diffuse_red", "diffuse_green",
								 "diffuse_blue", "ambient_red", "ambient_green", "ambient_blue"});
}

bool isReal(PlyType type)
{
	return type == PlyType::Float32 || type == PlyType::Float64;
}

/// The columns of a colour of the vertices.
std::vector<const ValueColumn*> coloursOf(const std::vector<ValueColumn>& columns)
{
	std::vector<const ValueColumn*> colours;
	for (const ValueColumn& column : columns) {
		if (isColour(column) && !isReal(column.type)) colours.push_back(&column);
	}
	return colours;
}

/// Whether colours serve as labels: few colours, and most edges have the same colour at both ends.
bool arePalette(const std::vector<const ValueColumn*>& colours, const MeshView& mesh)
{
	constexpr std::size_t mostColours = 256;
	constexpr double      leastEqual  = 0.75; // of the edges
	if (colours.empty()) return false;
	const auto colourOf = [&](std::int32_t v) {
		std::vector<double> colour;
		for (const ValueColumn* column : colours)
			colour.push_back(column->values[std::size_t(v)]);
		return colour;
	};
	std::set<std::vector<double>> all;
	std::size_t                   equalNum = 0;
	for (std::size_t f = 0; f < mesh.faceNum; ++f) {
		const auto                t = mesh.triangle(f);
		const std::vector<double> a = colourOf(t[0]), b = colourOf(t[1]), c = colourOf(t[2]);
		equalNum += std::size_t(a == b) + std::size_t(b == c) + std::size_t(c == a);
		all.insert(a);
		if (all.size() > mostColours) return false;
	}
	return all.size() > 1 && double(equalNum) >= leastEqual * 3 * double(mesh.faceNum);
}

/// Whether values of a column have no mean.
bool isNearest(const ValueColumn& column, Transfer transfer, bool hasPalette)
{
	if (transfer == Transfer::Nearest) return true;
	if (isReal(column.type)) return false;
	return !isColour(column) || (hasPalette && transfer == Transfer::Auto);
}

double valueAt(const ValueColumn& column, bool isNearest, const MeshView& mesh,
			   const BarycentricPoint& at)
{
	const auto ofCorner = [&](int k) {
		const std::int32_t v = mesh.vertexOf(3 * std::size_t(at.face) + std::size_t(k));
		return column.values[std::size_t(v)];
	};
	if (isNearest) return ofCorner(nearestCorner(at));
	const double mean = meanOfCorners(at, ofCorner);
	return isReal(column.type) ? mean : std::floor(mean + 0.5);
}

/// Means of unit vectors are shorter.
void normalizeNormals(std::vector<ValueColumn>& columns)
{
	const std::array<ValueColumn*, 3> n = {columnNamed(columns, "nx"), columnNamed(columns, "ny"),
										   columnNamed(columns, "nz")};
	if (!n[0] || !n[1] || !n[2]) return;
	for (std::size_t v = 0; v < n[0]->values.size(); ++v) {
		double squared = 0;
		for (const ValueColumn* c : n)
			squared += c->values[v] * c->values[v];
		if (!(squared > 0)) continue;
		for (ValueColumn* c : n)
			c->values[v] /= std::sqrt(squared);
	}
}

} // namespace

std::unique_ptr<TextureSource> takeTexture(MeshAttributes& attributes, const MeshView& mesh,
										   bool isSewn)
{
	if (attributes.hasTexture())
		return std::make_unique<TextureSource>(mesh, std::move(attributes.texture));
	if (!isSewn) return nullptr;
	CornerTexture ofVertices = textureOfVertices(attributes, mesh);
	if (ofVertices.uv.empty()) return nullptr;
	auto source = std::make_unique<TextureSource>(mesh, std::move(ofVertices));
	if (!source->hasSeams()) return nullptr;
	dropTextureOfVertices(attributes);
	return source;
}

MeshAttributes carryAttributes(MeshAttributes& source, const MeshView& mesh,
							   const TextureSource* texture, const RemeshResult& result,
							   Transfer transfer)
{
	const bool     hasPalette = arePalette(coloursOf(source.ofVertices), mesh);
	MeshAttributes carried;
	carried.lost = source.lost;
	for (ValueColumn& column : source.ofVertices) {
		ValueColumn to{column.name, column.type, {}, {}};
		to.values.reserve(result.surfacePoints.size());
		const bool nearest = isNearest(column, transfer, hasPalette);
		for (const BarycentricPoint& at : result.surfacePoints)
			to.values.push_back(valueAt(column, nearest, mesh, at));
		carried.ofVertices.push_back(std::move(to));
		column.values = {};
	}
	normalizeNormals(carried.ofVertices);
	for (ValueColumn& column : source.ofFaces) {
		if (isOneOf(column.name, {"nx", "ny", "nz"})) {
			if (column.name == "nx") carried.lost.push_back("normals of faces");
			continue;
		}
		ValueColumn to{column.name, column.type, {}, column.names};
		for (const BarycentricPoint& at : result.facePoints)
			to.values.push_back(column.values[std::size_t(at.face)]);
		carried.ofFaces.push_back(std::move(to));
		column.values = {};
	}
	if (texture != nullptr) carried.texture = texture->carriedTo(result);
	carried.images          = source.images;
	carried.materials       = source.materials;
	carried.materialLibrary = source.materialLibrary;
	carried.gltf            = source.gltf;
	carried.folder          = source.folder;
	carried.unit            = source.unit;
	return carried;
}

bool isSewn(const RemeshOptions& options)
{
	return options.sew && !options.selectedOnly;
}

MeshSource::MeshSource(InputMesh input, const RemeshOptions& options) : mesh(std::move(input))
{
	texture = takeTexture(mesh.attributes, mesh.view(), isSewn(options));
}

MeshView MeshSource::view() const
{
	MeshView view = mesh.view();
	if (texture != nullptr && texture->hasSeams()) view.line = texture->seams().data();
	return view;
}

RemeshOptions MeshSource::withPlaces(const RemeshOptions& options) const
{
	RemeshOptions all           = options;
	all.surfacePointsOfVertices = needsPoints();
	all.surfacePointsOfFaces    = needsPointsOfFaces();
	return all;
}

bool needsDoubleOutput(const InputMesh& input, const RemeshResult& result)
{
	return input.doublePrecision ||
		   !floatResolves(largestCoordinate(result.mesh.view()), result.report.quality.meanEdgeLen);
}

} // namespace gpr::app
