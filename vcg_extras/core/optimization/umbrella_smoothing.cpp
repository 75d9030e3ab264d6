// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "umbrella_smoothing.h"

#include "move_guard.h"
#include "relaxation.h"

#include <vcg_extras/core/mesh/mesh_edit.h>
#include <vcg_extras/core/surface/walk.h>

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

Vec3f stepAt(const HalfEdgeMesh& m, const Buffer<Umbrella>& umbrella, int v)
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

Buffer<Vec3f> secondOrderUmbrella(const HalfEdgeMesh& m, Workers& workers)
{
	Buffer<Umbrella> umbrella(m.vertexNum);
	workers.forRange(umbrella.size(), [&](std::size_t begin, std::size_t end) {
		for (std::size_t v = begin; v < end; ++v)
			umbrella[v] = umbrellaAt(m, int(v));
	});
	Buffer<Vec3f> step(m.vertexNum);
	workers.forRange(step.size(), [&](std::size_t begin, std::size_t end) {
		for (std::size_t v = begin; v < end; ++v)
			step[v] = stepAt(m, umbrella, int(v));
	});
	return step;
}

void smoothByUmbrella2(const Surface& surface, ResultMesh& result, Workers& workers)
{
	const Buffer<char>  flat = findFlatVertices(result, workers);
	const Buffer<Vec3f> step = secondOrderUmbrella(result.mesh, workers);
	MoveGuard           guard(result, workers);
	workers.forRange(flat.size(), [&](std::size_t begin, std::size_t end) {
		for (int v = int(begin); v < int(end); ++v) {
			if (!flat[v] || !isFree(result, v)) continue;
			ResultVertex next = result.vertex[v];
			walk(surface.mesh, next.anchor, tangential(step[v] * -1.0f, next.normal));
			next.normal = surface.mesh.faceNormal(next.anchor.face);
			guard.propose(v, next);
		}
	});
	guard.move();
}

} // namespace gpr
