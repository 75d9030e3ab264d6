// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "load.h"

#include <vcg_extras/core/base/box.h>
#include <vcg_extras/core/base/failure.h>
#include <vcg_extras/core/base/poller.h>
#include <vcg_extras/core/results.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace gpr {

namespace {

void refuseHugeInput(const MeshView& input)
{
	// Half-edges have numbers of 32 bits; a factor of two is left for splitting.
	constexpr std::size_t maxFaces = std::size_t(1) << 29;
	if (input.faceNum > maxFaces || input.vertexNum > maxFaces) {
		throw Failure(Status::UnusableInput,
					  "The mesh has more than 536,870,912 faces or vertices.");
	}
}

bool repeatsIndex(const std::array<std::int32_t, 3>& corner)
{
	return corner[0] == corner[1] || corner[1] == corner[2] || corner[2] == corner[0];
}

std::int64_t nonFiniteNum(const MeshView& input, Workers& workers)
{
	return workers.sumEach<std::int64_t>(
		input.vertexNum, [&](int v, std::int64_t& num) { num += !isFinite(input.position(v)); });
}

/// Room for the few faces and vertices added to most scans by splitting long edges. Untouched
/// memory costs nothing.
std::size_t withRoom(std::size_t n)
{
	return n + n / 32;
}

/// Copies the usable faces in their order; sourceFace is the face of the input.
void copyFaces(const MeshView& input, Workers& workers, IndexedMesh& mesh, CleanCounts& counts)
{
	mesh.triangle.reset(withRoom(3 * input.faceNum));
	mesh.sourceFace.reset(withRoom(input.faceNum));
	mesh.faceNum = int(input.faceNum);
	counts.repeatedIndexFaces +=
		workers.sumEach<std::int64_t>(input.faceNum, [&](int f, std::int64_t& n) {
			const auto corner = input.triangle(f);
			std::copy(corner.begin(), corner.end(), &mesh.triangle[3 * f]);
			mesh.sourceFace[f] = f;
			n += repeatsIndex(corner);
		});
	if (counts.repeatedIndexFaces == 0 && counts.nonFiniteVertices == 0) return;
	const std::vector<int> usable = workers.collectIf(input.faceNum, [&](int f) {
		const auto corner = input.triangle(f);
		return !repeatsIndex(corner) &&
			   std::all_of(corner.begin(), corner.end(),
						   [&](std::int32_t v) { return isFinite(input.position(v)); });
	});
	keepFaces(mesh, usable, workers);
}

/// Marks the vertices used by faces.
Buffer<char> findUsed(const IndexedMesh& mesh, std::size_t vertexNum, Workers& workers)
{
	Buffer<char> used(vertexNum, 0);
	// Relaxed atomic store: every thread writes the same 1.
	workers.forEach(std::size_t(3) * mesh.faceNum, [&](int c) {
		__atomic_store_n(&used[mesh.triangle[c]], char(1), __ATOMIC_RELAXED);
	});
	return used;
}

Box<double> boxOfUsed(const MeshView& input, const Buffer<char>& used, Workers& workers)
{
	return workers.sumEach<Box<double>>(input.vertexNum, [&](int v, Box<double>& box) {
		if (used[v]) box.add(input.position(v));
	});
}

Frame requireFrame(const Box<double>& box)
{
	if (canBeFramed(box)) return frameOf(box);
	const double extent = box.largestSide();
	const bool   isTiny = extent > 0 && std::isfinite(extent);
	throw Failure(Status::UnusableInput, isTiny ? "The surface is too small for the numbers."
												: "The surface has no area.");
}

/// Copies the used vertices in their order and renames the corners of faces.
void copyVertices(const MeshView& input, const Buffer<char>& used, Workers& workers,
				  IndexedMesh& mesh, CleanCounts& counts)
{
	mesh.vertexNum = int(input.vertexNum);
	mesh.position.reset(withRoom(input.vertexNum));
	workers.forEach(input.vertexNum, [&](int v) {
		if (used[v]) mesh.position[v] = mesh.frame.toWorking(input.position(v));
	});
	const std::int64_t unused = workers.sumEach<std::int64_t>(
		input.vertexNum, [&](int v, std::int64_t& n) { n += !used[v]; });
	if (unused > 0) dropUnusedVertices(mesh, workers);
	counts.unreferencedVertices = unused - counts.nonFiniteVertices;
}

bool isSoup(const IndexedMesh& mesh)
{
	// Every vertex is used: with 3 F vertices no two faces share a vertex.
	return mesh.faceNum > 1 && mesh.vertexNum == 3 * mesh.faceNum;
}

/// Joins vertices at (nearly) equal positions; drops faces that lose a corner.
void weld(IndexedMesh& mesh, Workers& workers, CleanCounts& counts)
{
	Poller           poller(workers);
	SamePlaceTable   table(std::size_t(mesh.vertexNum));
	std::vector<int> first;
	for (int v = 0; v < mesh.vertexNum; ++v) {
		poller.count();
		first.push_back(table.findOrPut(mesh.position[v], v));
		counts.weldedVertices += first.back() != v;
	}
	counts.zeroAreaFaces += renameCorners(mesh, first, workers);
	dropUnusedVertices(mesh, workers);
}

} // namespace

