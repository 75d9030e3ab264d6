// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OPTIMIZATION_TERMS_H
#define VCG_EXTRAS_CORE_OPTIMIZATION_TERMS_H

#include <vcg_extras/core/base/symmetric_matrix.h>
#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/surface/closest_face_map.h>

namespace gpr {

/// What vertices are moved by: four terms, each of which says where a vertex is to go while all
/// others stay. None of them knows of constraints or limits.

/// Barycentric: from v to the barycentre of its ring, weighted by area, and by the density at the
/// vertices if there is one.
Vec3f wayToBarycentre(const HalfEdgeMesh& mesh, int v, const Buffer<float>& density = {});

/// Umbrella: U² / ν at every vertex, by the second-order umbrella operator of Kobbelt, Campagna,
/// Vorsatz and Seidel (1998); the vertex is to go the other way,
///
///   U(p) = mean of the neighbours - p,  U²(p) = mean of the neighbours' U - U(p),
///   p <- p - U²(p) / ν,                 ν = 1 + (mean of 1 over the neighbours' valences).
///
/// At a border U is that of the border polygon, so that the border does not draw the inside to it.
Buffer<Vec3f> secondOrderUmbrella(const HalfEdgeMesh& mesh, Workers& workers);

/// Conformal: what the faces at a vertex p want, by the energy of Hormann and Greiner, MIPS (2000),
/// E = (|a|² + |b|² + |b - a|²) / (4√3·area) for the face (p, p + a, p + b), 1 if it is
/// equilateral.
struct ConformalPull {
	Vec3f force;         ///< minus the gradient over p
	float stiffness = 0; ///< the Hessian's diagonal

	/// Adds a face and returns its energy. inverse: 1 over twice its area. The normal may be the
	/// surface's; where it is no unit vector, unit is 1 over its length. Inline: each step of a
	/// descent calls it for every corner of every face.
	///
	///     gradient = -2k (a + b) / 2A - E / 2A · n × (b - a),  Hessian ≈ 4k / 2A,  k = 1 / (2√3)
	float add(const Vec3f& a, const Vec3f& b, const Vec3f& normal, float unit, float inverse)
	{
		constexpr float k      = 0.28867513f;
		const Vec3f     across = b - a;
		const float     edges  = squaredLength(a) + squaredLength(b) + squaredLength(across);
		const float     energy = k * edges * inverse;
		force += (a + b) * (2 * k * inverse);
		force += cross(normal, across) * (energy * inverse * unit);
		stiffness += 4 * k * inverse;
		return energy;
	}
};

/// Distance: the squared distance of the input's vertices p from the planes of their closest faces,
/// as a function of the shifts s of the faces' corners,
///
///     ½ Σ_p A_p (n·(p - x) - Σ_k b_k n·s_k)²,
///
/// where n is the face's normal, x a point of it, A_p the input's area round p, and b_k are the
/// weights of the corners at the point of the face nearest to p. As n is the same for all p of a
/// face, nine sums say all: they do not grow with the input, and a step reads little.
class DistanceTerm {
public:
	struct FaceSums {
		Vec3f normal;
		float own[3];   ///< Σ A b_k²
		float joint[3]; ///< Σ A b_k b_l, where l follows k
		float pull[3];  ///< Σ A b_k n·(p - x)
	};

	explicit DistanceTerm(const HalfEdgeMesh& mesh) : m_(mesh), sums_(mesh.faceNum) {}

	/// For the present map and places. Cost: linear in the input, parallel.
	void assemble(const Surface& surface, const ClosestFaceMap& map, Workers& workers);

	const FaceSums& of(int face) const { return sums_[face]; }

private:
	const HalfEdgeMesh& m_;
	Buffer<FaceSums>    sums_;
};

/// What the distance wants of a vertex.
struct DistancePull {
	Vec3f           force;     ///< minus the gradient over its shift
	SymmetricMatrix stiffness; ///< the Hessian over its shift

	/// Adds the k-th corner's part of a face. shift: the vertex' own; a and b lead from it to the
	/// next corner and the one before, where these are now. All three began in the face's plane, so
	/// that a and b tell how far the others have left it.
	void add(const DistanceTerm::FaceSums& face, int k, const Vec3f& shift, const Vec3f& a,
			 const Vec3f& b)
	{
		const int   before = k == 0 ? 2 : k - 1;
		const float own    = dot(face.normal, shift);
		const float next = own + dot(face.normal, a), last = own + dot(face.normal, b);
		const float left =
			face.pull[k] - face.own[k] * own - face.joint[k] * next - face.joint[before] * last;
		force += face.normal * left;
		stiffness.addOuter(face.normal, face.own[k]);
	}
};

} // namespace gpr

#endif
