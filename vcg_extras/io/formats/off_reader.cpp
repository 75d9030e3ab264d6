// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_formats.h"
#include "off_lines.h"

#include <vcg_extras/io/mesh/face_list.h>
#include <vcg_extras/io/mesh/precision.h>

#include <algorithm>

namespace gpr::app {

namespace {

/// The part of the mesh from one piece of a file.
struct MeshPiece {
	double*  coordinates = nullptr; ///< of all vertices, three each
	FaceList faces;

	void addVertex(std::size_t number, const std::array<double, 3>& position)
	{
		std::copy(position.begin(), position.end(), coordinates + 3 * number);
	}
	void addFace(const std::int64_t* corners, std::size_t num) { faces.add(corners, num); }
};

} // namespace

InputMesh readOff(std::string_view file)
{
	const OffHeader                     header = readOffHeader(file, file.size());
	const std::vector<std::string_view> text   = linePieces(file.substr(header.byteNum));
	std::vector<OffPiece<MeshPiece>>    pieces(text.size());
	Workers                             workers(0, nullptr);
	const std::vector<std::size_t>      before = recordsBefore(text, countOffRecords, workers);

	InputMesh mesh;
	mesh.doublePrecision = true;
	mesh.doubles.resize(3 * std::min(header.vertexNum, before.back()));
	workers.forTasks(text.size(), [&](std::size_t i, int) {
		pieces[i].sink.coordinates = mesh.doubles.data();
		pieces[i].read(text[i], before[i], header);
	});
	FaceList faces;
	for (OffPiece<MeshPiece>& piece : pieces) {
		if (piece.badPlace != nullptr) failAtOffLine(file, piece.badPlace, 0, true);
		faces.append(piece.sink.faces);
		piece = OffPiece<MeshPiece>(); // gives its memory back
	}
	requireAllOffRecords(header, before.back());
	faces.finish(mesh);
	settlePrecision(mesh);
	return mesh;
}

} // namespace gpr::app
