// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_formats.h"
#include "ply_header.h"
#include "ply_source.h"

#include <vcg_extras/io/base/exit_code.h>
#include <vcg_extras/io/mesh/face_list.h>

#include <algorithm>
#include <cstring>
#include <limits>

namespace gpr::app {

namespace {

// ---- vertices

template <class Source, class S>
void readVerticesOneByOne(const PlyElement& e, const CoordinateProperties& c, Source& source,
						  S* out)
{
	PlyRecord record;
	for (std::uint64_t v = 0; v < e.count; ++v) {
		readRecord(e, {}, source, record);
		for (const int i : {c.x, c.y, c.z})
			*out++ = S(Source::coordinate(record.scalars[std::size_t(i)]));
	}
}

/// Distance of a property from the begin of its record; every earlier property is a scalar.
std::size_t offsetOf(const PlyElement& e, int property)
{
	std::size_t bytes = 0;
	for (int i = 0; i < property; ++i)
		bytes += plyTypeSize(e.properties[i].type);
	return bytes;
}

template <class S>
constexpr PlyType typeOfScalar()
{
	return sizeof(S) == sizeof(double) ? PlyType::Float64 : PlyType::Float32;
}

/// Whether the coordinates lie beside each other in the machine's own form, all of the same type.
bool areBeside(const PlyElement& e, const CoordinateProperties& c, const BinarySource& source)
{
	if (source.swapped() || e.hasList() || c.y != c.x + 1 || c.z != c.x + 2) return false;
	const PlyType type = e.properties[c.x].type;
	if (type != PlyType::Float32 && type != PlyType::Float64) return false;
	return e.properties[c.y].type == type && e.properties[c.z].type == type;
}

template <class S>
bool copyVertices(const PlyElement& e, const CoordinateProperties& c, BinarySource& source, S* out)
{
	if (!areBeside(e, c, source) || e.properties[c.x].type != typeOfScalar<S>()) return false;
	const std::size_t stride = e.smallestRecordBytes();
	const char*       from   = source.take(std::size_t(e.count) * stride) + offsetOf(e, c.x);
	if (stride == 3 * sizeof(S)) {
		if (e.count > 0) std::memcpy(out, from, std::size_t(e.count) * stride);
		return true;
	}
	for (std::uint64_t v = 0; v < e.count; ++v, from += stride, out += 3) {
		std::memcpy(out, from, 3 * sizeof(S));
	}
	return true;
}

template <class S>
bool copyVertices(const PlyElement&, const CoordinateProperties&, TextSource&, S*)
{
	return false;
}

void requireVertexNum(const PlyElement& e)
{
	if (e.count > std::uint64_t(std::numeric_limits<std::int32_t>::max())) {
		failInput("more than 2147483647 vertices");
	}
}

template <class Source>
void readVertices(const PlyElement& e, Source& source, InputMesh& mesh)
{
	requireVertexNum(e);
	const CoordinateProperties c = findCoordinates(e);
	mesh.doublePrecision         = needsDouble(e, c);
	const auto readInto          = [&](auto& coordinates) {
        coordinates.resize(3 * std::size_t(e.count));
        if (!copyVertices(e, c, source, coordinates.data())) {
            readVerticesOneByOne(e, c, source, coordinates.data());
        }
	};
	if (mesh.doublePrecision) {
		readInto(mesh.doubles);
	}
	else {
		readInto(mesh.floats);
	}
}

// ---- faces

/// The layout of a triangle's record that can be copied: a one-byte count of 3, three indices of 32
/// bits, scalars before and after.
struct TriangleRecord {
	std::size_t bytes   = 0;
	std::size_t countAt = 0;
};

bool findTriangleRecord(const PlyElement& e, int indexList, TriangleRecord& record)
{
	const PlyProperty& list = e.properties[indexList];
	if (plyTypeSize(list.countType) != 1 || plyTypeSize(list.type) != 4) return false;
	for (int i = 0; i < int(e.properties.size()); ++i) {
		if (e.properties[i].isList && i != indexList) return false;
	}
	record.countAt = offsetOf(e, indexList);
	record.bytes   = e.smallestRecordBytes() + 12;
	return true;
}

/// Copies triangles up to the first face with more corners; returns the number of triangles.
std::uint64_t copyTriangles(const PlyElement& e, int indexList, BinarySource& source,
							IndexArray& triangles)
{
	TriangleRecord record;
	if (source.swapped() || !findTriangleRecord(e, indexList, record)) return 0;
	std::uint64_t     most    = std::min<std::uint64_t>(e.count, source.bytesLeft() / record.bytes);
	const char*       at      = source.peek() + record.countAt;
	const std::size_t oldSize = triangles.size();
	std::uint64_t     num     = 0;
	triangles.resize(oldSize + 3 * std::size_t(most));
	std::int32_t* out = triangles.data() + oldSize;
	for (; num < most && *at == 3; ++num, at += record.bytes, out += 3) {
		std::memcpy(out, at + 1, 12);
	}
	triangles.resize(oldSize + 3 * std::size_t(num));
	source.take(std::size_t(num) * record.bytes);
	return num;
}

std::uint64_t copyTriangles(const PlyElement&, int, TextSource&, IndexArray&)
{
	return 0;
}

template <class Source>
void readFaces(const PlyElement& e, Source& source, FaceList& faces)
{
	const int indexList = findIndexList(e);
	PlyRecord face;
	// After the first polygon no block is tried again: its memory would be asked for each time.
	const std::uint64_t copied = copyTriangles(e, indexList, source, faces.triangles);
	for (std::uint64_t f = copied; f < e.count; ++f) {
		readRecord(e, {indexList}, source, face);
		faces.add(face.corners.data(), face.corners.size());
	}
}

template <class Source>
void readStrips(const PlyElement& e, Source& source, FaceList& faces)
{
	const int indexList = findIndexList(e);
	PlyRecord strip;
	for (std::uint64_t s = 0; s < e.count; ++s) {
		readRecord(e, {indexList}, source, strip);
		faces.addStrip(strip.corners);
	}
}

// ---- at their places in the file

/// Looks at the vertices in the file; false if the vertices cannot be used in place.
bool lookAtVertices(const PlyElement& e, BinarySource& source, MeshView& mesh)
{
	requireVertexNum(e);
	const CoordinateProperties c = findCoordinates(e);
	if (!areBeside(e, c, source)) return false;
	mesh.vertexNum           = std::size_t(e.count);
	mesh.doublePrecision     = e.properties[c.x].type == PlyType::Float64;
	mesh.positionStrideBytes = e.smallestRecordBytes();
	mesh.positions = source.take(mesh.vertexNum * mesh.positionStrideBytes) + offsetOf(e, c.x);
	return true;
}

/// The same for faces, all of which must be triangles.
bool lookAtFaces(const PlyElement& e, BinarySource& source, MeshView& mesh)
{
	TriangleRecord record;
	if (source.swapped() || !findTriangleRecord(e, findIndexList(e), record)) return false;
	if (e.count > source.bytesLeft() / record.bytes) return false;
	mesh.faceNum             = std::size_t(e.count);
	mesh.triangleStrideBytes = record.bytes;
	const char* const first  = source.take(mesh.faceNum * record.bytes) + record.countAt;
	mesh.triangles           = first + 1;
	// Without a branch in the loop: nearly always all are.
	bool allThree = true;
	for (std::size_t f = 0; f < mesh.faceNum; ++f)
		allThree &= first[f * record.bytes] == 3;
	return allThree;
}

bool indicesAreInRange(const MeshView& mesh)
{
	std::uint32_t largest = 0;
	for (std::size_t f = 0; f < mesh.faceNum; ++f) {
		for (const std::int32_t v : mesh.triangle(f))
			largest = std::max(largest, std::uint32_t(v));
	}
	return largest < mesh.vertexNum;
}

/// False if a part must be converted, or is wrong: then the file is read as usual.
bool lookAtBody(const PlyHeader& header, BinarySource source, MeshView& mesh)
{
	const std::size_t num = usefulElementNum(header);
	for (std::size_t i = 0; i < num; ++i) {
		const PlyElement& e = header.elements[i];
		if (e.properties.empty() || e.count == 0) continue;
		if (e.count > source.recordsLeft(e) || e.name == "tristrips") return false;
		if (e.name == "vertex") {
			if (mesh.positions != nullptr || !lookAtVertices(e, source, mesh)) return false;
		}
		else if (e.name == "face") {
			if (mesh.triangles != nullptr || !lookAtFaces(e, source, mesh)) return false;
		}
		else {
			skipElement(e, source);
		}
	}
	return mesh.positions != nullptr && mesh.triangles != nullptr && indicesAreInRange(mesh);
}

// ---- the whole

template <class Source>
void readElement(const PlyElement& e, Source& source, InputMesh& mesh, FaceList& faces)
{
	if (e.properties.empty() || e.count == 0) return;
	if (e.count > source.recordsLeft(e)) failTruncated(e);
	if (e.name == "vertex") {
		readVertices(e, source, mesh);
	}
	else if (e.name == "face") {
		readFaces(e, source, faces);
	}
	else if (e.name == "tristrips") {
		readStrips(e, source, faces);
	}
	else {
		skipElement(e, source);
	}
}

template <class Source>
InputMesh readBody(const PlyHeader& header, Source source)
{
	InputMesh         mesh;
	FaceList          faces;
	const std::size_t num = usefulElementNum(header);
	for (std::size_t i = 0; i < num; ++i)
		readElement(header.elements[i], source, mesh, faces);
	faces.finish(mesh);
	return mesh;
}

} // namespace

InputMesh readPly(std::string_view file)
{
	const PlyHeader header = readPlyHeader(file);
	checkElements(header);
	return withSource(header, file, [&](auto source) { return readBody(header, source); });
}

InputMesh lookAtPly(std::string_view file)
{
	const PlyHeader header = readPlyHeader(file);
	if (header.format == PlyFormat::Ascii) return readPly(file);
	checkElements(header);
	const BinarySource source(file.substr(header.byteNum),
							  header.format == PlyFormat::LittleEndian);
	InputMesh          mesh;
	MeshView           inFile;
	if (!lookAtBody(header, source, inFile)) return readBody(header, source);
	mesh.inFile          = inFile;
	mesh.doublePrecision = inFile.doublePrecision;
	return mesh;
}

} // namespace gpr::app
