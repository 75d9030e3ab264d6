// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "byte_order.h"
#include "mesh_formats.h"

#include <algorithm>
#include <array>
#include <map>
#include <string>

namespace gpr::app {

namespace {

/// Of the corners in the file. 0 for a degenerate triangle.
Vec3d unitNormal(const std::array<Vec3d, 3>& corner)
{
	const Vec3d  normal = cross(corner[1] - corner[0], corner[2] - corner[0]);
	const double size   = length(normal);
	return size > 0 ? normal * (1 / size) : Vec3d();
}

void putFloats(const Vec3d& v, char*& at)
{
	for (const double c : {v.x, v.y, v.z})
		putLittleEndian(float(c), at);
}

std::array<Vec3d, 3> cornersOf(const TriangleMesh& mesh, std::size_t f)
{
	std::array<Vec3d, 3> corner;
	for (std::size_t k = 0; k < 3; ++k)
		corner[k] = Vec3d(Vec3f(mesh.positions[std::size_t(mesh.triangles[3 * f + k])]));
	return corner;
}

void writeBinaryStl(const TriangleMesh& mesh, OutputFile& out)
{
	constexpr std::size_t headerBytes = 80, recordBytes = 50;
	std::string           header("binary STL written by gpremesh");
	header.resize(headerBytes);
	out.text(header);
	char  count[4];
	char* end = count;
	putLittleEndian(std::uint32_t(mesh.faceNum()), end);
	out.bytes(count, sizeof count);
	for (std::size_t f = 0; f < mesh.faceNum(); ++f) {
		const std::array<Vec3d, 3> corner = cornersOf(mesh, f);

		char  record[recordBytes] = {};
		char* at                  = record;
		putFloats(unitNormal(corner), at);
		for (const Vec3d& p : corner)
			putFloats(p, at);
		out.bytes(record, recordBytes);
	}
}

void writeFacet(const TriangleMesh& mesh, bool doublePrecision, std::size_t f, OutputFile& out)
{
	out.text("facet normal");
	out.position(unitNormal(cornersOf(mesh, f)), false);
	out.text("\nouter loop\n");
	for (std::size_t c = 3 * f; c < 3 * f + 3; ++c) {
		out.text("vertex");
		out.position(mesh.positions[std::size_t(mesh.triangles[c])], doublePrecision);
		out.text("\n");
	}
	out.text("endloop\nendfacet\n");
}

/// The faces of each region, region after region.
void writeSolids(const TriangleMesh& mesh, bool doublePrecision, const FaceRegions& regions,
				 OutputFile& out)
{
	std::map<std::int32_t, std::vector<std::size_t>> facesOf;
	for (std::size_t f = 0; f < mesh.faceNum(); ++f)
		facesOf[regions.label[f]].push_back(f);
	for (const auto& [label, faces] : facesOf) {
		const std::string name = regions.nameOf(label);
		out.text("solid " + name + "\n");
		for (const std::size_t f : faces)
			writeFacet(mesh, doublePrecision, f, out);
		out.text("endsolid " + name + "\n");
	}
}

bool holdsMoreThanRegions(const MeshAttributes& attributes)
{
	return !attributes.ofVertices.empty() || attributes.hasTexture() ||
		   std::any_of(attributes.ofFaces.begin(), attributes.ofFaces.end(),
					   [](const ValueColumn& column) { return !tellsRegions(column.name); });
}

bool areSeveral(const std::vector<std::int32_t>& labels)
{
	return std::any_of(labels.begin(), labels.end(),
					   [&](std::int32_t label) { return label != labels[0]; });
}

} // namespace

void writeOff(const TriangleMesh& mesh, bool doublePrecision, OutputFile& out)
{
	out.text("OFF\n");
	out.text(std::to_string(mesh.vertexNum()) + " " + std::to_string(mesh.faceNum()) + " 0\n");
	for (const Vec3d& p : mesh.positions) {
		out.position(p, doublePrecision);
		out.text("\n");
	}
	for (std::size_t f = 0; f < mesh.faceNum(); ++f) {
		out.text("3");
		for (std::size_t c = 3 * f; c < 3 * f + 3; ++c) {
			out.text(" ");
			out.integer(mesh.triangles[c]);
		}
		out.text("\n");
	}
}

void writeStl(const TriangleMesh& mesh, bool doublePrecision, const MeshAttributes& attributes,
			  OutputFile& out, std::vector<std::string>& lost)
{
	const FaceRegions regions = regionsOf(attributes);
	if (areSeveral(regions.label)) {
		if (holdsMoreThanRegions(attributes))
			lost.push_back("attributes but for regions, which this format does not hold");
		writeSolids(mesh, doublePrecision, regions, out);
		return;
	}
	if (attributes.any()) lost.push_back("any attribute, which this format does not hold");
	writeBinaryStl(mesh, out);
}

} // namespace gpr::app
