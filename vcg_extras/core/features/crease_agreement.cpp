// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "crease_agreement.h"

#include "curve_slide.h"

namespace gpr {

namespace {

/// Normal of the working surface beside the curve at arc s, on the left of the direction of growing
/// arcs, or on the right.
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

/// Normal of the working surface on the side of h, looked up at v, an end of h; zero if v never
/// moves along its line.
Vec3f normalBesideEdge(const Surface& surface, const BoundaryCurves& curves, const ResultMesh& r,
					   int h, int v)
{
	const ResultVertex& here = r.vertex[v];
	if (here.curve < 0 || r.mesh.isBorderVertex(v)) return {};
	const SlideRoom room = slideRoom(r, curves, v);
	if (!room.isOpen()) return {};
	const Curve& c         = curves.curves[here.curve];
	const int    w         = r.mesh.origin[h] == v ? r.mesh.target(h) : r.mesh.origin[h];
	const Vec3f  place     = r.vertex[w].point.position;
	const float  toForward = squaredLength(c.at(here.arc + room.forward) - place);
	const float  toBack    = squaredLength(c.at(here.arc - room.backward) - place);
	const bool   forward   = toForward <= toBack;
	const float  middle    = here.arc + 0.5f * (forward ? room.forward : -room.backward);
	return normalBeside(surface.mesh, c, middle, forward == (r.mesh.origin[h] == v));
}

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

} // namespace gpr
