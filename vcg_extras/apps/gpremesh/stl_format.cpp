// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "stl_format.h"

#include "exit_code.h"
#include "precision.h"
#include "text_scanner.h"
#include "weld.h"

#include <cstring>
#include <limits>
#include <numeric>

namespace gpr::app {

namespace {

constexpr std::size_t headerBytes = 80;
constexpr std::size_t facetBytes  = 50; // normal, three corners, two bytes of attributes

/// What STL binary files hold is little endian on every machine.
std::uint32_t loadCount(const char* at)
{
	std::uint32_t value = 0;
	for (int i = 3; i >= 0; --i)
		value = value << 8 | std::uint8_t(at[i]);
	return value;
}

float loadFloat(const char* at)
{
	const std::uint32_t bits = loadCount(at);
	float               value;
	std::memcpy(&value, &bits, sizeof value);
	return value;
}

/// Every corner its own vertex so far: corner i is vertex i.
void numberCorners(InputMesh& mesh)
{
	if (mesh.vertexNum() > std::size_t(std::numeric_limits<std::int32_t>::max())) {
		throw AppError(ExitCode::BadInput, "more than 715827882 triangles");
	}
	mesh.triangles.resize(mesh.vertexNum());
	std::iota(mesh.triangles.begin(), mesh.triangles.end(), 0);
}

InputMesh readBinary(std::string_view file)
{
	const std::size_t faceNum = loadCount(file.data() + headerBytes);
	if (faceNum > (file.size() - headerBytes - 4) / facetBytes) {
		throw AppError(ExitCode::BadInput, "the file ends too early: its header promises " +
											   std::to_string(faceNum) + " triangles");
	}
	InputMesh mesh;
	mesh.floats.resize(9 * faceNum);
	const char* facet = file.data() + headerBytes + 4;
	float*      out   = mesh.floats.data();
	for (std::size_t f = 0; f < faceNum; ++f, facet += facetBytes) {
		for (int k = 0; k < 9; ++k)
			*out++ = loadFloat(facet + 12 + 4 * k);
	}
	numberCorners(mesh);
	return mesh;
}

/// Compares with a keyword in lower case; some programs write capitals.
bool isKeyword(std::string_view word, std::string_view keyword)
{
	if (word.size() != keyword.size()) return false;
	for (std::size_t i = 0; i < word.size(); ++i) {
		const char c = word[i] >= 'A' && word[i] <= 'Z' ? char(word[i] - 'A' + 'a') : word[i];
		if (c != keyword[i]) return false;
	}
	return true;
}

/// Reads "facet normal x y z outer loop vertex ... endloop endfacet" from its second word on.
void readFacet(TextScanner& text, CoordinateArray<double>& positions)
{
	int              cornerNum = 0;
	std::string_view word      = text.word();
	for (; !isKeyword(word, "endfacet"); word = text.word()) {
		if (word.empty()) text.failTruncated();
		if (!isKeyword(word, "vertex")) continue; // the normal and the words around the corners
		if (++cornerNum > 3) text.fail("a facet with more than three corners");
		for (int k = 0; k < 3; ++k)
			positions.push_back(text.nextNumber());
	}
	if (cornerNum != 3) text.fail("a facet with fewer than three corners");
}

InputMesh readAscii(std::string_view file)
{
	InputMesh   mesh;
	TextScanner text(file, 0);
	bool        ended    = false;
	mesh.doublePrecision = true;
	for (std::string_view word = text.word(); !word.empty(); word = text.word()) {
		if (isKeyword(word, "facet")) {
			readFacet(text, mesh.doubles);
		}
		else if (isKeyword(word, "solid") || isKeyword(word, "endsolid")) {
			ended = word.size() > 5;
			text.nextLine(); // the rest is the solid's name
		}
		else {
			text.fail("neither a facet nor the end of the solid");
		}
	}
	if (!ended) mesh.notes.push_back("The STL file has no 'endsolid'; it may be cut off.");
	numberCorners(mesh);
	settlePrecision(mesh);
	return mesh;
}

bool beginsWithSolid(std::string_view file)
{
	return isKeyword(TextScanner(file.substr(0, 1024), 0).word(), "solid");
}

/// The first word decides, but binary files may begin with "solid" too: so the size that the count
/// asks for goes first, and zero bytes tell as well.
bool isBinary(std::string_view file)
{
	if (file.size() < headerBytes + 4) return false;
	const std::size_t promised =
		headerBytes + 4 + facetBytes * loadCount(file.data() + headerBytes);
	if (file.size() == promised) return true;
	return !beginsWithSolid(file) || file.substr(0, 1024).find('\0') != file.npos;
}

} // namespace

InputMesh readStl(std::string_view file)
{
	const bool binary = isBinary(file);
	if (!binary && !beginsWithSolid(file)) {
		throw AppError(ExitCode::BadInput, "neither an ASCII nor a binary STL file");
	}
	InputMesh mesh = binary ? readBinary(file) : readAscii(file);
	weldEqualPositions(mesh);
	return mesh;
}

namespace {

void putFloat(float value, char*& at)
{
	std::uint32_t bits;
	std::memcpy(&bits, &value, sizeof bits);
	for (int i = 0; i < 4; ++i)
		*at++ = char(bits >> (8 * i) & 0xff);
}

void putVector(const Vec3d& v, char*& at)
{
	putFloat(float(v.x), at);
	putFloat(float(v.y), at);
	putFloat(float(v.z), at);
}

} // namespace

void writeStl(const TriangleMesh& mesh, OutputFile& out)
{
	char header[headerBytes + 4] = "binary STL"; // must not begin with "solid"
	for (int i = 0; i < 4; ++i)
		header[headerBytes + i] = char(mesh.faceNum() >> (8 * i) & 0xff);
	out.bytes(header, sizeof header);
	for (std::size_t f = 0; f < mesh.faceNum(); ++f) {
		const std::int32_t* corner            = &mesh.triangles[3 * f];
		const Vec3d         a                 = mesh.positions[std::size_t(corner[0])];
		const Vec3d         b                 = mesh.positions[std::size_t(corner[1])];
		const Vec3d         c                 = mesh.positions[std::size_t(corner[2])];
		char                facet[facetBytes] = {};
		char*               at                = facet;
		putVector(normalized(cross(b - a, c - a)), at);
		for (const Vec3d& p : {a, b, c})
			putVector(p, at);
		out.bytes(facet, sizeof facet);
	}
}

} // namespace gpr::app
