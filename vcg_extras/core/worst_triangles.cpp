// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "worst_triangles.h"

#include "delaunay_flips.h"
#include "mesh_edit.h"
#include "poor_faces.h"
#include "sectors.h"

#include <algorithm>
#include <cmath>

namespace gpr {

namespace {

constexpr float radians    = 3.14159265f / 180;
constexpr int   mostRounds = 8;
constexpr int   mostMoves  = 3; ///< of a vertex with one step length
/// A move or flip must not turn a face by more than about 26°.
constexpr float turnCosine   = 0.9f;
constexpr float stepShares[] = {0.2f, 0.1f, 0.05f, 0.025f}; ///< of the ideal edge

class AngleRaiser {
public:
	AngleRaiser(const Surface& surface, float angle, ResultMesh& result, Workers& workers) :
			surface_(surface), angle_(angle), r_(result), m_(result.mesh), workers_(workers)
	{
	}

	void run()
	{
		for (int round = 0; round < mostRounds; ++round) {
			const std::vector<int> faces = findPoorFaces(m_, angle_, workers_);
			if (faces.empty()) return;
			if (!improve(faces)) return;
		}
	}

private:
	const Surface& surface_;
	float          angle_;
	ResultMesh&    r_;
	HalfEdgeMesh&  m_;
	Workers&       workers_;

	bool improve(const std::vector<int>& faces)
	{
		bool better = false;
		for (int v : verticesOf(m_, faces)) {
			if (isFree(r_, v) && isFlat(m_, v)) better = search(v) || better;
		}
		for (int f : faces) {
			for (int h = 3 * f; h < 3 * f + 3; ++h)
				better = flipIfBetter(h) || better;
		}
		return better;
	}

	bool search(int v)
	{
		float worst  = smallestAngleAround(m_, v, m_.position[v], turnCosine);
		bool  better = false;
		if (worst >= angle_) return false;
		for (float share : stepShares) {
			for (int move = 0; move < mostMoves; ++move) {
				if (!moveToBest(v, share * r_.idealEdge, worst)) break;
				better = true;
			}
		}
		return better;
	}

	bool moveToBest(int v, float reach, float& worst)
	{
		const ResultVertex start = r_.vertex[v];
		Anchor             best;
		for (const Vec3f& direction : compassDirections(start.normal)) {
			Anchor at = start.anchor;
			if (walk(surface_.mesh, at, direction * reach) != WalkEnd::Arrived) continue;
			const float angle = smallestAngleAround(m_, v, at.position, turnCosine);
			if (angle <= worst) continue;
			worst = angle;
			best  = at;
		}
		if (best.face < 0) return false;
		r_.vertex[v].anchor = best;
		r_.vertex[v].normal = surface_.mesh.faceNormal(best.face);
		m_.position[v]      = best.position;
		return true;
	}

	/// Only on flat ground and away from creases.
	bool flipIfBetter(int h)
	{
		const int g = m_.opposite[h];
		if (g < 0) return false;
		const int   a = m_.origin[h], b = m_.target(h), c = m_.apex(h), d = m_.apex(g);
		const float now = std::min(smallestAngle(m_, h / 3), smallestAngle(m_, g / 3));
		if (now >= angle_) return false;
		if (!isFlat(m_, a) || !isFlat(m_, b) || !isFlat(m_, c) || !isFlat(m_, d)) return false;
		if (!flipKeepsShape(m_, h, now * 1.001f, turnCosine) || !canFlip(m_, h)) return false;
		flip(m_, h);
		++r_.flipNum;
		return true;
	}
};

} // namespace

void raiseWorstAngles(const Surface& surface, float angleDeg, ResultMesh& result, Workers& workers)
{
	AngleRaiser(surface, angleDeg * radians, result, workers).run();
}

} // namespace gpr
