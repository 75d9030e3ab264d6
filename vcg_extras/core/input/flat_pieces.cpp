// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "flat_pieces.h"

#include <vcg_extras/core/base/box.h>
#include <vcg_extras/core/base/poller.h>
#include <vcg_extras/core/base/sort_unique.h>
#include <vcg_extras/core/base/triangle.h>
#include <vcg_extras/core/base/union_find.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>

namespace gpr {

namespace {

/// Working units, with a box of about 1: above the rounding of coordinates, as for the weld.
constexpr float minWidth = 1e-6f;
/// Height over length.
constexpr float minSlope = 1e-3f;

/// corner: the first of the three corners of a face.
bool isThin(const Buffer<Vec3f>& position, const int* corner)
{
	return isThin(position[corner[0]], position[corner[1]], position[corner[2]]);
}

/// Thin faces, ascending. All corners of a thin face are rough, with a margin for rounding; the
/// first corner finds the face.
std::vector<int> findThin(const Surface& surface, Workers& workers)
{
	static_assert(roughWidth >= 1.5f * minWidth);
	const HalfEdgeMesh& m    = surface.mesh;
	std::vector<int>    thin = workers.collectEach<int>(m.vertexNum, [&](int v, auto& out) {
        if (!surface.normal[v].isRough()) return;
        forEachOutgoing(m, v, [&](int h) {
            if (h % 3 == 0 && isThin(m.position, &m.origin[h])) out.push_back(h / 3);
        });
    });
	sortPolled(thin.begin(), thin.end(), workers);
	return thin;
}

/// Area and box of some faces.
struct Extent {
	double     area = 0;
	Box<float> box;

	Extent(const HalfEdgeMesh& m, int f) : area(0.5 * double(length(m.faceCross(f))))
	{
		for (int h = 3 * f; h < 3 * f + 3; ++h)
			box.add(m.position[m.origin[h]]);
	}

	void add(const Extent& other)
	{
		area += other.area;
		box += other.box;
	}

	/// Whether the faces are thin together too: no small piece of many small faces, and no row of
	/// many needles.
	bool isLine() const { return !(area > double(minWidth) * double(box.diagonal())); }
};

class FlatFinder {
public:
	FlatFinder(const HalfEdgeMesh& mesh, std::vector<int> thin, Workers& workers) :
			m_(mesh), poller_(workers), thin_(std::move(thin)), seen_(thin_.size(), 0),
			gone_(thin_.size(), 0), pieceOf_(numbersBelow(thin_.size()))
	{
		for (int f : thin_)
			extent_.emplace_back(m_, f);
	}

	std::vector<int> run()
	{
		for (int i = 0; i < int(thin_.size()); ++i) {
			if (!seen_[i]) judge(i);
		}
		peelBorders();
		std::vector<int> flat;
		for (std::size_t i = 0; i < thin_.size(); ++i) {
			if (gone_[i]) flat.push_back(thin_[i]);
		}
		return flat;
	}

private:
	const HalfEdgeMesh& m_;
	Poller              poller_;
	std::vector<int>    thin_; ///< faces, ascending
	// Per thin face, by its index in thin_; so are all faces below.
	std::vector<char>   seen_, gone_;
	std::vector<int>    pieceOf_; ///< another face of the same dropped piece; the head: itself
	std::vector<Extent> extent_;  ///< of the piece with this head

	/// The thin face beyond half-edge h, or -1.
	int thinBeyond(int h) const
	{
		return m_.isBorderEdge(h) ? -1 : placeIn(thin_, m_.opposite[h] / 3);
	}

	// ---- whole components

	/// Marks the thin faces joined to a thin face, if these are a whole component and a line.
	void judge(int first)
	{
		bool             isWhole = true;
		std::vector<int> joined{first};
		Extent           all = extent_[first];
		seen_[first]         = 1;
		for (std::size_t i = 0; i < joined.size(); ++i) {
			poller_.count();
			const int f = thin_[joined[i]];
			if (i > 0) all.add(extent_[joined[i]]);
			for (int h = 3 * f; h < 3 * f + 3; ++h) {
				const int k = thinBeyond(h);
				isWhole     = isWhole && (k >= 0 || m_.isBorderEdge(h));
				if (k < 0 || seen_[k]) continue;
				seen_[k] = 1;
				joined.push_back(k);
			}
		}
		if (!isWhole || !all.isLine()) return;
		for (int i : joined)
			gone_[i] = 1;
	}

