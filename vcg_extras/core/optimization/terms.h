// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OPTIMIZATION_TERMS_H
#define VCG_EXTRAS_CORE_OPTIMIZATION_TERMS_H

#include "rings.h"

#include <vcg_extras/core/base/symmetric_matrix.h>
#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/surface/closest_face_map.h>

#include <algorithm>

namespace gpr {

// The terms that move vertices. A term gives the wanted move of a vertex while all other vertices
// stay. Terms know no constraints and no limits.

/// A move, shortened to the length `longest` if it is longer.
inline Vec3f shortened(const Vec3f& move, float longest)
{
	const float l = length(move);
	return l > longest ? move * (longest / l) : move;
}

/// Barycentric: the way from v to the barycentre of its ring, weighted by area, and by the density
/// at the vertices if given.
Vec3f wayToBarycentre(const HalfEdgeMesh& mesh, int v, const Buffer<float>& density = {});

/// Height: the way from the mean of the neighbours to v, along the normal of the ring. On a sphere
/// of radius R the height is h²/2R for the edge length h. Needs a vertex inside the mesh.
Vec3f heightOverRing(const HalfEdgeMesh& mesh, int v);

/// Umbrella: U² / ν at every vertex, by the second-order umbrella operator of Kobbelt, Campagna,
/// Vorsatz and Seidel (1998); the wanted move is the negative,
///
///   U(p) = mean of the neighbours - p,  U²(p) = mean of the neighbours' U - U(p),
///   p <- p - U²(p) / ν,                 ν = 1 + (mean of 1 over the neighbours' valences).
///
/// At a border, U is the umbrella of the border polygon, so that the border does not pull the
/// inside outwards.
Buffer<Vec3f> secondOrderUmbrella(const HalfEdgeMesh& mesh, Workers& workers);

/// Conformal: what a face says to its corners, by the energy of Hormann and Greiner, MIPS (2000),
/// E = (sum of the squared edges) / (4√3·area), 1 if the face is equilateral. For the corner p of
/// the face (p, p + a, p + b) with the unit normal n:
///
///     force = 2k (a + b) / 2A + E / 2A · n × (b - a),  stiffness = 4k / 2A,  k = 1 / (2√3)
///
/// The force is minus the gradient over p, the stiffness the diagonal of the Hessian without small
/// terms. Energy, normal and lengths are computed once for all three corners.
struct ConformalFace {
	Float4 force[3];            ///< per corner; the fourth lane is the stiffness there
	Float4 normal;              ///< its length is twice the area
	float  squaredEdge[3] = {}; ///< from each corner to the next
	float  energy         = 0;

	/// leastArea: 2A counts as at least this share of the mean squared edge, so that a degenerate
	/// face has a finite force.
	ConformalFace(const Float4& a, const Float4& b, const Float4& c, float leastArea = 0)
	{
		constexpr float k  = 0.28867513f;
		const Float4    ab = b - a, bc = c - b, ca = a - c;
		normal              = cross(ab, bc);
		squaredEdge[0]      = dot(ab, ab);
		squaredEdge[1]      = dot(bc, bc);
		squaredEdge[2]      = dot(ca, ca);
		const float sum     = squaredEdge[0] + squaredEdge[1] + squaredEdge[2];
		const float twice   = length(normal) + 1e-30f;
		const float unit    = 1 / twice;
		const float inverse = leastArea > 0 ? 1 / std::max(twice, leastArea * sum / 3) : unit;
		energy              = k * sum * inverse;
		const float  along = 2 * k * inverse, across = energy * inverse * unit;
		const Float4 stiffness(0, 0, 0, 2 * along);
		const auto   at = [&](const Float4& sides, const Float4& opposite) {
            return sides * along + cross(normal, opposite) * across + stiffness;
		};
		force[0] = at(ab - ca, bc);
		force[1] = at(bc - ab, ca);
		force[2] = at(ca - bc, ab);
	}
};

/// Distance: the squared distance of the input vertices from their closest faces, as a function of
/// the shifts of the vertices: ½ Σ_ij s_i K_ij s_j - Σ_i f_i s_i. K_ij is stored for every vertex
/// and every spoke beside the vertex, so that a step reads K_ij in a row.
class DistanceTerm {
public:
	/// rings: of the mesh.
	DistanceTerm(const HalfEdgeMesh& mesh, const Rings& rings);

	/// Assembles the term for the present map and places. Cost: linear in the input, parallel.
	/// isRough: uses every second vertex of the input, for moves with later rounds.
	void assemble(const Surface& surface, const ClosestFaceMap& map, bool isRough,
				  Workers& workers);

	const SymmetricLanes& own(int v) const { return own_[v]; }
	/// The fourth lane is twice the area of the ring of v.
	const Float4& force(int v) const { return force_[v]; }
	/// The matrix for the edge of a spoke.
	const SymmetricLanes& joint(int spoke) const { return joint_[spoke]; }

private:
	/// The contribution of the input vertices assigned to a face, to the corners and to the edges
	/// from each corner to the next.
	struct FaceTerm {
		SymmetricLanes own[3], joint[3];
		Float4         force[3]; ///< the fourth lane is twice the area of the face
	};

	const HalfEdgeMesh&    m_;
	const Rings&           rings_;
	Buffer<SymmetricLanes> own_;
	Buffer<SymmetricLanes> joint_; ///< per spoke
	Buffer<Float4>         force_;

	FaceTerm termOf(const Surface& surface, const ClosestFaceMap& map, bool isRough, int f) const;
	void     addUp(int v, const Rings::Ring<FaceTerm>& ring);
};

} // namespace gpr

#endif
