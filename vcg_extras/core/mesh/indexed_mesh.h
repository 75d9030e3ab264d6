// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_MESH_INDEXED_MESH_H
#define VCG_EXTRAS_CORE_MESH_INDEXED_MESH_H

#include <vcg_extras/core/base/box.h>
#include <vcg_extras/core/base/buffer.h>
#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/vec.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <vector>

namespace gpr {

/// Where the engine's float coordinates lie in the caller's frame:
/// caller = origin + working / scale. The scale is a power of two, so that scaling loses no bit and
/// the engine sees coordinates of magnitude one whatever the caller's unit.
struct Frame {
	Vec3d  origin;
	double scale = 1;

	Vec3f toWorking(const Vec3d& p) const { return Vec3f((p - origin) * scale); }
	Vec3d toCaller(const Vec3f& p) const { return origin + Vec3d(p) * (1 / scale); }
};

/// Whether a surface in that box has a size that can be computed with.
bool canBeFramed(const Box<double>& box);

/// The frame for a surface in that box, whose largest side will be at least 1/2 and below 1. Needs:
/// canBeFramed.
Frame frameOf(const Box<double>& box);

/// Vertices and triangles without adjacency: the form of the mesh until it is ordered.
struct IndexedMesh {
	Frame         frame;
	int           vertexNum = 0;
	int           faceNum   = 0;
	Buffer<Vec3f> position;   ///< working coordinates; like the others at least this long
	Buffer<int>   triangle;   ///< 3 a face
	Buffer<int>   sourceFace; ///< per face: the caller's face it is part of
	Buffer<float> size;       ///< per vertex: see sizing.h; empty: the same everywhere
	/// Where vertices of several sheets lie that were one, ascending: see junctions.h.
	std::vector<Vec3f> meetings;

	Vec3f faceCross(int f) const
	{
		const Vec3f a = position[triangle[3 * f]];
		return cross(position[triangle[3 * f + 1]] - a, position[triangle[3 * f + 2]] - a);
	}
};

/// The first `num` values once more. Large arrays are copied by all threads: memory that is written
/// to for the first time costs more than the copy.
template <class T>
Buffer<T> copyOf(const Buffer<T>& from, std::size_t num, Workers& workers)
{
	Buffer<T> to(num);
	workers.forRange(num, [&](std::size_t begin, std::size_t end) {
		std::memcpy(static_cast<void*>(to.data() + begin), from.data() + begin,
					(end - begin) * sizeof(T));
	});
	return to;
}

template <class T>
Buffer<T> copyOf(const Buffer<T>& from, Workers& workers)
{
	return copyOf(from, from.size(), workers);
}

/// Makes it at least n values long; those it had are kept.
template <class T>
void makeRoom(Buffer<T>& values, std::size_t n, Workers& workers)
{
	if (values.size() >= n) return;
	Buffer<T> longer(n);
	workers.forRange(values.size(), [&](std::size_t begin, std::size_t end) {
		std::copy(values.data() + begin, values.data() + end, longer.data() + begin);
	});
	values.swap(longer);
}

IndexedMesh copyOf(const IndexedMesh& from, Workers& workers);

/// From the edge that begins at corner h into its face, perpendicular to the edge.
Vec3f inward(const IndexedMesh& mesh, int h);

/// Keeps these faces only, ascending, and returns per face its new number (-1 if it is dropped).
Buffer<int> keepFaces(IndexedMesh& mesh, const std::vector<int>& kept, Workers& workers);

/// Renames the corners; faces that have a corner twice then are dropped, and their number returned.
std::int64_t renameCorners(IndexedMesh& mesh, const std::vector<int>& newName, Workers& workers);

/// Drops vertices in no face and renames the others, which keep their order.
void dropUnusedVertices(IndexedMesh& mesh, Workers& workers);

} // namespace gpr

#endif
