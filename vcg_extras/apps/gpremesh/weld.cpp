// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "weld.h"

#include <cstring>

namespace gpr::app {

namespace {

/// The bits of a position, so that comparing is exact and NaN equals itself.
template <class S>
struct PositionKey {
	std::uint64_t x = 0, y = 0, z = 0;

	explicit PositionKey(const S* p) : x(bitsOf(p[0])), y(bitsOf(p[1])), z(bitsOf(p[2])) {}

	bool operator==(const PositionKey& b) const { return x == b.x && y == b.y && z == b.z; }

	std::size_t hash() const
	{
		// Multiplying by large odd numbers spreads the mantissas; the top half is the well-mixed
		// one.
		std::uint64_t h = x * 0x9E3779B97F4A7C15u;
		h               = (h ^ (h >> 32) ^ y) * 0xC2B2AE3D27D4EB4Fu;
		h               = (h ^ (h >> 32) ^ z) * 0x165667B19E3779F9u;
		return std::size_t(h ^ (h >> 32));
	}

	static std::uint64_t bitsOf(S value)
	{
		if (value == 0) return 0; // both signs
		std::uint64_t bits = 0;
		std::memcpy(&bits, &value, sizeof(S));
		return bits;
	}
};

std::size_t tableSizeFor(std::size_t entryNum)
{
	std::size_t size = 16;
	while (size < 2 * entryNum)
		size *= 2;
	return size;
}

/// For each position the number of the vertex that stands for it; packs the kept positions.
template <class S>
std::vector<std::int32_t> packDistinct(CoordinateArray<S>& positions)
{
	const std::size_t         num = positions.size() / 3;
	std::vector<std::int32_t> vertexOf(num);
	std::vector<std::int32_t> table(tableSizeFor(num), -1);
	std::size_t               kept = 0;
	for (std::size_t i = 0; i < num; ++i) {
		const PositionKey<S> key(&positions[3 * i]);
		std::size_t          slot = key.hash() & (table.size() - 1);
		while (table[slot] >= 0 &&
			   !(PositionKey<S>(&positions[3 * std::size_t(table[slot])]) == key)) {
			slot = (slot + 1) & (table.size() - 1);
		}
		if (table[slot] < 0) {
			// Never ahead of i, so what is overwritten has been read already.
			for (int k = 0; k < 3; ++k)
				positions[3 * kept + k] = positions[3 * i + k];
			table[slot] = std::int32_t(kept++);
		}
		vertexOf[i] = table[slot];
	}
	positions.resize(3 * kept);
	return vertexOf;
}

} // namespace

void weldEqualPositions(InputMesh& mesh)
{
	const std::vector<std::int32_t> vertexOf =
		mesh.doublePrecision ? packDistinct(mesh.doubles) : packDistinct(mesh.floats);
	for (std::int32_t& corner : mesh.triangles)
		corner = vertexOf[std::size_t(corner)];
}

} // namespace gpr::app
