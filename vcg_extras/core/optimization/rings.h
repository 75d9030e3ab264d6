// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OPTIMIZATION_RINGS_H
#define VCG_EXTRAS_CORE_OPTIMIZATION_RINGS_H

#include <vcg_extras/core/base/buffer.h>
#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/half_edge_mesh.h>

#include <new>
#include <vector>

namespace gpr {

/// The rings of faces round all vertices of a mesh, in a row, for passes over a mesh with fixed
/// faces. A pass computes the term of a face once, not once for each corner: vertices are taken in
/// pieces of fixed size, and the terms of the faces at a piece stay in the cache during the work on
/// the piece. Faces between two pieces are computed for both.
class Rings {
public:
	/// A half-edge that leaves the vertex.
	struct Spoke {
		int target; ///< vertex at the end
		int corner; ///< 4 · place of the face in the piece + corner of the vertex
	};

	/// The spokes of a vertex, in the order of forEachOutgoing, with the terms of their faces.
	template <class Term>
	struct Ring {
		const Spoke* spoke;
		int          size;
		bool         isClosed; ///< the last face is the face before the first
		const Term*  terms;

		const Term& term(int i) const { return terms[spoke[i].corner >> 2]; }
		int         corner(int i) const { return spoke[i].corner & 3; }
	};

	/// Cost: a pass over the mesh; 8 B per half-edge, 4 B per vertex and about 5 B per face.
	Rings(const HalfEdgeMesh& mesh, Workers& workers);

	/// Index of the first spoke of v among all.
	int begin(int v) const { return start_[v]; }
	int spokeNum() const { return int(spoke_.size()); }

	/// Calls visit(v, ring) for all vertices, in parallel, with the terms returned by termOf(face).
	template <class Term, class TermOf, class Visit>
	void forEach(Workers& workers, const TermOf& termOf, const Visit& visit) const
	{
		std::vector<Buffer<Term>> terms(std::size_t(workers.threadNum()));
		workers.forTasks(pieceNum(), [&](std::size_t piece, int worker) {
			Buffer<Term>&     of   = terms[std::size_t(worker)];
			const int* const  face = face_.data() + faceStart_[piece];
			const std::size_t num  = std::size_t(faceStart_[piece + 1] - faceStart_[piece]);
			if (of.size() < num) of.reset(num);
			for (std::size_t i = 0; i < num; ++i)
				new (&of[i]) Term(termOf(face[i])); // in place
			const int end = beginOf(piece + 1);
			for (int v = beginOf(piece); v < end; ++v) {
				const int size = start_[v + 1] - start_[v];
				visit(v, Ring<Term>{spoke_.data() + start_[v], size, !m_.isBorderVertex(v),
									of.data()});
			}
		});
	}

private:
	const HalfEdgeMesh& m_;
	Buffer<int>         start_; ///< per vertex: of its spokes
	Buffer<Spoke>       spoke_;
	std::vector<int>    faceStart_; ///< per piece: in face_
	std::vector<int>    face_;      ///< of the pieces, one after the other

	std::size_t pieceNum() const { return faceStart_.size() - 1; }
	int         beginOf(std::size_t piece) const;
};

} // namespace gpr

#endif
