// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "stages.h"

#include "transforms.h"

#include <vcg_extras/core/input/load.h>
#include <vcg_extras/core/input/repair_manifold.h>
#include <vcg_extras/core/mesh/spatial_order.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

namespace gpr::test {

IndexedMesh loaded(const TriangleMesh& mesh, Workers& workers)
{
	CleanCounts counts;
	return loadInput(mesh.view(), workers, counts);
}

Buffer<char> edgesThatTurn(const Surface& surface, double degrees)
{
	const HalfEdgeMesh& m = surface.mesh;
	Buffer<char>        turns(std::size_t(m.halfEdgeNum()), char(0));
	for (int h = 0; h < m.halfEdgeNum(); ++h) {
		if (m.isBorderEdge(h)) continue;
		const float cosine = dot(m.faceNormal(h / 3), m.faceNormal(m.opposite[h] / 3));
		turns[h]           = cosine < float(std::cos(degrees * pi / 180));
	}
	return turns;
}

Surface surfaceOf(const TriangleMesh& mesh, Workers& workers)
{
	return surfaceOf(loaded(mesh, workers), workers);
}

Surface surfaceOf(IndexedMesh&& indexed, Workers& workers)
{
	Buffer<int> faceStart;
	Surface     surface;
	surface.grid = orderSpatially(indexed, workers, faceStart);
	if (!connect(indexed, faceStart, workers, surface)) throw std::logic_error("not manifold");
	return surface;
}

void repair(IndexedMesh& mesh, Workers& workers, CleanCounts& counts, bool keepsPlaces)
{
	Buffer<int> faceStart;
	Surface     surface;
	orderSpatially(mesh, workers, faceStart);
	const bool  isManifold = connect(mesh, faceStart, workers, surface);
	Buffer<int> link       = std::move(surface.mesh.opposite);
	if (isManifold) mesh = disconnect(surface);
	repairManifold(mesh, link, JunctionMode::Cut, keepsPlaces, workers, counts);
}

HalfEdgeMesh halfEdgesOf(const TriangleMesh& mesh, int spareVertices, int spareFaces)
{
	HalfEdgeMesh m;
	m.vertexNum = int(mesh.vertexNum());
	m.faceNum   = int(mesh.faceNum());
	m.position.reset(mesh.vertexNum() + std::size_t(spareVertices));
	m.outgoing = Buffer<int>(mesh.vertexNum() + std::size_t(spareVertices), -1);
	m.origin   = Buffer<int>(3 * (mesh.faceNum() + std::size_t(spareFaces)), -1);
	m.opposite = Buffer<int>(3 * (mesh.faceNum() + std::size_t(spareFaces)), -1);
	for (std::size_t v = 0; v < mesh.vertexNum(); ++v)
		m.position[v] = Vec3f(mesh.positions[v]);
	std::copy(mesh.triangles.begin(), mesh.triangles.end(), m.origin.begin());

	std::map<std::pair<int, int>, int> byEnds;
	for (int h = 0; h < m.halfEdgeNum(); ++h)
		byEnds[{m.origin[h], m.target(h)}] = h;
	for (const auto& [ends, h] : byEnds) {
		const auto found = byEnds.find({ends.second, ends.first});
		m.opposite[h]    = found == byEnds.end() ? -1 : found->second;
	}
	for (int h = 0; h < m.halfEdgeNum(); ++h) {
		int& out = m.outgoing[m.origin[h]];
		if (out < 0 || m.opposite[h] < 0) out = h;
	}
	return m;
}

namespace {

template <class T>
Buffer<T> copyOf(const Buffer<T>& buffer)
{
	Buffer<T> copy(buffer.size());
	std::copy(buffer.begin(), buffer.end(), copy.begin());
	return copy;
}

} // namespace

HalfEdgeMesh copyOf(const HalfEdgeMesh& mesh)
{
	HalfEdgeMesh copy;
	copy.vertexNum = mesh.vertexNum;
	copy.faceNum   = mesh.faceNum;
	copy.position  = copyOf(mesh.position);
	copy.origin    = copyOf(mesh.origin);
	copy.opposite  = copyOf(mesh.opposite);
	copy.outgoing  = copyOf(mesh.outgoing);
	if (mesh.hasCreases()) copy.crease = copyOf(mesh.crease);
	return copy;
}

ResultMesh resultOf(const Surface& surface, const BoundaryCurves& boundary)
{
	const HalfEdgeMesh& m = surface.mesh;
	ResultMesh          result;
	result.mesh = copyOf(m);
	result.vertex.resize(m.vertexNum);
	double area = 0;
	for (int f = 0; f < m.faceNum; ++f)
		area += 0.5 * double(length(m.faceCross(f)));
	result.idealEdge = float(std::sqrt(2 * area / (std::sqrt(3.0) * m.vertexNum)));
	for (int v = 0; v < m.vertexNum; ++v) {
		const int face          = m.outgoing[v] / 3;
		result.vertex[v].point  = {m.position[v], face};
		result.vertex[v].normal = m.faceNormal(face);
	}
	for (std::size_t c = 0; c < boundary.curves.size(); ++c) {
		const Curve& curve = boundary.curves[c];
		for (int i = 0; i < curve.pointNum(); ++i) {
			ResultVertex& v = result.vertex[curve.vertex[i]];
			v.curve         = int(c);
			v.arc           = curve.arc[i];
			v.point.face    = curve.faceAt(curve.arc[i]);
		}
	}
	return result;
}

TriangleMesh meshOf(const HalfEdgeMesh& m)
{
	TriangleMesh mesh;
	for (int v = 0; v < m.vertexNum; ++v)
		mesh.positions.push_back(Vec3d(m.position[v]));
	for (int f = 0; f < m.faceNum; ++f) {
		if (m.origin[3 * f] < 0) continue;
		for (int k = 0; k < 3; ++k)
			mesh.triangles.push_back(m.origin[3 * f + k]);
	}
	return withoutUnused(mesh);
}

TriangleMesh meshOf(const IndexedMesh& m)
{
	TriangleMesh mesh;
	for (int v = 0; v < m.vertexNum; ++v)
		mesh.positions.push_back(Vec3d(m.position[v]));
	mesh.triangles.assign(m.triangle.data(), m.triangle.data() + 3 * std::size_t(m.faceNum));
	return mesh;
}

SampledDistance sampledBetween(const HalfEdgeMesh& input, const HalfEdgeMesh& result,
							   Workers& workers)
{
	const MeasuredSurface from(viewOf(input), workers), to(viewOf(result), from, workers);
	return sampledDistance({input, from}, {result, to}, 10, workers);
}

} // namespace gpr::test
