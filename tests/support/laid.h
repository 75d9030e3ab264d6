// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GPR_TESTS_SUPPORT_LAID_H
#define GPR_TESTS_SUPPORT_LAID_H

#include "stages.h"

#include <vcg_extras/core/mesh/face_quality.h>
#include <vcg_extras/core/optimization/fit.h>
#include <vcg_extras/core/surface/nearest_on_mesh.h>
#include <vcg_extras/core/surface/surface_distance.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace gpr::test {

/// A fine surface, and a coarse result whose vertices lie on the surface.
struct Laid {
	Workers        workers;
	Surface        surface;
	BoundaryCurves boundary;
	ResultMesh     result;

	Laid(const TriangleMesh& fine, const TriangleMesh& coarse, int threads = 2) :
			workers(threads, nullptr), surface(surfaceOf(fine, workers))
	{
		TriangleMesh laid = coarse;
		for (Vec3d& p : laid.positions)
			p = Vec3d(surface.frame.toWorking(p));
		result.mesh = halfEdgesOf(laid);
		result.vertex.resize(laid.vertexNum());
		const NearestOnMesh tree(surface.mesh, workers);
		for (int v = 0; v < result.mesh.vertexNum; ++v) {
			ResultVertex& r         = result.vertex[v];
			r.point                 = tree.nearest(result.mesh.position[v]);
			r.normal                = surface.mesh.faceNormal(r.point.face);
			result.mesh.position[v] = r.point.position;
		}
	}

	/// Mean edge length, in working units.
	float meanEdge() const
	{
		const HalfEdgeMesh& m   = result.mesh;
		float               sum = 0;
		for (int h = 0; h < m.halfEdgeNum(); ++h)
			sum += length(m.position[m.target(h)] - m.position[m.origin[h]]);
		return sum / float(m.halfEdgeNum());
	}

	/// Largest distance, both ways, in mean edges.
	float farthest()
	{
		const MutualDistance d = sampledBetween(surface.mesh, result.mesh, workers).mutual;
		return float(d.larger().max) / meanEdge();
	}

	FitOutcome fit(float minAngleDeg = 32, int rounds = 4, int worstRounds = 0)
	{
		FitSettings settings;
		settings.worstRounds = worstRounds;
		settings.rounds      = rounds;
		settings.minAngleDeg = minAngleDeg;
		return fitToInput(surface, boundary, settings, result, workers);
	}

	/// A vertex of the result, in units of the input.
	Vec3d at(int v) const { return surface.frame.toCaller(result.mesh.position[v]); }

	/// Root mean square distance from the vertices of the fine surface to the result, in units of
	/// the input.
	double rms()
	{
		const NearestOnMesh tree(result.mesh, workers);
		double              sum = 0;
		for (int p = 0; p < surface.mesh.vertexNum; ++p) {
			const Vec3f at = surface.mesh.position[p];
			sum += double(squaredLength(tree.nearest(at).position - at));
		}
		return std::sqrt(sum / surface.mesh.vertexNum) / surface.frame.scale;
	}

	std::vector<float> minAngles() const
	{
		std::vector<float>  angles;
		const HalfEdgeMesh& m = result.mesh;
		for (int f = 0; f < m.faceNum; ++f)
			angles.push_back(smallestAngle(m.position[m.origin[3 * f]],
										   m.position[m.origin[3 * f + 1]],
										   m.position[m.origin[3 * f + 2]]));
		return angles;
	}
};

} // namespace gpr::test

#endif
