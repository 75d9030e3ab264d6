// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface_distance.h"

#include "distance_histogram.h"
#include "even_points.h"

#include <algorithm>
#include <cmath>

namespace gpr {

namespace {

struct DistanceSums {
	double squares = 0, max = 0;

	void add(double distance)
	{
		squares += distance * distance;
		max = std::max(max, distance);
	}
	DistanceSums& operator+=(const DistanceSums& o)
	{
		squares += o.squares;
		max = std::max(max, o.max);
		return *this;
	}
};

Vec3d firstCorner(const MeshView& mesh)
{
	for (std::size_t f = 0; f < mesh.faceNum; ++f)
		if (isUsableFace(mesh, f)) return mesh.position(std::size_t(mesh.vertexOf(3 * f)));
	return {};
}

/// The usable faces, with positions relative to origin so that no digit is lost to an offset.
HalfEdgeMesh cornersOf(const MeshView& mesh, const Vec3d& origin)
{
	HalfEdgeMesh to;
	to.vertexNum = int(mesh.vertexNum);
	to.position.reset(mesh.vertexNum);
	for (std::size_t v = 0; v < mesh.vertexNum; ++v)
		to.position[v] = Vec3f(mesh.position(v) - origin);
	to.origin.reset(3 * mesh.faceNum);
	for (std::size_t f = 0; f < mesh.faceNum; ++f) {
		if (!isUsableFace(mesh, f)) continue;
		for (std::size_t k = 0; k < 3; ++k)
			to.origin[3 * std::size_t(to.faceNum) + k] = mesh.vertexOf(3 * f + k);
		++to.faceNum;
	}
	return to;
}

std::vector<char> usedVertices(const MeshView& mesh)
{
	std::vector<char> used(mesh.vertexNum, 0);
	for (std::size_t f = 0; f < mesh.faceNum; ++f) {
		if (!isUsableFace(mesh, f)) continue;
		for (std::size_t k = 0; k < 3; ++k)
			used[std::size_t(mesh.vertexOf(3 * f + k))] = 1;
	}
	return used;
}

} // namespace

SurfaceDistance distanceOfEvenPoints(const MeshView& mesh, std::int64_t pointNum,
									 const std::function<double(const Vec3d&)>& distance,
									 Workers&                                   workers)
{
	const EvenPoints points(mesh, pointNum);
	if (points.num() == 0) return {};
	DistanceHistogram  histogram;
	const DistanceSums sums =
		workers.sum<DistanceSums>(points.num(), [&](std::size_t begin, std::size_t end) {
			DistanceSums part;
			points.forEach(begin, end, [&](const Vec3d& p) {
				const double d = distance(p);
				part.add(d);
				histogram.add(d);
			});
			return part;
		});
	return {std::sqrt(sums.squares / double(points.num())), histogram.p999(sums.max), sums.max};
}

NearSurface::NearSurface(const MeshView& mesh, Workers& workers) :
		origin_(firstCorner(mesh)), faces_(cornersOf(mesh, origin_)), tree_(faces_, &workers)
{
}

double NearSurface::distance(const Vec3d& p) const
{
	const Vec3f local(p - origin_);
	return double(length(tree_.nearest(local).position - local));
}

double NearSurface::meanSquareOver(const MeshView& mesh, std::size_t face) const
{
	const auto  t      = mesh.triangle(face);
	const Vec3d p[3]   = {mesh.position(std::size_t(t[0])), mesh.position(std::size_t(t[1])),
						  mesh.position(std::size_t(t[2]))};
	const auto  square = [&](const Vec3d& q) {
        const double d = distance(q);
        return d * d;
	};
	double mean = 9.0 / 20 * square((p[0] + p[1] + p[2]) * (1.0 / 3));
	for (int k = 0; k < 3; ++k)
		mean += square(p[k]) / 20 + 2 * square((p[k] + p[(k + 1) % 3]) * 0.5) / 15;
	return mean;
}

std::vector<float> NearSurface::ofFaces(const MeshView& mesh, Workers& workers) const
{
	std::vector<float> distances(mesh.faceNum, 0);
	if (faces_.faceNum == 0) return distances;
	workers.forRange(mesh.faceNum, [&](std::size_t begin, std::size_t end) {
		for (std::size_t f = begin; f < end; ++f)
			if (isUsableFace(mesh, f)) distances[f] = float(std::sqrt(meanSquareOver(mesh, f)));
	});
	return distances;
}

double NearSurface::largestOfVertices(const MeshView& mesh, Workers& workers) const
{
	const std::vector<char> used = usedVertices(mesh);
	return workers
		.sum<DistanceSums>(mesh.vertexNum,
						   [&](std::size_t begin, std::size_t end) {
							   DistanceSums part;
							   for (std::size_t v = begin; v < end; ++v)
								   if (used[v] != 0) part.add(distance(mesh.position(v)));
							   return part;
						   })
		.max;
}

SurfaceDistance NearSurface::from(const MeshView& mesh, std::int64_t pointNum,
								  Workers& workers) const
{
	if (faces_.faceNum == 0) return {};
	SurfaceDistance d = distanceOfEvenPoints(
		mesh, pointNum, [this](const Vec3d& p) { return distance(p); }, workers);
	d.max = std::max(d.max, largestOfVertices(mesh, workers));
	return d;
}

} // namespace gpr
