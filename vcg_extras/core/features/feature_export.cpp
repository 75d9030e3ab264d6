// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "feature_export.h"

#include <algorithm>
#include <array>

namespace gpr {

namespace {

using Corners = std::array<std::int32_t, 3>;

/// The input vertices at the corners of a working face. Ordering may have turned the face, repair
/// may have inverted it, welding may have moved its corners a little. So the best of the six ways
/// to lay the face on its input face counts: the corners move least.
Corners callersCorners(const MeshView& input, const Surface& s, int f)
{
	static constexpr int ways[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1},
									   {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
	const auto           source     = input.triangle(std::size_t(s.sourceFace[f]));
	std::array<Vec3f, 3> wanted;
	for (int k = 0; k < 3; ++k)
		wanted[k] = s.frame.toWorking(input.position(source[k]));

	Corners best{};
	float   least = HUGE_VALF;
	for (const auto& way : ways) {
		float moved = 0;
		for (int k = 0; k < 3; ++k)
			moved += squaredLength(s.mesh.position[s.mesh.origin[3 * f + k]] - wanted[way[k]]);
		if (moved >= least) continue;
		least = moved;
		best  = {source[way[0]], source[way[1]], source[way[2]]};
	}
	return best;
}

void exportFace(const Surface& s, const FeatureEdges& features, int f, const Corners& corner,
				FeatureResult& out)
{
	for (int k = 0; k < 3; ++k) {
		const int h = 3 * f + k, v = s.mesh.origin[h];
		out.vertexStrength[corner[k]] =
			std::max(out.vertexStrength[corner[k]], features.vertexStrength[v]);
		out.vertexFeature[corner[k]] |= features.vertexFeature[v];
		if (s.mesh.isCreaseEdge(h) && h < s.mesh.opposite[h]) {
			out.edges.push_back({corner[k], corner[(k + 1) % 3], features.edgeStrength[h]});
		}
	}
}

} // namespace

void exportFeatures(const MeshView& input, const Surface& surface, const FeatureEdges& features,
					FeatureResult& out)
{
	out.vertexStrength.assign(input.vertexNum, 0);
	out.vertexFeature.assign(input.vertexNum, 0);
	for (int f = 0; f < surface.mesh.faceNum; ++f)
		exportFace(surface, features, f, callersCorners(input, surface, f), out);

	// A vertex in no usable face, or an index out of range, is never marked here.
	out.faceMark.assign(input.faceNum, 0);
	for (int f = 0; f < surface.mesh.faceNum; ++f) {
		const std::int32_t source = surface.sourceFace[f];
		for (int k = 0; k < 3; ++k) {
			if (out.vertexFeature[input.vertexOf(3 * std::size_t(source) + k)] != 0)
				out.faceMark[source] = 1;
		}
	}
	out.figures           = features.figures;
	out.figures.support   = double(features.support) / surface.frame.scale;
	out.figures.minLength = double(features.minLength) / surface.frame.scale;
	for (std::uint8_t mark : out.vertexFeature)
		out.figures.vertexNum += mark != 0;
	for (std::uint8_t mark : out.faceMark)
		out.figures.faceNum += mark != 0;
}

} // namespace gpr
