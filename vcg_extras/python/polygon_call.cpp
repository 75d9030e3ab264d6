// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "polygon_call.h"

#include <vcg_extras/io/mesh/polygon.h>

namespace gpr::python {

namespace {

using Corners = std::vector<std::int64_t>;

/// Calls visit(first corner, number of corners) for every polygon.
template <class Visit>
void forEachPolygon(const Indices& sizes, const Visit& visit)
{
	std::size_t begin = 0;
	for (std::size_t i = 0; i < sizes.shape(0); ++i) {
		const std::size_t size = std::size_t(sizes.data()[i]);
		visit(begin, size);
		begin += size;
	}
}

void checkCorners(const MeshView& mesh, const Indices& corners, const Indices& sizes)
{
	std::int64_t sum = 0;
	for (std::size_t i = 0; i < sizes.shape(0); ++i) {
		if (sizes.data()[i] < 3) throw nb::value_error("A polygon has fewer than three corners.");
		sum += sizes.data()[i];
	}
	if (sum != std::int64_t(corners.shape(0))) throw nb::value_error("The corners do not add up.");
	for (std::size_t c = 0; c < corners.shape(0); ++c) {
		if (corners.data()[c] < 0 || std::size_t(corners.data()[c]) >= mesh.vertexNum)
			throw nb::value_error("A corner is no vertex.");
	}
}

void addTriangles(const Indices& sizes, Corners& out)
{
	forEachPolygon(sizes, [&](std::size_t begin, std::size_t size) {
		for (std::size_t k = 0; size == 3 && k < 3; ++k)
			out.push_back(std::int64_t(begin + k));
	});
}

void addLargerOnes(const MeshView& mesh, const Indices& corners, const Indices& sizes, Corners& out)
{
	std::vector<Vec3d>       at;
	std::vector<std::size_t> cut;
	forEachPolygon(sizes, [&](std::size_t begin, std::size_t size) {
		if (size == 3) return;
		at.clear();
		for (std::size_t k = begin; k < begin + size; ++k)
			at.push_back(mesh.position(std::size_t(corners.data()[k])));
		app::cutPolygon(at, cut);
		for (const std::size_t c : cut)
			out.push_back(std::int64_t(begin + c));
	});
}

} // namespace

nb::object cutPolygons(const Positions& positions, const Indices& corners, const Indices& sizes)
{
	Corners triangles;
	{
		const nb::gil_scoped_release noLock;
		const MeshView               mesh = viewOf(positions);
		checkCorners(mesh, corners, sizes);
		addTriangles(sizes, triangles);
		addLargerOnes(mesh, corners, sizes, triangles);
	}
	return toNumpy(std::move(triangles));
}

} // namespace gpr::python
