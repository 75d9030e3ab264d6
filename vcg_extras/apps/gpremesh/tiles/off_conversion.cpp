// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion.h"
#include "mesh_spill.h"

#include <vcg_extras/io/formats/off_lines.h>
#include <vcg_extras/io/text/text_pieces.h>

#include <filesystem>

namespace gpr::app {

namespace {

/// Receives the vertices and faces of OffPiece.
struct OffSink {
	MeshPieceBytes mesh;

	void addVertex(std::size_t, const std::array<double, 3>& position) { mesh.addVertex(position); }
	void addFace(const std::int64_t* corners, std::size_t num) { mesh.addFace(corners, num); }
};

} // namespace

std::vector<std::string> convertOff(const Conversion& job)
{
	const std::string begin  = beginOfFile(job.source);
	const OffHeader   header = readOffHeader(begin, std::filesystem::file_size(job.source));
	TextPieces        text(job.source, header.byteNum,
						   lineNumber(begin, begin.data() + header.byteNum) - 1);
	MeshSpill         mesh(job.scratch, job.limit);
	Workers           workers(0, nullptr);
	std::size_t       recordNum = 0;
	const double      all       = double(text.bytesLeft());
	for (std::string_view block = text.next(); !block.empty(); block = text.next()) {
		job.tell(1 - double(text.bytesLeft()) / all);
		const std::vector<std::string_view> pieces = linePieces(block);
		const std::vector<std::size_t> before = recordsBefore(pieces, countOffRecords, workers);
		std::vector<OffPiece<OffSink>> read(pieces.size());
		workers.forTasks(pieces.size(), [&](std::size_t i, int) {
			read[i].read(pieces[i], recordNum + before[i], header);
		});
		for (const OffPiece<OffSink>& piece : read) {
			if (piece.badPlace != nullptr)
				failAtOffLine(block, piece.badPlace, text.linesBefore(), text.bytesLeft() == 0);
			mesh.add(piece.sink.mesh);
		}
		recordNum += before.back();
	}
	requireAllOffRecords(header, recordNum);
	return mesh.writePly(job.target);
}

} // namespace gpr::app
