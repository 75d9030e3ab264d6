// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "obj_format.h"

#include "face_list.h"
#include "precision.h"
#include "text_scanner.h"

namespace gpr::app {

namespace {

void readPosition(TextScanner& text, CoordinateArray<double>& positions)
{
	for (int k = 0; k < 3; ++k) {
		const std::string_view word = text.wordOnLine();
		if (word.empty()) text.fail("a vertex with fewer than three coordinates");
		positions.push_back(text.number(word));
	}
}

/// The vertex index of "7", "7/1", "7//2" or "-1/4/4", counted from 0. Whether it is within the
/// mesh is seen at the end: a face may name a vertex that follows later.
std::int64_t cornerOf(std::string_view word, std::size_t vertexNum, const TextScanner& text)
{
	const std::int64_t index = text.integer(word.substr(0, word.find('/')));
	if (index > 0) return index - 1;
	const std::int64_t fromEnd = std::int64_t(vertexNum) + index;
	if (index == 0 || fromEnd < 0) text.fail("a face names a vertex that does not exist");
	return fromEnd;
}

void readFace(TextScanner& text, std::size_t vertexNum, FaceList& faces,
			  std::vector<std::int64_t>& corners)
{
	corners.clear();
	for (std::string_view w = text.wordOnLine(); !w.empty(); w = text.wordOnLine()) {
		corners.push_back(cornerOf(w, vertexNum, text));
	}
	faces.add(corners.data(), corners.size());
}

} // namespace

InputMesh readObj(std::string_view file)
{
	InputMesh                 mesh;
	FaceList                  faces;
	TextScanner               text(file, '#', true);
	std::vector<std::int64_t> corners;
	mesh.doublePrecision = true;
	do {
		const std::string_view keyword = text.wordOnLine();
		if (keyword == "v") {
			readPosition(text, mesh.doubles);
		}
		else if (keyword == "f") {
			readFace(text, mesh.doubles.size() / 3, faces, corners);
		}
	} while (text.nextLine());
	faces.finish(mesh);
	settlePrecision(mesh);
	return mesh;
}

void writeObj(const TriangleMesh& mesh, bool doublePrecision, OutputFile& out)
{
	for (const Vec3d& p : mesh.positions) {
		out.text("v");
		out.position(p, doublePrecision);
		out.text("\n");
	}
	for (std::size_t f = 0; f < mesh.faceNum(); ++f) {
		out.text("f");
		for (std::size_t k = 0; k < 3; ++k) {
			out.text(" ");
			out.integer(mesh.triangles[3 * f + k] + std::int64_t(1));
		}
		out.text("\n");
	}
}

} // namespace gpr::app
