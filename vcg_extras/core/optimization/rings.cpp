// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "rings.h"

#include <algorithm>
#include <cstddef>

namespace gpr {

namespace {

/// Vertices of a piece: the terms of the faces, about 200 B each, fit into the cache of a core.
constexpr int pieceSize = 1024;

/// The faces at a piece, in the order of the first visit.
class FacesOfPiece {
public:
	explicit FacesOfPiece(int faceNum) : place_(std::size_t(faceNum), -1) {}

	int placeOf(int f)
	{
		int& place = place_[std::size_t(f)];
		if (place < 0) {
			place = int(faces_.size());
			faces_.push_back(f);
		}
		return place;
	}

	std::vector<int> take()
	{
		for (int f : faces_)
			place_[std::size_t(f)] = -1;
		return std::move(faces_);
	}

private:
	std::vector<int> place_; ///< per face of the mesh, or -1
	std::vector<int> faces_;
};

} // namespace

int Rings::beginOf(std::size_t piece) const
{
	return std::min(m_.vertexNum, int(piece) * pieceSize);
}

Rings::Rings(const HalfEdgeMesh& mesh, Workers& workers) :
		m_(mesh), start_(std::size_t(mesh.vertexNum) + 1),
		faceStart_(std::size_t(mesh.vertexNum + pieceSize - 1) / pieceSize + 1, 0)
{
	workers.forEach(std::size_t(m_.vertexNum), [&](int v) {
		int num = 0;
		forEachOutgoing(m_, v, [&](int) { ++num; });
		start_[v + 1] = num;
	});
	start_[0] = 0;
	workers.sumUp(start_.data(), start_.size());
	spoke_.reset(std::size_t(start_[m_.vertexNum]));
	std::vector<std::vector<int>> faces(pieceNum());
	std::vector<FacesOfPiece>     of(std::size_t(workers.threadNum()), FacesOfPiece(m_.faceNum));
	workers.forTasks(pieceNum(), [&](std::size_t piece, int worker) {
		FacesOfPiece& here = of[std::size_t(worker)];
		for (int v = beginOf(piece); v < beginOf(piece + 1); ++v) {
			int i = start_[v];
			forEachOutgoing(m_, v, [&](int h) {
				spoke_[i++] = {m_.target(h), 4 * here.placeOf(h / 3) + h % 3};
			});
		}
		faces[piece] = here.take();
	});
	for (std::size_t piece = 0; piece < faces.size(); ++piece) {
		face_.insert(face_.end(), faces[piece].begin(), faces[piece].end());
		faceStart_[piece + 1] = int(face_.size());
	}
}

} // namespace gpr
