// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "region_labels.h"

#include "face_point.h"

#include <vcg_extras/core/mesh/components.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace gpr {

namespace {

/// A piece is at home in a cell if this share of the cell's area, or this share of the piece, lies
/// in the cell. Smaller shares come from middles beyond the line.
constexpr double shareOfCell = 0.3, shareOfPiece = 0.6;
/// Passes that smooth borders without a line.
constexpr int evenings = 8;
constexpr int none     = -1;

/// Assigns faces of a result to pieces of the input's regions. A cell is a set of faces of the
/// result between feature lines.
class PieceOfFaces {
public:
	PieceOfFaces(const MeshView& input, const Surface& surface, const ResultMesh& result,
				 Workers& workers) :
			surface_(surface),
			result_(result), workers_(workers),
			pieces_(findComponents(surface.mesh, workers,
								   [&](int h) {
									   return labelOf(input, surface, h / 3) ==
											  labelOf(input, surface, surface.mesh.opposite[h] / 3);
								   })),
			cells_(findComponents(result.mesh, workers,
								  [&](int h) { return !result.mesh.isCreaseEdge(h); }))
	{
		sumUpPieces(input);
		findMiddles();
		findHomes();
		settleCells();
		fillGaps();
		countFaces();
		for (int k = 0; k < evenings && evenOut(); ++k)
			workers.poll();
	}

	RegionLabels labels()
	{
		std::vector<char> isSeen(piece_.size(), 0);
		for (std::size_t f = 0; f < pieceOf_.size(); ++f) {
			isSeen[pieceOf_[f]] = 1;
			moveIntoPiece(int(f));
		}
		RegionLabels out;
		out.middle = std::move(middle_);
		for (std::size_t p = 0; p < piece_.size(); ++p) {
			if (!isSeen[p]) out.lost.push_back(piece_[p]);
		}
		std::stable_sort(
			out.lost.begin(), out.lost.end(),
			[](const RegionPiece& a, const RegionPiece& b) { return a.area > b.area; });
		return out;
	}

private:
	const Surface&                surface_;
	const ResultMesh&             result_;
	Workers&                      workers_;
	const Components              pieces_; ///< of the surface
	const Components              cells_;  ///< of the result
	std::vector<RegionPiece>      piece_;
	std::vector<SurfacePoint>     middle_;
	std::vector<int>              pieceOf_;   ///< per face of the result, or none
	std::vector<int>              faceNumOf_; ///< per piece: its faces of the result
	std::vector<std::vector<int>> homeOf_; ///< per cell: the pieces at home in the cell, ascending
	std::vector<int> lookedAtFor_; ///< per face of the surface: the last face moved from there

	static std::int32_t labelOf(const MeshView& input, const Surface& surface, int f)
	{
		return input.region[surface.sourceFace[f]];
	}

	void sumUpPieces(const MeshView& input)
	{
		const double unit = 1 / surface_.frame.scale;
		piece_.resize(std::size_t(pieces_.num));
		for (int f = 0; f < surface_.mesh.faceNum; ++f) {
			RegionPiece& piece = piece_[pieces_.ofFace[f]];
			piece.label        = labelOf(input, surface_, f);
			piece.area += 0.5 * double(length(surface_.mesh.faceCross(f))) * unit * unit;
		}
	}

	void findMiddles()
	{
		const std::size_t num = std::size_t(result_.mesh.faceNum);
		middle_.resize(num);
		workers_.forEach(num, [&](int f) { middle_[f] = pointOfFace(surface_, result_, f); });
		for (const SurfacePoint& at : middle_)
			pieceOf_.push_back(pieces_.ofFace[at.face]);
	}

	void findHomes()
	{
		std::map<std::pair<int, int>, double> areaOf; // by cell and piece: area of faces
		std::vector<double> ofCell(std::size_t(cells_.num), 0), ofPiece(piece_.size(), 0);
		for (std::size_t f = 0; f < pieceOf_.size(); ++f) {
			const double area = double(length(result_.mesh.faceCross(int(f))));
			areaOf[{cells_.ofFace[f], pieceOf_[f]}] += area;
			ofCell[cells_.ofFace[f]] += area;
			ofPiece[pieceOf_[f]] += area;
		}
		homeOf_.resize(ofCell.size());
		for (const auto& [where, area] : areaOf) {
			const auto [cell, piece] = where;
			if (area >= shareOfCell * ofCell[cell] || area >= shareOfPiece * ofPiece[piece])
				homeOf_[cell].push_back(piece);
		}
	}

