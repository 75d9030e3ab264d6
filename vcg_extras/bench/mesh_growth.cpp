// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_growth.h"

#include "edge_table.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gpr::bench {

namespace {

/// All edges are split while the wanted number of faces exceeds the present number by this factor.
/// The rest takes two passes over the longest edges, without traces of the regular pattern.
constexpr double regularFactor = 16;
constexpr double onePassFactor = 4;

/// A number in [-1, 1) that depends on the seed, the pass and the edge only; the bits are mixed as
/// in the finaliser of MurmurHash3.
double randomShare(std::uint64_t seed, std::uint64_t index)
{
	std::uint64_t bits = seed * 0x9e3779b97f4a7c15u + index;
	bits ^= bits >> 33;
	bits *= 0xff51afd7ed558ccdu;
	bits ^= bits >> 33;
	bits *= 0xc4ceb9fe1a85ec53u;
	bits ^= bits >> 33;
	return double(bits >> 11) * (2 / 9007199254740992.0) - 1;
}

class Growing {
public:
	Growing(TriangleMesh& mesh, const MeshGrowth& growth) :
			mesh_(mesh), growth_(growth), workers_(0, nullptr)
	{
	}

	/// One pass: splits the longest edges, or all edges, until there are faceNum faces.
	void growOnce(std::int64_t faceNum, int pass, double jitter)
	{
		jitter_ = jitter;
		edges_  = findEdges(mesh_.triangles, mesh_.vertexNum(), workers_);
		findNormals();
		chooseEdges(faceNum);
		placeVertices(std::uint64_t(growth_.seed) * 64 + std::uint64_t(pass));
		splitFaces();
	}

private:
	TriangleMesh&      mesh_;
	const MeshGrowth&  growth_;
	Workers            workers_;
	double             jitter_ = 0;
	EdgeTable          edges_;
	std::vector<Vec3f> normal_;
	std::vector<int>   vertexOfEdge_; ///< -1: not split

	std::pair<int, int> endsOf(int edge) const
	{
		const int side = edges_.firstSide[edge];
		return {mesh_.triangles[side], endOfSide(mesh_.triangles, side)};
	}

	float lengthOf(int edge) const
	{
		const auto [a, b] = endsOf(edge);
		return float(length(mesh_.positions[b] - mesh_.positions[a]));
	}

	void findNormals()
	{
		std::vector<Vec3d> sum(mesh_.vertexNum());
		for (std::size_t i = 0; i < mesh_.triangles.size(); i += 3) {
			const std::int32_t* t = &mesh_.triangles[i];
			const Vec3d         a = mesh_.positions[t[0]];
			const Vec3d normal    = cross(mesh_.positions[t[1]] - a, mesh_.positions[t[2]] - a);
			for (int k = 0; k < 3; ++k)
				sum[t[k]] += normal;
		}
		normal_.resize(sum.size());
		for (std::size_t v = 0; v < sum.size(); ++v)
			normal_[v] = Vec3f(normalized(sum[v]));
	}

	/// Gives each edge to split a new vertex, in the order of the edges.
	void chooseEdges(std::int64_t faceNum)
	{
		constexpr int      chosen  = -2;
		const std::int64_t missing = faceNum - std::int64_t(mesh_.faceNum());
		if (missing >= std::int64_t(mesh_.triangles.size())) {
			vertexOfEdge_.assign(edges_.edgeNum, chosen);
		}
		else {
			vertexOfEdge_.assign(edges_.edgeNum, -1);
			for (const int edge : longestEdges(missing))
				vertexOfEdge_[edge] = chosen;
		}
		int next = int(mesh_.vertexNum());
		for (int& vertex : vertexOfEdge_)
			if (vertex == chosen) vertex = next++;
	}

	/// The longest edges whose splits make at most moreFaces faces; ties by number.
	std::vector<int> longestEdges(std::int64_t moreFaces) const
	{
		std::vector<std::pair<float, int>> order(edges_.edgeNum);
		for (int e = 0; e < edges_.edgeNum; ++e)
			order[e] = {-lengthOf(e), e};
		std::sort(order.begin(), order.end());
		std::vector<int> longest;
		for (const auto& [length, edge] : order) {
			moreFaces -= edges_.sideNum[edge];
			if (moreFaces < 0) break;
			longest.push_back(edge);
		}
		return longest;
	}

	void placeVertices(std::uint64_t seed)
	{
		mesh_.positions.reserve(mesh_.positions.size() + edges_.edgeNum);
		for (int e = 0; e < edges_.edgeNum; ++e)
			if (vertexOfEdge_[e] >= 0) mesh_.positions.push_back(placeOn(e, seed));
	}

