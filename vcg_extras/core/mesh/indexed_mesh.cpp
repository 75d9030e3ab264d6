// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "indexed_mesh.h"

#include "half_edge_mesh.h"

#include <algorithm>
#include <cmath>

namespace gpr {

namespace {

double scaleFor(double extent)
{
	int exponent = 0;
	std::frexp(extent, &exponent);
	return std::ldexp(1.0, -exponent);
}

double largestCoordinate(const Box<double>& box)
{
	double most = 0;
	for (const Vec3d& p : {box.low, box.high}) {
		for (double c : {p.x, p.y, p.z})
			most = std::max(most, std::abs(c));
	}
	return most;
}

} // namespace

bool canBeFramed(const Box<double>& box)
{
	const double extent = box.largestSide();
	return extent > 0 && std::isfinite(extent) && std::isfinite(scaleFor(extent));
}

Frame frameOf(const Box<double>& box)
{
	Frame        frame;
	const double extent = box.largestSide();
	// Coordinates that lie near the surface's own size stay as they are, so that float input is
	// taken over exactly; only far offsets (georeferenced scans) are removed.
	if (largestCoordinate(box) > 4 * extent) frame.origin = (box.low + box.high) * 0.5;
	frame.scale = scaleFor(extent);
	return frame;
}

IndexedMesh copyOf(const IndexedMesh& from, Workers& workers)
{
	IndexedMesh to;
	to.frame      = from.frame;
	to.vertexNum  = from.vertexNum;
	to.faceNum    = from.faceNum;
	to.position   = copyOf(from.position, workers);
	to.triangle   = copyOf(from.triangle, workers);
	to.sourceFace = copyOf(from.sourceFace, workers);
	to.size       = copyOf(from.size, workers);
	return to;
}

Vec3f inward(const IndexedMesh& mesh, int h)
{
	const Vec3f a = mesh.position[mesh.triangle[h]];
	const Vec3f e = normalized(mesh.position[mesh.triangle[nextInFace(h)]] - a);
	return normalized(tangential(mesh.position[mesh.triangle[prevInFace(h)]] - a, e));
}

Buffer<int> keepFaces(IndexedMesh& mesh, const std::vector<int>& kept, Workers& workers)
{
	Buffer<int> newFace(mesh.faceNum), triangle(3 * kept.size()), sourceFace(kept.size());
	workers.forEach(mesh.faceNum, [&](int f) { newFace[f] = -1; });
	workers.forEach(kept.size(), [&](int i) {
		newFace[kept[i]] = i;
		std::copy_n(&mesh.triangle[3 * kept[i]], 3, &triangle[3 * i]);
		sourceFace[i] = mesh.sourceFace[kept[i]];
	});
	mesh.triangle.swap(triangle);
	mesh.sourceFace.swap(sourceFace);
	mesh.faceNum = int(kept.size());
	return newFace;
}

std::int64_t renameCorners(IndexedMesh& mesh, const std::vector<int>& newName)
{
	int faces = 0;
	for (int f = 0; f < mesh.faceNum; ++f) {
		int corner[3];
		for (int k = 0; k < 3; ++k)
			corner[k] = newName[mesh.triangle[3 * f + k]];
		if (corner[0] == corner[1] || corner[1] == corner[2] || corner[2] == corner[0]) continue;
		for (int k = 0; k < 3; ++k)
			mesh.triangle[3 * faces + k] = corner[k];
		mesh.sourceFace[faces++] = mesh.sourceFace[f];
	}
	const std::int64_t dropped = mesh.faceNum - faces;
	mesh.faceNum               = faces;
	return dropped;
}

void dropUnusedVertices(IndexedMesh& mesh)
{
	std::vector<int> rename(mesh.vertexNum, -1);
	for (int i = 0; i < 3 * mesh.faceNum; ++i)
		rename[mesh.triangle[i]] = 0;
	int kept = 0;
	for (int v = 0; v < mesh.vertexNum; ++v) {
		if (rename[v] < 0) continue;
		rename[v]             = kept;
		mesh.position[kept++] = mesh.position[v];
	}
	mesh.vertexNum = kept;
	for (int i = 0; i < 3 * mesh.faceNum; ++i)
		mesh.triangle[i] = rename[mesh.triangle[i]];
}

} // namespace gpr
