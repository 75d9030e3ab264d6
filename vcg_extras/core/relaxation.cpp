// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "relaxation.h"

#include "sectors.h"
#include "sizing.h"
#include "walk.h"

namespace gpr {

namespace {

/// A face of a shape below this (30°-30°-120°) must not get worse.
constexpr float poorShape = 0.6f;
/// A move must not turn a face by more than 60°.
constexpr float foldCosine = 0.5f;
/// Rounds of taking moves back; then all moves near the trouble are.
constexpr int mostTakeBackRounds = 8;

/// Weight of area where the triangles are to be of this size. Lloyd's theory asks for the fourth
/// power of 1/size for the density of the area; for barycentres of rings, whose faces are small
/// already where they are to be small, the third power keeps the grading (docs/algorithm.md).
float densityOfSize(float size)
{
	return 1 / (size * size * size);
}

/// Per vertex of the result; empty where the triangles are to be of one size.
Buffer<float> findDensities(const Surface& surface, const ResultMesh& result, Workers& workers)
{
	Buffer<float> density = sizesOf(surface, result, workers);
	for (float& d : density)
		d = densityOfSize(d);
	return density;
}

/// From v to the barycentre of its ring, weighted by area and density, in the tangent plane.
Vec3f stepToBarycentre(const HalfEdgeMesh& m, int v, const Vec3f& normal,
					   const Buffer<float>& density)
{
	const Vec3f p = m.position[v];
	Vec3f       sum;
	float       weight = 0;
	forEachOutgoing(m, v, [&](int h) {
		const Vec3f a = m.position[m.target(h)] - p, b = m.position[m.apex(h)] - p;
		float       area = length(cross(a, b));
		if (!density.empty()) area *= density[v] + density[m.target(h)] + density[m.apex(h)];
		sum += (a + b) * (area / 3);
		weight += area;
	});
	if (!(weight > 0)) return {};
	return tangential(sum * (1 / weight), normal);
}

/// The moves of one step, with what is needed to take them back.
class MoveGuard {
public:
	MoveGuard(ResultMesh& result, Workers& workers) :
			r_(result), workers_(workers), before_(result.vertex.size())
	{
	}

	void remember(int v) { before_[v] = r_.vertex[v]; }

	/// Takes moves back until no face is folded or poorer than it was while poor.
	void takeBackBadMoves(const Buffer<char>& moved)
	{
		Buffer<char> still(moved.size());
		std::copy(moved.begin(), moved.end(), still.begin());
		for (int round = 0; round < mostTakeBackRounds; ++round) {
			const std::vector<int> bad = findBadFaces(still);
			if (bad.empty()) return;
			for (int f : bad) {
				for (int k = 0; k < 3; ++k)
					takeBack(r_.mesh.origin[3 * f + k], still);
			}
		}
		for (int v = 0; v < r_.mesh.vertexNum; ++v)
			takeBack(v, still);
	}

private:
	ResultMesh&          r_;
	Workers&             workers_;
	Buffer<ResultVertex> before_;

	void takeBack(int v, Buffer<char>& moved)
	{
		if (!moved[v]) return;
		moved[v]            = 0;
		r_.vertex[v]        = before_[v];
		r_.mesh.position[v] = before_[v].anchor.position;
	}

	Vec3f placeBefore(int v, const Buffer<char>& moved) const
	{
		return moved[v] ? before_[v].anchor.position : r_.mesh.position[v];
	}

	std::vector<int> findBadFaces(const Buffer<char>& moved)
	{
		const HalfEdgeMesh& m = r_.mesh;
		return workers_.collect<int>(m.faceNum, [&](std::size_t begin, std::size_t end, auto& out) {
			for (int f = int(begin); f < int(end); ++f) {
				const int a = m.origin[3 * f], b = m.origin[3 * f + 1], c = m.origin[3 * f + 2];
				if (!moved[a] && !moved[b] && !moved[c]) continue;
				if (isBad(f, placeBefore(a, moved), placeBefore(b, moved), placeBefore(c, moved)))
					out.push_back(f);
			}
		});
	}

	bool isBad(int f, const Vec3f& a, const Vec3f& b, const Vec3f& c) const
	{
		const HalfEdgeMesh& m    = r_.mesh;
		const Vec3f         now  = m.faceCross(f);
		const Vec3f         then = cross(b - a, c - a);
		const float         turn = dot(now, then);
		if (turn <= 0 ||
			turn * turn < foldCosine * foldCosine * squaredLength(now) * squaredLength(then))
			return true;
		const float shape =
			triangleShape(m.position[m.origin[3 * f]], m.position[m.origin[3 * f + 1]],
						  m.position[m.origin[3 * f + 2]]);
		return shape < poorShape && shape < triangleShape(a, b, c);
	}
};

} // namespace

Buffer<char> findFlatVertices(const ResultMesh& result, Workers& workers)
{
	Buffer<char> flat(result.mesh.vertexNum);
	workers.forRange(flat.size(), [&](std::size_t begin, std::size_t end) {
		for (std::size_t v = begin; v < end; ++v)
			flat[v] = isFlat(result.mesh, int(v));
	});
	return flat;
}

void relaxOnce(const Surface& surface, ResultMesh& result, Workers& workers)
{
	HalfEdgeMesh&       m       = result.mesh;
	const Buffer<char>  flat    = findFlatVertices(result, workers);
	const Buffer<float> density = findDensities(surface, result, workers);
	Buffer<Vec3f>       step(m.vertexNum);
	workers.forRange(m.vertexNum, [&](std::size_t begin, std::size_t end) {
		for (std::size_t v = begin; v < end; ++v) {
			const bool moves = flat[v] && isFree(result, int(v));
			step[v] =
				moves ? stepToBarycentre(m, int(v), result.vertex[v].normal, density) : Vec3f();
		}
	});
	MoveGuard    guard(result, workers);
	Buffer<char> moved(m.vertexNum);
	workers.forRange(m.vertexNum, [&](std::size_t begin, std::size_t end) {
		for (std::size_t v = begin; v < end; ++v) {
			moved[v] = squaredLength(step[v]) > 0;
			if (!moved[v]) continue;
			guard.remember(int(v));
			ResultVertex& r = result.vertex[v];
			walk(surface.mesh, r.anchor, step[v]);
			r.normal      = surface.mesh.faceNormal(r.anchor.face);
			m.position[v] = r.anchor.position;
		}
	});
	guard.takeBackBadMoves(moved);
}

} // namespace gpr
