// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_IO_FORMATS_STL_FACETS_H
#define VCG_EXTRAS_IO_FORMATS_STL_FACETS_H

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

// Binary STL files.

namespace gpr::app {

/// Of the facets: behind the header and their count.
constexpr std::size_t stlFacetsAt   = 84;
constexpr std::size_t stlFacetBytes = 50;

/// Whether a file is binary, for any first word. begin: some thousand bytes of the file, or all.
bool isBinaryStl(std::string_view begin, std::uint64_t fileBytes);

/// Throws AppError (BadInput) for a binary file shorter than the count after its header says.
void requireAllFacets(std::string_view begin, std::uint64_t fileBytes);

/// Notes about a binary file that is longer than the count says.
std::vector<std::string> notesOfStl(std::string_view begin, std::uint64_t fileBytes);

/// What no other format has room for.
constexpr const char* stlAttributes = "colours or other data in attribute bytes of facets";

/// The length of a binary STL file by the count after its header.
std::uint64_t promisedStlBytes(std::string_view begin);

/// The bits of a corner's coordinates, so that equal corners are one vertex: both zeros are alike,
/// and so are all values that are no number.
struct StlCornerKey {
	std::array<std::uint32_t, 3> bits;

	bool operator==(const StlCornerKey& other) const { return bits == other.bits; }

	std::uint64_t hash() const
	{
		constexpr std::uint64_t golden = 0x9E3779B97F4A7C15; // Knuth: spreads whatever lies close
		std::uint64_t           sum    = 0;
		for (const std::uint32_t b : bits)
			sum = (sum ^ b) * golden;
		return sum ^ sum >> 32;
	}
};

/// Facets in the order of a file.
class StlFacets {
public:
	explicit StlFacets(std::string_view facets) :
			begin_(facets.data()), num_(facets.size() / stlFacetBytes)
	{
	}

	std::size_t cornerNum() const { return 3 * num_; }

	std::array<float, 3> corner(std::size_t c) const
	{
		constexpr std::size_t normalBytes = 12, cornerBytes = 12;
		std::array<float, 3>  p;
		std::memcpy(p.data(),
					begin_ + stlFacetBytes * (c / 3) + normalBytes + cornerBytes * (c % 3),
					cornerBytes);
		return p;
	}

	/// The same as coordinates of a vertex: NaN in place of infinite values.
	std::array<float, 3> position(std::size_t c) const
	{
		std::array<float, 3> p = corner(c);
		for (float& x : p)
			x = std::isfinite(x) ? x : std::numeric_limits<float>::quiet_NaN();
		return p;
	}

	StlCornerKey key(std::size_t c) const
	{
		StlCornerKey         key;
		std::array<float, 3> p = corner(c);
		for (std::size_t k = 0; k < 3; ++k) {
			if (p[k] == 0) p[k] = 0; // without a sign
			if (std::isnan(p[k])) p[k] = std::numeric_limits<float>::quiet_NaN();
			std::memcpy(&key.bits[k], &p[k], sizeof(float));
		}
		return key;
	}

	/// Whether a facet has attribute bytes other than zero: by some programs a colour.
	bool hasAttribute(std::size_t f) const
	{
		const char* const end = begin_ + stlFacetBytes * (f + 1);
		return end[-1] != 0 || end[-2] != 0;
	}

private:
	const char* begin_;
	std::size_t num_;
};

} // namespace gpr::app

#endif
