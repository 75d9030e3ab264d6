// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "size_grading.h"

#include <algorithm>
#include <functional>
#include <queue>

namespace gpr {

namespace {

/// Neighbours in space have close indices, so a block of consecutive vertices is a patch of the
/// surface that stays in the cache. A block is also large enough for most paths to end inside.
constexpr std::size_t blockSize = 4096;

/// An upper bound on the size of a vertex.
struct Bound {
	float size;
	int   vertex;

	bool operator>(const Bound& o) const
	{
		return size != o.size ? size > o.size : vertex > o.vertex;
	}
};

using Bounds = std::vector<Bound>;

/// A queue with the smallest bound first.
using BoundQueue = std::priority_queue<Bound, Bounds, std::greater<Bound>>;

/// Consecutive vertices; only one thread at a time reads or writes their sizes.
struct Block {
	Bounds           arriving; ///< for vertices in it
	Bounds           leaving;  ///< for vertices of other blocks
	std::vector<int> lowered;  ///< its vertices that are lowered, each once
};

/// Lowers sizes at the vertices round given vertices. The graded size of a vertex is the minimum
/// over all paths to the vertex of first size plus rise, so the order of paths does not matter.
/// Inside a block this is Dijkstra's algorithm, which reads each vertex once. Bounds that leave a
/// block are handed over after all blocks are done; the blocks that received bounds go on.
class Grader {
public:
	Grader(const HalfEdgeMesh& mesh, float slope, Workers& workers, Buffer<float>& size) :
			m_(mesh), slope_(slope), workers_(workers), size_(size),
			block_((size.size() + blockSize - 1) / blockSize), isLowered_(size.size(), 0)
	{
	}

	std::vector<int> run(const std::vector<int>& small)
	{
		for (int v : small) {
			blockOf(v).arriving.push_back({size_[v], v});
			markLowered(v);
		}
		largest_ = *std::max_element(size_.begin(), size_.end());
		for (std::vector<int> active = activeBlocks(); !active.empty(); active = activeBlocks()) {
			workers_.forTasks(active.size(),
							  [&](std::size_t i, int) { lowerInside(block_[active[i]]); });
			for (int b : active)
				handOver(block_[b].leaving);
		}
		return takeLowered();
	}

private:
	const HalfEdgeMesh& m_;
	float               slope_;
	Workers&            workers_;
	Buffer<float>&      size_;
	float               largest_ = 0;
	std::vector<Block>  block_;
	std::vector<char>   isLowered_;

	Block& blockOf(int v) { return block_[std::size_t(v) / blockSize]; }

	void markLowered(int v)
	{
		if (isLowered_[v] != 0) return;
		isLowered_[v] = 1;
		blockOf(v).lowered.push_back(v);
	}

	std::vector<int> activeBlocks() const
	{
		std::vector<int> active;
		for (std::size_t b = 0; b < block_.size(); ++b) {
			if (!block_[b].arriving.empty()) active.push_back(int(b));
		}
		return active;
	}

	void lowerInside(Block& block)
	{
		BoundQueue queue(std::greater<Bound>(), std::move(block.arriving));
		block.arriving.clear();
		while (!queue.empty()) {
			const Bound least = queue.top();
			queue.pop();
			// A smaller bound has come first.
			if (least.size > size_[least.vertex]) continue;
			lowerNeighbours(least, block, queue);
		}
	}

	void lowerNeighbours(const Bound& from, Block& block, BoundQueue& queue)
	{
		const Vec3f place = m_.position[from.vertex];
		forEachNeighbour(m_, from.vertex, [&](int w) {
			const Bound bound = {from.size + slope_ * length(m_.position[w] - place), w};
			// Another thread may write the sizes of another block.
			if (&blockOf(w) != &block) {
				if (bound.size < largest_) block.leaving.push_back(bound);
			}
			else if (bound.size < size_[w]) {
				lower(bound);
				queue.push(bound);
			}
		});
	}

	void lower(const Bound& bound)
	{
		size_[bound.vertex] = bound.size;
		markLowered(bound.vertex);
	}

	void handOver(Bounds& leaving)
	{
		for (const Bound& bound : leaving) {
			if (!(bound.size < size_[bound.vertex])) continue;
			lower(bound);
			blockOf(bound.vertex).arriving.push_back(bound);
		}
		leaving.clear();
	}

	std::vector<int> takeLowered()
	{
		std::vector<int> all;
		for (const Block& block : block_)
			all.insert(all.end(), block.lowered.begin(), block.lowered.end());
		return all;
	}
};

} // namespace

void gradeSizes(const HalfEdgeMesh& m, float slope, Workers& workers, std::vector<int>& small,
				Buffer<float>& size)
{
	if (small.empty()) return;
	small = Grader(m, slope, workers, size).run(small);
}

} // namespace gpr
