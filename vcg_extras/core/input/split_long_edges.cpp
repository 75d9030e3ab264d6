// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "split_long_edges.h"

#include "edge_table.h"

#include <vcg_extras/core/base/failure.h>
#include <vcg_extras/core/base/poller.h>
#include <vcg_extras/core/results.h>

#include <algorithm>

namespace gpr {

namespace {

/// A face to split, or a part of a face.
struct Face {
	int corner[3]; ///< from the mesh's number of vertices on: new vertices, in their order
	int source;    ///< face of the input mesh that contains this face
};

/// The faces and vertices made of split faces.
struct SplitFaces {
	std::vector<Face>  faces;
	std::vector<Vec3f> position; ///< of the new vertices, one for each split edge
	std::vector<float> size;     ///< of the new vertices; empty for a mesh without sizes
};

/// The rule for edges that are too long.
struct EdgeRule {
	float                maxSquared;
	const Buffer<float>& size; ///< per vertex, or empty

	/// minSize: the smaller size of the edge's ends; 1 without sizes.
	bool isLong(float squared, float minSize) const
	{
		return squared > maxSquared * minSize * minSize;
	}
	bool isLong(const Buffer<Vec3f>& position, int a, int b) const
	{
		return isLong(squaredLength(position[a] - position[b]),
					  size.empty() ? 1.0f : std::min(size[a], size[b]));
	}
	/// corner: the first of the three corners of a face.
	bool isLongFace(const Buffer<Vec3f>& position, const int* corner) const
	{
		return isLong(position, corner[0], corner[1]) || isLong(position, corner[1], corner[2]) ||
			   isLong(position, corner[2], corner[0]);
	}
	bool isLongFace(const IndexedMesh& mesh, int f) const
	{
		return isLongFace(mesh.position, &mesh.triangle[3 * f]);
	}
};

[[noreturn]] void failWithTooManyFaces()
{
	throw Failure(Status::OutOfMemory,
				  "Splitting the long edges would make too many faces; ask for fewer vertices or "
				  "remove the stray triangles.");
}

/// Splits the long faces round by round. Both faces of a long edge are long faces, so no other
/// faces are needed.
class Splitter {
public:
	Splitter(const IndexedMesh& mesh, const std::vector<int>& longFaces, float maxLength,
			 std::int64_t maxFaces, Workers& workers) :
			mesh_(mesh),
			rule_{maxLength * maxLength, mesh.size}, maxFaces_(maxFaces),
			faceNum_(std::int64_t(mesh.faceNum) - std::int64_t(longFaces.size())), poller_(workers)
	{
		for (int f : longFaces) {
			const int* t = &mesh.triangle[3 * f];
			todo_.push_back({{t[0], t[1], t[2]}, mesh.sourceFace[f]});
		}
	}

	bool isLong(int a, int b) const
	{
		return rule_.isLong(squaredLength(position(a) - position(b)),
							std::min(sizeOf(a), sizeOf(b)));
	}

	SplitFaces run()
	{
		while (!todo_.empty()) {
			std::vector<Face> round;
			round.swap(todo_);
			if (!hasStrips_) midpoint_.clear();
			midpoint_.reserve(midpoint_.size() + round.size());
			for (const Face& face : round)
				split(face);
		}
		return std::move(split_);
	}

private:
	const IndexedMesh& mesh_;
	EdgeRule           rule_;
	std::int64_t       maxFaces_;
	std::int64_t       faceNum_; ///< of the mesh, without the long faces
	Poller             poller_;
	std::vector<Face>  todo_;
	SplitFaces         split_;
	/// Edges split in this round; with strips all split edges, as a strip splits its edges ahead.
	EdgeTable midpoint_;
	bool      hasStrips_ = false;

	Vec3f position(int v) const
	{
		return v < mesh_.vertexNum ? mesh_.position[v] : split_.position[v - mesh_.vertexNum];
	}

	float sizeOf(int v) const
	{
		if (rule_.size.empty()) return 1;
		return v < mesh_.vertexNum ? mesh_.size[v] : split_.size[v - mesh_.vertexNum];
	}

	int midpointOf(int a, int b)
	{
		poller_.count();
		const int next   = mesh_.vertexNum + int(split_.position.size());
		const int middle = midpoint_.findOrPut(a, b, next);
		if (middle == next) {
			split_.position.push_back((position(a) + position(b)) * 0.5f);
			if (!rule_.size.empty()) split_.size.push_back(0.5f * (sizeOf(a) + sizeOf(b)));
		}
		return middle;
	}

	void put(int a, int b, int c, int source)
	{
		poller_.count();
		const bool isDone = !isLong(a, b) && !isLong(b, c) && !isLong(c, a);
		(isDone ? split_.faces : todo_).push_back({{a, b, c}, source});
		if (faceNum_ + std::int64_t(split_.faces.size() + todo_.size()) > maxFaces_)
			failWithTooManyFaces();
	}

