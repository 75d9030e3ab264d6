// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_IO_MESH_JOINED_PIECES_H
#define VCG_EXTRAS_IO_MESH_JOINED_PIECES_H

#include <vcg_extras/core/remesh.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace gpr::app {

/// Several meshes as one mesh, for a common run. Each mesh is a region of the whole, or several
/// regions if the mesh has regions itself, so that edges of the result follow the borders between
/// pieces. A result is cut there into results of the pieces, whose borders coincide.
class JoinedPieces {
public:
	/// The pieces must outlive this object. Cost: a copy of all pieces.
	explicit JoinedPieces(std::vector<MeshView> pieces);

	MeshView view() const;

	/// The part of a result, with its points of vertices and faces, for piece k: mesh, points and
	/// labels as if the piece had been remeshed alone, with the orientation of the piece. The
	/// report is the report of the whole. Points of vertices on another piece are moved to the
	/// nearest place of piece k. Cost: O(F log F) for F faces of the piece.
	RemeshResult ofPiece(const RemeshResult& whole, std::size_t k) const;

private:
	/// A region of a piece, by its label in the whole mesh.
	struct Part {
		std::size_t  piece;
		std::int32_t label; ///< the piece's own
	};

	std::vector<MeshView>     piece_;
	std::vector<std::int32_t> firstFace_, firstVertex_; ///< per piece, and an end
	MarkedMesh                whole_;
	std::vector<Part>         part_;
	std::vector<std::string>  names_; ///< of parts

	void add(std::size_t k);
	void addRegions(std::size_t k);
	bool hasFace(std::size_t k, std::int32_t face) const;
	void movePoints(const TriangleMesh& mesh, std::size_t k,
					std::vector<BarycentricPoint>& points) const;
	void turnAsPiece(std::size_t k, RemeshResult& part) const;
};

} // namespace gpr::app

#endif
