// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_MESH_INDEXED_MESH_H
#define VCG_EXTRAS_CORE_MESH_INDEXED_MESH_H

#include <vcg_extras/core/base/box.h>
#include <vcg_extras/core/base/buffer.h>
#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh_view.h>
#include <vcg_extras/core/vec.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <optional>
#include <vector>

namespace gpr {

/// The relation of the engine's float coordinates and the frame of the input: input = origin +
/// working / scale. The scale is a power of two: scaling loses no bit, and working coordinates have
/// a magnitude of about 1 in any unit of the input.
struct Frame {
	Vec3d  origin;
	double scale = 1;

	Vec3f toWorking(const Vec3d& p) const { return Vec3f((p - origin) * scale); }
	Vec3d toCaller(const Vec3f& p) const { return origin + Vec3d(p) * (1 / scale); }
};

/// Whether the size of a surface with this bounding box is usable in computations.
bool canBeFramed(const Box<double>& box);

/// The frame of a surface with this bounding box; the largest side becomes at least 1/2 and below
/// 1. Needs canBeFramed.
Frame frameOf(const Box<double>& box);

/// The frame of some faces of a mesh, without corners that are not finite; nothing if their size is
/// not usable. isIn: whether a face counts.
template <class IsIn>
std::optional<Frame> frameOf(const MeshView& mesh, const IsIn& isIn)
{
	Box<double> box;
	for (std::size_t c = 0; c < 3 * mesh.faceNum; ++c) {
		if (!isIn(c / 3)) continue;
		const Vec3d p = mesh.position(std::size_t(mesh.vertexOf(c)));
		if (isFinite(p)) box.add(p);
	}
	return canBeFramed(box) ? std::optional<Frame>(frameOf(box)) : std::nullopt;
}

/// Vertices and triangles without adjacency: the form of a mesh before connect().
struct IndexedMesh {
	Frame         frame;
	int           vertexNum = 0;
	int           faceNum   = 0;
	Buffer<Vec3f> position;   ///< working coordinates; every array may be longer
	Buffer<int>   triangle;   ///< 3 a face
	Buffer<int>   sourceFace; ///< per face: the face of the input
	Buffer<float> size;       ///< per vertex: see sizing.h; empty: even sizes
	/// The places of vertices that were split into several sheets, ascending: see junctions.h.
	std::vector<Vec3f> meetings;

	Vec3f faceCross(int f) const
	{
		const Vec3f a = position[triangle[3 * f]];
		return cross(position[triangle[3 * f + 1]] - a, position[triangle[3 * f + 2]] - a);
	}
};

/// A copy of the first `num` values, by all threads: the first write to memory costs more than the
/// copy. If there are fewer values, the rest of the copy is unknown.
template <class T>
Buffer<T> copyOf(const Buffer<T>& from, std::size_t num, Workers& workers)
{
	Buffer<T> to(num);
	workers.forRange(std::min(num, from.size()), [&](std::size_t begin, std::size_t end) {
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

/// Enlarges a buffer to at least n values and keeps its values.
template <class T>
void makeRoom(Buffer<T>& values, std::size_t n, Workers& workers)
{
	if (values.size() < n) values = copyOf(values, n, workers);
}

IndexedMesh copyOf(const IndexedMesh& from, Workers& workers);

/// The direction into the face of half-edge h, perpendicular to the edge.
Vec3f inward(const IndexedMesh& mesh, int h);

/// Drops all other faces; `kept` is ascending. Returns the new number of each face (-1: dropped).
Buffer<int> keepFaces(IndexedMesh& mesh, const std::vector<int>& kept, Workers& workers);

/// Renames the corners, drops faces with two equal corners, and returns the number of dropped
/// faces.
std::int64_t renameCorners(IndexedMesh& mesh, const std::vector<int>& newName, Workers& workers);

/// Drops vertices in no face and renumbers all other vertices, in the same order.
void dropUnusedVertices(IndexedMesh& mesh, Workers& workers);

} // namespace gpr

#endif
