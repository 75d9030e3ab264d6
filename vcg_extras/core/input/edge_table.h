// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_INPUT_EDGE_TABLE_H
#define VCG_EXTRAS_CORE_INPUT_EDGE_TABLE_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gpr {

/// A number per edge, found by the two ends of the edge. A table without chains: most of the time
/// of splitting went into the memory of a std::unordered_map's nodes.
class EdgeTable {
public:
	void clear()
	{
		entry_.assign(entry_.size(), Entry());
		num_ = 0;
	}

	void reserve(std::size_t edgeNum)
	{
		if (2 * edgeNum <= entry_.size()) return;
		std::size_t size = 1024;
		while (size < 2 * edgeNum)
			size *= 2;
		std::vector<Entry> old(size);
		old.swap(entry_);
		for (const Entry& e : old) {
			if (e.number >= 0) placeOf(e.edge) = e;
		}
	}

	/// The number of the edge a-b; a new edge gets the number `next`.
	int findOrPut(int a, int b, int next)
	{
		const std::uint64_t low = std::min(a, b), high = std::max(a, b);
		const std::uint64_t edge  = low << 32 | high;
		Entry&              place = placeOf(edge);
		if (place.number >= 0) return place.number;
		place = {edge, next};
		if (2 * ++num_ > entry_.size()) reserve(2 * num_);
		return next;
	}

	std::size_t size() const { return num_; }

private:
	struct Entry {
		std::uint64_t edge   = 0;
		int           number = -1; ///< below 0: free

		bool isFreeOr(std::uint64_t other) const { return number < 0 || edge == other; }
	};
	std::vector<Entry> entry_ = std::vector<Entry>(1024); ///< a power of two, at most half full
	std::size_t        num_   = 0;

	/// The entry of the edge, or a free entry: beside the edges with the same and the next smaller
	/// ends, which are asked for soon before and after. If nearby entries are full, anywhere.
	Entry& placeOf(std::uint64_t edge)
	{
		// A vertex has three edges to others on the mean; a line of the cache holds four entries.
		constexpr std::size_t   perVertex = 4, nearby = 8;
		constexpr std::uint64_t golden = 0x9E3779B97F4A7C15; // Knuth: spreads whatever lies close
		const std::size_t       mask   = entry_.size() - 1;
		std::size_t             at     = std::size_t(edge >> 32) * perVertex & mask;
		for (std::size_t i = 0; i < nearby; ++i, at = (at + 1) & mask) {
			if (entry_[at].isFreeOr(edge)) return entry_[at];
		}
		// In steps that differ from edge to edge: step by step, a search would have to pass the
		// whole dense part of the table, where the edges beside their smaller ends lie.
		const std::uint64_t hash = edge * golden;
		const std::size_t   step = std::size_t(hash >> 16) | 1; // odd: reaches all entries
		at                       = std::size_t(hash >> 32) & mask;
		while (!entry_[at].isFreeOr(edge))
			at = (at + step) & mask;
		return entry_[at];
	}
};

} // namespace gpr

#endif
