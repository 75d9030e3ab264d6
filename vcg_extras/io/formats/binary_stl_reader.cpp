// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "soup_reader.h"
#include "stl_facets.h"

#include <vcg_extras/core/base/buffer.h>
#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/io/base/exit_code.h>

#include <algorithm>
#include <limits>

namespace gpr::app {

namespace {

/// Finds the first of all corners at the same place. A table with open addressing that threads fill
/// side by side: the number of a place only falls, so the outcome does not depend on the order of
/// the threads.
class FirstCorners {
public:
	FirstCorners(const StlFacets& facets, Workers& workers) :
			facets_(facets), workers_(workers), table_(sizeFor(facets.cornerNum()))
	{
		workers_.forRange(table_.size(), [&](std::size_t begin, std::size_t end) {
			std::fill(table_.data() + begin, table_.data() + end, none);
		});
	}

	/// Of every corner.
	Buffer<int> find()
	{
		const std::size_t num = facets_.cornerNum();
		Buffer<int>       slot(num);
		workers_.forRange(num, [&](std::size_t begin, std::size_t end) {
			for (std::size_t c = begin; c < end; ++c)
				slot[c] = put(c);
		});
		workers_.forRange(num, [&](std::size_t begin, std::size_t end) {
			for (std::size_t c = begin; c < end; ++c)
				slot[c] = table_[slot[c]];
		});
		return slot;
	}

private:
	static constexpr int none = -1;
	const StlFacets&     facets_;
	Workers&             workers_;
	Buffer<int>          table_; ///< a power of two, at most two thirds full

	static std::size_t sizeFor(std::size_t cornerNum)
	{
		std::size_t size = 64;
		while (2 * size < 3 * cornerNum)
			size *= 2;
		return size;
	}

	/// The place in the table of corner c's vertex.
	int put(std::size_t c)
	{
		const StlCornerKey key  = facets_.key(c);
		const std::size_t  mask = table_.size() - 1;
		for (std::size_t at = std::size_t(key.hash()) & mask;; at = (at + 1) & mask) {
			int seen = __atomic_load_n(&table_[at], __ATOMIC_RELAXED);
			if (seen == none && __atomic_compare_exchange_n(&table_[at], &seen, int(c), false,
															__ATOMIC_RELAXED, __ATOMIC_RELAXED))
				return int(at);
			if (!(facets_.key(std::size_t(seen)) == key)) continue;
			while (int(c) < seen &&
				   !__atomic_compare_exchange_n(&table_[at], &seen, int(c), true, __ATOMIC_RELAXED,
												__ATOMIC_RELAXED)) {}
			return int(at);
		}
	}
};

/// Numbers the vertices in the order of their first corners.
void numberVertices(const StlFacets& facets, Buffer<int>& first, InputMesh& mesh)
{
	mesh.triangles.resize(facets.cornerNum());
	int next = 0;
	for (std::size_t c = 0; c < facets.cornerNum(); ++c) {
		const std::size_t f = std::size_t(first[c]);
		if (f < c) {
			mesh.triangles[c] = mesh.triangles[f];
			continue;
		}
		mesh.triangles[c] = next++;
		for (const float x : facets.position(c))
			mesh.floats.push_back(x);
	}
}

} // namespace

InputMesh readBinaryStl(std::string_view file)
{
	constexpr std::size_t mostCorners = std::numeric_limits<std::int32_t>::max();
	const std::size_t     end         = std::size_t(promisedStlBytes(file));
	const StlFacets       facets(file.substr(stlFacetsAt, end - stlFacetsAt));
	if (facets.cornerNum() > mostCorners) failInput("the file has more than 715827882 faces");
	Workers     workers(0, nullptr);
	Buffer<int> first = FirstCorners(facets, workers).find();
	InputMesh   mesh;
	numberVertices(facets, first, mesh);
	return mesh;
}

} // namespace gpr::app
