// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "relaxation.h"

#include "move_guard.h"

#include <vcg_extras/core/mesh/sectors.h>
#include <vcg_extras/core/sampling/sizing.h>
#include <vcg_extras/core/surface/walk.h>

namespace gpr {

namespace {

/// Weight of area where the triangles are to be of this size. Lloyd's theory asks for the fourth
/// power of 1/size for the density of the area; for barycentres of rings, whose faces are small
/// already where they are to be small, the third power keeps the grading (docs/algorithm.md).
float densityOfSize(float size)
{
	return 1 / (size * size * size);
}

/// Per vertex of the result; empty where the triangles are to be of one size.
Buffer<float> findDensities(const Surface& surface, const ResultMesh& result, Workers& workers)
{
	Buffer<float> density = sizesOf(surface, result, workers);
	for (float& d : density)
		d = densityOfSize(d);
	return density;
}

/// The faces round a vertex, read once for all that a step wants to know: the ring is what costs.
class Ring {
public:
	void gather(const HalfEdgeMesh& m, int v)
	{
		sum_ = {};
		faces_.clear();
		forEachFaceRound(m, v, [&](int h, const Vec3f& a, const Vec3f& b) {
			faces_.push_back({h, a + b, cross(a, b)});
			sum_ += faces_.back().cross;
		});
	}

	/// Whether the faces lie within about 37° of their mean normal: isFlat() of a vertex that is on
	/// no feature line.
	bool isFlatFan() const
	{
		const float limit = flatCosine * flatCosine * squaredLength(sum_);
		bool        flat  = squaredLength(sum_) > 0;
		for (const Face& f : faces_) {
			const float d = dot(f.cross, sum_);
			flat          = flat && d > 0 && d * d >= limit * squaredLength(f.cross);
		}
		return flat;
	}

	/// From v to the barycentre of the ring, weighted by area and density.
	Vec3f wayToBarycentre(const HalfEdgeMesh& m, int v, const Buffer<float>& density) const
	{
		Vec3f sum;
		float weight = 0;
		for (const Face& f : faces_) {
			float area = length(f.cross);
			if (!density.empty())
				area *= density[v] + density[m.target(f.halfEdge)] + density[m.apex(f.halfEdge)];
			sum += f.middle * (area / 3);
			weight += area;
		}
		return weight > 0 ? sum * (1 / weight) : Vec3f();
	}

private:
	struct Face {
		int   halfEdge;
		Vec3f middle; ///< sum of the other corners, seen from the vertex
		Vec3f cross;
	};
	std::vector<Face> faces_;
	Vec3f             sum_; ///< of the cross products
};

/// The vertex after a walk.
ResultVertex walked(const Surface& surface, ResultVertex vertex, const Vec3f& step)
{
	walk(surface.mesh, vertex.anchor, step);
	vertex.normal = surface.mesh.faceNormal(vertex.anchor.face);
	return vertex;
}

} // namespace

Vec3f wayToBarycentre(const HalfEdgeMesh& m, int v, const Buffer<float>& density)
{
	Ring ring;
	ring.gather(m, v);
	return ring.wayToBarycentre(m, v, density);
}

Buffer<char> findFlatVertices(const ResultMesh& result, Workers& workers)
{
	Buffer<char> flat(result.mesh.vertexNum);
	workers.forRange(flat.size(), [&](std::size_t begin, std::size_t end) {
		for (std::size_t v = begin; v < end; ++v)
			flat[v] = isFlat(result.mesh, int(v));
	});
	return flat;
}

void relaxOnce(const Surface& surface, ResultMesh& result, Workers& workers)
{
	const HalfEdgeMesh& m       = result.mesh;
	const Buffer<float> density = findDensities(surface, result, workers);
	MoveGuard           guard(result, workers);
	workers.forRange(m.vertexNum, [&](std::size_t begin, std::size_t end) {
		Ring ring;
		for (int v = int(begin); v < int(end); ++v) {
			if (!isFree(result, v)) continue;
			ring.gather(m, v);
			if (!ring.isFlatFan()) continue;
			const ResultVertex& here = result.vertex[v];
			const Vec3f         step = tangential(ring.wayToBarycentre(m, v, density), here.normal);
			if (squaredLength(step) > 0) guard.propose(v, walked(surface, here, step));
		}
	});
	guard.move();
}

} // namespace gpr
