// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ply_writer.h"

#include <cstring>
#include <string>

namespace gpr::app {

namespace {

/// Puts the bytes of a value in little endian order on every machine.
template <class Bits, class T>
void put(T value, char*& at)
{
	static_assert(sizeof(Bits) == sizeof(T), "the same size");
	Bits bits;
	std::memcpy(&bits, &value, sizeof bits);
	for (std::size_t i = 0; i < sizeof bits; ++i)
		*at++ = char(bits >> (8 * i) & 0xff);
}

std::string header(const TriangleMesh& mesh, bool doublePrecision)
{
	const std::string type = doublePrecision ? "double" : "float";
	return "ply\nformat binary_little_endian 1.0\ncomment written by gpremesh\nelement vertex " +
		   std::to_string(mesh.vertexNum()) + "\nproperty " + type + " x\nproperty " + type +
		   " y\nproperty " + type + " z\nelement face " + std::to_string(mesh.faceNum()) +
		   "\nproperty list uchar int vertex_indices\nend_header\n";
}

} // namespace

void writePly(const TriangleMesh& mesh, bool doublePrecision, OutputFile& out)
{
	out.text(header(mesh, doublePrecision));
	for (const Vec3d& p : mesh.positions) {
		char  record[24];
		char* at = record;
		for (const double c : {p.x, p.y, p.z}) {
			if (doublePrecision) {
				put<std::uint64_t>(c, at);
			}
			else {
				put<std::uint32_t>(float(c), at);
			}
		}
		out.bytes(record, std::size_t(at - record));
	}
	for (std::size_t f = 0; f < mesh.faceNum(); ++f) {
		char  record[13] = {3};
		char* at         = record + 1;
		for (std::size_t k = 0; k < 3; ++k)
			put<std::uint32_t>(mesh.triangles[3 * f + k], at);
		out.bytes(record, sizeof record);
	}
}

} // namespace gpr::app
