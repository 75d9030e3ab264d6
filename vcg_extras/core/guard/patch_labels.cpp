// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch_labels.h"

#include <vcg_extras/core/base/sort_unique.h>
#include <vcg_extras/core/base/union_find.h>

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <map>
#include <set>

namespace gpr {

namespace {

/// More passes change next to nothing.
constexpr int maxPasses = 12;

class Cleaning {
public:
	Cleaning(const HalfEdgeMesh& mesh, const std::vector<PatchRole>& role,
			 std::vector<int>& label) :
			m_(mesh),
			role_(role), label_(label)
	{
	}

	void run(Workers& workers)
	{
		for (int pass = 0; pass < maxPasses; ++pass) {
			workers.poll();
			findPieces();
			const int changes = joinPieces() + joinEnclosed() + fillGapsAndNotches();
			if (changes == 0) return;
		}
	}

private:
	const HalfEdgeMesh&           m_;
	const std::vector<PatchRole>& role_;
	std::vector<int>&             label_;
	std::vector<int>              pieceOf_; ///< per vertex: the first vertex of its piece, or -1
	std::vector<int>              ring_;

	int  labelOf(int v) const { return label_[v]; }
	bool isInside(int v) const { return role_[labelOf(v)] == PatchRole::Inside; }
	bool isBorder(int v) const { return role_[labelOf(v)] == PatchRole::Border; }

	/// A piece: connected vertices of a border cell, or connected vertices inside.
	void findPieces()
	{
		pieceOf_ = numbersBelow(std::size_t(m_.vertexNum));
		for (int h = 0; h < m_.halfEdgeNum(); ++h) {
			const int  v = m_.origin[h], w = m_.target(h);
			const bool isSame = isInside(v) ? isInside(w) : labelOf(w) == labelOf(v);
			if (isSame) joinSets(pieceOf_, v, w);
		}
		for (int v = 0; v < m_.vertexNum; ++v)
			pieceOf_[v] = isInside(v) || isBorder(v) ? rootOf(pieceOf_, v) : -1;
	}

	/// Gives the vertices of the marked pieces another label next to the piece, if any. may(w):
	/// whether a vertex may get the label of its neighbour w.
	template <class May>
	int giveAway(const std::vector<char>& isGiven, const May& may)
	{
		std::vector<int> front;
		for (int v = 0; v < m_.vertexNum; ++v) {
			const int piece = pieceOf_[v];
			if (piece >= 0 && isGiven[piece]) front.push_back(v);
		}
		const std::size_t givenNum = front.size();
		for (std::size_t before = givenNum + 1; front.size() < before;) {
			before = front.size();
			std::vector<int> left;
			for (int v : front) {
				const int label = labelBeside(v, may);
				if (label < 0) {
					left.push_back(v);
					continue;
				}
				label_[v]   = label;
				pieceOf_[v] = -1;
			}
			front = std::move(left);
		}
		return int(givenNum - front.size());
	}

	template <class May>
	int labelBeside(int v, const May& may) const
	{
		int found = -1;
		forEachNeighbour(m_, v, [&](int w) {
			const bool isSame = pieceOf_[w] >= 0 && pieceOf_[w] == pieceOf_[v];
			if (!isSame && may(w) && (found < 0 || isInside(w))) found = labelOf(w);
		});
		return found;
	}

	/// Gives away all pieces of a border cell but the largest.
	int joinPieces()
	{
		std::map<int, int> size; // per piece
		for (int v = 0; v < m_.vertexNum; ++v) {
			if (isBorder(v)) ++size[pieceOf_[v]];
		}
		std::map<int, int> largest; // per label: a piece
		for (const auto& [piece, num] : size) {
			const auto at = largest.emplace(labelOf(piece), piece).first;
			if (size[at->second] < num) at->second = piece;
		}
		std::vector<char> isGiven(pieceOf_.size(), 0);
		for (const auto& [piece, num] : size)
			isGiven[piece] = largest[labelOf(piece)] != piece;
		return giveAway(isGiven, [](int) { return true; });
	}

