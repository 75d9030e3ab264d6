// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "layer_marks.h"

#include "refusal.h"

#include <QString>
#include <cmath>
#include <map>

namespace gpr_filter {

namespace {

void require(const MeshModel& layer, int mask, const char* attribute)
{
	if (layer.hasDataMask(mask)) return;
	throw Refusal(std::string("Regions shall come from the ") + attribute +
				  ", which the layer does not have.");
}

std::string textureName(const CMeshO& mesh, int index)
{
	const bool isNamed = index >= 0 && std::size_t(index) < mesh.textures.size();
	return isNamed ? QString::fromStdString(std::string(mesh.textures[std::size_t(index)]))
						 .section('/', -1)
						 .toStdString()
				   : "texture " + std::to_string(index);
}

LayerRegions regionsByTexture(const MeshModel& layer)
{
	require(layer, MeshModel::MM_WEDGTEXCOORD, "texture index of faces");
	LayerRegions regions;
	for (const CFaceO& face : layer.cm.face) {
		if (!face.IsD()) regions.label.push_back(face.cWT(0).N());
	}
	std::int32_t largest = -1;
	for (const std::int32_t label : regions.label)
		largest = std::max(largest, label);
	for (std::int32_t label = 0; label <= largest; ++label)
		regions.names.push_back(textureName(layer.cm, label));
	return regions;
}

/// Numbered as they come.
LayerRegions regionsByColour(const MeshModel& layer)
{
	require(layer, MeshModel::MM_FACECOLOR, "colour of faces");
	LayerRegions                          regions;
	std::map<std::uint32_t, std::int32_t> number;
	for (const CFaceO& face : layer.cm.face) {
		if (face.IsD()) continue;
		const vcg::Color4b  c     = face.cC();
		const std::uint32_t value = std::uint32_t(c[0]) << 24 | std::uint32_t(c[1]) << 16 |
									std::uint32_t(c[2]) << 8 | std::uint32_t(c[3]);
		const auto [found, isNew] = number.emplace(value, std::int32_t(number.size()));
		regions.label.push_back(found->second);
		if (isNew) {
			regions.names.push_back(QStringLiteral("colour #%1")
										.arg(value >> 8, 6, 16, QLatin1Char('0'))
										.toStdString());
		}
	}
	return regions;
}

LayerRegions regionsByQuality(const MeshModel& layer)
{
	require(layer, MeshModel::MM_FACEQUALITY, "quality of faces");
	LayerRegions regions;
	for (const CFaceO& face : layer.cm.face) {
		if (face.IsD()) continue;
		const double quality = double(face.cQ());
		if (quality != std::floor(quality) || std::abs(quality) > double(INT32_MAX)) {
			throw Refusal("The quality of some faces is no whole number, so the quality has no "
						  "labels of regions.");
		}
		regions.label.push_back(std::int32_t(quality));
	}
	return regions;
}

} // namespace

LayerRegions regionsOf(const MeshModel& layer, RegionSource source)
{
	switch (source) {
	case RegionSource::Texture:
		return regionsByTexture(layer);
	case RegionSource::Colour:
		return regionsByColour(layer);
	case RegionSource::Quality:
		return regionsByQuality(layer);
	default:
		return {};
	}
}

std::vector<float> wantedSizesOf(const MeshModel& layer)
{
	if (!layer.hasDataMask(MeshModel::MM_VERTQUALITY)) {
		throw Refusal("Sizes shall come from the quality of the vertices, which the layer does "
					  "not have.");
	}
	std::vector<float> sizes;
	for (const CVertexO& vertex : layer.cm.vert) {
		if (vertex.IsD()) continue;
		const float size = float(vertex.cQ());
		if (!(size > 0) || !std::isfinite(size)) {
			throw Refusal("The sizes are the quality of the vertices, but the quality of some "
						  "vertices is not above 0.");
		}
		sizes.push_back(size);
	}
	return sizes;
}

} // namespace gpr_filter
