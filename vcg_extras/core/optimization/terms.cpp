// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "terms.h"

#include <vcg_extras/core/mesh/face_plane.h>
#include <vcg_extras/core/mesh/mesh_edit.h>

namespace gpr {

namespace {

/// A face with at least this many input vertices uses every second one in a rough assembly.
constexpr int manyVertices = 4;

/// The first-order umbrella and the valence of a vertex, side by side because both are averaged.
struct Umbrella {
	Vec3f vector;
	float inverseValence = 1;
};

Umbrella umbrellaAt(const HalfEdgeMesh& m, int v)
{
	Vec3f      sum;
	int        n   = 0;
	const auto add = [&](int w) {
		sum += m.position[w] - m.position[v];
		++n;
	};
	if (m.isBorderVertex(v)) {
		add(borderNeighbour(m, v, true));
		add(borderNeighbour(m, v, false));
	}
	else {
		forEachNeighbour(m, v, add);
	}
	const float share = 1 / float(n);
	return {sum * share, share};
}

Vec3f umbrellaStep(const HalfEdgeMesh& m, const Buffer<Umbrella>& umbrella, int v)
{
	Vec3f sum;
	float inverse = 0;
	int   n       = 0;
	forEachNeighbour(m, v, [&](int w) {
		sum += umbrella[w].vector;
		inverse += umbrella[w].inverseValence;
		++n;
	});
	const float share = 1 / float(n);
	return (sum * share - umbrella[v].vector) * (1 / (1 + inverse * share));
}

} // namespace

Vec3f wayToBarycentre(const HalfEdgeMesh& m, int v, const Buffer<float>& density)
{
	Float4 sum;
	float  weight = 0;
	forEachFaceRound(m, v, [&](int h, const Float4& a, const Float4& b) {
		float area = length(cross(a, b));
		if (!density.empty()) area *= density[v] + density[m.target(h)] + density[m.apex(h)];
		sum += (a + b) * (area / 3);
		weight += area;
	});
	return weight > 0 ? sum.xyz() * (1 / weight) : Vec3f();
}

Vec3f heightOverRing(const HalfEdgeMesh& m, int v)
{
	const Vec3f normal = normalized(ringSum(m, v).normal);
	return normal * -dot(umbrellaAt(m, v).vector, normal);
}

Buffer<Vec3f> secondOrderUmbrella(const HalfEdgeMesh& m, Workers& workers)
{
	Buffer<Umbrella> umbrella(m.vertexNum);
	workers.forEach(m.vertexNum, [&](int v) { umbrella[v] = umbrellaAt(m, v); });
	Buffer<Vec3f> step(m.vertexNum);
	workers.forEach(m.vertexNum, [&](int v) { step[v] = umbrellaStep(m, umbrella, v); });
	return step;
}

DistanceTerm::DistanceTerm(const HalfEdgeMesh& mesh, const Rings& rings) :
		m_(mesh), rings_(rings), own_(mesh.vertexNum), joint_(rings.spokeNum()),
		force_(mesh.vertexNum)
{
}

void DistanceTerm::assemble(const Surface& surface, const ClosestFaceMap& map, bool isRough,
							Workers& workers)
{
	rings_.forEach<FaceTerm>(
		workers, [&](int f) { return termOf(surface, map, isRough, f); },
		[&](int v, const Rings::Ring<FaceTerm>& ring) { addUp(v, ring); });
}

/// Visits each input vertex once, for all three corners.
DistanceTerm::FaceTerm DistanceTerm::termOf(const Surface& surface, const ClosestFaceMap& map,
											bool isRough, int f) const
{
	FaceTerm        term;
	const FacePlane plane(m_, f);
	for (Float4& force : term.force)
		force = Float4(0, 0, 0, length(plane.areaNormal()));
	const int num    = int(map.end(f) - map.begin(f));
	const int stride = isRough && num >= manyVertices ? 2 : 1;
	for (const int* i = map.begin(f); i < map.end(f); i += stride) {
		const Vec3f          p    = surface.mesh.position[*i];
		const Vec3f          n    = surface.normal[*i].unpack();
		const Foot           foot = plane.nearestFoot(p);
		const float          off  = dot(n, p - plane.pointAt(foot));
		const float          area = surface.area[*i].value() * float(stride);
		const Float4         pull(n.x * off, n.y * off, n.z * off, 0);
		const SymmetricLanes outer = SymmetricLanes::outer(n);
		for (int k = 0; k < 3; ++k) {
			const float share = area * foot.weight[k];
			term.own[k] += outer * (share * foot.weight[k]);
			term.joint[k] += outer * (share * foot.weight[(k + 1) % 3]);
			term.force[k] += pull * share;
		}
	}
	return term;
}

/// The edge of a spoke is an edge of its own face and of the face before.
void DistanceTerm::addUp(int v, const Rings::Ring<FaceTerm>& ring)
{
	SymmetricLanes own;
	Float4         force;
	const int      first = rings_.begin(v);
	for (int i = 0; i < ring.size; ++i) {
		const FaceTerm& term  = ring.term(i);
		const int       k     = ring.corner(i);
		SymmetricLanes  joint = term.joint[k];
		own += term.own[k];
		force += term.force[k];
		if (i > 0 || ring.isClosed) {
			const int before = i > 0 ? i - 1 : ring.size - 1;
			joint += ring.term(before).joint[(ring.corner(before) + 2) % 3];
		}
		joint_[first + i] = joint;
	}
	own_[v]   = own;
	force_[v] = force;
}

} // namespace gpr