	void split(const Face& face)
	{
		const int longest = longestEdge(face);
		if (isNeedle(face, longest)) return splitNeedle(face, longest);
		int middle[3];
		int longNum = 0;
		for (int k = 0; k < 3; ++k) {
			const int a = face.corner[k], b = face.corner[(k + 1) % 3];
			middle[k] = isLong(a, b) ? midpointOf(a, b) : -1;
			longNum += middle[k] >= 0;
		}
		const int* v = face.corner;
		if (longNum == 3) {
			put(v[0], middle[0], middle[2], face.source);
			put(v[1], middle[1], middle[0], face.source);
			put(v[2], middle[2], middle[1], face.source);
			put(middle[0], middle[1], middle[2], face.source);
		}
		else if (longNum == 2) {
			splitTwo(face, middle);
		}
		else {
			const int k = middle[0] >= 0 ? 0 : middle[1] >= 0 ? 1 : 2;
			put(v[k], middle[k], v[(k + 2) % 3], face.source);
			put(middle[k], v[(k + 1) % 3], v[(k + 2) % 3], face.source);
		}
	}

	/// a-b is the short edge. Cuts corner c off, and divides the rest along its shorter diagonal.
	void splitTwo(const Face& face, const int middle[3])
	{
		const int k = middle[0] < 0 ? 0 : middle[1] < 0 ? 1 : 2;
		const int a = face.corner[k], b = face.corner[(k + 1) % 3], c = face.corner[(k + 2) % 3];
		const int bc = middle[(k + 1) % 3], ca = middle[(k + 2) % 3];
		put(c, ca, bc, face.source);
		if (squaredLength(position(a) - position(bc)) < squaredLength(position(b) - position(ca))) {
			put(a, b, bc, face.source);
			put(a, bc, ca, face.source);
		}
		else {
			put(a, b, ca, face.source);
			put(b, bc, ca, face.source);
		}
	}

	int longestEdge(const Face& face) const
	{
		float squared[3];
		for (int k = 0; k < 3; ++k)
			squared[k] =
				squaredLength(position(face.corner[k]) - position(face.corner[(k + 1) % 3]));
		return int(std::max_element(squared, squared + 3) - squared);
	}

	/// Whether edge k, the longest, is far too long, and the third corner so near that only one row
	/// of faces fits between.
	bool isNeedle(const Face& face, int k) const
	{
		const int   a = face.corner[k], b = face.corner[(k + 1) % 3], c = face.corner[(k + 2) % 3];
		const Vec3f edge    = position(b) - position(a);
		const float squared = squaredLength(edge);
		const float least   = std::min({sizeOf(a), sizeOf(b), sizeOf(c)});
		if (!rule_.isLong(squared / (minNeedleLength * minNeedleLength), least)) return false;
		const float height = squaredLength(cross(edge, position(c) - position(a))) / squared;
		return !rule_.isLong(4 * height, least);
	}

	/// Splits a needle into a strip of faces between its longest edge a -> b and the other two
	/// edges, with a face per part of these edges. Halving all edges round by round would halve the
	/// diagonals too, and make 3 faces per 2 faces of the strip.
	void splitNeedle(const Face& face, int longest)
	{
		const int a = face.corner[longest], b = face.corner[(longest + 1) % 3],
				  c = face.corner[(longest + 2) % 3];
		hasStrips_  = true;
		std::vector<int> low{a}, high{a};
		addParts(a, b, low);
		low.push_back(b);
		addParts(a, c, high);
		high.push_back(c);
		addParts(c, b, high);

		put(a, low[1], high[1], face.source);
		std::size_t i = 1, k = 1;
		while (i + 2 < low.size() || k + 1 < high.size()) {
			if (k + 1 == high.size() || (i + 2 < low.size() && isLowNearer(low, i, high, k))) {
				put(low[i], low[i + 1], high[k], face.source);
				++i;
			}
			else {
				put(low[i], high[k + 1], high[k], face.source);
				++k;
			}
		}
		put(low[i], b, high[k], face.source);
	}

	/// Whether the diagonal to the next point of the low side is the shorter diagonal.
	bool isLowNearer(const std::vector<int>& low, std::size_t i, const std::vector<int>& high,
					 std::size_t k) const
	{
		return squaredLength(position(low[i + 1]) - position(high[k])) <
			   squaredLength(position(low[i]) - position(high[k + 1]));
	}

