// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contract_edges.h"

#include <vcg_extras/core/base/poller.h>
#include <vcg_extras/core/base/sort_unique.h>
#include <vcg_extras/core/base/union_find.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace gpr {

namespace {

constexpr int none = -1;

using Edge = std::pair<int, int>; ///< the smaller vertex first

std::vector<Edge> findEdgesWithoutLength(const IndexedMesh& mesh, Workers& workers)
{
	std::vector<Edge> edges = workers.collectEach<Edge>(mesh.faceNum, [&](int f, auto& out) {
		const int* corner = &mesh.triangle[3 * f];
		for (int k = 0; k < 3; ++k) {
			const int a = corner[k], b = corner[(k + 1) % 3];
			if (mesh.position[a] == mesh.position[b]) out.push_back(std::minmax({a, b}));
		}
	});
	sortUnique(edges);
	return edges;
}

/// The topology of a cluster of vertices and its faces, for contracting the cluster to a vertex.
/// The topology stays the same if the cluster has no holes and each vertex beside the cluster is
/// joined to it in one piece: the link condition (Dey, Edelsbrunner, Guha and Nekhayev 1999) for
/// many vertices at once. The outside of a border counts as another vertex beside the cluster.
class ClusterTopology {
public:
	explicit ClusterTopology(const std::vector<int>& cluster) : cluster_(cluster) {}

	/// Adds a face with a corner in the cluster.
	void addFace(const std::array<int, 3>& corner)
	{
		std::vector<int> in, out;
		for (int v : corner)
			(isInside(v) ? in : out).push_back(v);
		if (in.size() == 3) ++innerFaceNum_;
		if (in.size() == 2) {
			--lessFaces_[out[0]];
			apexOf_[std::minmax({in[0], in[1]})] = out[0];
		}
		if (in.size() == 1) addOpposite(std::minmax({out[0], out[1]}));
		for (int k = 0; k < 3; ++k)
			addSide(corner[k], corner[(k + 1) % 3]);
	}

	/// A hole of three edges, with an edge in the cluster, has no area. From here on the hole
	/// counts as a face: contracting the edge joins the other two edges.
	void fillSlits()
	{
		std::map<int, std::vector<int>> openTo; // per vertex beside the cluster: over border edges
		for (const auto& [edge, faceNum] : faceNum_) {
			const auto [a, b] = edge;
			if (faceNum != 1 || isInside(a) == isInside(b)) continue;
			openTo[isInside(a) ? b : a].push_back(isInside(a) ? a : b);
		}
		for (const auto& [beside, inside] : openTo) {
			if (inside.size() == 2) fillSlit(beside, inside[0], inside[1]);
		}
	}

	bool staysTheSame() const
	{
		if (hasTwins_) return false;
		std::map<int, int> pieceNum = lessFaces_; // and the edges to the cluster
		std::set<int>      border;                // vertices of the cluster
		int                innerEdgeNum = 0, innerBorderEdgeNum = 0;
		for (const auto& [edge, faceNum] : faceNum_) {
			const auto [a, b] = edge;
			if (faceNum > 2) return false;
			const bool isInner = isInside(a) && isInside(b);
			innerEdgeNum += isInner;
			innerBorderEdgeNum += isInner && faceNum == 1;
			for (int v : {a, b}) {
				if (faceNum == 1 && isInside(v)) border.insert(v);
			}
			if (!isInner) ++pieceNum[isInside(a) ? b : a];
		}
		if (int(cluster_.size()) - innerEdgeNum + innerFaceNum_ != 1) return false;
		for (const auto& [beside, num] : pieceNum) {
			if (num != 1) return false;
		}
		return border.empty() || int(border.size()) - innerBorderEdgeNum == 1;
	}

private:
	const std::vector<int>& cluster_; ///< ascending
	int                     innerFaceNum_ = 0;
	std::map<int, int>      lessFaces_; ///< per vertex beside the cluster: minus the faces with an
										///< edge of the cluster
	std::map<Edge, int> apexOf_;        ///< per edge of the cluster: the third corner of a face
	std::map<Edge, int> faceNum_;       ///< per edge with an end in the cluster
	std::set<Edge>      opposite_; ///< edges opposite to the cluster, of faces with a corner in
								   ///< the cluster
	bool hasTwins_ = false;        ///< two faces would have the same vertices

