// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_formats.h"
#include "obj_lines.h"

#include <vcg_extras/io/mesh/face_list.h>
#include <vcg_extras/io/mesh/precision.h>

namespace gpr::app {

namespace {

/// The part of the mesh from one piece of a file.
struct MeshPiece {
	std::vector<double> coordinates; ///< three a vertex
	FaceList            faces;
	bool                holdsMore = false; ///< see readObj

	void addVertex(const std::array<double, 3>& position, Words& behind)
	{
		coordinates.insert(coordinates.end(), position.begin(), position.end());
		holdsMore = holdsMore || !behind.isAtEnd();
	}
	void addFace(const std::int64_t* corners, std::size_t num) { faces.add(corners, num); }
	void addOther(std::string_view keyword)
	{
		holdsMore |= keyword == "vt" || keyword == "vn" || keyword == "usemtl" ||
					 keyword == "mtllib" || keyword == "g" || keyword == "o";
	}
};

} // namespace

InputMesh readObj(std::string_view file)
{
	bool holdsMore = false;
	return readObj(file, holdsMore);
}

InputMesh readObj(std::string_view file, bool& holdsMore)
{
	Workers                          workers(0, nullptr);
	std::vector<ObjPiece<MeshPiece>> pieces        = readObjPieces<MeshPiece>(file, 0, workers);
	std::size_t                      coordinateNum = 0;
	for (const ObjPiece<MeshPiece>& piece : pieces)
		coordinateNum += piece.sink.coordinates.size();

	InputMesh mesh;
	FaceList  faces;
	holdsMore            = false;
	mesh.doublePrecision = true;
	mesh.doubles.reserve(coordinateNum);
	for (ObjPiece<MeshPiece>& piece : pieces) {
		if (piece.badPlace != nullptr) failAtObjLine(lineNumber(file, piece.badPlace));
		const std::vector<double>& read = piece.sink.coordinates;
		mesh.doubles.insert(mesh.doubles.end(), read.begin(), read.end());
		faces.append(piece.sink.faces);
		holdsMore = holdsMore || piece.sink.holdsMore;
		piece     = ObjPiece<MeshPiece>(); // gives its memory back
	}
	faces.finish(mesh);
	settlePrecision(mesh);
	return mesh;
}

} // namespace gpr::app
