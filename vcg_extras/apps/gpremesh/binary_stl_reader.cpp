// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "exit_code.h"
#include "soup_io.h"

#include <vcg_extras/core/base/buffer.h>
#include <vcg_extras/core/base/workers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

namespace gpr::app {

namespace {

constexpr std::size_t headerBytes = 80, countBytes = 4, facetBytes = 50, normalBytes = 12;

/// The bits of a corner's coordinates, so that equal ones are one vertex: both zeros are alike, and
/// so is all that is no number.
struct CornerKey {
	std::array<std::uint32_t, 3> bits;

	bool operator==(const CornerKey& other) const { return bits == other.bits; }

	std::size_t hash() const
	{
		constexpr std::uint64_t golden = 0x9E3779B97F4A7C15; // Knuth: spreads whatever lies close
		std::uint64_t           sum    = 0;
		for (const std::uint32_t b : bits)
			sum = (sum ^ b) * golden;
		return std::size_t(sum ^ sum >> 32);
	}
};

/// The facets of a file.
class Facets {
public:
	explicit Facets(std::string_view file) :
			begin_(file.data() + headerBytes + countBytes),
			num_((file.size() - headerBytes - countBytes) / facetBytes)
	{
	}

	std::size_t cornerNum() const { return 3 * num_; }

	/// NaN in the place of infinite coordinates, too.
	std::array<float, 3> corner(std::size_t c) const
	{
		std::array<float, 3> p;
		std::memcpy(p.data(), begin_ + facetBytes * (c / 3) + normalBytes + 12 * (c % 3), 12);
		return p;
	}

	CornerKey key(std::size_t c) const
	{
		CornerKey key;
		for (std::size_t k = 0; k < 3; ++k) {
			float x = corner(c)[k];
			if (x == 0) x = 0; // without a sign
			if (std::isnan(x)) x = std::numeric_limits<float>::quiet_NaN();
			std::memcpy(&key.bits[k], &x, sizeof x);
		}
		return key;
	}

private:
	const char* begin_;
	std::size_t num_;
};

/// Finds the first of all corners at one place. A table with open addressing that threads fill side
/// by side: a place's number only falls, so that the outcome does not depend on who comes first.
class FirstCorners {
public:
	FirstCorners(const Facets& facets, Workers& workers) :
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
	const Facets&        facets_;
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
		const CornerKey   key  = facets_.key(c);
		const std::size_t mask = table_.size() - 1;
		for (std::size_t at = key.hash() & mask;; at = (at + 1) & mask) {
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
void numberVertices(const Facets& facets, Buffer<int>& first, InputMesh& mesh)
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
		for (const float x : facets.corner(c))
			mesh.floats.push_back(std::isfinite(x) ? x : std::numeric_limits<float>::quiet_NaN());
	}
}

} // namespace

InputMesh readBinaryStl(std::string_view file)
{
	constexpr std::size_t mostCorners = std::numeric_limits<std::int32_t>::max();
	const Facets          facets(file.substr(0, promisedStlBytes(file)));
	if (facets.cornerNum() > mostCorners)
		throw AppError(ExitCode::BadInput, "it has more than 715827882 faces");
	Workers     workers(0, nullptr);
	Buffer<int> first = FirstCorners(facets, workers).find();
	InputMesh   mesh;
	numberVertices(facets, first, mesh);
	return mesh;
}

} // namespace gpr::app
