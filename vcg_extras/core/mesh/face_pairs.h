// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_MESH_FACE_PAIRS_H
#define VCG_EXTRAS_CORE_MESH_FACE_PAIRS_H

#include "face_boxes.h"

#include <vcg_extras/core/base/workers.h>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace gpr {

/// A search for pairs of faces by their boxes. Groups of 16 neighbouring faces go through the
/// tree together, for speed.
class FacePairs {
public:
	using Pair = std::pair<int, int>; ///< two faces, the smaller first

	/// wanted: per face, whether to search its pairs; empty: all faces. Both arguments must outlive
	/// this.
	FacePairs(const FaceBoxes& boxes, const std::vector<char>& wanted) :
			boxes_(boxes), wanted_(wanted)
	{
	}

	enum class Extent {
		All,     ///< all pairs
		AllFaces ///< at least one pair of each face in a pair: fewer tests where faces have many
	};

	/// Collects the pairs with a wanted face, meeting boxes and doMeet(f, g), once a pair. The list
	/// does not depend on the threads. A group of faces ends its search after mostOfGroup pairs,
	/// because thousands of faces at one place have millions of pairs: the list then lacks pairs,
	/// but is not empty. Cost: O(F log F), parallel.
	template <class Test>
	std::vector<Pair> collect(Workers& workers, Extent extent, const Test& doMeet) const
	{
		const std::size_t groupNum   = (std::size_t(boxes_.faceNum()) + groupSize - 1) / groupSize;
		constexpr std::size_t grain  = 16; // a group may have thousands of pairs
		const auto            search = [&](std::size_t begin, std::size_t end, auto& out) {
            for (std::size_t group = begin; group < end; ++group)
                if (isGroupWanted(int(group))) searchGroup(int(group), extent, doMeet, out);
		};
		return workers.collect<Pair>(groupNum, search, grain);
	}

private:
	static constexpr int fanOut     = FaceBoxes::fanOut;
	static constexpr int groupLevel = 2; ///< the level of nodes that are groups
	static constexpr int groupSize  = fanOut * fanOut;
	/// A bit for each face of a group.
	using Marks = std::uint32_t;
	/// Some hundreds for each face; a group with a face that crosses thousands of faces comes near.
	static constexpr std::size_t mostOfGroup = 256 * groupSize;

	/// The sides of a group's boxes in separate arrays, as compilers can compare several floats at
	/// once.
	class GroupSides {
	public:
		GroupSides(const Box<float>* boxes, int num)
		{
			for (int k = 0; k < groupSize; ++k) {
				const Box<float> box = k < num ? boxes[k] : Box<float>();
				lowX_[k] = box.low.x, lowY_[k] = box.low.y, lowZ_[k] = box.low.z;
				highX_[k] = box.high.x, highY_[k] = box.high.y, highZ_[k] = box.high.z;
			}
		}

		/// Sets meets[k] to whether box k meets box b.
		void compareWith(const Box<float>& b, int* meets) const
		{
			for (int k = 0; k < groupSize; ++k)
				meets[k] = int(lowX_[k] <= b.high.x) & int(b.low.x <= highX_[k]) &
						   int(lowY_[k] <= b.high.y) & int(b.low.y <= highY_[k]) &
						   int(lowZ_[k] <= b.high.z) & int(b.low.z <= highZ_[k]);
		}

	private:
		float lowX_[groupSize], lowY_[groupSize], lowZ_[groupSize];
		float highX_[groupSize], highY_[groupSize], highZ_[groupSize];
	};

	const FaceBoxes&         boxes_;
	const std::vector<char>& wanted_;

	bool isWanted(int f) const { return wanted_.empty() || wanted_[f]; }

	bool isGroupWanted(int group) const
	{
		if (wanted_.empty()) return true;
		const int end = std::min(boxes_.faceNum(), (group + 1) * groupSize);
		for (int i = group * groupSize; i < end; ++i) {
			if (wanted_[boxes_.face(i)]) return true;
		}
		return false;
	}

	/// Compares the wanted faces of a group with all faces in reach.
	template <class Test>
	void searchGroup(int group, Extent extent, const Test& doMeet, std::vector<Pair>& out) const
	{
		Marks             inPair = 0;
		const Box<float>& box    = boxes_.level(groupLevel)[group];
		const std::size_t most   = out.size() + mostOfGroup;
		const auto        isNear = [&](int level, int i) {
            // With wanted faces, an unwanted group does not search: the wanted group finds it even
            // behind.
            const bool isBehind = !wanted_.empty() || lastGroupBelow(level, i) >= group;
            return isBehind && boxes_.level(level)[i].meets(box);
		};
		boxes_.forEachNode(groupLevel, isNear, [&](int other) {
			compareGroups(group, other, extent, doMeet, inPair, out);
			return out.size() < most;
		});
	}

	static int lastGroupBelow(int level, int i)
	{
		std::int64_t end = i + 1;
		for (; level > groupLevel; --level)
			end *= fanOut;
		return int(end) - 1;
	}

	/// inPair: the faces of the group in a pair so far.
	template <class Test>
	void compareGroups(int group, int other, Extent extent, const Test& doMeet, Marks& inPair,
					   std::vector<Pair>& out) const
	{
		const int        endI   = std::min(boxes_.faceNum(), (group + 1) * groupSize);
		const int        beginK = other * groupSize;
		const int        endK   = std::min(boxes_.faceNum(), beginK + groupSize);
		const Box<float> box    = boxes_.level(groupLevel)[other];
		const GroupSides sides(&boxes_.level(0)[beginK], endK - beginK);
		int              meets[groupSize];
		Marks            othersInPair = 0;
		for (int i = group * groupSize; i < endI; ++i) {
			const Box<float> own = boxes_.level(0)[i];
			if (!own.meets(box)) continue;
			if (!isWanted(boxes_.face(i))) continue;
			sides.compareWith(own, meets);
			const Marks ownMark = Marks(1) << (i - group * groupSize);
			// The first of two wanted faces finds the second.
			for (int k = wanted_.empty() ? std::max(i + 1, beginK) : beginK; k < endK; ++k) {
				if (meets[k - beginK] == 0 || k == i) continue;
				const int f = boxes_.face(i), g = boxes_.face(k);
				if (k < i && isWanted(g)) continue;
				const Marks mark = Marks(1) << (k - beginK);
				if (extent == Extent::AllFaces && (inPair & ownMark) && (othersInPair & mark))
					continue;
				if (!doMeet(f, g)) continue;
				inPair |= ownMark;
				othersInPair |= mark;
				out.push_back(std::minmax(f, g));
			}
		}
	}
};

} // namespace gpr

#endif
