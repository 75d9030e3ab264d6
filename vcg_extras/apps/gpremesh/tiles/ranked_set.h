// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_TILES_RANKED_SET_H
#define VCG_EXTRAS_APPS_GPREMESH_TILES_RANKED_SET_H

#include <cstddef>
#include <cstdint>
#include <vector>

namespace gpr::app {

/// A set of whole numbers below a limit with ranks: the number of elements below a given number.
/// Memory: 5/32 of a byte for each number below the limit, in the set or not.
class RankedSet {
public:
	explicit RankedSet(std::uint64_t limit) : words_(std::size_t(limit / wordBits + 1), 0) {}

	void insert(std::uint64_t i) { words_[wordOf(i)] |= bitOf(i); }
	bool has(std::uint64_t i) const { return (words_[wordOf(i)] & bitOf(i)) != 0; }

	/// Completes the set; no number may be added afterwards.
	void finish()
	{
		for (std::size_t w = 0; w < words_.size(); ++w) {
			if (w % blockWords == 0) before_.push_back(size_);
			size_ += bitNum(words_[w]);
		}
	}

	std::uint64_t size() const { return size_; }
	/// Number of elements below i.
	std::uint64_t rank(std::uint64_t i) const
	{
		const std::size_t word = wordOf(i), block = word / blockWords;
		std::uint64_t     num = before_[block];
		for (std::size_t w = block * blockWords; w < word; ++w)
			num += bitNum(words_[w]);
		return num + bitNum(words_[word] & (bitOf(i) - 1));
	}

private:
	static constexpr std::uint64_t wordBits   = 64;
	static constexpr std::size_t   blockWords = 4;
	std::vector<std::uint64_t>     words_;
	std::vector<std::uint64_t>     before_; ///< per block of words
	std::uint64_t                  size_ = 0;

	static std::size_t   wordOf(std::uint64_t i) { return std::size_t(i / wordBits); }
	static std::uint64_t bitOf(std::uint64_t i) { return std::uint64_t(1) << (i % wordBits); }
	/// Adds up neighbouring bits, then pairs, and so on.
	static std::uint64_t bitNum(std::uint64_t word)
	{
		word -= word >> 1 & 0x5555555555555555u;
		word = (word & 0x3333333333333333u) + (word >> 2 & 0x3333333333333333u);
		word = (word + (word >> 4)) & 0x0f0f0f0f0f0f0f0fu;
		return word * 0x0101010101010101u >> 56;
	}
};

} // namespace gpr::app

#endif
