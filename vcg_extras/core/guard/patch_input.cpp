// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch_input.h"

#include "face_sets.h"
#include "sparse_array.h"

#include <vcg_extras/core/base/triangle.h>
#include <vcg_extras/core/mesh/edge_sides.h>
#include <vcg_extras/core/mesh/mesh_edit.h>
#include <vcg_extras/core/surface/local_nearest.h>
#include <vcg_extras/core/surface/nearest_samples.h>

#include <algorithm>
#include <cmath>
#include <queue>
#include <utility>

namespace gpr {

namespace {

/// Most vertices of the input near patches: mostVertices, plus mostPerVertex for each vertex of the
/// result there. More vertices are too much for repeated work.
constexpr std::size_t mostVertices = 200'000, mostPerVertex = 500;
/// Longest edges of the input near patches, as shares of the result's longest edge there: at the
/// border of a patch, for edges that follow the result's triangles, and inside.
constexpr float longestAtBorder = 0.4f, longestInside = 0.6f;
/// Search distance beyond a patch, in edges of the result.
constexpr float reachBeyond = 1.5f;
/// Factor on the search distance inside: there the input may be farther from vertices of the
/// result.
constexpr float reachInside = 2;

/// Cells of the result's vertices near patches, on the input, by paths over edges.
class LocalCells {
public:
	LocalCells(const Surface& surface, const ResultMesh& result, const std::vector<PatchRole>& role,
			   float reach, std::size_t mostReached, Workers& workers) :
			m_(surface.mesh),
			mostReached_(mostReached), label_(m_.vertexNum, notSeen)
	{
		std::vector<float> most(role.size(), 0);
		for (std::size_t v = 0; v < role.size(); ++v) {
			if (role[v] == PatchRole::Far) continue;
			most[v] = reachBeyond * longestEdgeAt(result.mesh, int(v));
			if (role[v] != PatchRole::Near)
				most[v] = reach * reachInside * std::max(most[v], result.idealEdge);
			const SurfacePoint& at = result.vertex[v].point;
			for (int h = 3 * at.face; h < 3 * at.face + 3; ++h)
				push(length(m_.position[m_.origin[h]] - at.position), m_.origin[h], int(v));
		}
		run(most, workers);
	}

	int                     labelOf(int v) const { return label_[v]; }
	const std::vector<int>& reached() const { return reached_; }

private:
	static constexpr int       notSeen = -1, outside = -2;
	const HalfEdgeMesh&        m_;
	std::size_t                mostReached_;
	SparseArray<int>           label_; ///< per vertex of the input
	std::vector<int>           reached_;
	std::priority_queue<Reach> front_;

	void push(float distance, int vertex, int label) { front_.push({distance, vertex, label}); }

	void run(const std::vector<float>& most, Workers& workers)
	{
		while (!front_.empty() && reached_.size() <= mostReached_) {
			workers.poll();
			const Reach e = front_.top();
			front_.pop();
			// A vertex too far from its nearest vertex of the result belongs to no cell, so that no
			// other cell leaks out past it.
			const int label = e.distance > most[e.label] ? outside : e.label;
			if (label_[e.vertex] != notSeen) continue;
			label_.set(e.vertex, label);
			if (label == outside) continue;
			reached_.push_back(e.vertex);
			forEachNeighbour(m_, e.vertex, [&](int w) {
				if (label_[w] != notSeen) return;
				push(e.distance + length(m_.position[w] - m_.position[e.vertex]), w, e.label);
			});
		}
	}
};

/// The faces of the input with all corners in cells.
PatchInput facesInCells(const HalfEdgeMesh& m, const LocalCells& cells, Workers& workers)
{
	PatchInput local;
	local.inputVertex = cells.reached();
	std::sort(local.inputVertex.begin(), local.inputVertex.end());
	local.ownNum = int(local.inputVertex.size());
	for (int v : local.inputVertex)
		local.byEdges.push_back(cells.labelOf(v));
	workers.poll(); // each step takes a tenth of a second with half a million faces
	const std::vector<int> faces = facesBetween(m, local.inputVertex);
	workers.poll();
	const auto    inInput = [&](int h) { return 3 * faces[h / 3] + h % 3; };
	HalfEdgeMesh& to      = local.mesh;
	to                    = facesAlone(m, faces, local.inputVertex);
	workers.poll();
	linkFaces(to, workers, [&](const EdgeSide* side, std::size_t num) {
		return num == 2 && m.opposite[inInput(side[0].halfEdge)] == inInput(side[1].halfEdge);
	});
	to.crease.reset(std::size_t(to.halfEdgeNum()));
	for (int h = 0; h < to.halfEdgeNum(); ++h)
		to.crease[h] = char(m.isBorderEdge(inInput(h)));
	return local;
}

/// Splits edges longer than a share of the result's edges near by.
class PatchSubdivision {
public:
	PatchSubdivision(const HalfEdgeMesh& result, const std::vector<char>& isDeep,
					 PatchInput& local) :
			local_(local),
			m_(local.mesh)
	{
		for (int label : local.byEdges)
			limit_.push_back((isDeep[label] ? longestInside : longestAtBorder) *
							 longestEdgeAt(result, label));
	}

	/// Stops above `most` vertices.
	void run(std::size_t most, Workers& workers)
	{
		while (std::size_t(m_.vertexNum) <= most && splitLongest() > 0)
			workers.poll();
	}

private:
	PatchInput&        local_;
	HalfEdgeMesh&      m_;
	std::vector<float> limit_; ///< per vertex

