// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "terms.h"

#include <vcg_extras/core/mesh/face_plane.h>
#include <vcg_extras/core/mesh/mesh_edit.h>

#include <algorithm>

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

namespace {

DistanceTerm::FaceSums sumsOf(const FacePlane& plane, const Surface& surface,
							  const ClosestFaceMap& map, int f)
{
	DistanceTerm::FaceSums sums{normalized(plane.areaNormal()), {}, {}, {}};
	for (const int* i = map.begin(f); i != map.end(f); ++i) {
		const Vec3f at     = surface.mesh.position[*i];
		const Foot  foot   = plane.nearestFoot(at);
		const float area   = map.area(*i);
		const float height = dot(sums.normal, at - plane.corner());
		for (int k = 0; k < 3; ++k) {
			const float weighted = area * foot.weight[k];
			sums.own[k] += weighted * foot.weight[k];
			sums.joint[k] += weighted * foot.weight[k == 2 ? 0 : k + 1];
			sums.pull[k] += weighted * height;
		}
	}
	return sums;
}

} // namespace

void DistanceTerm::assemble(const Surface& surface, const ClosestFaceMap& map, Workers& workers)
{
	workers.forEach(m_.faceNum,
					[&](int f) { sums_[f] = sumsOf(FacePlane(m_, f), surface, map, f); });
}

} // namespace gpr
