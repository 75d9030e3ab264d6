// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "size_grading.h"

#include <algorithm>
#include <cmath>

namespace gpr {

namespace {

/// What the neighbours leave of a size.
float gradedSize(const HalfEdgeMesh& m, float slope, const Buffer<float>& size, int v)
{
	float least = size[v];
	forEachNeighbour(m, v, [&](int w) {
		if (!(size[w] < least)) return;
		least = std::min(least, size[w] + slope * length(m.position[w] - m.position[v]));
	});
	return least;
}

/// A list of vertices without repetition.
class VertexList {
public:
	explicit VertexList(int vertexNum) : isListed_(std::size_t(vertexNum), 0) {}

	void add(int v)
	{
		if (isListed_[v] != 0) return;
		isListed_[v] = 1;
		list_.push_back(v);
	}
	/// Hands the list over and is empty then.
	std::vector<int> take()
	{
		for (int v : list_)
			isListed_[v] = 0;
		std::vector<int> taken;
		taken.swap(list_);
		return taken;
	}

private:
	std::vector<int>  list_;
	std::vector<char> isListed_;
};

/// Vertices by their sizes. The smaller ones come first: what they lower is lowered once, and not
/// again and again as the sizes round it fall.
class SizeQueue {
public:
	SizeQueue(float least, float largest) :
			least_(least), perSize_(bucketNum / std::max(largest - least, 1e-30f)),
			bucket_(bucketNum)
	{
	}

	static constexpr int bucketNum = 64;

	int bucketOf(float size) const
	{
		return std::min(bucketNum - 1, int((size - least_) * perSize_));
	}
	void add(int v, float size) { bucket_[bucketOf(size)].push_back(v); }
	/// Empties a bucket.
	std::vector<int> take(int b)
	{
		std::vector<int> taken;
		taken.swap(bucket_[b]);
		return taken;
	}

private:
	float                         least_, perSize_;
	std::vector<std::vector<int>> bucket_;
};

/// Lowers sizes at the vertices round some.
class Grader {
public:
	Grader(const HalfEdgeMesh& mesh, float slope, Workers& workers, Buffer<float>& size) :
			m_(mesh), slope_(slope), workers_(workers), size_(size), lowered_(mesh.vertexNum),
			next_(mesh.vertexNum)
	{
	}

	std::vector<int> run(const std::vector<int>& small)
	{
		float least = HUGE_VALF, largest = 0;
		for (int v : small)
			least = std::min(least, size_[v]);
		for (float size : size_)
			largest = std::max(largest, size);
		SizeQueue queue(least, largest);
		for (int v : small) {
			lowered_.add(v);
			queue.add(v, size_[v]);
		}
		for (int b = 0; b < SizeQueue::bucketNum; ++b)
			lowerFrom(b, queue);
		return lowered_.take();
	}

private:
	const HalfEdgeMesh& m_;
	float               slope_;
	Workers&            workers_;
	Buffer<float>&      size_;
	VertexList          lowered_, next_;
	std::vector<float>  value_;

	void lowerFrom(int b, SizeQueue& queue)
	{
		for (std::vector<int> source = queue.take(b); !source.empty(); source = queue.take(b)) {
			for (int v : source) {
				if (queue.bucketOf(size_[v]) < b) continue; // it was lowered since, and done then
				forEachNeighbour(m_, v, [&](int w) {
					if (size_[w] > size_[v]) next_.add(w);
				});
			}
			lower(next_.take(), queue);
		}
	}

	/// All are found from the same sizes before any is written: no thread sees another's.
	void lower(const std::vector<int>& tried, SizeQueue& queue)
	{
		// Ever smaller changes far from their cause are not worth a round.
		constexpr float worth = 0.999f;
		value_.resize(tried.size());
		workers_.forEach(tried.size(),
						 [&](int i) { value_[i] = gradedSize(m_, slope_, size_, tried[i]); });
		for (std::size_t i = 0; i < tried.size(); ++i) {
			const int v = tried[i];
			if (!(value_[i] < worth * size_[v])) continue;
			size_[v] = value_[i];
			queue.add(v, value_[i]);
			lowered_.add(v);
		}
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
