// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "glb_container.h"

#include "ply_source.h"

#include <algorithm>

namespace gpr::app {

namespace {

/// The next chunk, cut off the file's begin; empty at its end.
std::string_view takeChunk(std::string_view& file, std::uint32_t& kind)
{
	kind = 0;
	if (file.size() < gltf::chunkHeaderBytes) {
		file = {};
		return {};
	}
	const auto length = loadLittleEndian<std::uint32_t>(file.data());
	kind              = loadLittleEndian<std::uint32_t>(file.data() + 4);
	file.remove_prefix(gltf::chunkHeaderBytes);
	if (length > file.size()) failInput("the file is cut off");
	const std::string_view chunk = file.substr(0, length);
	file.remove_prefix(std::min<std::size_t>((length + 3) / 4 * 4, file.size()));
	return chunk;
}

GltfJson parsed(std::string_view text)
{
	constexpr int mostDeep  = 100; // functions on parts of the JSON call themselves for each level
	bool          isTooDeep = false;
	const auto    look      = [&](int depth, GltfJson::parse_event_t, GltfJson&) {
        isTooDeep = isTooDeep || depth > mostDeep;
        return !isTooDeep;
	};
	GltfJson json = GltfJson::parse(text, look, false);
	if (isTooDeep || !json.is_object()) failInput("its JSON part is malformed");
	return json;
}

int componentNumOf(const GltfJson& accessor)
{
	const auto type = accessor.find("type");
	if (type == accessor.end() || !type->is_string()) failInput("an accessor has no type");
	if (*type == "SCALAR") return 1;
	if (*type == "VEC2") return 2;
	if (*type == "VEC3") return 3;
	if (*type == "VEC4") return 4;
	failInput("an accessor has a wrong type");
}

PlyType typeOf(std::int64_t componentType)
{
	const std::int64_t type = componentType - gltf::firstComponentType;
	if (type < 0 || type > int(PlyType::Float32) || type == int(PlyType::Int32))
		failInput("an accessor has numbers of an unknown kind");
	return PlyType(type);
}

bool hasSign(PlyType type)
{
	return type == PlyType::Int8 || type == PlyType::Int16 || type == PlyType::Float32;
}

/// The largest whole number of a type.
double largestOf(PlyType type)
{
	const std::size_t bits = 8 * plyTypeSize(type) - (hasSign(type) ? 1 : 0);
	return double((std::uint64_t(1) << bits) - 1);
}

} // namespace

GlbChunks glbChunksOf(std::string_view file)
{
	if (file.size() < gltf::headerBytes ||
		loadLittleEndian<std::uint32_t>(file.data()) != gltf::magic)
		failInput("the file is no binary glTF file");
	if (loadLittleEndian<std::uint32_t>(file.data() + 4) != gltf::version)
		failInput("the file has another version of glTF than 2.0");
	const auto length = loadLittleEndian<std::uint32_t>(file.data() + 8);
	if (length > file.size() || length < gltf::headerBytes) failInput("the file is cut off");
	file = file.substr(gltf::headerBytes, length - gltf::headerBytes);

	std::uint32_t          kind = 0;
	const std::string_view json = takeChunk(file, kind);
	if (kind != gltf::jsonChunk) failInput("the file has no JSON part");
	GlbChunks              glb{parsed(json), {}};
	const std::string_view second = takeChunk(file, kind);
	if (kind == gltf::binaryChunk) glb.binary = second;
	return glb;
}

const GltfJson& listOf(const GltfJson& object, const char* name)
{
	static const GltfJson none = GltfJson::array();
	const auto            list = object.find(name);
	if (list == object.end()) return none;
	if (!list->is_array()) failInput(std::string("its '") + name + "' is no list");
	return *list;
}

std::int64_t countOf(const GltfJson& object, const char* name, std::int64_t fallback)
{
	const auto value = object.find(name);
	if (value == object.end()) return fallback;
	if (!value->is_number_unsigned() || value->get<std::uint64_t>() > INT64_MAX)
		failInput(std::string("its '") + name + "' is no whole number of at least 0");
	return std::int64_t(value->get<std::uint64_t>());
}

const GltfJson& entryOf(const GltfJson& list, std::int64_t index, const char* what)
{
	if (index < 0 || index >= std::int64_t(list.size()) || !list[std::size_t(index)].is_object())
		failInput(std::string("the file names a ") + what + " that does not exist");
	return list[std::size_t(index)];
}

std::string_view bufferViewOf(const GlbChunks& glb, std::int64_t index)
{
	const GltfJson& view = entryOf(listOf(glb.json, "bufferViews"), index, "buffer view");
	const GltfJson& buffer =
		entryOf(listOf(glb.json, "buffers"), countOf(view, "buffer", -1), "buffer");
	if (countOf(view, "buffer", -1) != 0 || buffer.contains("uri"))
		failInput("its data lie in another file, which is not read");
	const auto offset = std::uint64_t(countOf(view, "byteOffset", 0));
	const auto length = std::uint64_t(countOf(view, "byteLength", 0));
	if (offset > glb.binary.size() || length > glb.binary.size() - offset)
		failInput("a buffer view goes beyond the file's data");
	return glb.binary.substr(std::size_t(offset), std::size_t(length));
}

GltfRows::GltfRows(const GlbChunks& glb, std::int64_t accessor, int wantedComponents)
{
	const GltfJson& entry = entryOf(listOf(glb.json, "accessors"), accessor, "accessor");
	if (entry.contains("sparse") || !entry.contains("bufferView"))
		failInput("the file has sparse accessors, which are not read");
	type_           = typeOf(countOf(entry, "componentType", 0));
	componentBytes_ = plyTypeSize(type_);
	componentNum_   = componentNumOf(entry);
	if (wantedComponents != 0 && componentNum_ != wantedComponents)
		failInput("an accessor has a wrong type");
	const auto normalizedEntry = entry.find("normalized");
	isNormalized_ = normalizedEntry != entry.end() && *normalizedEntry == GltfJson(true);

	const std::int64_t view  = countOf(entry, "bufferView", -1);
	bytes_                   = bufferViewOf(glb, view);
	const auto        offset = std::uint64_t(countOf(entry, "byteOffset", 0));
	const auto        rows   = std::uint64_t(countOf(entry, "count", 0));
	const std::size_t packed = componentBytes_ * std::size_t(componentNum_);
	const auto stride = std::uint64_t(countOf(listOf(glb.json, "bufferViews")[std::size_t(view)],
											  "byteStride", std::int64_t(packed)));
	// Each row has at least a byte of its own, so the products below stay small.
	if (stride < packed || stride > 252 || offset > bytes_.size() || rows > bytes_.size())
		failInput("an accessor goes beyond its buffer view");
	bytes_.remove_prefix(std::size_t(offset));
	if (rows > 0 && (rows - 1) * stride + packed > bytes_.size())
		failInput("an accessor goes beyond its buffer view");
	rowNum_ = std::size_t(rows);
	stride_ = std::size_t(stride);
}

double GltfRows::number(std::size_t row, int component) const
{
	const double value = loadValue<double>(type_, at(row, component), !hostIsLittleEndian());
	if (!isNormalized_ || !isInteger(type_)) return value;
	return std::max(value / largestOf(type_), -1.0);
}

std::int64_t GltfRows::index(std::size_t row) const
{
	if (hasSign(type_)) failInput("its indices are no whole numbers without sign");
	return loadValue<std::int64_t>(type_, at(row, 0), !hostIsLittleEndian());
}

} // namespace gpr::app
