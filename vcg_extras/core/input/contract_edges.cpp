// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contract_edges.h"

#include <vcg_extras/core/base/poller.h>
#include <vcg_extras/core/base/sort_unique.h>
#include <vcg_extras/core/base/union_find.h>

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

namespace gpr {

namespace {

using Edge = std::pair<int, int>; ///< the smaller vertex first

Edge edgeOf(int a, int b)
{
	return std::minmax({a, b});
}

std::vector<Edge> findEdgesWithoutLength(const IndexedMesh& mesh, Workers& workers)
{
	std::vector<Edge> edges = workers.collectEach<Edge>(mesh.faceNum, [&](int f, auto& out) {
		const int* corner = &mesh.triangle[3 * f];
		for (int k = 0; k < 3; ++k) {
			const int a = corner[k], b = corner[(k + 1) % 3];
			if (mesh.position[a] == mesh.position[b]) out.push_back(edgeOf(a, b));
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
			++facesTo_[out[0]];
			apexOf_[edgeOf(in[0], in[1])] = out[0];
		}
		if (in.size() == 1) addOpposite(edgeOf(out[0], out[1]));
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
		std::map<int, std::set<int>> reaches; // per vertex beside the cluster: neighbours in the
											  // cluster
		std::set<int> border;
		int           innerEdgeNum = 0, innerBorderEdgeNum = 0;
		for (const auto& [edge, faceNum] : faceNum_) {
			const auto [a, b] = edge;
			if (faceNum > 2) return false;
			const bool isInner = isInside(a) && isInside(b);
			innerEdgeNum += isInner;
			innerBorderEdgeNum += isInner && faceNum == 1;
			if (faceNum == 1) border.insert({a, b});
			if (!isInner) reaches[isInside(a) ? b : a].insert(isInside(a) ? a : b);
		}
		if (int(cluster_.size()) - innerEdgeNum + innerFaceNum_ != 1) return false;
		for (const auto& [beside, inside] : reaches) {
			const auto faces = facesTo_.find(beside);
			if (int(inside.size()) - (faces == facesTo_.end() ? 0 : faces->second) != 1)
				return false;
		}
		const auto borderNum =
			std::count_if(border.begin(), border.end(), [&](int v) { return isInside(v); });
		return borderNum == 0 || borderNum - innerBorderEdgeNum == 1;
	}

private:
	const std::vector<int>& cluster_; ///< ascending
	int                     innerFaceNum_ = 0;
	std::map<int, int>      facesTo_; ///< per vertex beside the cluster: faces with an edge of the
									  ///< cluster
	std::map<Edge, int> apexOf_;      ///< per edge of the cluster: the third corner of a face
	std::map<Edge, int> faceNum_;     ///< per edge with an end in the cluster
	std::set<Edge>      opposite_;    ///< edges opposite to the cluster, of faces with a corner in
									  ///< the cluster
	bool hasTwins_ = false;           ///< two faces would have the same vertices

	bool isInside(int v) const { return std::binary_search(cluster_.begin(), cluster_.end(), v); }
	void addOpposite(const Edge& edge) { hasTwins_ |= !opposite_.insert(edge).second; }
	void addSide(int a, int b)
	{
		if (isInside(a) || isInside(b)) ++faceNum_[edgeOf(a, b)];
	}

	void fillSlit(int beside, int a, int b)
	{
		const auto inner = faceNum_.find(edgeOf(a, b));
		if (inner == faceNum_.end() || inner->second != 1) return;
		const auto apex = apexOf_.find(inner->first);
		if (apex != apexOf_.end() && apex->second == beside) return; // a face, and no hole
		++inner->second;
		++faceNum_[edgeOf(a, beside)];
		++faceNum_[edgeOf(b, beside)];
		++facesTo_[beside];
	}
};

/// Contracts the clusters in turn; each cluster is judged in the mesh with all earlier
/// contractions.
class Contraction {
public:
	Contraction(IndexedMesh& mesh, const std::vector<Edge>& edges, Workers& workers) :
			mesh_(mesh), poller_(workers)
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

	int nameOf(int v) const
	{
		const auto found = newName_.find(v);
		return found == newName_.end() ? v : found->second;
	}

private:
	IndexedMesh&                    mesh_;
	Poller                          poller_;
	std::map<int, std::vector<int>> cluster_; ///< by the least vertex; ascending
	std::map<int, int>              firstOf_; ///< per vertex of a cluster: the least vertex
	std::map<int, std::vector<int>> facesAt_; ///< per cluster
	std::unordered_map<int, int>    newName_;

	void findClusters(const std::vector<Edge>& edges)
	{
		for (const auto& [a, b] : edges) {
			poller_.count();
			firstOf_.emplace(a, a);
			firstOf_.emplace(b, b);
		}
		for (const auto& [a, b] : edges)
			joinSets(firstOf_, a, b);
		std::vector<int> vertices;
		for (const auto& entry : firstOf_)
			vertices.push_back(entry.first);
		std::sort(vertices.begin(), vertices.end());
		for (int v : vertices)
			cluster_[rootOf(firstOf_, v)].push_back(v);
		for (int v : vertices)
			firstOf_[v] = rootOf(firstOf_, v);
	}

	void findFaces(Workers& workers)
	{
		std::vector<char> isInCluster(std::size_t(mesh_.vertexNum), 0);
		for (const auto& entry : firstOf_)
			isInCluster[std::size_t(entry.first)] = 1;
		const std::vector<int> faces = workers.collectIf(mesh_.faceNum, [&](int f) {
			const int* corner = &mesh_.triangle[3 * f];
			return isInCluster[corner[0]] || isInCluster[corner[1]] || isInCluster[corner[2]];
		});
		for (int f : faces) {
			poller_.count();
			std::set<int> at;
			for (int k = 0; k < 3; ++k) {
				const auto found = firstOf_.find(mesh_.triangle[3 * f + k]);
				if (found != firstOf_.end()) at.insert(found->second);
			}
			for (int first : at)
				facesAt_[first].push_back(f);
		}
	}

	bool isHarmless(int first, const std::vector<int>& cluster)
	{
		ClusterTopology topology(cluster);
		for (int f : facesAt_.at(first)) {
			poller_.count();
			const int*               t = &mesh_.triangle[3 * f];
			const std::array<int, 3> corner{nameOf(t[0]), nameOf(t[1]), nameOf(t[2])};
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
	std::vector<int> newName(std::size_t(mesh.vertexNum));
	workers.forEach(newName.size(),
					[&](int v) { newName[std::size_t(v)] = contraction.nameOf(v); });
	counts.zeroAreaFaces += renameCorners(mesh, newName, workers);
	dropUnusedVertices(mesh, workers);
}

} // namespace gpr