	bool isInside(int v) const { return std::binary_search(cluster_.begin(), cluster_.end(), v); }
	void addOpposite(const Edge& edge) { hasTwins_ |= !opposite_.insert(edge).second; }
	void addSide(int a, int b)
	{
		if (isInside(a) || isInside(b)) ++faceNum_[std::minmax({a, b})];
	}

	void fillSlit(int beside, int a, int b)
	{
		const auto inner = faceNum_.find(std::minmax({a, b}));
		if (inner == faceNum_.end() || inner->second != 1) return;
		const auto apex = apexOf_.find(inner->first);
		if (apex != apexOf_.end() && apex->second == beside) return; // a face, and no hole
		++inner->second;
		++faceNum_[std::minmax({a, beside})];
		++faceNum_[std::minmax({b, beside})];
		--lessFaces_[beside];
	}
};

/// Contracts the clusters in turn; each cluster is judged in the mesh with all earlier
/// contractions.
class Contraction {
public:
	Contraction(IndexedMesh& mesh, const std::vector<Edge>& edges, Workers& workers) :
			mesh_(mesh), poller_(workers), firstOf_(std::size_t(mesh.vertexNum), none),
			newName_(numbersBelow(std::size_t(mesh.vertexNum)))
	{
		findClusters(edges);
		findFaces(workers);
	}

	/// Returns the number of vertices joined to other vertices.
	std::int64_t run()
	{
		std::int64_t num = 0;
		for (const auto& [first, cluster] : cluster_) {
			if (!isHarmless(first, cluster)) continue;
			for (int v : cluster)
				newName_[v] = first;
			num += std::int64_t(cluster.size()) - 1;
		}
		return num;
	}

	/// Per vertex.
	const std::vector<int>& newNames() const { return newName_; }

private:
	IndexedMesh&                    mesh_;
	Poller                          poller_;
	std::map<int, std::vector<int>> cluster_; ///< by the least vertex; ascending
	std::vector<int>                firstOf_; ///< per vertex: the least of its cluster, or none
	std::map<int, std::vector<int>> facesAt_; ///< per cluster
	std::vector<int>                newName_;

	void findClusters(const std::vector<Edge>& edges)
	{
		for (const auto& [a, b] : edges) {
			firstOf_[a] = a;
			firstOf_[b] = b;
		}
		for (const auto& [a, b] : edges)
			joinSets(firstOf_, a, b);
		for (int v = 0; v < mesh_.vertexNum; ++v) {
			poller_.count();
			if (firstOf_[v] == none) continue;
			firstOf_[v] = rootOf(firstOf_, v);
			cluster_[firstOf_[v]].push_back(v);
		}
	}

	void findFaces(Workers& workers)
	{
		const std::vector<int> faces = workers.collectIf(mesh_.faceNum, [&](int f) {
			const int* corner = &mesh_.triangle[3 * f];
			return std::any_of(corner, corner + 3, [&](int v) { return firstOf_[v] != none; });
		});
		for (int f : faces) {
			poller_.count();
			for (int h = 3 * f; h < 3 * f + 3; ++h) {
				const int first = firstOf_[mesh_.triangle[h]];
				if (first == none) continue;
				std::vector<int>& at = facesAt_[first];
				if (at.empty() || at.back() != f) at.push_back(f);
			}
		}
	}

	bool isHarmless(int first, const std::vector<int>& cluster)
	{
		ClusterTopology topology(cluster);
		for (int f : facesAt_.at(first)) {
			poller_.count();
			const int*               t = &mesh_.triangle[3 * f];
			const std::array<int, 3> corner{newName_[t[0]], newName_[t[1]], newName_[t[2]]};
			const bool               isGone =
				corner[0] == corner[1] || corner[1] == corner[2] || corner[2] == corner[0];
			if (!isGone) topology.addFace(corner);
		}
		topology.fillSlits();
		return topology.staysTheSame();
	}
};

} // namespace

void contractEdgesWithoutLength(IndexedMesh& mesh, Workers& workers, CleanCounts& counts)
{
	const std::vector<Edge> edges = findEdgesWithoutLength(mesh, workers);
	if (edges.empty()) return;
	Contraction        contraction(mesh, edges, workers);
	const std::int64_t num = contraction.run();
	if (num == 0) return;
	counts.contractedEdges += num;
	counts.zeroAreaFaces += renameCorners(mesh, contraction.newNames(), workers);
	dropUnusedVertices(mesh, workers);
}

} // namespace gpr
