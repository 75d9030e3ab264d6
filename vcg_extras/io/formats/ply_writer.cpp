// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ply_writer.h"

#include "little_endian.h"

#include <string>

namespace gpr::app {

namespace {

constexpr std::int32_t selectedFlag = 0x20; ///< vcglib's bit

std::string header(const MeshView& mesh, bool doublePrecision, const PlyVertexData& data)
{
	const std::string type = doublePrecision ? "double" : "float";
	std::string       text =
		"ply\nformat binary_little_endian 1.0\ncomment written by gpremesh\nelement vertex " +
		std::to_string(mesh.vertexNum) + "\n";
	for (const char* name : {" x\n", " y\n", " z\n"})
		text += "property " + type + name;
	if (data.selected != nullptr) text += "property int flags\n";
	if (data.quality != nullptr) text += "property float quality\n";
	if (data.rgb != nullptr) {
		text += "property uchar red\nproperty uchar green\nproperty uchar blue\n"
				"property uchar alpha\n";
	}
	return text + "element face " + std::to_string(mesh.faceNum) +
		   "\nproperty list uchar int vertex_indices\nend_header\n";
}

void putPosition(const Vec3d& p, bool doublePrecision, char*& at)
{
	for (const double c : {p.x, p.y, p.z}) {
		if (doublePrecision) {
			putLittleEndian<std::uint64_t>(c, at);
		}
		else {
			putLittleEndian<std::uint32_t>(float(c), at);
		}
	}
}

void putData(const PlyVertexData& data, std::size_t v, char*& at)
{
	if (data.selected != nullptr)
		putLittleEndian<std::uint32_t>(data.selected[v] ? selectedFlag : 0, at);
	if (data.quality != nullptr) putLittleEndian<std::uint32_t>(data.quality[v], at);
	if (data.rgb == nullptr) return;
	for (std::size_t k = 0; k < 3; ++k)
		*at++ = char(data.rgb[3 * v + k]);
	*at++ = char(255);
}

} // namespace

void writePly(const MeshView& mesh, bool doublePrecision, const PlyVertexData& data,
			  OutputFile& out)
{
	out.text(header(mesh, doublePrecision, data));
	for (std::size_t v = 0; v < mesh.vertexNum; ++v) {
		char  record[24 + 12];
		char* at = record;
		putPosition(mesh.position(v), doublePrecision, at);
		putData(data, v, at);
		out.bytes(record, std::size_t(at - record));
	}
	for (std::size_t f = 0; f < mesh.faceNum; ++f) {
		char  record[13] = {3};
		char* at         = record + 1;
		for (std::size_t k = 0; k < 3; ++k)
			putLittleEndian<std::uint32_t>(mesh.vertexOf(3 * f + k), at);
		out.bytes(record, sizeof record);
	}
}

void writePly(const TriangleMesh& mesh, bool doublePrecision, OutputFile& out)
{
	writePly(mesh.view(), doublePrecision, PlyVertexData(), out);
}

} // namespace gpr::app
