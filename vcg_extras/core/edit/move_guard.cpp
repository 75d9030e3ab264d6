// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "move_guard.h"

#include <vcg_extras/core/surface/normal_agreement.h>

#include <algorithm>

namespace gpr {

MoveGuard::MoveGuard(const Acceptance& limits, const Shortening& shortening, HalfEdgeMesh& mesh,
					 Workers& workers) :
		limits_(limits),
		shortening_(shortening), m_(mesh), workers_(workers), from_(mesh.vertexNum),
		shift_(mesh.vertexNum)
{
}

void MoveGuard::start()
{
	workers_.forEach(m_.vertexNum, [&](int v) {
		from_[v]  = m_.position[v];
		shift_[v] = Vec3f();
	});
}

void MoveGuard::takeOver()
{
	workers_.forEach(m_.vertexNum, [&](int v) { shift_[v] = m_.position[v] - from_[v]; });
}

bool MoveGuard::hasMoved(int f) const
{
	const int* c = &m_.origin[3 * f];
	return !(shift_[c[0]] == Vec3f() && shift_[c[1]] == Vec3f() && shift_[c[2]] == Vec3f());
}

bool MoveGuard::settle(const Buffer<Vec3f>& normal)
{
	const auto isSpoiltFace = [&](int f) { return isSpoilt(f, normal); };
	return settleAmong(workers_.collectIf(m_.faceNum, isSpoiltFace), normal);
}

void MoveGuard::takeBack(const std::vector<int>& faces, const Buffer<Vec3f>& normal)
{
	settleAmong(facesRound(m_, shorten(faces, 0)), normal);
}

void MoveGuard::takeAllBack()
{
	shift_.fill(Vec3f());
	workers_.forEach(m_.vertexNum, [&](int v) { m_.position[v] = at(v); });
}

bool MoveGuard::isSpoilt(int f, const Buffer<Vec3f>& normal) const
{
	if (!hasMoved(f)) return false;
	const int*    c      = &m_.origin[3 * f];
	const Corners before = {from_[c[0]], from_[c[1]], from_[c[2]]};
	if (spoilsFace(limits_, before, m_.corners(f))) return true;
	if (normal.empty()) return false;
	const float now = normalAgreement(m_, normal, f);
	if (now >= limits_.agreement) return false;
	const Vec3f wanted = normal[c[0]] + normal[c[1]] + normal[c[2]];
	return spoilsAgreement(limits_, agreement(before.cross(), wanted), now);
}

/// Shortens the moves of spoilt faces among the given, then of spoilt faces round these, and so on.
bool MoveGuard::settleAmong(std::vector<int> faces, const Buffer<Vec3f>& normal)
{
	for (int round = 0; round <= shortening_.maxRounds; ++round) {
		const auto isSound = [&](int f) { return !isSpoilt(f, normal); };
		faces.erase(std::remove_if(faces.begin(), faces.end(), isSound), faces.end());
		if (faces.empty()) return true;
		faces = facesRound(m_, shorten(faces, round < shortening_.halvings ? 0.5f : 0.0f));
	}
	takeAllBack();
	return false;
}

/// Shortens the moves of the corners of the faces; returns the corners.
std::vector<int> MoveGuard::shorten(const std::vector<int>& faces, float share)
{
	std::vector<int> vertices = verticesOf(m_, faces);
	for (int v : vertices) {
		shift_[v]      = shift_[v] * share;
		m_.position[v] = at(v);
	}
	return vertices;
}

} // namespace gpr
