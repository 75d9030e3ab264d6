// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "move_guard.h"

#include <utility>

namespace gpr {

namespace {

/// A face of a shape below this (30°-30°-120°) must not get worse.
constexpr float poorShape = 0.6f;
/// A move must not turn a face by more than 60°.
constexpr float foldCosine = 0.5f;
/// Rounds of taking moves back; then all moves are.
constexpr int mostTakeBackRounds = 8;

Vec3f crossOf(const Corners& f)
{
	return cross(f.b - f.a, f.c - f.a);
}

/// Of a triangle with the given cross product; see triangleShape. No root.
float squaredShape(const Vec3f& cross, const Corners& f)
{
	const float edges =
		squaredLength(f.b - f.a) + squaredLength(f.c - f.b) + squaredLength(f.a - f.c) + 1e-30f;
	return 12 * squaredLength(cross) / (edges * edges);
}

} // namespace

bool spoilsFace(const Corners& before, const Corners& after)
{
	const Vec3f now = crossOf(after), then = crossOf(before);
	const float turn = dot(now, then);
	if (turn <= 0 ||
		turn * turn < foldCosine * foldCosine * squaredLength(now) * squaredLength(then))
		return true;
	const float shape = squaredShape(now, after);
	return shape < poorShape * poorShape && shape < squaredShape(then, before);
}

MoveGuard::MoveGuard(ResultMesh& result, Workers& workers) :
		r_(result), workers_(workers), next_(result.vertex.size()), moved_(result.vertex.size(), 0)
{
}

void MoveGuard::clear()
{
	moved_.fill(0);
}

void MoveGuard::move()
{
	exchange();
	for (int round = 0; round < mostTakeBackRounds; ++round) {
		const std::vector<int> bad = findBadFaces();
		if (bad.empty()) return;
		for (int f : bad) {
			for (int k = 0; k < 3; ++k)
				takeBack(r_.mesh.origin[3 * f + k]);
		}
	}
	for (int v = 0; v < r_.mesh.vertexNum; ++v)
		takeBack(v);
}

void MoveGuard::exchange()
{
	workers_.forRange(moved_.size(), [&](std::size_t begin, std::size_t end) {
		for (std::size_t v = begin; v < end; ++v) {
			if (!moved_[v]) continue;
			std::swap(next_[v], r_.vertex[v]);
			r_.mesh.position[v] = r_.vertex[v].anchor.position;
		}
	});
}

void MoveGuard::takeBack(int v)
{
	if (!moved_[v]) return;
	moved_[v]           = 0;
	r_.vertex[v]        = next_[v];
	r_.mesh.position[v] = r_.vertex[v].anchor.position;
}

Vec3f MoveGuard::placeBefore(int v) const
{
	return moved_[v] ? next_[v].anchor.position : r_.mesh.position[v];
}

std::vector<int> MoveGuard::findBadFaces()
{
	const HalfEdgeMesh& m = r_.mesh;
	return workers_.collect<int>(m.faceNum, [&](std::size_t begin, std::size_t end, auto& out) {
		for (int f = int(begin); f < int(end); ++f) {
			const int* corner = &m.origin[3 * f];
			if (!moved_[corner[0]] && !moved_[corner[1]] && !moved_[corner[2]]) continue;
			if (isBad(f)) out.push_back(f);
		}
	});
}

bool MoveGuard::isBad(int f) const
{
	const HalfEdgeMesh& m      = r_.mesh;
	const int*          corner = &m.origin[3 * f];
	return spoilsFace({placeBefore(corner[0]), placeBefore(corner[1]), placeBefore(corner[2])},
					  {m.position[corner[0]], m.position[corner[1]], m.position[corner[2]]});
}

} // namespace gpr
