// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "distance_accuracy.h"

#include "exact_distances.h"

#include <tests/support/mesh_builders.h>
#include <tests/support/random_source.h>
#include <tests/support/split_edges.h>
#include <tests/support/stages.h>
#include <vcg_extras/core/input/load.h>
#include <vcg_extras/core/surface/disk_flood.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

namespace gpr::test {

namespace {

/// A random point of the surface, faces alike.
Sample randomSample(const HalfEdgeMesh& m, Random& random)
{
	const int f = random.below(m.faceNum);
	float     u = float(random.unit()), v = float(random.unit());
	if (u + v > 1) u = 1 - u, v = 1 - v;
	const Vec3f a = m.position[m.origin[3 * f]];
	const Vec3f p =
		a + (m.position[m.origin[3 * f + 1]] - a) * u + (m.position[m.origin[3 * f + 2]] - a) * v;
	return {{p, f}, m.faceNormal(f)};
}

/// Adds the vertices of a disk with their exact distances; meanwhile mean and above5Percent are
/// sums.
template <class Exact>
void addDisk(const Exact& exact, const NearestField& field, double radius, Accuracy& sum)
{
	for (const auto& [v, d] : exact) {
		if (!(d > 0)) continue;
		const NearestField::Nearest& near = field.nearest[v];
		if (near.sample < 0) {
			sum.unreachedNum += d < 0.95 * radius;
			continue;
		}
		const double error = double(near.distance) / d - 1;
		++sum.vertexNum;
		sum.mean += std::abs(error);
		sum.largestOver  = std::max(sum.largestOver, error);
		sum.largestUnder = std::min(sum.largestUnder, error);
		sum.above5Percent += std::abs(error) > 0.05;
	}
}

void makeMeans(Accuracy& sum)
{
	const double num = double(std::max<std::int64_t>(1, sum.vertexNum));
	sum.mean /= num;
	sum.above5Percent /= num;
}

/// The half-plane of Poincaré: lengths at height y are divided by y.
double onHyperbolicPlane(const Vec3d& a, const Vec3d& b)
{
	const Vec3d way = b - a;
	return std::acosh(1 + dot(way, way) / (2 * a.y * b.y));
}

/// The part of the half-plane over [0, 1] × [0.25, 1].
TriangleMesh halfPlane(int cellNum, double jitter, Random& random)
{
	TriangleMesh mesh = jitteredGrid(cellNum, jitter, random);
	for (Vec3d& p : mesh.positions)
		p.y = 0.25 + 0.75 * p.y;
	return mesh;
}

/// Whether the part contains a disk of this hyperbolic radius about p, with all shortest ways in
/// the disk.
bool holdsDisk(const Vec3d& p, double radius)
{
	const double width = p.y * std::sinh(radius);
	return p.x > width && p.x < 1 - width && p.y * std::exp(-radius) > 0.25 &&
		   p.y * std::exp(radius) < 1;
}

} // namespace

Ground::Ground(const MeshView& mesh, double percent)
{
	Workers      workers(2, nullptr);
	CleanCounts  counts;
	IndexedMesh  indexed = loadInput(mesh, workers, counts);
	const double n       = percent / 100 * double(mesh.vertexNum);
	const double densest =
		std::sqrt(2 * measureFaces(indexed, workers).area / (std::sqrt(3.0) * n));
	radius = float(0.962 * densest); // eq. (1)
	splitLongEdges(indexed, 0.8f * radius, 1 << 30, workers);
	Buffer<int> faceStart;
	surface.grid = orderSpatially(indexed, workers, faceStart);
	if (!connect(indexed, faceStart, workers, surface)) throw std::logic_error("not manifold");
}

Accuracy measureAccuracy(const Ground& ground, Metric metric, double reach, int sourceNum,
						 std::uint32_t seed)
{
	const HalfEdgeMesh& m = ground.surface.mesh;
	Random              random(seed);
	Accuracy            sum;
	NearestField        field;
	field.nearest.reset(m.vertexNum);
	field.mark         = Buffer<NearestField::Mark>(std::size_t(m.vertexNum), {0, 0});
	const float radius = float(reach) * ground.radius;
	DiskFlood   flood(FloodGround{m, ground.surface.normal, nullptr, metric == Metric::Default},
					  field, radius);
	for (int i = 0; i < sourceNum; ++i) {
		const Sample sample = randomSample(m, random);
		field.nearest.fill({HUGE_VALF, -1});
		flood.run(0, sample);
		addDisk(ExactDistances(m, sample.point, double(radius)).all(), field, double(radius), sum);
	}
	makeMeans(sum);
	return sum;
}

Accuracy measureUnderStretch(int cellNum, double radius, int sourceNum, std::uint32_t seed)
{
	constexpr double    jitter = 0.3;
	Random              random(seed);
	Workers             workers(2, nullptr);
	const Surface       surface = surfaceOf(halfPlane(cellNum, jitter, random), workers);
	const HalfEdgeMesh& m       = surface.mesh;
	const auto          place   = [&](const Vec3f& p) { return surface.frame.toCaller(p); };
	Buffer<float>       stretch(std::size_t(m.vertexNum));
	for (int v = 0; v < m.vertexNum; ++v)
		stretch[v] = float(1 / place(m.position[v]).y);
	NearestField field;
	field.nearest.reset(m.vertexNum);
	field.mark          = Buffer<NearestField::Mark>(std::size_t(m.vertexNum), {0, 0});
	const double inUnit = radius * surface.frame.scale;
	DiskFlood    flood(FloodGround{m, surface.normal, &stretch, false}, field, float(inUnit));
	Accuracy     sum;
	for (int disk = 0; disk < sourceNum;) {
		const Sample sample = randomSample(m, random);
		const Vec3d  source = place(sample.point.position);
		if (!holdsDisk(source, radius)) continue;
		++disk;
		field.nearest.fill({HUGE_VALF, -1});
		flood.run(0, sample);
		std::vector<std::pair<int, double>> exact;
		for (int v = 0; v < m.vertexNum; ++v) {
			const double d = onHyperbolicPlane(source, place(m.position[v]));
			if (d < radius) exact.push_back({v, d * surface.frame.scale});
		}
		addDisk(exact, field, inUnit, sum);
	}
	makeMeans(sum);
	return sum;
}

} // namespace gpr::test
