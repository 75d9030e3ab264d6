// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "crease_sides.h"

#include "constraint.h"
#include "fold_repair.h"

#include <vcg_extras/core/mesh/crossing_faces.h>
#include <vcg_extras/core/mesh/face_quality.h>
#include <vcg_extras/core/mesh/mesh_edit.h>
#include <vcg_extras/core/surface/normal_agreement.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace gpr {

namespace {

/// A face that agrees less with the input beside its line (60°) lies across it.
constexpr float leastAgreement = 0.5f;
/// Where a flip cannot reach that it must at least turn the worse of two faces so far towards it.
constexpr float leastGain = 0.1f;
/// Passes over the feature lines.
constexpr int mostRounds = 4;
/// Angles, in radians, that a flip leaves at least (6°), or those there are.
constexpr float leastAngle = 0.1f;
/// And how well they agree with the surface's normals at their corners, at least or as before.
constexpr float leastCornerAgreement = 0.5f;
/// Looks at a face in the test for crossing faces, in all: what is left on a large mesh stays.
constexpr std::int64_t mostLooks = 20000000;

/// The input's normal beside the curve at arc s, on the left of the direction in which arcs grow,
/// or on the right.
Vec3f normalBeside(const HalfEdgeMesh& input, const Curve& c, float s, bool left)
{
	const int segment = c.segmentAt(s);
	const int face    = c.face[segment];
	if (left) return input.faceNormal(face);
	for (int h = 3 * face; h < 3 * face + 3; ++h) {
		if (input.origin[h] == c.vertex[segment] && input.opposite[h] >= 0)
			return input.faceNormal(input.opposite[h] / 3);
	}
	return {};
}

/// The input's normal on the side of h, looked up by one of its ends, v; zero where v never moves
/// along its line.
Vec3f normalBesideEdge(const Surface& surface, const BoundaryCurves& curves, const ResultMesh& r,
					   int h, int v)
{
	const ResultVertex& here = r.vertex[v];
	if (here.curve < 0 || r.mesh.isBorderVertex(v)) return {};
	const SlideRoom room = slideRoom(r, curves, v);
	if (!room.isOpen()) return {};
	const Curve& c         = curves.curves[here.curve];
	const int    w         = r.mesh.origin[h] == v ? r.mesh.target(h) : r.mesh.origin[h];
	const Vec3f  place     = r.vertex[w].anchor.position;
	const float  toForward = squaredLength(c.at(here.arc + room.forward) - place);
	const float  toBack    = squaredLength(c.at(here.arc - room.backward) - place);
	const bool   forward   = toForward <= toBack;
	const float  middle    = here.arc + 0.5f * (forward ? room.forward : -room.backward);
	return normalBeside(surface.mesh, c, middle, forward == (r.mesh.origin[h] == v));
}

class CreaseFaceAligner {
public:
	CreaseFaceAligner(const Surface& surface, const BoundaryCurves& curves, ResultMesh& result,
					  Workers& workers) :
			surface_(surface),
			curves_(curves), r_(result), m_(result.mesh), workers_(workers), looksLeft_(mostLooks)
	{
	}

	int run()
	{
		int flips = 0;
		for (int round = 0; round < mostRounds; ++round) {
			const int before = flips;
			for (int h = 0; h < m_.halfEdgeNum(); ++h) {
				if (m_.isCreaseEdge(h) && !isDeadFace(m_, h / 3)) flips += align(h);
			}
			if (flips == before) break;
		}
		r_.flipNum += flips;
		return flips;
	}

private:
	const Surface&        surface_;
	const BoundaryCurves& curves_;
	ResultMesh&           r_;
	HalfEdgeMesh&         m_;
	Workers&              workers_;
	std::int64_t          looksLeft_;

	/// How good a pair of faces is.
	struct Quality {
		float agreement, cornerAgreement, angle;

		bool beats(const Quality& o) const
		{
			return agreement > std::min(leastAgreement, o.agreement + leastGain) &&
				   cornerAgreement >= std::min(leastCornerAgreement, o.cornerAgreement) &&
				   angle >= std::min(leastAngle, o.angle);
		}
	};

	Quality qualityOf(int f, int g) const
	{
		return {std::min(agreementOf(f), agreementOf(g)),
				std::min(faceAgreement(surface_, r_, f), faceAgreement(surface_, r_, g)),
				std::min(smallestAngle(m_, f), smallestAngle(m_, g))};
	}

	/// The least agreement of a face's crease edges; 1 where there are none.
	float agreementOf(int f) const
	{
		float least = 1;
		for (int h = 3 * f; h < 3 * f + 3; ++h)
			least = std::min(least, creaseAgreement(surface_, curves_, r_, h));
		return least;
	}

	bool align(int h)
	{
		if (creaseAgreement(surface_, curves_, r_, h) >= leastAgreement) return false;
		return flipIfBetter(nextInFace(h)) || flipIfBetter(prevInFace(h));
	}

	bool flipIfBetter(int e)
	{
		const int g = m_.opposite[e];
		if (g < 0 || m_.isCurveEdge(e) || !canFlip(m_, e)) return false;
		const int     f = std::min(e, g) / 3, other = std::max(e, g) / 3;
		const Quality before = qualityOf(f, other);
		flip(m_, e);
		if (qualityOf(f, other).beats(before) && crossesNothing({f, other})) return true;
		flip(m_, nextInFace(e));
		return false;
	}

	bool crossesNothing(const std::vector<int>& faces)
	{
		looksLeft_ -= m_.faceNum;
		return looksLeft_ >= 0 && countCrossingPairs(m_, faces, workers_) == 0;
	}
};

} // namespace

float creaseAgreement(const Surface& surface, const BoundaryCurves& curves,
					  const ResultMesh& result, int h)
{
	const HalfEdgeMesh& m = result.mesh;
	if (!m.hasCreases() || !m.isCreaseEdge(h)) return 1;
	for (int v : {m.origin[h], m.target(h)}) {
		const Vec3f wanted = normalBesideEdge(surface, curves, result, h, v);
		if (squaredLength(wanted) > 0) return dot(wanted, m.faceNormal(h / 3));
	}
	return 1;
}

int alignFacesAtCreases(const Surface& surface, const BoundaryCurves& curves, ResultMesh& result,
						Workers& workers)
{
	if (!result.mesh.hasCreases()) return 0;
	return CreaseFaceAligner(surface, curves, result, workers).run();
}

} // namespace gpr
