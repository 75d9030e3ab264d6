// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface_refinement.h"

#include "edge_table.h"
#include "split_long_edges.h"

#include <vcg_extras/core/base/failure.h>
#include <vcg_extras/core/base/sort_unique.h>
#include <vcg_extras/core/mesh/spatial_order.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace gpr {

namespace {

using Face = SplitFaces::Face;

/// Inserts the parts of split faces in place of the faces. Ordered vertices and faces keep their
/// order, so all arrays are copied once with the new items inserted: ordering and connecting a
/// whole scan anew for a few splits takes five times as long.
class PartInsertion {
public:
	PartInsertion(const std::vector<int>& longFaces, SplitFaces split, Surface& surface,
				  Workers& workers) :
			longFaces_(longFaces),
			split_(std::move(split)), s_(surface), m_(surface.mesh), workers_(workers)
	{
	}

	void run()
	{
		nameVertices();
		nameFaces();
		moveVertices();
		joinParts(moveFaces());
		turnRoundCorners();
	}

private:
	const std::vector<int>& longFaces_; ///< ascending
	SplitFaces              split_;     ///< corners get new names
	Surface&                s_;
	HalfEdgeMesh&           m_;
	Workers&                workers_;
	Buffer<int>      vertexName_; ///< new names of vertices: first of the old, then of the new
	Buffer<int>      faceName_;   ///< new names of faces; -1 for split faces
	std::vector<int> partName_;   ///< new names of parts

	// ---- names

	/// An item to insert, and the old item behind it.
	struct Insert {
		int before, item;
	};

	/// Names the first `num` items, the old items, in their order. gone: items that leave no gap.
	void nameOld(int num, const std::vector<Insert>& inserts, const std::vector<int>& gone,
				 Buffer<int>& name)
	{
		// The step from the name of the item before, at first.
		workers_.forEach(std::size_t(num), [&](int i) { name[i] = i > 0; });
		for (const Insert& insert : inserts) {
			if (insert.before < num) ++name[insert.before];
		}
		for (int i : gone) {
			if (i + 1 < num) --name[i + 1];
		}
		workers_.sumUp(name.data(), std::size_t(num));
	}

	/// A new vertex comes after the old vertices of its cell, as in a new ordering.
	std::vector<Insert> insertedVertices() const
	{
		const auto cellOf = [&](const Vec3f& p) { return s_.grid.cell(p, s_.grid.level); };
		std::vector<std::pair<std::uint64_t, int>> vertices; // cell and number
		for (std::size_t i = 0; i < split_.position.size(); ++i)
			vertices.push_back({cellOf(split_.position[i]), int(i)});
		std::sort(vertices.begin(), vertices.end());
		std::vector<Insert> inserts;
		for (const auto& v : vertices) {
			const auto isBehind = [&](int w) { return cellOf(m_.position[w]) > v.first; };
			inserts.push_back({firstOf(m_.vertexNum, isBehind), v.second});
		}
		return inserts;
	}

	void nameVertices()
	{
		const std::vector<Insert> inserts = insertedVertices();
		vertexName_.reset(std::size_t(m_.vertexNum) + inserts.size());
		nameOld(m_.vertexNum, inserts, {}, vertexName_);
		for (std::size_t i = 0; i < inserts.size(); ++i)
			vertexName_[m_.vertexNum + inserts[i].item] = inserts[i].before + int(i);
	}

	/// Renames a part's corners, and makes the smallest corner the first.
	void nameCorners(Face& part) const
	{
		for (int& v : part.corner)
			v = vertexName_[v];
		std::rotate(part.corner, std::min_element(part.corner, part.corner + 3), part.corner + 3);
	}

	/// The first parts take the numbers of the split faces; the rest follow at the end. The number
	/// decides the order of parts with the same smallest vertex.
	int numberOf(int part) const
	{
		const int longNum = int(longFaces_.size());
		return part < longNum ? longFaces_[std::size_t(part)] : m_.faceNum + part - longNum;
	}

	std::vector<Insert> insertedFaces() const
	{
		std::vector<Insert> inserts;
		const auto          keyOf = [&](int part) {
            return std::pair(split_.faces[std::size_t(part)].corner[0], numberOf(part));
		};
		for (int i = 0; i < int(split_.faces.size()); ++i) {
			const auto key      = keyOf(i);
			const auto isBehind = [&](int f) {
				return std::pair(vertexName_[m_.origin[3 * f]], f) >= key;
			};
			inserts.push_back({firstOf(m_.faceNum, isBehind), i});
		}
		std::sort(inserts.begin(), inserts.end(),
				  [&](const Insert& a, const Insert& b) { return keyOf(a.item) < keyOf(b.item); });
		return inserts;
	}

	void nameFaces()
	{
		for (Face& part : split_.faces)
			nameCorners(part);
		const std::vector<Insert> inserts = insertedFaces();
		faceName_.reset(m_.faceNum);
		nameOld(m_.faceNum, inserts, longFaces_, faceName_);
		for (int f : longFaces_)
			faceName_[f] = -1;
		partName_.resize(inserts.size());
		for (std::size_t i = 0; i < inserts.size(); ++i) {
			const int  before = inserts[i].before;
			const auto gone   = std::lower_bound(longFaces_.begin(), longFaces_.end(), before);
			partName_[std::size_t(inserts[i].item)] =
				before + int(i) - int(gone - longFaces_.begin());
		}
	}

