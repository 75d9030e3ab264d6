// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "distance_accuracy.h"

#include "exact_distances.h"

#include <tests/support/random_source.h>
#include <vcg_extras/core/input/load.h>
#include <vcg_extras/core/input/split_long_edges.h>
#include <vcg_extras/core/surface/disk_flood.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

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

/// Adds the vertices of one disk; mean and above5Percent are sums meanwhile.
void addDisk(const ExactDistances& exact, const NearestField& field, double radius, Accuracy& sum)
{
	for (const auto& [v, d] : exact.all()) {
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
	field.trial        = Buffer<NearestField::Trial>(std::size_t(m.vertexNum), {0, 0});
	const float radius = float(reach) * ground.radius;
	DiskFlood   flood(FloodGround{m, ground.surface.normal, nullptr, metric == Metric::Default},
					  field, radius);
	for (int i = 0; i < sourceNum; ++i) {
		const Sample sample = randomSample(m, random);
		field.nearest.fill({HUGE_VALF, -1});
		flood.run(0, sample);
		addDisk(ExactDistances(m, sample.point, double(radius)), field, double(radius), sum);
	}
	sum.mean /= double(std::max<std::int64_t>(1, sum.vertexNum));
	sum.above5Percent /= double(std::max<std::int64_t>(1, sum.vertexNum));
	return sum;
}

} // namespace gpr::test
