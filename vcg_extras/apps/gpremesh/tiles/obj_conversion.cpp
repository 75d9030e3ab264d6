// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion.h"
#include "mesh_spill.h"

#include <vcg_extras/io/formats/obj_lines.h>
#include <vcg_extras/io/text/text_pieces.h>

namespace gpr::app {

namespace {

/// The left-out data, in words.
struct LostOfObj {
	bool texture = false, normals = false, materials = false;

	void add(const LostOfObj& other)
	{
		texture |= other.texture;
		normals |= other.normals;
		materials |= other.materials;
	}
	std::string words() const
	{
		std::string list;
		for (const auto& [isLost, word] :
			 {std::pair(texture, "texture coordinates"), std::pair(normals, "normals"),
			  std::pair(materials, "materials")}) {
			if (isLost) list += (list.empty() ? "" : ", ") + std::string(word);
		}
		return list;
	}
};

/// Receives the vertices and faces of ObjPiece.
struct ObjSink {
	MeshPieceBytes mesh;
	LostOfObj      lost;

	void addVertex(const std::array<double, 3>& position, Words& behind)
	{
		MeshPieceBytes::Colour colour{};
		const bool             isColoured = !behind.isAtEnd() && readObjColour(behind, colour);
		mesh.addVertex(position, isColoured ? &colour : nullptr);
	}
	void addFace(const std::int64_t* corners, std::size_t num) { mesh.addFace(corners, num); }
	void addOther(std::string_view keyword)
	{
		lost.texture |= keyword == "vt";
		lost.normals |= keyword == "vn";
		lost.materials |= keyword == "usemtl";
	}
};

} // namespace

std::vector<std::string> convertObj(const Conversion& job)
{
	TextPieces   text(job.source);
	MeshSpill    mesh(job.scratch, job.limit);
	Workers      workers(0, nullptr);
	LostOfObj    lost;
	const double all = double(text.bytesLeft());
	for (std::string_view piece = text.next(); !piece.empty(); piece = text.next()) {
		job.tell(1 - double(text.bytesLeft()) / all);
		for (const auto& read : readObjPieces<ObjSink>(piece, mesh.vertexNum(), workers)) {
			if (read.badPlace != nullptr)
				failAtObjLine(text.linesBefore() + lineNumber(piece, read.badPlace));
			mesh.add(read.sink.mesh);
			lost.add(read.sink.lost);
		}
	}
	std::vector<std::string> notes = mesh.writePly(job.target);
	if (!lost.words().empty())
		notes.push_back("Not carried through tiles from an OBJ file: " + lost.words() + ".");
	return notes;
}

} // namespace gpr::app
