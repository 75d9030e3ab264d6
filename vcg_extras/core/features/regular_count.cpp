// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "regular_count.h"

#include "crease_clearance.h"

#include <vcg_extras/core/base/portable_math.h>
#include <vcg_extras/core/surface/surface_ray.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace gpr {

namespace {

/// The largest share of triangles that narrow strips spoil. In about a twentieth an angle is below
/// 30° then, as some strips suit the triangles by chance.
constexpr double mostSpoilt = 0.07;
/// Widths of a strip in edge lengths. In a narrower strip every triangle has an angle below 30°,
/// even with the best places along the sides. In a wider strip no triangle needs to have one, even
/// with the worst places.
constexpr double alwaysSpoilt = 0.2, neverSpoilt = 0.6;
/// The largest number of faces on a way across a strip.
constexpr int maxCrossings = 500;

/// A side of a crease edge with a narrow strip.
struct Side {
	float width; ///< of the strip
	float length;
};

/// Whether a strip may begin or end at h: at a border or at a crease edge.
bool isSide(const HalfEdgeMesh& m, float cosine, int h)
{
	return m.isBorderEdge(h) || isSharpEdge(m, h, cosine);
}

/// The sides whose strips are narrower than reach. cosine: of the normals at a crease edge.
std::vector<Side> narrowSides(const HalfEdgeMesh& m, float cosine, float reach, Workers& workers)
{
	return workers.collectEach<Side>(std::size_t(m.halfEdgeNum()), [&](int h, auto& out) {
		if (!isSide(m, cosine, h)) return;
		float width = reach;
		traceRay(m, h, {0, 1}, reach, maxCrossings, [&](int exit, float at) {
			if (at < width && isSide(m, cosine, exit)) width = at;
		});
		if (width < reach) out.push_back({width, m.edgeLength(h)});
	});
}

/// Length along the sides with spoilt triangles of an edge length.
double spoiltLength(const std::vector<Side>& sides, double edge)
{
	double sum = 0;
	for (const Side& side : sides) {
		const double width = double(side.width) / edge;
		const double share = (neverSpoilt - width) / (neverSpoilt - alwaysSpoilt);
		sum += double(side.length) * std::clamp(share, 0.0, 1.0);
	}
	return sum;
}

} // namespace

float edgeForRegularity(const HalfEdgeMesh& mesh, double area, float edge, float angle,
						Workers& workers)
{
	constexpr int           halvings = 20;
	const float             cosine   = float(portable::cos(double(angle)));
	const std::vector<Side> sides = narrowSides(mesh, cosine, float(neverSpoilt) * edge, workers);
	const auto              isRegular = [&](double at) {
        return at * spoiltLength(sides, at) * std::sqrt(3.0) / 4 <= mostSpoilt * area;
	};
	double low = 0, high = double(edge);
	if (isRegular(high)) return edge;
	for (int i = 0; i < halvings; ++i) {
		const double middle              = 0.5 * (low + high);
		(isRegular(middle) ? low : high) = middle;
	}
	return float(high);
}

} // namespace gpr
