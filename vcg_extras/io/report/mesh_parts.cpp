// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_parts.h"

#include <vcg_extras/core/base/sort_unique.h>
#include <vcg_extras/core/base/union_find.h>
#include <vcg_extras/core/mesh/edge_sides.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace gpr::app {

namespace {

void measureJunctions(const MeshView& mesh, const Buffer<EdgeSide>& sides, MeshParts& parts)
{
	forEachEdge(sides, [&](std::size_t begin, std::size_t end) {
		if (end - begin < 3 || sides[begin].low == sides[begin].high) return;
		++parts.junctionEdges;
		const double edge = length(mesh.position(std::size_t(sides[begin].high)) -
								   mesh.position(std::size_t(sides[begin].low)));
		if (std::isfinite(edge)) parts.junctionLength += edge;
	});
}

/// Per face: the first face of its piece.
std::vector<int> piecesOf(const MeshView& mesh, const Buffer<EdgeSide>& sides)
{
	std::vector<int>            first = numbersBelow(mesh.faceNum);
	std::map<std::int32_t, int> faceOf; // by label, at one edge
	forEachEdge(sides, [&](std::size_t begin, std::size_t end) {
		if (sides[begin].low == sides[begin].high) return;
		faceOf.clear();
		for (std::size_t i = begin; i < end && end - begin > 1; ++i) {
			const int face  = sides[i].halfEdge / 3;
			const int other = faceOf.emplace(mesh.region[face], face).first->second;
			joinSets(first, face, other);
		}
	});
	return first;
}

void measureRegions(const InputMesh& mesh, const Buffer<EdgeSide>& sides, MeshParts& parts)
{
	const MeshView view = mesh.view();
	if (view.region == nullptr) return;
	std::map<std::int32_t, MeshParts::Region> byLabel;
	const std::vector<int>                    first = piecesOf(view, sides);
	for (std::size_t f = 0; f < view.faceNum; ++f) {
		MeshParts::Region& region = byLabel[view.region[f]];
		++region.faces;
		region.pieces += first[f] == int(f);
		const double area = 0.5 * length(view.faceCross(f));
		region.area += std::isfinite(area) ? area : 0;
	}
	for (auto& [label, region] : byLabel) {
		region.label = label;
		region.name  = mesh.regions.nameOf(label);
		parts.regions.push_back(std::move(region));
	}
}

} // namespace

MeshParts measureParts(const InputMesh& mesh)
{
	MeshParts              parts;
	Workers                workers(1, nullptr);
	const Buffer<EdgeSide> sides = sortedSides(mesh.view(), workers);
	measureJunctions(mesh.view(), sides, parts);
	measureRegions(mesh, sides, parts);
	return parts;
}

} // namespace gpr::app
