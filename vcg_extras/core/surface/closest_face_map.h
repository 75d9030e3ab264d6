// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_SURFACE_CLOSEST_FACE_MAP_H
#define VCG_EXTRAS_CORE_SURFACE_CLOSEST_FACE_MAP_H

#include "result_mesh.h"

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/connect.h>

#include <cstdint>
#include <cstring>
#include <vector>

namespace gpr {

/// A number of at least 0 in 16 bits: a float without its sign and its last 15 bits, true to 0.2 %.
class PackedMeasure {
public:
	PackedMeasure() = default;
	explicit PackedMeasure(float x)
	{
		std::uint32_t bits;
		std::memcpy(&bits, &x, sizeof bits);
		upper_ = std::uint16_t((bits + 0x4000) >> 15);
	}

	float value() const
	{
		const std::uint32_t bits = std::uint32_t(upper_) << 15;
		float               x;
		std::memcpy(&x, &bits, sizeof x);
		return x;
	}

private:
	std::uint16_t upper_;
};

/// What each triangle of the result stands for: every vertex of the input belongs to the triangle
/// nearest to it, found by walking over the triangles from its former one, so that a sheet that
/// only looks near is never taken. 10 B per vertex of the input.
class ClosestFaceMap {
public:
	/// Finds the map, starting from a flood over the input from the result's surface points.
	/// Cost: linear in the input, parallel.
	ClosestFaceMap(const Surface& surface, const ResultMesh& result, Workers& workers);

	/// Brings the map up to date after vertices of the result moved. The faces must be the same.
	/// Cost: a look at every vertex of the input, and a walk for the few that change their face;
	/// parallel.
	void update(const ResultMesh& result, Workers& workers);

	/// The vertices of the input that belong to face f of the result, in an order that does not
	/// depend on the threads. Those that no surface point reaches belong to none.
	const int* begin(int f) const { return item_.data() + start_[f]; }
	const int* end(int f) const { return item_.data() + start_[f + 1]; }

	/// The input's area round p: a third of its faces', working units squared.
	float area(int p) const { return area_[p].value(); }

	/// Gives back all but the lists of begin() and end(): 6 B per vertex of the input.
	void keepListsOnly();

private:
	/// A vertex of the input that is to change its face.
	struct Leaver {
		int vertex, toFace;
	};

	const Surface&        surface_;
	Buffer<PackedMeasure> area_;
	Buffer<int>           start_; ///< per face of the result: where its vertices begin in item_
	Buffer<int>           item_;

	void                measureAreas(Workers& workers);
	std::vector<Leaver> takeLeavers(const HalfEdgeMesh& result, Workers& workers);
	void                takeIn(const std::vector<Leaver>& leavers, Workers& workers);
};

/// A vertex of the result near each vertex of the input, by a breadth-first flood over the input
/// from all surface points at once; -1 where none comes to. Cost: linear, parallel.
Buffer<int> floodFromPoints(const Surface& surface, const ResultMesh& result, Workers& workers);

} // namespace gpr

#endif
