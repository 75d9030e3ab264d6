// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ply_attribute_writer.h"

#include <cstring>
#include <string>
#include <type_traits>

namespace gpr::app {

namespace {

/// The bytes of one record, in little endian order on every machine.
class RecordBytes {
public:
	template <class T>
	void put(T value)
	{
		std::uint64_t bits = 0;
		if constexpr (sizeof(T) == 8) {
			std::memcpy(&bits, &value, 8);
		}
		else if constexpr (sizeof(T) == 4) {
			std::uint32_t half = 0;
			std::memcpy(&half, &value, 4);
			bits = half;
		}
		else {
			bits = std::uint64_t(std::make_unsigned_t<T>(value));
		}
		for (std::size_t i = 0; i < sizeof(T); ++i)
			bytes_ += char(bits >> (8 * i) & 0xff);
	}
	void putAs(PlyType type, double value)
	{
		switch (type) {
		case PlyType::Int8:
			return put(wholeOfRange<std::int8_t>(value));
		case PlyType::UInt8:
			return put(wholeOfRange<std::uint8_t>(value));
		case PlyType::Int16:
			return put(wholeOfRange<std::int16_t>(value));
		case PlyType::UInt16:
			return put(wholeOfRange<std::uint16_t>(value));
		case PlyType::Int32:
			return put(wholeOfRange<std::int32_t>(value));
		case PlyType::UInt32:
			return put(wholeOfRange<std::uint32_t>(value));
		case PlyType::Float32:
			return put(float(value));
		case PlyType::Float64:
			return put(value);
		}
	}
	void writeTo(OutputFile& out)
	{
		out.bytes(bytes_.data(), bytes_.size());
		bytes_.clear();
	}

private:
	std::string bytes_;
};

std::string propertiesOf(const std::vector<ValueColumn>& columns)
{
	std::string text;
	for (const ValueColumn& c : columns)
		text += std::string("property ") + plyTypeName(c.type) + " " + c.name + "\n";
	return text;
}

std::string headerOf(const TriangleMesh& mesh, bool doublePrecision, const MeshAttributes& a)
{
	const std::string coordinate = doublePrecision ? "property double " : "property float ";
	std::string       text       = "ply\nformat binary_little_endian 1.0\n"
								   "comment written by gpremesh\n";
	for (const std::string& image : a.images)
		text += "comment TextureFile " + image + "\n";
	text += "element vertex " + std::to_string(mesh.vertexNum()) + "\n";
	for (const char* name : {"x\n", "y\n", "z\n"})
		text += coordinate + name;
	text += propertiesOf(a.ofVertices) + "element face " + std::to_string(mesh.faceNum()) +
			"\nproperty list uchar int vertex_indices\n" + propertiesOf(a.ofFaces);
	if (a.hasTexture()) text += "property list uchar float texcoord\n";
	if (!a.texture.image.empty()) text += "property int texnumber\n";
	return text + "end_header\n";
}

void putFace(const TriangleMesh& mesh, const MeshAttributes& a, std::size_t f, RecordBytes& record)
{
	record.put(std::uint8_t(3));
	for (std::size_t c = 3 * f; c < 3 * f + 3; ++c)
		record.put(mesh.triangles[c]);
	for (const ValueColumn& column : a.ofFaces)
		record.putAs(column.type, column.values[f]);
	if (a.hasTexture()) {
		record.put(std::uint8_t(6));
		for (std::size_t i = 6 * f; i < 6 * f + 6; ++i)
			record.put(a.texture.uv[i]);
	}
	if (!a.texture.image.empty()) record.put(a.texture.image[f]);
}

} // namespace

void writePlyWithAttributes(const TriangleMesh& mesh, bool doublePrecision, const MeshAttributes& a,
							OutputFile& out)
{
	const PlyType coordinate = doublePrecision ? PlyType::Float64 : PlyType::Float32;
	out.text(headerOf(mesh, doublePrecision, a));
	RecordBytes record;
	for (std::size_t v = 0; v < mesh.vertexNum(); ++v) {
		const Vec3d& p = mesh.positions[v];
		for (const double c : {p.x, p.y, p.z})
			record.putAs(coordinate, c);
		for (const ValueColumn& column : a.ofVertices)
			record.putAs(column.type, column.values[v]);
		record.writeTo(out);
	}
	for (std::size_t f = 0; f < mesh.faceNum(); ++f) {
		putFace(mesh, a, f, record);
		record.writeTo(out);
	}
}

} // namespace gpr::app
