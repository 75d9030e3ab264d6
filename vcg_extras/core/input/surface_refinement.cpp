// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface_refinement.h"

#include "edge_table.h"
#include "split_long_edges.h"

#include <vcg_extras/core/base/sort_unique.h>

#include <algorithm>
#include <utility>

namespace gpr {

namespace {

/// What a surface has beyond the triangles that are split.
struct Links {
	Buffer<int>          opposite, outgoing;
	Buffer<PackedNormal> normal;
	MortonGrid           grid;

	explicit Links(Surface& surface) :
			opposite(std::move(surface.mesh.opposite)), outgoing(std::move(surface.mesh.outgoing)),
			normal(std::move(surface.normal)), grid(surface.grid)
	{
	}
};

/// The faces that were split, and what came in for them.
struct Change {
	const std::vector<int>& longFaces; ///< ascending; each has a new face in its place
	int                     faceNum;   ///< before
	int                     vertexNum; ///< before

	bool isChanged(int f) const
	{
		return f >= faceNum || std::binary_search(longFaces.begin(), longFaces.end(), f);
	}
	template <class Visit>
	void forEachFace(const IndexedMesh& mesh, const Visit& visit) const
	{
		for (int f : longFaces)
			visit(f);
		for (int f = faceNum; f < mesh.faceNum; ++f)
			visit(f);
	}
	template <class Visit>
	void forEachHalfEdge(const IndexedMesh& mesh, const Visit& visit) const
	{
		forEachFace(mesh, [&](int f) {
			for (int h = 3 * f; h < 3 * f + 3; ++h)
				visit(h);
		});
	}
};

/// Half-edges beside the faces that will be split: their own edges stay whole.
std::vector<int> halfEdgesBeside(const std::vector<int>& longFaces, const Surface& surface)
{
	const Change     change{longFaces, surface.mesh.faceNum, surface.mesh.vertexNum};
	std::vector<int> beside;
	for (int f : longFaces) {
		for (int h = 3 * f; h < 3 * f + 3; ++h) {
			const int other = surface.mesh.opposite[h];
			if (other >= 0 && !change.isChanged(other / 3)) beside.push_back(other);
		}
	}
	return beside;
}

/// Pairs the half-edges of the changed faces with each other and with those beside them.
void pairHalfEdges(const IndexedMesh& mesh, const Change& change, const std::vector<int>& beside,
				   Buffer<int>& opposite)
{
	EdgeTable first;
	first.reserve(3 * (change.longFaces.size() + std::size_t(mesh.faceNum - change.faceNum)));
	const auto pair = [&](int h) {
		const int a = mesh.triangle[h], b = mesh.triangle[nextInFace(h)];
		const int other = first.findOrPut(a, b, h);
		if (other == h) return;
		opposite[h]     = other;
		opposite[other] = h;
	};
	change.forEachHalfEdge(mesh, [&](int h) { opposite[h] = -1; });
	for (int h : beside)
		pair(h);
	change.forEachHalfEdge(mesh, pair);
}

/// Finds a half-edge that leaves each vertex of the changed faces: that of the border, if there is
/// one.
void findOutgoing(const IndexedMesh& mesh, const Change& change, const Buffer<int>& opposite,
				  Buffer<int>& outgoing)
{
	change.forEachHalfEdge(mesh, [&](int h) {
		int& own = outgoing[mesh.triangle[h]];
		if (own < 0 || change.isChanged(own / 3)) own = h;
	});
	change.forEachHalfEdge(mesh, [&](int h) {
		if (opposite[h] < 0) outgoing[mesh.triangle[h]] = h;
	});
}

/// Where the new vertices belong among those that are in the order of a grid's cells.
class OrderedInsertion {
public:
	OrderedInsertion(const IndexedMesh& mesh, int oldVertexNum, const MortonGrid& grid) :
			oldNum_(oldVertexNum)
	{
		for (int v = oldVertexNum; v < mesh.vertexNum; ++v) {
			const std::uint64_t key = grid.key(mesh.position[v]);
			added_.push_back({placeOf(mesh, grid, v), key, v});
		}
		std::sort(added_.begin(), added_.end(), [](const Added& a, const Added& b) {
			if (a.before != b.before) return a.before < b.before;
			return a.key != b.key ? a.key < b.key : a.vertex < b.vertex;
		});
	}

