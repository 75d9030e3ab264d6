// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "byte_order.h"
#include "mesh_formats.h"

#include <string>

namespace gpr::app {

namespace {

void addColumns(const std::vector<ValueColumn>& columns, PlyElement& element)
{
	for (const ValueColumn& c : columns)
		element.properties.push_back({c.name, c.type});
}

std::string headerOf(const MeshView& mesh, PlyType coordinate, const MeshAttributes& a)
{
	PlyElement vertex = elementWithPositions(coordinate, mesh.vertexNum);
	PlyElement face   = elementOfFaces(PlyType::UInt8, PlyType::Int32, mesh.faceNum);
	addColumns(a.ofVertices, vertex);
	addColumns(a.ofFaces, face);
	if (a.hasTexture()) face.properties.push_back({"texcoord", PlyType::Float32, true});
	if (!a.texture.image.empty()) face.properties.push_back({"texnumber", PlyType::Int32});
	std::string comments = "comment written by gpremesh\n";
	for (const std::string& image : a.images)
		comments += "comment TextureFile " + image + "\n";
	for (const ValueColumn& column : a.ofFaces) {
		for (std::size_t i = 0; i < column.names.size(); ++i)
			comments += nameComment(column.name) + std::to_string(i) + " " + column.names[i] + "\n";
	}
	return plyHeaderText({PlyFormat::LittleEndian, {vertex, face}}, comments);
}

/// The bytes of a record.
class Record {
public:
	explicit Record(std::size_t most) : bytes_(most), at_(bytes_.data()) {}

	template <class T>
	void put(T value)
	{
		putLittleEndian(value, at_);
	}
	void put(PlyType type, double value)
	{
		putAs(type, value, [this](auto number) { put(number); });
	}
	void putRow(const std::vector<ValueColumn>& columns, std::size_t row)
	{
		for (const ValueColumn& c : columns)
			put(c.type, c.values[row]);
	}
	void writeTo(OutputFile& out)
	{
		out.bytes(bytes_.data(), std::size_t(at_ - bytes_.data()));
		at_ = bytes_.data();
	}

private:
	std::vector<char> bytes_;
	char*             at_;
};

void putFace(const MeshView& mesh, const MeshAttributes& a, std::size_t f, Record& record)
{
	record.put(std::uint8_t(3));
	for (std::size_t c = 3 * f; c < 3 * f + 3; ++c)
		record.put(mesh.vertexOf(c));
	record.putRow(a.ofFaces, f);
	if (a.hasTexture()) {
		record.put(std::uint8_t(6));
		for (std::size_t i = 6 * f; i < 6 * f + 6; ++i)
			record.put(a.texture.uv[i]);
	}
	if (!a.texture.image.empty()) record.put(a.texture.image[f]);
}

} // namespace

void writePly(const MeshView& mesh, bool doublePrecision, const MeshAttributes& a, OutputFile& out)
{
	constexpr std::size_t mostOfMesh = 64; // bytes of a record without its columns
	const PlyType         coordinate = doublePrecision ? PlyType::Float64 : PlyType::Float32;
	out.text(headerOf(mesh, coordinate, a));
	Record record(mostOfMesh + sizeof(double) * (a.ofVertices.size() + a.ofFaces.size()));
	for (std::size_t v = 0; v < mesh.vertexNum; ++v) {
		const Vec3d p = mesh.position(v);
		for (const double c : {p.x, p.y, p.z})
			record.put(coordinate, c);
		record.putRow(a.ofVertices, v);
		record.writeTo(out);
	}
	for (std::size_t f = 0; f < mesh.faceNum; ++f) {
		putFace(mesh, a, f, record);
		record.writeTo(out);
	}
}

} // namespace gpr::app
