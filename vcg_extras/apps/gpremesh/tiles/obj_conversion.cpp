// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion.h"
#include "mesh_spill.h"

#include <vcg_extras/io/formats/obj_lines.h>
#include <vcg_extras/io/text/text_pieces.h>

#include <set>
#include <string_view>
#include <utility>

namespace gpr::app {

namespace {

/// The keywords of left-out data, and the data in words.
constexpr std::pair<std::string_view, const char*> leftOut[] = {
	{"vt", "texture coordinates"}, {"vn", "normals"}, {"usemtl", "materials"}};

/// Receives the vertices and faces of ObjPiece.
struct ObjSink {
	MeshPieceBytes             mesh;
	std::set<std::string_view> keywords; ///< of left-out data

	void addVertex(const std::array<double, 3>& position, Words& behind)
	{
		MeshPieceBytes::Colour colour{};
		const bool             isColoured = !behind.isAtEnd() && readObjColour(behind, colour);
		mesh.addVertex(position, isColoured ? &colour : nullptr);
	}
	void addFace(const std::int64_t* corners, std::size_t num) { mesh.addFace(corners, num); }
	void addOther(std::string_view keyword)
	{
		for (const auto& data : leftOut)
			if (keyword == data.first) keywords.insert(data.first);
	}
};

} // namespace

std::vector<std::string> convertObj(const Conversion& job)
{
	TextPieces                 text(job.source);
	MeshSpill                  mesh(job.scratch, job.limit);
	Workers                    workers(0, nullptr);
	std::set<std::string_view> keywords;
	const double               all = double(text.bytesLeft());
	for (std::string_view piece = text.next(); !piece.empty(); piece = text.next()) {
		job.tell(1 - double(text.bytesLeft()) / all);
		for (const auto& read : readObjPieces<ObjSink>(piece, mesh.vertexNum(), workers)) {
			if (read.badPlace != nullptr)
				failAtObjLine(text.linesBefore() + lineNumber(piece, read.badPlace));
			mesh.add(read.sink.mesh);
			keywords.insert(read.sink.keywords.begin(), read.sink.keywords.end());
		}
	}
	std::vector<std::string> notes = mesh.writePly(job.target);
	std::string              lost;
	for (const auto& [keyword, data] : leftOut)
		if (keywords.count(keyword) > 0) lost += (lost.empty() ? "" : ", ") + std::string(data);
	if (!lost.empty()) notes.push_back("Not carried through tiles from an OBJ file: " + lost + ".");
	return notes;
}

} // namespace gpr::app
