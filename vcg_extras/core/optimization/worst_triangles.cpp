// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "worst_triangles.h"

#include "delaunay_flips.h"

#include <vcg_extras/core/mesh/face_quality.h>
#include <vcg_extras/core/mesh/mesh_edit.h>
#include <vcg_extras/core/mesh/sectors.h>
#include <vcg_extras/core/surface/surface_point.h>
#include <vcg_extras/core/surface/walk.h>

#include <algorithm>
#include <cmath>

namespace gpr {

namespace {

constexpr int mostRounds = 8;
constexpr int mostMoves  = 3; ///< of a vertex with one step length
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
		std::vector<int> faces = findPoorFaces(m_, angle_, workers_);
		for (int round = 0; round < mostRounds && !faces.empty(); ++round) {
			changed_.clear();
			improve(faces);
			// What found nothing better is only tried again where something changed.
			faces = poorOnes(m_, angle_, facesRound(m_, verticesOf(m_, facesRound(m_, changed_))));
		}
	}

private:
	const Surface& surface_;
	float          angle_;
	ResultMesh&    r_;
	HalfEdgeMesh&  m_;
	Workers&       workers_;
	/// Vertices that moved in this round or stand at an edge that was flipped.
	std::vector<int> changed_;

	void improve(const std::vector<int>& faces)
	{
		for (int v : verticesOf(m_, faces)) {
			if (isFree(r_, v) && isFlat(m_, v) && search(v)) changed_.push_back(v);
		}
		for (int f : faces) {
			for (int h = 3 * f; h < 3 * f + 3; ++h)
				flipIfBetter(h);
		}
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
	void flipIfBetter(int h)
	{
		const int g = m_.opposite[h];
		if (g < 0) return;
		const int   a = m_.origin[h], b = m_.target(h), c = m_.apex(h), d = m_.apex(g);
		const float now = std::min(smallestAngle(m_, h / 3), smallestAngle(m_, g / 3));
		if (now >= angle_) return;
		if (!isFlat(m_, a) || !isFlat(m_, b) || !isFlat(m_, c) || !isFlat(m_, d)) return;
		if (!flipKeepsShape(m_, h, now * 1.001f, turnCosine) || !canFlip(m_, h)) return;
		flip(m_, h);
		++r_.flipNum;
		changed_.insert(changed_.end(), {a, b, c, d});
	}
};

} // namespace

void raiseWorstAngles(const Surface& surface, float angleDeg, ResultMesh& result, Workers& workers)
{
	AngleRaiser(surface, angleDeg * radians, result, workers).run();
}

} // namespace gpr
