// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_IO_FORMATS_GLB_CONTAINER_H
#define VCG_EXTRAS_IO_FORMATS_GLB_CONTAINER_H

#include "ply_header.h"

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string_view>

// The container of binary glTF 2.0 (Khronos, ISO/IEC 12113:2022): chunks, and typed rows of bytes.
// Nothing in a file is trusted: every index and length is checked.

namespace gpr::app {

using GltfJson = nlohmann::json;

/// Numbers of glTF: of chunks, of component types, and of the modes of primitives.
namespace gltf {
constexpr std::uint32_t magic = 0x46546C67, version = 2, jsonChunk = 0x4E4F534A,
						binaryChunk = 0x004E4942;
constexpr std::size_t  headerBytes = 12, chunkHeaderBytes = 8;
constexpr std::int64_t firstComponentType = 5120; ///< the others follow as in PlyType
enum Mode : std::int64_t { Triangles = 4, TriangleStrip = 5, TriangleFan = 6 };
} // namespace gltf

/// A file taken apart.
struct GlbChunks {
	GltfJson         json;
	std::string_view binary; ///< empty without a binary chunk
};

/// Throws AppError (BadInput) for a file of another kind or version, or a cut-off file.
GlbChunks glbChunksOf(std::string_view file);

/// The array of an object with this name; an empty array if missing.
const GltfJson& listOf(const GltfJson& object, const char* name);
/// A whole number of at least 0, or the fallback if missing. Throws AppError (BadInput) for any
/// other value.
std::int64_t countOf(const GltfJson& object, const char* name, std::int64_t fallback);
/// The entry of a list. Throws AppError (BadInput) for a missing entry; the sentence names the
/// entry by `what`.
const GltfJson& entryOf(const GltfJson& list, std::int64_t index, const char* what);

/// The bytes of a buffer view.
std::string_view bufferViewOf(const GlbChunks& glb, std::int64_t index);

/// Rows of numbers: an accessor.
class GltfRows {
public:
	/// Throws AppError (BadInput) for rows outside the file, sparse rows, or rows with another
	/// number of components; 0 takes any number.
	GltfRows(const GlbChunks& glb, std::int64_t accessor, int wantedComponents);

	std::size_t rowNum() const { return rowNum_; }
	int         componentNum() const { return componentNum_; }
	/// Whole numbers for 0 to 1, or -1 to 1, are returned in these ranges.
	double number(std::size_t row, int component) const;
	/// Of whole numbers without sign; throws AppError (BadInput) for other types.
	std::int64_t index(std::size_t row) const;

private:
	std::string_view bytes_;
	std::size_t      rowNum_ = 0, stride_ = 0, componentBytes_ = 0;
	PlyType          type_         = PlyType::Float32;
	int              componentNum_ = 0;
	bool             isNormalized_ = false;

	const char* at(std::size_t row, int component) const
	{
		return bytes_.data() + row * stride_ + std::size_t(component) * componentBytes_;
	}
};

} // namespace gpr::app

#endif