	bool isLong(int h, float& squared) const
	{
		const int a = m_.origin[h], b = m_.target(h);
		squared          = squaredLength(m_.position[a] - m_.position[b]);
		const float most = 0.5f * (limit_[a] + limit_[b]);
		return squared > most * most;
	}

	/// One pass over the long edges, the longest first.
	int splitLongest()
	{
		std::vector<std::pair<float, int>> edges;
		float                              squared = 0;
		for (int h = 0; h < m_.halfEdgeNum(); ++h) {
			if (m_.opposite[h] < h && isLong(h, squared)) edges.emplace_back(-squared, h);
		}
		std::sort(edges.begin(), edges.end());
		// Splitting an edge adds at most two faces and a vertex.
		reserve(m_, m_.vertexNum + int(edges.size()), m_.faceNum + 2 * int(edges.size()));
		for (const auto& edge : edges) {
			if (isLong(edge.second, squared)) split(edge.second);
		}
		return int(edges.size());
	}

	void split(int h)
	{
		const std::size_t a = std::size_t(m_.origin[h]), b = std::size_t(m_.target(h));
		const int         v = m_.vertexNum++;
		m_.position[v]      = (m_.position[int(a)] + m_.position[int(b)]) * 0.5f;
		if (m_.opposite[h] < 0) {
			splitBorderEdge(m_, h, v);
			m_.crease[m_.outgoing[v]] = m_.crease[h];
		}
		else {
			splitEdge(m_, h, v);
		}
		local_.inputVertex.push_back(local_.inputVertex[a]);
		local_.byEdges.push_back(local_.byEdges[a]);
		limit_.push_back(0.5f * (limit_[a] + limit_[b]));
	}
};

/// The corner with the largest weight at the point of the result nearest to p, in a search from
/// vertex `near`.
int labelAt(const HalfEdgeMesh& result, int near, const Vec3f& p, const Vec3f& normal)
{
	const SurfacePoint at = nearestByDescent(result, near, p, normal);
	if (at.face < 0) return near;
	const int* corner = &result.origin[3 * at.face];
	const auto weight = weightsAt(at.position, result.position[corner[0]],
								  result.position[corner[1]], result.position[corner[2]]);
	return corner[std::max_element(weight.begin(), weight.end()) - weight.begin()];
}

void findNearest(const HalfEdgeMesh& result, const std::vector<char>& isDeep, PatchInput& local,
				 Workers& workers)
{
	const HalfEdgeMesh& m = local.mesh;
	std::vector<Vec3f>  normal(std::size_t(m.vertexNum));
	for (int h = 0; h < m.halfEdgeNum(); ++h)
		normal[m.origin[h]] += m.faceCross(h / 3);
	local.byPlace = local.byEdges;
	workers.forEach(std::size_t(m.vertexNum), [&](int v) {
		int& nearest = local.byPlace[v];
		if (isDeep[nearest]) return; // patches only grow
		nearest = labelAt(result, nearest, m.position[v], normal[v]);
	});
}

std::size_t mostVerticesFor(const std::vector<PatchRole>& role)
{
	const auto far = std::count(role.begin(), role.end(), PatchRole::Far);
	return mostVertices + mostPerVertex * (role.size() - std::size_t(far));
}

} // namespace

float longestEdgeAt(const HalfEdgeMesh& m, int v)
{
	float squared = 0;
	forEachNeighbour(m, v, [&](int w) {
		squared = std::max(squared, squaredLength(m.position[w] - m.position[v]));
	});
	return std::sqrt(squared);
}

std::vector<char> deepVertices(const HalfEdgeMesh& result, const std::vector<PatchRole>& role)
{
	const auto        isInside = [&](int v) { return role[v] == PatchRole::Inside; };
	std::vector<char> isDeep(role.size());
	for (int v = 0; v < result.vertexNum; ++v) {
		isDeep[v] = isInside(v) && !anyNeighbour(result, v, [&](int w) { return !isInside(w); });
	}
	return isDeep;
}

std::vector<int> PatchInput::labels(const HalfEdgeMesh&           result,
									const std::vector<PatchRole>& role) const
{
	const std::vector<char> isDeep = deepVertices(result, role);
	std::vector<int>        label  = byEdges;
	for (std::size_t v = 0; v < label.size(); ++v) {
		const PatchRole here = role[label[v]], there = role[byPlace[v]];
		// A search that begins beyond the border of a patch and ends inside has come to another
		// sheet.
		const bool isBeyond = here == PatchRole::Near || here == PatchRole::Far;
		const bool hasLeft  = isBeyond && there == PatchRole::Inside;
		if (!isDeep[label[v]] && !hasLeft) label[v] = byPlace[v];
	}
	return label;
}

PatchInput collectPatchInput(const Surface& surface, const ResultMesh& result,
							 const std::vector<PatchRole>& role, float reach, Workers& workers)
{
	const std::size_t       most = mostVerticesFor(role);
	const LocalCells        cells(surface, result, role, reach, most, workers);
	PatchInput              local  = facesInCells(surface.mesh, cells, workers);
	const std::vector<char> isDeep = deepVertices(result.mesh, role);
	PatchSubdivision(result.mesh, isDeep, local).run(most, workers);
	local.share = double(local.mesh.vertexNum) / double(most);
	if (local.share <= 1) findNearest(result.mesh, isDeep, local, workers);
	return local;
}

} // namespace gpr
