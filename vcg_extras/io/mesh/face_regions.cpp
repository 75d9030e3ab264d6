// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "face_regions.h"

#include <vcg_extras/io/base/exit_code.h>

#include <algorithm>
#include <cmath>

namespace gpr::app {

namespace {

/// Names of region labels in files of several programs; the last three names come from the readers
/// of this project.
constexpr const char* regionNames[] = {"region",        "label",          "material", "group",
									   "CellEntityIds", "material_index", "object",   "solid"};

bool isWhole(double value)
{
	return value == std::floor(value) && std::abs(value) <= double(INT32_MAX);
}

/// A label for each combination of labels, in the order of appearance.
FaceRegions combined(const std::vector<FaceRegions>& all)
{
	using Key = std::vector<std::int32_t>;
	std::map<Key, std::int32_t> number;
	const auto                  keyOf = [&](std::size_t f) {
        Key key;
        for (const FaceRegions& one : all)
            key.push_back(one.label[f]);
        return key;
	};
	const std::size_t faceNum = all.front().label.size();
	for (std::size_t f = 0; f < faceNum; ++f)
		number[keyOf(f)] = 0;
	FaceRegions regions;
	for (auto& [key, label] : number) {
		label = std::int32_t(regions.names.size());
		std::string name;
		for (std::size_t i = 0; i < all.size(); ++i) {
			const std::string part = all[i].nameOf(key[i]);
			name += (name.empty() || part.empty() ? "" : " ") + part;
		}
		regions.names.push_back(name);
	}
	for (std::size_t f = 0; f < faceNum; ++f)
		regions.label.push_back(number[keyOf(f)]);
	return regions;
}

FaceRegions regionsNamed(const MeshAttributes& attributes, const std::string& name)
{
	const ValueColumn* const column = columnNamed(attributes.ofFaces, name);
	if (column == nullptr)
		failInput("its faces have no property '" + name + "' with labels of regions");
	if (!areLabels(*column))
		failInput("the values '" + name +
				  "' of its faces are no whole numbers, so they are no labels of regions");
	return regionsIn(*column);
}

} // namespace

void NamesOfFaces::begin(const std::string& name)
{
	const auto found = number_.find(name);
	if (found == number_.end())
		beginAnother(name);
	else
		current_ = found->second;
}

void NamesOfFaces::beginAnother(const std::string& name)
{
	if (names_.empty() && !of_.empty()) names_.emplace_back();
	current_ = double(names_.size());
	number_.emplace(name, int(names_.size()));
	names_.push_back(name);
}

bool areLabels(const ValueColumn& column)
{
	return std::all_of(column.values.begin(), column.values.end(), isWhole);
}

FaceRegions regionsIn(const ValueColumn& column)
{
	return {{column.values.begin(), column.values.end()}, column.names, column.name + "_"};
}

std::string FaceRegions::nameOf(std::int32_t labelOfOne) const
{
	const bool has = labelOfOne >= 0 && std::size_t(labelOfOne) < names.size();
	return has ? names[std::size_t(labelOfOne)] : prefix + std::to_string(labelOfOne);
}

bool tellsRegions(const std::string& columnName)
{
	return std::find(std::begin(regionNames), std::end(regionNames), columnName) !=
		   std::end(regionNames);
}

FaceRegions regionsOf(const MeshAttributes& attributes, const std::string& wanted)
{
	if (wanted == noRegions) return {};
	if (!wanted.empty()) return regionsNamed(attributes, wanted);
	std::vector<FaceRegions> all;
	for (const ValueColumn& column : attributes.ofFaces) {
		if (tellsRegions(column.name) && areLabels(column)) all.push_back(regionsIn(column));
	}
	const std::vector<std::int32_t>& image = attributes.texture.image;
	if (!attributes.materials.empty() && !image.empty())
		all.push_back({image, attributes.materials, {}});
	if (all.empty()) return {};
	return all.size() == 1 ? all[0] : combined(all);
}

} // namespace gpr::app