	Vec3d placeOn(int edge, std::uint64_t seed) const
	{
		const auto [i, j] = endsOf(edge);
		const Vec3d  a = mesh_.positions[i], b = mesh_.positions[j], along = b - a;
		const Vec3d  na = Vec3d(normal_[i]), nb = Vec3d(normal_[j]);
		const Vec3d  bulge = (nb * dot(along, nb) - na * dot(along, na)) * 0.125;
		const double shift = 0.5 + jitter_ * randomShare(seed, 2 * std::uint64_t(edge));
		const double rise =
			growth_.roughness * length(along) * randomShare(seed, 2 * std::uint64_t(edge) + 1);
		return a + along * shift + bulge * growth_.roundness + normalized(na + nb) * rise;
	}

	void splitFaces()
	{
		std::vector<std::int32_t> old;
		old.swap(mesh_.triangles);
		mesh_.triangles.reserve(old.size() + 6 * (mesh_.vertexNum() - normal_.size()));
		for (std::size_t side = 0; side < old.size(); side += 3)
			splitFace(&old[side], side);
	}

	//        c2
	//        /    \       c: corners; m: new vertices of the sides, -1 for a whole side
	//    m2      m1
	//    /        \     .
	//  c0 -- m0 -- c1
	void splitFace(const std::int32_t* corner, std::size_t side)
	{
		std::int32_t middle[3];
		int          splitNum = 0;
		for (int k = 0; k < 3; ++k) {
			middle[k] = vertexOfEdge_[edges_.edgeOfSide[side + std::size_t(k)]];
			if (middle[k] >= 0) ++splitNum;
		}
		if (splitNum == 0) add(corner[0], corner[1], corner[2]);
		if (splitNum == 1) splitInTwo(corner, middle);
		if (splitNum == 2) splitInThree(corner, middle);
		if (splitNum == 3) splitInFour(corner, middle);
	}

	void splitInTwo(const std::int32_t* corner, const std::int32_t* middle)
	{
		const int k    = middle[0] >= 0 ? 0 : middle[1] >= 0 ? 1 : 2;
		const int next = (k + 1) % 3, last = (k + 2) % 3;
		add(corner[k], middle[k], corner[last]);
		add(middle[k], corner[next], corner[last]);
	}

	/// Cuts off the corner between the two middles; the rest is cut along its shorter diagonal.
	void splitInThree(const std::int32_t* corner, const std::int32_t* middle)
	{
		const int whole = middle[0] < 0 ? 0 : middle[1] < 0 ? 1 : 2;
		const int a = corner[whole], b = corner[(whole + 1) % 3], c = corner[(whole + 2) % 3];
		const int onBC = middle[(whole + 1) % 3], onCA = middle[(whole + 2) % 3];
		add(onBC, c, onCA);
		if (squaredDistance(a, onBC) <= squaredDistance(b, onCA)) {
			add(a, b, onBC);
			add(a, onBC, onCA);
		}
		else {
			add(a, b, onCA);
			add(b, onBC, onCA);
		}
	}

	void splitInFour(const std::int32_t* corner, const std::int32_t* middle)
	{
		add(corner[0], middle[0], middle[2]);
		add(corner[1], middle[1], middle[0]);
		add(corner[2], middle[2], middle[1]);
		add(middle[0], middle[1], middle[2]);
	}

	double squaredDistance(int a, int b) const
	{
		return squaredLength(mesh_.positions[b] - mesh_.positions[a]);
	}

	void add(std::int32_t a, std::int32_t b, std::int32_t c)
	{
		mesh_.triangles.insert(mesh_.triangles.end(), {a, b, c});
	}
};

} // namespace

TriangleMesh growMesh(TriangleMesh mesh, std::int64_t faceNum, const MeshGrowth& growth)
{
	Growing growing(mesh, growth);
	for (int pass = 0; mesh.faceNum() > 0; ++pass) {
		const std::size_t before    = mesh.faceNum();
		const double      factor    = double(faceNum) / double(before);
		const bool        isRegular = factor >= regularFactor;
		const bool        isHalf    = factor > onePassFactor && !isRegular;
		const auto        aim = isHalf ? std::int64_t(std::sqrt(factor) * double(before)) : faceNum;
		// Jitter in every pass would make triangles ever thinner.
		growing.growOnce(aim, pass, isRegular ? 0 : growth.jitter);
		if (mesh.faceNum() == before) break;
	}
	return mesh;
}

} // namespace gpr::bench
