// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_EDIT_MOVE_GUARD_H
#define VCG_EXTRAS_CORE_EDIT_MOVE_GUARD_H

#include "acceptance.h"

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/half_edge_mesh.h>

#include <vector>

namespace gpr {

/// The rules by which MoveGuard shortens moves that spoil a face.
struct Shortening {
	int halvings  = 0; ///< of a move, before the whole move is taken back
	int maxRounds = 7; ///< usually one or two are enough; after the last, all moves are taken back
};

/// Tries moves of many vertices at once. Moves that spoil a face are shortened or taken back until
/// no face is spoilt. Cost: a pass over the faces, and a few passes over spoilt faces.
///
/// The user calls start(), sets mesh.position, and calls takeOver(); settle() or takeBack() come
/// last.
class MoveGuard {
public:
	MoveGuard(const Acceptance& limits, const Shortening& shortening, HalfEdgeMesh& mesh,
			  Workers& workers);

	/// Makes the present positions the start of new moves; all shifts are zero then.
	void start();
	/// Sets the shifts to the way from the start to the present positions.
	void takeOver();

	const Vec3f& shift(int v) const { return shift_[v]; }
	/// Whether a corner of the face moves.
	bool hasMoved(int f) const;

	/// Shortens the moves of spoilt faces until no face is spoilt. normal: surface normals at the
	/// vertices, or empty. False if the rounds ended first and all moves were taken back.
	bool settle(const Buffer<Vec3f>& normal = {});
	/// Takes back the moves of the corners of these faces, and settles faces spoilt by this.
	void takeBack(const std::vector<int>& faces, const Buffer<Vec3f>& normal);
	void takeAllBack();

private:
	Acceptance    limits_;
	Shortening    shortening_;
	HalfEdgeMesh& m_;
	Workers&      workers_;
	Buffer<Vec3f> from_;
	Buffer<Vec3f> shift_;

	Vec3f            at(int v) const { return from_[v] + shift_[v]; }
	bool             isSpoilt(int f, const Buffer<Vec3f>& normal) const;
	bool             settleAmong(std::vector<int> faces, const Buffer<Vec3f>& normal);
	std::vector<int> shorten(const std::vector<int>& faces, float share);
};

} // namespace gpr

#endif
