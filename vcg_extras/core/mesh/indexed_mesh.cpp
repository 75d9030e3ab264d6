// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "indexed_mesh.h"

#include "half_edge_mesh.h"

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
	// A surface near the origin keeps its coordinates, so that float input stays exact; only far
	// offsets (georeferenced scans) are subtracted.
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
	to.meetings   = from.meetings;
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

std::int64_t renameCorners(IndexedMesh& mesh, const std::vector<int>& newName, Workers& workers)
{
	workers.forEach(std::size_t(3) * mesh.faceNum,
					[&](int h) { mesh.triangle[h] = newName[mesh.triangle[h]]; });
	const std::vector<int> kept    = workers.collectIf(mesh.faceNum, [&](int f) {
        const int* corner = &mesh.triangle[3 * f];
        return corner[0] != corner[1] && corner[1] != corner[2] && corner[2] != corner[0];
    });
	const std::int64_t     dropped = mesh.faceNum - std::int64_t(kept.size());
	if (dropped > 0) keepFaces(mesh, kept, workers);
	return dropped;
}

void dropUnusedVertices(IndexedMesh& mesh, Workers& workers)
{
	Buffer<int> numberUpTo(mesh.vertexNum, 0); // number of used vertices up to each vertex
	workers.forEach(std::size_t(3) * mesh.faceNum, [&](int h) {
		__atomic_store_n(&numberUpTo[mesh.triangle[h]], 1, __ATOMIC_RELAXED);
	});
	const int kept = workers.sumUp(numberUpTo.data(), mesh.vertexNum);
	if (kept == mesh.vertexNum) return;
	Buffer<Vec3f> position(kept);
	workers.forEach(mesh.vertexNum, [&](int v) {
		const int before = v == 0 ? 0 : numberUpTo[v - 1];
		if (numberUpTo[v] > before) position[before] = mesh.position[v];
	});
	mesh.position.swap(position);
	mesh.vertexNum = kept;
	workers.forEach(std::size_t(3) * mesh.faceNum,
					[&](int h) { mesh.triangle[h] = numberUpTo[mesh.triangle[h]] - 1; });
}

} // namespace gpr