	/// Gives away inner pieces that meet at most two cells, nothing beyond the border, and are
	/// disks.
	int joinEnclosed()
	{
		const std::vector<int> euler = eulerOfPieces();
		std::vector<char>      isGiven(pieceOf_.size(), 0);
		for (const auto& [piece, labels] : cellsMet())
			isGiven[piece] = labels.size() <= 2 && euler[piece] == 1;
		return giveAway(isGiven, [this](int w) { return isBorder(w); });
	}

	/// The labels round the inner pieces that meet any.
	std::map<int, std::set<int>> cellsMet() const
	{
		std::map<int, std::set<int>> met;
		for (int v = 0; v < m_.vertexNum; ++v) {
			if (pieceOf_[v] < 0 || !isInside(v)) continue;
			forEachNeighbour(m_, v, [&](int w) {
				if (!isInside(w)) met[pieceOf_[v]].insert(labelOf(w));
			});
		}
		return met;
	}

	/// Per inner piece: vertices minus edges plus faces with a corner in the piece. 1: an open
	/// disk.
	std::vector<int> eulerOfPieces() const
	{
		std::vector<int> euler(pieceOf_.size(), 0);
		const auto       add = [&](std::initializer_list<int> corners, int sign) {
            for (int v : corners) {
                if (pieceOf_[v] < 0 || !isInside(v)) continue;
                euler[pieceOf_[v]] += sign;
                return; // inner corners belong to the same piece
            }
		};
		for (int v = 0; v < m_.vertexNum; ++v)
			add({v}, 1);
		for (int h = 0; h < m_.halfEdgeNum(); ++h) {
			if (m_.opposite[h] < h) add({m_.origin[h], m_.target(h)}, -1);
			if (h % 3 == 0) add({m_.origin[h], m_.target(h), m_.apex(h)}, 1);
		}
		return euler;
	}

	/// Fills gaps and notches until none is left. A change makes further ones beside itself only,
	/// so that later looks are few. Gaps come first: a cell on both sides of a gap looks like a
	/// notch.
	int fillGapsAndNotches()
	{
		int              changes  = 0;
		std::vector<int> vertices = numbersBelow(std::size_t(m_.vertexNum)), beside;
		const auto       join     = [&](int v, int label) {
            if (label < 0) return;
            label_[v] = label;
            ++changes;
            forEachNeighbour(m_, v, [&](int w) { beside.push_back(w); });
		};
		while (!vertices.empty()) {
			for (int v : vertices)
				join(v, cellBesideGap(v));
			for (int v : vertices)
				join(v, cellRoundNotch(v));
			sortUnique(beside);
			vertices.swap(beside);
			beside.clear();
		}
		return changes;
	}

	/// A cell beside a vertex beyond the border that meets inner vertices; -1 for other vertices.
	int cellBesideGap(int v) const
	{
		if (m_.outgoing[v] < 0 || isInside(v) || isBorder(v) || !meetsInside(v)) return -1;
		return labelBeside(v, [this](int w) { return isBorder(w); });
	}

	/// The cell that an inner vertex meets more than once; -1 for other vertices.
	int cellRoundNotch(int v) { return m_.outgoing[v] < 0 || !isInside(v) ? -1 : metTwice(v); }

	bool meetsInside(int v) const
	{
		return anyNeighbour(m_, v, [&](int w) { return isInside(w); });
	}

	/// A border label that appears twice round v with other labels between, or -1.
	int metTwice(int v)
	{
		ring_.clear();
		forEachNeighbour(m_, v, [&](int w) { ring_.push_back(isBorder(w) ? labelOf(w) : -1); });
		ring_.erase(std::unique(ring_.begin(), ring_.end()), ring_.end());
		const bool isFan = m_.isBorderVertex(v);
		if (!isFan && ring_.size() > 1 && ring_.front() == ring_.back()) ring_.pop_back();
		for (int label : ring_) {
			if (label >= 0 && std::count(ring_.begin(), ring_.end(), label) > 1) return label;
		}
		return -1;
	}
};

} // namespace

void cleanLabels(const HalfEdgeMesh& mesh, const std::vector<PatchRole>& role,
				 std::vector<int>& label, Workers& workers)
{
	Cleaning(mesh, role, label).run(workers);
}

} // namespace gpr