	/// -1 if there is no half-edge, or its face is split.
	int halfEdgeName(int h) const
	{
		const int f    = int(unsigned(h) / 3);
		const int name = h < 0 ? -1 : faceName_[f];
		return name < 0 ? -1 : h + 3 * (name - f);
	}

	// ---- arrays

	/// Moves each value to its new name, and appends the known values of new vertices.
	template <class T>
	void move(Buffer<T>& values, const std::vector<T>& added)
	{
		Buffer<T> moved(vertexName_.size());
		workers_.forEach(m_.vertexNum, [&](int v) { moved[vertexName_[v]] = values[v]; });
		for (std::size_t i = 0; i < added.size(); ++i)
			moved[vertexName_[std::size_t(m_.vertexNum) + i]] = added[i];
		values.swap(moved);
	}

	void moveVertices()
	{
		move(m_.position, split_.position);
		if (!s_.size.empty()) move(s_.size, split_.size);
		move(s_.normal, {});
		move(s_.area, {});
		workers_.forEach(m_.vertexNum,
						 [&](int v) { m_.outgoing[v] = halfEdgeName(m_.outgoing[v]); });
		move(m_.outgoing, {});
		m_.vertexNum = int(vertexName_.size());
	}

	/// Moves the `width` values of each face to its new name. Compilers unroll the loop for a known
	/// width, which halves the instructions.
	template <int width, class NewValue>
	void moveOfFaces(Buffer<int>& values, const NewValue& newValue)
	{
		Buffer<int> moved(width * faceNum());
		workers_.forEach(faceName_.size(), [&](int f) {
			if (faceName_[f] < 0) return;
			const int* const from = &values[width * f];
			int* const       to   = &moved[width * faceName_[f]];
			for (int k = 0; k < width; ++k)
				to[k] = newValue(from[k]);
		});
		values.swap(moved);
	}

	/// One array after the other: copies of all arrays at the same time would be the peak of the
	/// run's memory. Returns the half-edges whose neighbours were split.
	std::vector<int> moveFaces()
	{
		moveOfFaces<3>(m_.origin, [&](int v) { return vertexName_[v]; });
		moveOfFaces<1>(s_.sourceFace, [](int source) { return source; });
		std::vector<int> open = findOpenHalfEdges();
		moveOfFaces<3>(m_.opposite, [&](int h) { return halfEdgeName(h); });
		for (std::size_t i = 0; i < partName_.size(); ++i) {
			const Face& part = split_.faces[i];
			std::copy(part.corner, part.corner + 3, &m_.origin[3 * partName_[i]]);
			s_.sourceFace[partName_[i]] = part.source;
		}
		m_.faceNum = int(faceNum());
		return open;
	}

	std::size_t faceNum() const { return faceName_.size() - longFaces_.size() + partName_.size(); }

	/// The half-edges of other faces beside split faces.
	std::vector<int> findOpenHalfEdges() const
	{
		std::vector<int> open;
		for (int f : longFaces_) {
			for (int h = 3 * f; h < 3 * f + 3; ++h) {
				const int beyond = halfEdgeName(m_.opposite[h]);
				if (beyond >= 0) open.push_back(beyond);
			}
		}
		return open;
	}

	// ---- new items

	void joinParts(const std::vector<int>& open)
	{
		EdgeTable edges;
		edges.reserve((3 * partName_.size() + open.size()) / 2);
		for (int f : partName_) {
			for (int h = 3 * f; h < 3 * f + 3; ++h)
				join(h, edges);
		}
		for (int h : open)
			join(h, edges);
	}

	/// The second half of an edge finds the first half.
	void join(int h, EdgeTable& edges)
	{
		m_.opposite[h]  = -1;
		const int first = edges.findOrPut(m_.origin[h], m_.target(h), h);
		if (first == h) return;
		if (m_.opposite[first] >= 0 || m_.origin[first] == m_.origin[h])
			throw Failure(Status::InternalError, "The surface could not be connected anew.");
		m_.opposite[h]     = first;
		m_.opposite[first] = h;
	}

	void turnRoundCorners()
	{
		std::vector<int> corners;
		for (int f : partName_) {
			for (int h = 3 * f; h < 3 * f + 3; ++h) {
				m_.outgoing[m_.origin[h]] = h;
				corners.push_back(m_.origin[h]);
			}
		}
		sortUnique(corners);
		workers_.forEach(corners.size(), [&](int i) {
			const int v    = corners[std::size_t(i)];
			m_.outgoing[v] = firstOutgoing(m_.outgoing[v]);
			measureVertex(v, s_);
		});
	}

	/// The half-edge that connect() takes at the origin of h: the border half-edge; else the first
	/// half-edge of a face with the origin as first corner; else the first half-edge.
	int firstOutgoing(int h) const
	{
		int       first = h;
		const int begin = h;
		do {
			if (m_.opposite[h] < 0) return h;
			const bool isOwn = h % 3 == 0, wasOwn = first % 3 == 0;
			if (isOwn != wasOwn ? isOwn : h < first) first = h;
			h = nextInFace(m_.opposite[h]);
		} while (h != begin);
		return first;
	}
};

} // namespace

std::int64_t refineSurface(const std::vector<int>& longFaces, float maxLength,
						   std::int64_t maxFaces, Surface& surface, Workers& workers)
{
	if (longFaces.empty()) return 0;
	SplitFaces split    = splitLongFaces(surface, longFaces, maxLength, maxFaces, workers);
	const auto splitNum = std::int64_t(split.position.size());
	PartInsertion(longFaces, std::move(split), surface, workers).run();
	return splitNum;
}

} // namespace gpr
