// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_IO_FORMATS_STL_FACETS_H
#define VCG_EXTRAS_IO_FORMATS_STL_FACETS_H

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string_view>

// Binary STL files.

namespace gpr::app {

/// Of the facets: behind the header and their count.
constexpr std::size_t stlFacetsAt   = 84;
constexpr std::size_t stlFacetBytes = 50;

/// Whether a file is binary, whatever its first word claims. begin: of the file, some thousand
/// bytes of it or all.
bool isBinaryStl(std::string_view begin, std::uint64_t fileBytes);

/// Throws AppError (BadInput) where a binary file is shorter than the count behind its header says.
void requireAllFacets(std::string_view begin, std::uint64_t fileBytes);

/// How long a binary STL file is by the count that follows its header.
std::uint64_t promisedStlBytes(std::string_view begin);

/// The bits of a corner's coordinates, so that equal ones are one vertex: both zeros are alike, and
/// so is all that is no number.
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

/// Facets as they lie one after the other in a file.
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

	/// The same as coordinates of a vertex: NaN in the place of infinite ones.
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

private:
	const char* begin_;
	std::size_t num_;
};

} // namespace gpr::app

#endif
