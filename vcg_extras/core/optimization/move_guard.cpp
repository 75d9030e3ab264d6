// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "move_guard.h"

#include <vcg_extras/core/base/triangle.h>
#include <vcg_extras/core/surface/normal_agreement.h>

#include <algorithm>

namespace gpr {

namespace {

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

bool losesShape(float minShape, const Corners& before, const Vec3f& then, const Corners& after,
				const Vec3f& now)
{
	if (minShape == 0) return false;
	const float shape = squaredShape(now, after);
	return shape < minShape * minShape && shape < squaredShape(then, before);
}

bool losesAngle(const MoveLimits& limits, const Corners& before, const Corners& after)
{
	if (limits.minAngle == 0) return false;
	const float angle = smallestAngle(after.a, after.b, after.c);
	return angle < limits.minAngle &&
		   angle < limits.falls * smallestAngle(before.a, before.b, before.c);
}

} // namespace

bool spoilsFace(const MoveLimits& limits, const Corners& before, const Corners& after)
{
	const Vec3f now = crossOf(after), then = crossOf(before);
	const float turn = dot(now, then);
	if (turn <= 0 || turn * turn < limits.turnCosine * limits.turnCosine * squaredLength(now) *
									   squaredLength(then))
		return true;
	return losesShape(limits.minShape, before, then, after, now) ||
		   losesAngle(limits, before, after);
}

bool spoilsRing(const MoveLimits& limits, const HalfEdgeMesh& m, int v, const Vec3f& to)
{
	const Vec3f from   = m.position[v];
	bool        spoils = false;
	forEachOutgoing(m, v, [&](int h) {
		const Vec3f a = m.position[m.target(h)], b = m.position[m.apex(h)];
		spoils = spoils || spoilsFace(limits, {from, a, b}, {to, a, b});
	});
	return spoils;
}

MoveGuard::MoveGuard(const MoveLimits& limits, HalfEdgeMesh& mesh, Workers& workers) :
		limits_(limits), m_(mesh), workers_(workers), from_(mesh.vertexNum)
{
	std::copy(m_.position.data(), m_.position.data() + m_.vertexNum, from_.data());
}

void MoveGuard::start()
{
	if (shift_.empty()) shift_.reset(m_.vertexNum);
	workers_.forRange(m_.vertexNum, [&](std::size_t begin, std::size_t end) {
		for (std::size_t v = begin; v < end; ++v) {
			from_[v]  = m_.position[v];
			shift_[v] = Vec3f();
		}
	});
}

void MoveGuard::takeOver()
{
	if (shift_.empty()) shift_.reset(m_.vertexNum);
	workers_.forRange(m_.vertexNum, [&](std::size_t begin, std::size_t end) {
		for (std::size_t v = begin; v < end; ++v)
			shift_[v] = m_.position[v] - from_[v];
	});
}

void MoveGuard::apply()
{
	workers_.forRange(m_.vertexNum, [&](std::size_t begin, std::size_t end) {
		for (std::size_t v = begin; v < end; ++v)
			m_.position[v] = at(int(v));
	});
}

bool MoveGuard::hasMoved(int f) const
{
	const int* c = &m_.origin[3 * f];
	return !(shift_[c[0]] == Vec3f() && shift_[c[1]] == Vec3f() && shift_[c[2]] == Vec3f());
}

bool MoveGuard::settle(const Buffer<Vec3f>& normal)
{
	const auto collectSpoilt = [&](std::size_t begin, std::size_t end, auto& out) {
		for (std::size_t f = begin; f < end; ++f) {
			if (isSpoilt(int(f), normal)) out.push_back(int(f));
		}
	};
	shortened_.clear();
	return settleFrom(workers_.collect<int>(m_.faceNum, collectSpoilt), normal);
}

std::vector<char> MoveGuard::takeBack(const std::vector<int>& faces, const Buffer<Vec3f>& normal)
{
	shortened_.clear();
	const std::vector<int> spoilt = spoiltAmong(facesRound(m_, shorten(faces, 0)), normal);
	// Where all moves were taken back, all faces have changed.
	std::vector<char> changed(m_.faceNum, char(!settleFrom(spoilt, normal)));
	for (int f : facesRound(m_, shortened_))
		changed[f] = 1;
	return changed;
}

void MoveGuard::takeAllBack()
{
	shift_.fill(Vec3f());
	apply();
}

bool MoveGuard::isSpoilt(int f, const Buffer<Vec3f>& normal) const
{
	if (!hasMoved(f)) return false;
	const int* c = &m_.origin[3 * f];
	return spoilsFace(limits_, {from_[c[0]], from_[c[1]], from_[c[2]]},
					  {m_.position[c[0]], m_.position[c[1]], m_.position[c[2]]}) ||
		   (!normal.empty() && losesAgreement(f, normal));
}

bool MoveGuard::losesAgreement(int f, const Buffer<Vec3f>& normal) const
{
	const int*  c   = &m_.origin[3 * f];
	const float now = faceAgreement(m_, normal, f);
	if (!(now < limits_.minAgreement)) return false;
	const Vec3f wanted = normal[c[0]] + normal[c[1]] + normal[c[2]];
	const Vec3f then   = crossOf({from_[c[0]], from_[c[1]], from_[c[2]]});
	return now < limits_.falls * agreement(then, wanted);
}

std::vector<int> MoveGuard::spoiltAmong(std::vector<int> faces, const Buffer<Vec3f>& normal) const
{
	const auto isSound = [&](int f) { return !isSpoilt(f, normal); };
	faces.erase(std::remove_if(faces.begin(), faces.end(), isSound), faces.end());
	return faces;
}

bool MoveGuard::settleFrom(std::vector<int> spoilt, const Buffer<Vec3f>& normal)
{
	for (int round = 0; round < limits_.maxRounds && !spoilt.empty(); ++round) {
		const float share = round < limits_.halvings ? 0.5f : 0.0f;
		spoilt            = spoiltAmong(facesRound(m_, shorten(spoilt, share)), normal);
	}
	if (spoilt.empty()) return true;
	takeAllBack();
	return false;
}

/// Shortens the moves of the faces' corners; returns these.
std::vector<int> MoveGuard::shorten(const std::vector<int>& faces, float share)
{
	std::vector<int> vertices = verticesOf(m_, faces);
	for (int v : vertices) {
		shift_[v]      = shift_[v] * share;
		m_.position[v] = at(v);
	}
	shortened_.insert(shortened_.end(), vertices.begin(), vertices.end());
	return vertices;
}

} // namespace gpr
