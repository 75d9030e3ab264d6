// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ply_reader.h"

#include "exit_code.h"
#include "face_list.h"
#include "ply_header.h"
#include "ply_source.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <string>

namespace gpr::app {

namespace {

[[noreturn]] void fail(const std::string& sentence)
{
	throw AppError(ExitCode::BadInput, sentence);
}

[[noreturn]] void failTruncated(const PlyElement& element)
{
	fail("the file ends too early: its header promises " + std::to_string(element.count) +
		 " records of '" + element.name + "'");
}

template <class Source>
std::uint64_t listLength(const PlyProperty& list, Source& source)
{
	const std::int64_t num = source.whole(list.countType);
	if (num < 0) fail("a list of negative length");
	if (std::uint64_t(num) > source.valuesLeft(list.type)) {
		fail("a list is longer than the rest of the file, which seems to be cut off");
	}
	return std::uint64_t(num);
}

template <class Source>
void skipProperty(const PlyProperty& p, Source& source)
{
	if (p.isList) {
		source.skip(p.type, listLength(p, source));
	}
	else {
		source.skip(p.type);
	}
}

/// Steps over an element that is of no use here.
template <class Source>
void skipElement(const PlyElement& element, Source& source)
{
	for (std::uint64_t i = 0; i < element.count; ++i) {
		for (const PlyProperty& p : element.properties)
			skipProperty(p, source);
	}
}

void skipElement(const PlyElement& element, BinarySource& source)
{
	if (!element.hasList()) {
		source.take(std::size_t(element.count) * element.smallestRecordBytes());
		return;
	}
	skipElement<BinarySource>(element, source);
}

// ---- vertices

/// Which of an element's properties are the coordinates.
struct CoordinateProperties {
	int x = -1, y = -1, z = -1;
};

CoordinateProperties findCoordinates(const PlyElement& e)
{
	const CoordinateProperties c{e.find("x"), e.find("y"), e.find("z")};
	for (const int i : {c.x, c.y, c.z}) {
		if (i < 0 || e.properties[i].isList) fail("its vertices have no x, y and z");
	}
	return c;
}

bool needsDouble(PlyType type)
{
	return type == PlyType::Float64 || type == PlyType::Int32 || type == PlyType::UInt32;
}

template <class S, class Source>
void readVerticesOneByOne(const PlyElement& e, const CoordinateProperties& c, Source& source,
						  S* out)
{
	for (std::uint64_t v = 0; v < e.count; ++v, out += 3) {
		for (int i = 0; i < int(e.properties.size()); ++i) {
			const PlyProperty& p = e.properties[i];
			if (i == c.x) {
				out[0] = S(source.real(p.type));
			}
			else if (i == c.y) {
				out[1] = S(source.real(p.type));
			}
			else if (i == c.z) {
				out[2] = S(source.real(p.type));
			}
			else {
				skipProperty(p, source);
			}
		}
	}
}

/// Distance of a property from the begin of its record; every property before it is a scalar.
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

/// Copies the coordinates when they lie beside each other in the machine's own form.
template <class S>
bool copyVertices(const PlyElement& e, const CoordinateProperties& c, BinarySource& source, S* out)
{
	const bool beside = c.y == c.x + 1 && c.z == c.x + 2;
	if (source.swapped() || e.hasList() || !beside) return false;
	for (const int i : {c.x, c.y, c.z}) {
		if (e.properties[i].type != typeOfScalar<S>()) return false;
	}
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
bool copyVertices(const PlyElement&, const CoordinateProperties&, AsciiSource&, S*)
{
	return false;
}

template <class Source>
void readVertices(const PlyElement& e, Source& source, InputMesh& mesh)
{
	if (e.count > std::uint64_t(std::numeric_limits<std::int32_t>::max())) {
		fail("more than 2147483647 vertices");
	}
	const CoordinateProperties c = findCoordinates(e);
	for (const int i : {c.x, c.y, c.z}) {
		mesh.doublePrecision = mesh.doublePrecision || needsDouble(e.properties[i].type);
	}
	const auto readInto = [&](auto& coordinates) {
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

int findIndexList(const PlyElement& e)
{
	for (const char* name : {"vertex_indices", "vertex_index"}) {
		const int i = e.find(name);
		if (i >= 0 && e.properties[i].isList && isInteger(e.properties[i].type)) return i;
	}
	fail("its element '" + e.name + "' has no list of vertex indices");
}

template <class Source>
void readIndexList(const PlyProperty& list, Source& source, std::vector<std::int64_t>& indices)
{
	indices.resize(std::size_t(listLength(list, source)));
	for (std::int64_t& i : indices)
		i = source.whole(list.type);
}

template <class Source>
void readFace(const PlyElement& e, int indexList, Source& source, FaceList& faces,
			  std::vector<std::int64_t>& corners)
{
	for (int i = 0; i < int(e.properties.size()); ++i) {
		if (i == indexList) {
			readIndexList(e.properties[i], source, corners);
		}
		else {
			skipProperty(e.properties[i], source);
		}
	}
	faces.add(corners.data(), corners.size());
}

/// How the record of a triangle looks when it can be copied: a one-byte count of 3, three indices
/// of 32 bits, scalars before and after.
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

/// Copies triangles up to the first face that is none; tells how many.
std::uint64_t copyTriangles(const TriangleRecord& record, std::uint64_t most, BinarySource& source,
							IndexArray& triangles)
{
	most                      = std::min<std::uint64_t>(most, source.bytesLeft() / record.bytes);
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

template <class Source>
void readFaces(const PlyElement& e, Source& source, FaceList& faces)
{
	const int                 indexList = findIndexList(e);
	std::vector<std::int64_t> corners;
	for (std::uint64_t f = 0; f < e.count; ++f)
		readFace(e, indexList, source, faces, corners);
}

void readFaces(const PlyElement& e, BinarySource& source, FaceList& faces)
{
	const int      indexList = findIndexList(e);
	TriangleRecord record;
	if (source.swapped() || !findTriangleRecord(e, indexList, record)) {
		readFaces<BinarySource>(e, source, faces);
		return;
	}
	std::vector<std::int64_t> corners;
	std::uint64_t             f = copyTriangles(record, e.count, source, faces.triangles);
	for (; f < e.count; ++f) {
		// After the first polygon no block is tried again: its memory would be asked for each time.
		readFace(e, indexList, source, faces, corners);
	}
}

/// A strip: each index makes a triangle with the two before it, every second one turned over; -1
/// ends the strip. Triangles with a repeated index only steer the strip and are left out.
void addStrip(const std::vector<std::int64_t>& strip, FaceList& faces)
{
	std::size_t begin = 0;
	for (std::size_t i = 0; i < strip.size(); ++i) {
		if (strip[i] == -1) {
			begin = i + 1;
			continue;
		}
		if (i < begin + 2) continue;
		const bool         turned  = (i - begin) % 2 == 1;
		const std::int64_t third[] = {turned ? strip[i - 1] : strip[i - 2],
									  turned ? strip[i - 2] : strip[i - 1], strip[i]};
		if (third[0] == third[1] || third[1] == third[2] || third[2] == third[0]) continue;
		faces.add(third, 3);
	}
}

template <class Source>
void readStrips(const PlyElement& e, Source& source, FaceList& faces)
{
	const int                 indexList = findIndexList(e);
	std::vector<std::int64_t> strip;
	for (std::uint64_t s = 0; s < e.count; ++s) {
		for (int i = 0; i < int(e.properties.size()); ++i) {
			if (i == indexList) {
				readIndexList(e.properties[i], source, strip);
			}
			else {
				skipProperty(e.properties[i], source);
			}
		}
		addStrip(strip, faces);
	}
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

void checkElements(const PlyHeader& header)
{
	for (const char* name : {"vertex", "face", "tristrips"}) {
		const auto num = std::count_if(header.elements.begin(), header.elements.end(),
									   [&](const PlyElement& e) { return e.name == name; });
		if (num > 1) fail("its header has the element '" + std::string(name) + "' twice");
	}
}

/// Nothing after the last element of the three is read: files with damaged extras still serve.
std::size_t usefulElementNum(const PlyHeader& header)
{
	std::size_t num = 0;
	for (std::size_t i = 0; i < header.elements.size(); ++i) {
		const std::string& name = header.elements[i].name;
		if (name == "vertex" || name == "face" || name == "tristrips") num = i + 1;
	}
	return num;
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
	const std::string_view body = file.substr(header.byteNum);
	if (header.format == PlyFormat::Ascii) {
		return readBody(header, AsciiSource(body, header.lineNum + 1));
	}
	return readBody(header, BinarySource(body, header.format == PlyFormat::LittleEndian));
}

} // namespace gpr::app
