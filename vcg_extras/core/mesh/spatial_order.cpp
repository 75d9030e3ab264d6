// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "spatial_order.h"

#include <vcg_extras/core/base/box.h>

#include <algorithm>

namespace gpr {

namespace {

/// Inserts two zero bits after each of the lowest 21 bits of x.
std::uint64_t spreadBits(std::uint64_t x)
{
	x &= 0x1fffff;
	x = (x | x << 32) & 0x1f00000000ffffull;
	x = (x | x << 16) & 0x1f0000ff0000ffull;
	x = (x | x << 8) & 0x100f00f00f00f00full;
	x = (x | x << 4) & 0x10c30c30c30c30c3ull;
	x = (x | x << 2) & 0x1249249249249249ull;
	return x;
}

/// A key and an index in a single word, to move half the memory. Vertices and faces take at most 30
/// bits (see load.cpp), also as keys of faces; keys of cells take at most 33 bits.
constexpr int indexBits = 30;
using Keyed             = std::uint64_t;

Keyed keyed(std::uint64_t key, std::size_t index)
{
	return key << indexBits | index;
}
int indexOf(Keyed item)
{
	return int(item & ((Keyed(1) << indexBits) - 1));
}
std::uint64_t keyOf(Keyed item)
{
	return item >> indexBits;
}

/// Stable radix sort by the lowest `bits` bits of the keys, in the fewest passes with digits of at
/// most 12 bits: more digits would write to more places than caches hold. A stable sort has a
/// unique result, so any thread can sort any piece.
void radixSort(Buffer<Keyed>& items, int bits, Workers& workers)
{
	constexpr int       maxDigitBits = 12;
	const int           passNum      = (bits + maxDigitBits - 1) / maxDigitBits;
	const int           digitBits    = (bits + passNum - 1) / passNum;
	const std::size_t   digitNum     = std::size_t(1) << digitBits;
	const std::size_t   n            = items.size();
	const std::size_t   pieceNum     = std::min<std::size_t>(64, n / 4096 + 1);
	const std::size_t   pieceSize    = (n + pieceNum - 1) / pieceNum;
	Buffer<Keyed>       other(n);
	Buffer<std::size_t> place(pieceNum * digitNum);

	for (int shift = indexBits; shift < indexBits + bits; shift += digitBits) {
		const auto digitOf = [&](std::size_t i) { return items[i] >> shift & (digitNum - 1); };
		workers.forTasks(pieceNum, [&](std::size_t piece, int) {
			std::size_t* count = &place[piece * digitNum];
			std::fill(count, count + digitNum, 0);
			const std::size_t end = std::min(n, (piece + 1) * pieceSize);
			for (std::size_t i = piece * pieceSize; i < end; ++i)
				++count[digitOf(i)];
		});
		std::size_t total = 0;
		for (std::size_t digit = 0; digit < digitNum; ++digit) {
			for (std::size_t piece = 0; piece < pieceNum; ++piece) {
				std::size_t&      count = place[piece * digitNum + digit];
				const std::size_t here  = count;
				count                   = total;
				total += here;
			}
		}
		workers.forTasks(pieceNum, [&](std::size_t piece, int) {
			std::size_t*      next = &place[piece * digitNum];
			const std::size_t end  = std::min(n, (piece + 1) * pieceSize);
			for (std::size_t i = piece * pieceSize; i < end; ++i)
				other[next[digitOf(i)]++] = items[i];
		});
		items.swap(other);
	}
}

/// A surface fills about 4^level cells of a level: the deepest level with about a vertex in each
/// cell.
int levelFor(int vertexNum)
{
	int level = 1;
	for (std::int64_t cells = 1; cells <= vertexNum && level < 11; cells *= 4)
		++level;
	return level;
}

/// Puts the sizes of the vertices in the new order.
void renameSizes(const Buffer<int>& rename, Workers& workers, Buffer<float>& size)
{
	if (size.empty()) return;
	Buffer<float> ordered(rename.size());
	workers.forEach(rename.size(), [&](int v) { ordered[rename[v]] = size[v]; });
	size.swap(ordered);
}

/// Sorts the vertices; returns their new numbers.
Buffer<int> orderVertices(IndexedMesh& mesh, const MortonGrid& grid, Workers& workers)
{
	const std::size_t n = mesh.vertexNum;
	Buffer<Keyed>     items(n);
	workers.forEach(n,
					[&](int v) { items[v] = keyed(grid.cell(mesh.position[v], grid.level), v); });
	radixSort(items, 3 * grid.level, workers);

	Buffer<Vec3f> position(n);
	Buffer<int>   rename(n);
	workers.forEach(n, [&](int v) {
		const int old = indexOf(items[v]);
		position[v]   = mesh.position[old];
		rename[old]   = v;
	});
	mesh.position.swap(position);
	renameSizes(rename, workers, mesh.size);
	return rename;
}

/// The faces by their smallest vertex, stable. Sorting moves whole streams of faces, which is
/// faster than shared counters per vertex.
Buffer<Keyed> facesBySmallestVertex(const IndexedMesh& mesh, Workers& workers)
{
	Buffer<Keyed> items(mesh.faceNum);
	workers.forEach(mesh.faceNum, [&](int f) {
		const int* t = &mesh.triangle[3 * f];
		items[f]     = keyed(std::uint64_t(std::min({t[0], t[1], t[2]})), f);
	});
	int bits = 1;
	while (mesh.vertexNum >> bits > 0)
		++bits;
	radixSort(items, bits, workers);
	return items;
}

/// The begin of each key in the sorted items, and their number at the end.
void findStarts(const Buffer<Keyed>& items, std::size_t keyNum, Workers& workers,
				Buffer<int>& start)
{
	start.reset(keyNum + 1);
	workers.forEach(items.size() + 1, [&](int i) {
		const std::size_t first = i == 0 ? 0 : keyOf(items[i - 1]) + 1;
		const std::size_t last  = std::size_t(i) == items.size() ? keyNum : keyOf(items[i]);
		for (std::size_t key = first; key <= last; ++key)
			start[key] = i;
	});
}

} // namespace

void orderFaces(IndexedMesh& mesh, Workers& workers, Buffer<int>& faceStart)
{
	const Buffer<Keyed> face = facesBySmallestVertex(mesh, workers);
	findStarts(face, mesh.vertexNum, workers, faceStart);

	Buffer<int> triangle(std::size_t(3) * mesh.faceNum);
	Buffer<int> sourceFace(mesh.faceNum);
	workers.forEach(mesh.faceNum, [&](int f) {
		const int  old   = indexOf(face[f]);
		const int* from  = &mesh.triangle[std::size_t(3) * old];
		const int  first = int(std::min_element(from, from + 3) - from);
		for (int k = 0; k < 3; ++k)
			triangle[3 * f + k] = from[(first + k) % 3];
		sourceFace[f] = mesh.sourceFace[old];
	});
	mesh.triangle.swap(triangle);
	mesh.sourceFace.swap(sourceFace);
}

MortonGrid gridAround(const Box<float>& box)
{
	MortonGrid grid;
	grid.low = box.low;
	// A little wider, so that the highest coordinate still falls into the last cell.
	grid.cubeSize = 1.000001f * box.largestSide();
	if (!(grid.cubeSize > 0)) grid.cubeSize = 1;
	return grid;
}

std::uint64_t MortonGrid::key(const Vec3f& p) const
{
	const float scale = float(1 << deepestLevel) / cubeSize;
	const auto  cell  = [scale](float offset) {
        const float c = offset * scale;
        return std::uint64_t(int(std::min(std::max(c, 0.0f), float((1 << deepestLevel) - 1))));
	};
	return spreadBits(cell(p.x - low.x)) | spreadBits(cell(p.y - low.y)) << 1 |
		   spreadBits(cell(p.z - low.z)) << 2;
}

MortonGrid orderSpatially(IndexedMesh& mesh, Workers& workers, Buffer<int>& faceStart)
{
	MortonGrid grid = gridAround(workers.sumEach<Box<float>>(
		mesh.vertexNum, [&](int v, Box<float>& part) { part.add(mesh.position[v]); }));
	grid.level      = levelFor(mesh.vertexNum);
	{
		const Buffer<int> rename = orderVertices(mesh, grid, workers);
		workers.forEach(std::size_t(3) * mesh.faceNum,
						[&](int i) { mesh.triangle[i] = rename[mesh.triangle[i]]; });
	}
	orderFaces(mesh, workers, faceStart);
	return grid;
}

} // namespace gpr
