// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "terms.h"

#include <vcg_extras/core/mesh/mesh_edit.h>

namespace gpr {

namespace {

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
	Vec3f sum;
	float weight = 0;
	forEachFaceRound(m, v, [&](int h, const Vec3f& a, const Vec3f& b) {
		float area = length(cross(a, b));
		if (!density.empty()) area *= density[v] + density[m.target(h)] + density[m.apex(h)];
		sum += (a + b) * (area / 3);
		weight += area;
	});
	return weight > 0 ? sum * (1 / weight) : Vec3f();
}

Buffer<Vec3f> secondOrderUmbrella(const HalfEdgeMesh& m, Workers& workers)
{
	Buffer<Umbrella> umbrella(m.vertexNum);
	workers.forEach(m.vertexNum, [&](int v) { umbrella[v] = umbrellaAt(m, v); });
	Buffer<Vec3f> step(m.vertexNum);
	workers.forEach(m.vertexNum, [&](int v) { step[v] = umbrellaStep(m, umbrella, v); });
	return step;
}

DistanceTerm::DistanceTerm(const HalfEdgeMesh& mesh) :
		m_(mesh), edge_(mesh.halfEdgeNum()), own_(mesh.vertexNum), force_(mesh.vertexNum)
{
	// Edges are numbered in the order of their lower half-edges.
	int num = 0;
	for (int h = 0; h < m_.halfEdgeNum(); ++h) {
		const int g = m_.opposite[h];
		edge_[h]    = g >= 0 && g < h ? edge_[g] : num++;
	}
	joint_.reset(num);
}

void DistanceTerm::assemble(const Surface& surface, const ClosestFaceMap& map, Workers& workers)
{
	workers.forEach(joint_.size(), [&](int edge) { joint_[edge] = SymmetricMatrix(); });
	workers.forEach(m_.vertexNum, [&](int v) { assembleVertex(surface, map, v); });
}

/// An edge is summed up by its lower vertex, which sees both faces: nothing is written twice.
void DistanceTerm::assembleVertex(const Surface& surface, const ClosestFaceMap& map, int v)
{
	SymmetricMatrix own;
	Vec3f           force;
	forEachOutgoing(m_, v, [&](int h) {
		const int       next = m_.target(h), last = m_.apex(h);
		const Vec3f     p = m_.position[v], q = m_.position[next], r = m_.position[last];
		SymmetricMatrix withNext, withLast;
		for (const int* i = map.begin(h / 3); i != map.end(h / 3); ++i) {
			const PackedWeights w    = map.weights(i);
			const float         b[3] = {w.first(), w.second(), w.third()};
			const float         bp = b[h % 3], bq = b[nextInFace(h) % 3], br = b[prevInFace(h) % 3];
			const Vec3f         n   = surface.normal[*i].unpack();
			const float         off = dot(n, surface.mesh.position[*i] - p * bp - q * bq - r * br);
			const float         share = map.area(*i) * bp;
			force += n * (share * off);
			own.addOuter(n, share * bp);
			withNext.addOuter(n, share * bq);
			withLast.addOuter(n, share * br);
		}
		if (v < next) joint_[edge_[h]] += withNext;
		if (v < last) joint_[edge_[prevInFace(h)]] += withLast;
	});
	own_[v]   = own;
	force_[v] = force;
}

} // namespace gpr
