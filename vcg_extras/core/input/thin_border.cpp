// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "thin_border.h"

#include "flat_pieces.h"

#include <vcg_extras/core/base/box.h>
#include <vcg_extras/core/mesh/edge_sides.h>
#include <vcg_extras/core/mesh/indexed_mesh.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

namespace gpr {

namespace {

/// Margin for computing widths again, in another frame, when the part is remeshed.
constexpr float margin = 2;

class ThinBorder {
public:
	ThinBorder(const MeshView& input, const std::vector<std::uint8_t>& isInPart) :
			input_(input), isInPart_(isInPart)
	{
		findThin();
		if (!thin_.empty()) findBorder();
	}

	/// All thin faces at the border, and all thin faces linked to the border by vertices of thin
	/// faces.
	std::vector<std::size_t> faces()
	{
		std::vector<std::size_t> found;
		std::vector<char>        isFound(thin_.size(), 0);
		while (!border_.empty()) {
			const std::int32_t v = border_.back();
			border_.pop_back();
			auto at =
				std::lower_bound(thinAt_.begin(), thinAt_.end(), std::pair(v, std::size_t(0)));
			for (; at != thinAt_.end() && at->first == v; ++at) {
				if (isFound[at->second]) continue;
				isFound[at->second] = 1;
				found.push_back(thin_[at->second]);
				for (std::int32_t corner : input_.triangle(found.back()))
					border_.push_back(corner);
			}
		}
		return found;
	}

private:
	const MeshView&                  input_;
	const std::vector<std::uint8_t>& isInPart_;
	std::vector<std::size_t>         thin_; ///< faces
	/// Corners of thin faces, each with the index of the face in thin_; sorted.
	std::vector<std::pair<std::int32_t, std::size_t>> thinAt_;
	std::vector<std::int32_t>                         border_; ///< corners on the border

	Box<double> boxOfPart() const
	{
		Box<double> box;
		for (std::size_t f = 0; f < input_.faceNum; ++f) {
			if (!isInPart_[f]) continue;
			for (std::int32_t v : input_.triangle(f)) {
				const Vec3d p = input_.position(std::size_t(v));
				if (isFinite(p)) box.add(p);
			}
		}
		return box;
	}

	void findThin()
	{
		const Box<double> box = boxOfPart();
		if (!canBeFramed(box)) return;
		const Frame frame = frameOf(box);
		for (std::size_t f = 0; f < input_.faceNum; ++f) {
			if (isInPart_[f] && isThinIn(frame, f)) addThin(f);
		}
		std::sort(thinAt_.begin(), thinAt_.end());
	}

	bool isThinIn(const Frame& frame, std::size_t f) const
	{
		std::array<Vec3f, 3> corner;
		for (std::size_t k = 0; k < 3; ++k) {
			const Vec3d p = input_.position(std::size_t(input_.triangle(f)[k]));
			if (!isFinite(p)) return false; // dropped when the part is loaded
			corner[k] = frame.toWorking(p);
		}
		return isThin(corner[0], corner[1], corner[2], margin);
	}

	void addThin(std::size_t f)
	{
		for (std::int32_t v : input_.triangle(f))
			thinAt_.push_back({v, thin_.size()});
		thin_.push_back(f);
	}

	/// Looks only at edges with an end at a thin face: few edges.
	void findBorder()
	{
		std::vector<char> isCorner(input_.vertexNum, 0);
		for (const auto& [v, i] : thinAt_)
			isCorner[std::size_t(v)] = 1;
		std::vector<EdgeSide> sides;
		for (std::size_t c = 0; c < 3 * input_.faceNum; ++c) {
			const EdgeSide side = edgeSide(input_, c);
			if (isInPart_[c / 3] &&
				(isCorner[std::size_t(side.low)] || isCorner[std::size_t(side.high)]))
				sides.push_back(side);
		}
		std::sort(sides.begin(), sides.end());
		forEachEdge(sides, [&](std::size_t begin, std::size_t end) {
			if (end - begin == 1)
				border_.insert(border_.end(), {sides[begin].low, sides[begin].high});
		});
	}
};

} // namespace

void takeOutThinBorder(const MeshView& input, std::vector<std::uint8_t>& isInPart)
{
	const std::vector<std::size_t> faces = ThinBorder(input, isInPart).faces();
	const auto partNum = std::count(isInPart.begin(), isInPart.end(), std::uint8_t(1));
	if (std::ptrdiff_t(faces.size()) == partNum) return;
	for (std::size_t f : faces)
		isInPart[f] = 0;
}

} // namespace gpr
