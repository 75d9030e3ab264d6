// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OPTIMIZATION_MOVE_GUARD_H
#define VCG_EXTRAS_CORE_OPTIMIZATION_MOVE_GUARD_H

#include <vcg_extras/core/base/triangle.h>
#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/half_edge_mesh.h>

#include <vector>

namespace gpr {

/// What a move of its corners must not do to a face. What is below a bound before may stay there,
/// but must not fall further.
struct MoveLimits {
	float turnCosine   = 0.5f; ///< no turn by more than 60°: the face would soon lie folded over
	float minShape     = 0;    ///< see triangleShape
	float minAngle     = 0;    ///< radians
	float minAgreement = -1;   ///< with the surface's normals; looked at where these are given
	float falls        = 1; ///< below this share of its value before, an angle or agreement falls
	int   halvings     = 0; ///< of a move, before it is taken back whole
	int   maxRounds    = 7; ///< of shortening moves: mostly one or two; then all are taken back
};

/// Whether the limits forbid the move, whatever the surface's normals.
bool spoilsFace(const MoveLimits& limits, const Corners& before, const Corners& after);
/// Whether they forbid v to move from its place to `to` while all others stay.
bool spoilsRing(const MoveLimits& limits, const HalfEdgeMesh& mesh, int v, const Vec3f& to);

/// Moves of many vertices at once, on trial. Those of faces that they spoil are shortened or taken
/// back until no face is spoilt. Cost: a pass over the faces, and the few faces concerned.
///
/// start() comes first. Who makes the moves then sets mesh.position, and calls takeOver(). settle()
/// or takeBack() come last.
class MoveGuard {
public:
	MoveGuard(const MoveLimits& limits, HalfEdgeMesh& mesh, Workers& workers);

	/// Makes the present places the start of new moves; all shifts are zero then.
	void start();
	/// Moves from the start to the present places.
	void takeOver();

	const Vec3f& shift(int v) const { return shift_[v]; }
	/// Whether a corner of the face moves.
	bool hasMoved(int f) const;

	/// Shortens the moves of spoilt faces until there are none. normal: of the surface at the
	/// vertices, or empty. False if there was no end to it, and all moves were taken back.
	bool settle(const Buffer<Vec3f>& normal = {});
	/// Takes the moves of these faces back, and settles what this spoils.
	void takeBack(const std::vector<int>& faces, const Buffer<Vec3f>& normal);
	void takeAllBack();

private:
	MoveLimits    limits_;
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