	// ---- at borders

	/// Takes faces off until no face may go; each face may make way for its neighbours. The faces
	/// taken off in one place must be a line together: else a surface of needles would go row by
	/// row.
	void peelBorders()
	{
		std::vector<int> waiting(thin_.size());
		std::iota(waiting.rbegin(), waiting.rend(), 0);
		while (!waiting.empty()) {
			poller_.count();
			const int i = waiting.back(), f = thin_[i];
			waiting.pop_back();
			if (gone_[i] || !mayGo(f) || !joinsALine(i)) continue;
			gone_[i] = 1;
			for (int h = 3 * f; h < 3 * f + 3; ++h) {
				const int k = thinBeyond(h);
				if (k >= 0) waiting.push_back(k);
			}
		}
	}

	/// Joins a thin face with the dropped pieces at its edges, if all together are a line.
	bool joinsALine(int i)
	{
		const int f   = thin_[i];
		Extent    all = extent_[i];
		int       piece[3], pieceNum = 0;
		for (int h = 3 * f; h < 3 * f + 3; ++h) {
			const int k = thinBeyond(h);
			if (k < 0 || !gone_[k]) continue;
			const int p = rootOf(pieceOf_, k);
			if (std::find(piece, piece + pieceNum, p) != piece + pieceNum) continue;
			all.add(extent_[p]);
			piece[pieceNum++] = p;
		}
		if (!all.isLine()) return false;
		for (int k = 0; k < pieceNum; ++k)
			pieceOf_[piece[k]] = i;
		extent_[i] = all;
		return true;
	}

	bool isBorder(int h) const
	{
		const int k = thinBeyond(h);
		return m_.isBorderEdge(h) || (k >= 0 && gone_[k]);
	}

	/// Whether the topology stays and, but for rounding, the surface and its border.
	bool mayGo(int f) const
	{
		int borderNum = 0, border = -1;
		for (int h = 3 * f; h < 3 * f + 3; ++h) {
			if (!isBorder(h)) continue;
			++borderNum;
			border = h;
		}
		if (borderNum == 2) return true;
		return borderNum == 1 && isInner(m_.apex(border)) &&
			   m_.edgeLength(border) >= m_.edgeLength(nextInFace(border)) &&
			   m_.edgeLength(border) >= m_.edgeLength(prevInFace(border));
	}

	bool isInner(int v) const
	{
		return !m_.isBorderVertex(v) && !anyOutgoing(m_, v, [&](int h) { return isBorder(h); });
	}
};

} // namespace

bool isThin(const Vec3f& a, const Vec3f& b, const Vec3f& c, float factor)
{
	const Vec3f n     = cross(b - a, c - a);
	const float width = factor * minWidth;
	const float squared =
		std::max({squaredLength(b - a), squaredLength(c - b), squaredLength(a - c)});
	// Most faces are judged without a root: faces far wider than minWidth.
	if (squaredLength(n) > 4 * width * width * squared) return false;
	const float longest = std::sqrt(squared);
	return !(length(n) > longest * std::min(width, factor * minSlope * longest));
}

std::vector<int> findFlatPieces(const Surface& surface, Workers& workers)
{
	return FlatFinder(surface.mesh, findThin(surface, workers), workers).run();
}

bool allFacesThin(const IndexedMesh& mesh, Workers& workers)
{
	std::atomic<bool> foundOther{false};
	workers.forEach(mesh.faceNum, [&](int f) {
		if (!foundOther && !isThin(mesh.position, &mesh.triangle[3 * f])) foundOther = true;
	});
	return !foundOther;
}

IndexedMesh withoutFaces(Surface& surface, const std::vector<int>& faces, Workers& workers,
						 std::int64_t& droppedNum)
{
	IndexedMesh      mesh = disconnect(surface);
	std::vector<int> dropped;
	dropped.reserve(faces.size());
	for (int f : faces)
		dropped.push_back(mesh.sourceFace[f]);
	sortUnique(dropped);
	droppedNum += std::int64_t(dropped.size());
	const std::vector<int> kept = workers.collectIf(
		mesh.faceNum, [&](int f) { return !std::binary_search(faces.begin(), faces.end(), f); });
	keepFaces(mesh, kept, workers);
	dropUnusedVertices(mesh, workers);
	return mesh;
}

} // namespace gpr