void requireVertexNumbers(const MeshView& input, Workers& workers)
{
	const auto         vertexNum = std::uint32_t(input.vertexNum);
	const std::int64_t badNum =
		workers.sumEach<std::int64_t>(input.faceNum, [&](int f, std::int64_t& bad) {
			for (std::int32_t v : input.triangle(f))
				bad += std::uint32_t(v) >= vertexNum;
		});
	if (badNum > 0)
		throw Failure(Status::UnusableInput, "A face names a vertex that does not exist.");
}

IndexedMesh loadInput(const MeshView& input, Workers& workers, CleanCounts& counts)
{
	refuseHugeInput(input);
	if (input.faceNum == 0) throw Failure(Status::UnusableInput, "The mesh has no faces.");
	requireVertexNumbers(input, workers);

	IndexedMesh mesh;
	counts.nonFiniteVertices = nonFiniteNum(input, workers);
	copyFaces(input, workers, mesh, counts);
	if (mesh.faceNum == 0) {
		throw Failure(Status::UnusableInput, "No face has three different, finite vertices.");
	}
	const Buffer<char> used = findUsed(mesh, input.vertexNum, workers);
	mesh.frame              = requireFrame(boxOfUsed(input, used, workers));
	if (input.mirrorAxis >= 0) setCoordinate(mesh.frame.origin, input.mirrorAxis, 0.0);
	copyVertices(input, used, workers, mesh, counts);
	if (isSoup(mesh)) weld(mesh, workers, counts);
	if (mesh.faceNum == 0) {
		throw Failure(Status::UnusableInput, "No face has an area.");
	}
	return mesh;
}

FaceExtents measureFaces(const IndexedMesh& mesh, Workers& workers)
{
	constexpr std::size_t together = FaceExtents::facesTogether;
	static_assert(Workers::pieceSize % together == 0);
	FaceExtents extents;
	extents.longestSquared.reset((std::size_t(mesh.faceNum) + together - 1) / together);
	extents.area = workers.sum<double>(mesh.faceNum, [&](std::size_t begin, std::size_t end) {
		double area = 0;
		for (std::size_t group = begin; group < end; group += together) {
			float longest = 0;
			for (std::size_t f = group; f < std::min(group + together, end); ++f) {
				const int*  corner = &mesh.triangle[3 * f];
				const Vec3f a = mesh.position[corner[0]], b = mesh.position[corner[1]],
							c = mesh.position[corner[2]];
				area += 0.5 * double(length(cross(b - a, c - a)));
				longest = std::max(
					{longest, squaredLength(b - a), squaredLength(c - b), squaredLength(a - c)});
			}
			extents.longestSquared[group / together] = longest;
		}
		return area;
	});
	return extents;
}

} // namespace gpr