	/// Gives all faces of a cell the only piece at home. With several pieces at home, faces of
	/// other pieces get none.
	void settleCells()
	{
		for (std::size_t f = 0; f < pieceOf_.size(); ++f) {
			const std::vector<int>& home = homeOf_[cells_.ofFace[f]];
			const bool isAtHome = std::binary_search(home.begin(), home.end(), pieceOf_[f]);
			if (home.empty() || isAtHome) continue;
			pieceOf_[f] = home.size() == 1 ? home[0] : none;
		}
	}

	/// The pieces of the three neighbours in the same cell, or none.
	std::array<int, 3> piecesRound(int f) const
	{
		const HalfEdgeMesh& m = result_.mesh;
		std::array<int, 3>  round{none, none, none};
		for (int k = 0; k < 3; ++k) {
			const int h = 3 * f + k;
			if (!m.isCurveEdge(h)) round[k] = pieceOf_[m.opposite[h] / 3];
		}
		return round;
	}

	/// Gives faces without a piece the largest piece number of their neighbours, round by round.
	void fillGaps()
	{
		std::vector<int> open;
		for (std::size_t f = 0; f < pieceOf_.size(); ++f) {
			if (pieceOf_[f] == none) open.push_back(int(f));
		}
		while (!open.empty()) {
			std::vector<int> left;
			for (int f : open) {
				const std::array<int, 3> round = piecesRound(f);
				int&                     own   = pieceOf_[f];
				own                            = *std::max_element(round.begin(), round.end());
				if (own == none) left.push_back(f);
			}
			open.swap(left);
		}
	}

	void countFaces()
	{
		faceNumOf_.assign(piece_.size(), 0);
		for (int piece : pieceOf_)
			++faceNumOf_[piece];
	}

	/// Moves faces with two neighbours of the same other piece to this piece, in cells with several
	/// pieces.
	bool evenOut()
	{
		bool hasChanged = false;
		for (int f = 0; f < result_.mesh.faceNum; ++f) {
			if (homeOf_[cells_.ofFace[f]].size() < 2) continue;
			const std::array<int, 3> n   = piecesRound(f);
			const int                two = n[0] == n[1] || n[0] == n[2] ? n[0] : n[1];
			const bool isPair            = two != none && std::count(n.begin(), n.end(), two) >= 2;
			if (!isPair || two == pieceOf_[f] || isAlone(f, n)) continue;
			--faceNumOf_[pieceOf_[f]];
			++faceNumOf_[two];
			pieceOf_[f] = two;
			hasChanged  = true;
		}
		return hasChanged;
	}

	/// Whether a face is the only face of its piece, so that the piece would be lost.
	bool isAlone(int f, const std::array<int, 3>& round) const
	{
		const int own = pieceOf_[f];
		return std::count(round.begin(), round.end(), own) == 0 && faceNumOf_[own] == 1;
	}

	/// Moves the middle of a face beyond the border of its piece to the middle of the nearest face
	/// of the piece, in steps over edges. Such a face exists: the piece is at home because middles
	/// lie in the piece.
	void moveIntoPiece(int face)
	{
		const HalfEdgeMesh& m     = surface_.mesh;
		const int           piece = pieceOf_[face], first = middle_[face].face;
		if (pieces_.ofFace[first] == piece) return;
		if (lookedAtFor_.empty()) lookedAtFor_.assign(std::size_t(m.faceNum), none);
		std::vector<int> reached{first};
		lookedAtFor_[first] = face;
		for (std::size_t i = 0; i < reached.size(); ++i) {
			const int f = reached[i];
			if (pieces_.ofFace[f] == piece) {
				middle_[face] = {m.faceCentre(f), f};
				return;
			}
			for (int h = 3 * f; h < 3 * f + 3; ++h) {
				const int g = m.opposite[h] < 0 ? f : m.opposite[h] / 3;
				if (std::exchange(lookedAtFor_[g], face) != face) reached.push_back(g);
			}
		}
	}
};

} // namespace

RegionLabels labelFaces(const MeshView& input, const Surface& surface, const ResultMesh& result,
						Workers& workers)
{
	return PieceOfFaces(input, surface, result, workers).labels();
}

} // namespace gpr