	/// The new number of each vertex.
	Buffer<int> numbers(Workers& workers) const
	{
		Buffer<int> number(std::size_t(oldNum_) + added_.size());
		workers.forRange(std::size_t(oldNum_), [&](std::size_t begin, std::size_t end) {
			auto next =
				std::upper_bound(added_.begin(), added_.end(), int(begin),
								 [](int v, const Added& added) { return v < added.before; });
			for (std::size_t v = begin; v < end; ++v) {
				while (next != added_.end() && next->before <= int(v))
					++next;
				number[v] = int(v) + int(next - added_.begin());
			}
		});
		for (std::size_t i = 0; i < added_.size(); ++i)
			number[added_[i].vertex] = added_[i].before + int(i);
		return number;
	}

private:
	struct Added {
		int           before; ///< the old vertex that it comes before
		std::uint64_t key;
		int           vertex;
	};
	int                oldNum_;
	std::vector<Added> added_;

	/// The end of its cell.
	int placeOf(const IndexedMesh& mesh, const MortonGrid& grid, int v) const
	{
		const std::uint64_t cell = grid.cell(mesh.position[v], grid.level);
		int                 low = 0, high = oldNum_;
		while (low < high) {
			const int middle = low + (high - low) / 2;
			if (grid.cell(mesh.position[middle], grid.level) <= cell)
				low = middle + 1;
			else
				high = middle;
		}
		return low;
	}
};

template <class T>
void renumber(const Buffer<int>& number, Workers& workers, Buffer<T>& values)
{
	if (values.empty()) return;
	Buffer<T> moved(number.size());
	workers.forRange(number.size(), [&](std::size_t begin, std::size_t end) {
		for (std::size_t v = begin; v < end; ++v)
			moved[number[v]] = values[v];
	});
	values.swap(moved);
}

/// The half-edges' numbers stay, so that only what counts vertices changes.
void orderVertices(const Change& change, IndexedMesh& mesh, Links& links, Workers& workers)
{
	const Buffer<int> number =
		OrderedInsertion(mesh, change.vertexNum, links.grid).numbers(workers);
	renumber(number, workers, mesh.position);
	renumber(number, workers, mesh.size);
	renumber(number, workers, links.outgoing);
	renumber(number, workers, links.normal);
	workers.forRange(std::size_t(3) * mesh.faceNum, [&](std::size_t begin, std::size_t end) {
		for (std::size_t h = begin; h < end; ++h)
			mesh.triangle[h] = number[mesh.triangle[h]];
	});
}

void putTogether(IndexedMesh& mesh, Links& links, Surface& surface)
{
	surface.mesh.vertexNum = mesh.vertexNum;
	surface.mesh.faceNum   = mesh.faceNum;
	surface.mesh.position  = std::move(mesh.position);
	surface.mesh.origin    = std::move(mesh.triangle);
	surface.mesh.opposite  = std::move(links.opposite);
	surface.mesh.outgoing  = std::move(links.outgoing);
	surface.sourceFace     = std::move(mesh.sourceFace);
	surface.normal         = std::move(links.normal);
	surface.size           = std::move(mesh.size);
	surface.grid           = links.grid;
}

} // namespace

std::int64_t refineSurface(const std::vector<int>& longFaces, float maxLength,
						   std::int64_t maxFaces, Surface& surface, Workers& workers)
{
	if (longFaces.empty()) return 0;
	const Change           change{longFaces, surface.mesh.faceNum, surface.mesh.vertexNum};
	const std::vector<int> beside = halfEdgesBeside(longFaces, surface);
	Links                  links(surface);
	IndexedMesh            mesh     = disconnect(surface);
	const std::int64_t     splitNum = splitLongEdges(mesh, longFaces, maxLength, maxFaces, workers);

	links.opposite.resize(std::size_t(3) * mesh.faceNum);
	links.outgoing.resize(mesh.vertexNum);
	std::fill(links.outgoing.data() + change.vertexNum, links.outgoing.data() + mesh.vertexNum, -1);
	links.normal.resize(mesh.vertexNum);
	pairHalfEdges(mesh, change, beside, links.opposite);
	findOutgoing(mesh, change, links.opposite, links.outgoing);
	orderVertices(change, mesh, links, workers);

	std::vector<int> touched;
	change.forEachHalfEdge(mesh, [&](int h) { touched.push_back(mesh.triangle[h]); });
	sortUnique(touched);
	putTogether(mesh, links, surface);
	for (int v : touched)
		surface.normal[v] = vertexNormal(surface.mesh, v);
	return splitNum;
}

} // namespace gpr