	/// Appends all midpoints of the repeated halving of a -> b, in order.
	void addParts(int a, int b, std::vector<int>& points)
	{
		if (!isLong(a, b)) return;
		if (std::int64_t(points.size()) > maxFaces_) failWithTooManyFaces();
		const int middle = midpointOf(a, b);
		addParts(a, middle, points);
		points.push_back(middle);
		addParts(middle, b, points);
	}
};

/// Adds values behind the first `num` values of a buffer.
template <class T>
void append(Buffer<T>& values, int num, const std::vector<T>& added, Workers& workers)
{
	if (added.empty()) return;
	makeRoom(values, num + added.size(), workers);
	std::copy(added.begin(), added.end(), values.begin() + num);
}

/// The first new faces replace the long faces; the rest follow at the end.
void writeBack(IndexedMesh& mesh, const std::vector<int>& longFaces, const SplitFaces& split,
			   Workers& workers)
{
	const std::vector<Face>& faces = split.faces;
	const int                extra = int(faces.size() - longFaces.size());
	makeRoom(mesh.triangle, 3 * (std::size_t(mesh.faceNum) + extra), workers);
	makeRoom(mesh.sourceFace, std::size_t(mesh.faceNum) + extra, workers);
	workers.forEach(faces.size(), [&](std::size_t i) {
		const int f =
			i < longFaces.size() ? longFaces[i] : mesh.faceNum + int(i - longFaces.size());
		for (int k = 0; k < 3; ++k)
			mesh.triangle[3 * f + k] = faces[i].corner[k];
		mesh.sourceFace[f] = faces[i].source;
	});
	mesh.faceNum += extra;

	append(mesh.position, mesh.vertexNum, split.position, workers);
	append(mesh.size, mesh.vertexNum, split.size, workers);
	mesh.vertexNum += int(split.position.size());
}

} // namespace

std::vector<int> findLongFaces(const IndexedMesh& mesh, const FaceExtents& extents, float maxLength,
							   Workers& workers)
{
	constexpr int  together = FaceExtents::facesTogether;
	const EdgeRule rule{maxLength * maxLength, mesh.size};
	return workers.collectEach<int>(extents.longestSquared.size(), [&](int group, auto& out) {
		if (!rule.isLong(extents.longestSquared[group], 1)) return;
		for (int f = together * group; f < std::min(together * (group + 1), mesh.faceNum); ++f)
			if (rule.isLongFace(mesh, f)) out.push_back(f);
	});
}

std::vector<int> findLongFaces(const IndexedMesh& mesh, float maxLength,
							   const std::vector<int>& among, Workers& workers)
{
	const EdgeRule rule{maxLength * maxLength, mesh.size};
	return workers.collectEach<int>(among.size(), [&](int i, auto& out) {
		if (rule.isLongFace(mesh, among[i])) out.push_back(among[i]);
	});
}

std::int64_t splitLongEdges(IndexedMesh& mesh, const std::vector<int>& longFaces, float maxLength,
							std::int64_t maxFaces, Workers& workers)
{
	if (longFaces.empty()) return 0;
	const SplitFaces split = Splitter(mesh, longFaces, maxLength, maxFaces, workers).run();
	writeBack(mesh, longFaces, split, workers);
	return std::int64_t(split.position.size());
}

std::int64_t maxFacesFor(std::int64_t vertexNum, std::int64_t faceNum)
{
	const std::int64_t most = std::max<std::int64_t>(4 * faceNum, 200 * vertexNum + 10000000);
	return std::min<std::int64_t>(most, 700000000);
}

LongFaces findTooLong(const IndexedMesh& mesh, const FaceExtents& extents, float radius,
					  Workers& workers)
{
	constexpr double maxSingleFaces = 0.15; // share that may have longer edges
	LongFaces        found;
	found.longest = longestEdgeInRadii * radius;
	found.faces   = findLongFaces(mesh, extents, found.longest, workers);
	if (double(found.faces.size()) < maxSingleFaces * mesh.faceNum) {
		found.longest = longestSingleEdge * radius;
		found.faces   = findLongFaces(mesh, found.longest, found.faces, workers);
	}
	return found;
}

LongFaces findTooLong(const Surface& surface, float longest, Workers& workers)
{
	const HalfEdgeMesh& m = surface.mesh;
	const EdgeRule      rule{longest * longest, surface.size};
	return {workers.collectIf(m.faceNum,
							  [&](int f) { return rule.isLongFace(m.position, &m.origin[3 * f]); }),
			longest};
}

void raiseSizes(const LongFaces& tooLong, Surface& surface)
{
	const HalfEdgeMesh& m = surface.mesh;
	for (int f : tooLong.faces) {
		for (int h = 3 * f; h < 3 * f + 3; ++h) {
			const float least = m.edgeLength(h) / tooLong.longest;
			for (int v : {m.origin[h], m.target(h)})
				surface.size[v] = std::max(surface.size[v], least);
		}
	}
}

} // namespace gpr
