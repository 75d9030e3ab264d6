// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "rings.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace gpr {

namespace {

/// Vertices of a piece: the terms of the faces, about 200 B each, fit into the cache of a core.
constexpr int pieceSize = 1024;

} // namespace

int Rings::beginOf(std::size_t piece) const
{
	return std::min(m_.vertexNum, int(piece) * pieceSize);
}

Rings::Rings(const HalfEdgeMesh& mesh, Workers& workers) :
		m_(mesh), start_(std::size_t(mesh.vertexNum) + 1),
		faceStart_(std::size_t(mesh.vertexNum + pieceSize - 1) / pieceSize + 1, 0)
{
	workers.forEach(std::size_t(m_.vertexNum), [&](int v) { start_[v + 1] = m_.valence(v); });
	start_[0] = 0;
	workers.sumUp(start_.data(), start_.size());
	spoke_.reset(std::size_t(start_[m_.vertexNum]));
	std::vector<std::vector<int>> faces(pieceNum());
	std::vector<std::vector<int>> placeOf(std::size_t(workers.threadNum()),
										  std::vector<int>(std::size_t(m_.faceNum), -1));
	workers.forTasks(pieceNum(), [&](std::size_t piece, int worker) {
		std::vector<int>& place = placeOf[std::size_t(worker)]; // per face: in this piece, or -1
		std::vector<int>  own;                                  // in the order of the first visit
		for (int v = beginOf(piece); v < beginOf(piece + 1); ++v) {
			int i = start_[v];
			forEachOutgoing(m_, v, [&](int h) {
				int& at = place[std::size_t(h / 3)];
				if (at < 0) {
					at = int(own.size());
					own.push_back(h / 3);
				}
				spoke_[i++] = {m_.target(h), 4 * at + h % 3};
			});
		}
		for (int f : own)
			place[std::size_t(f)] = -1;
		faces[piece] = std::move(own);
	});
	for (std::size_t piece = 0; piece < faces.size(); ++piece) {
		face_.insert(face_.end(), faces[piece].begin(), faces[piece].end());
		faceStart_[piece + 1] = int(face_.size());
	}
}

} // namespace gpr
