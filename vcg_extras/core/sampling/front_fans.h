// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_SAMPLING_FRONT_FANS_H
#define VCG_EXTRAS_CORE_SAMPLING_FRONT_FANS_H

#include <vcg_extras/core/base/sort_unique.h>

#include <algorithm>
#include <vector>

namespace gpr {

/// The memory of a block's sampling: for each sample, the samples near it when its intersections
/// were searched, and the samples placed near it since. So an intersection can be rejected as taken
/// without a look at the surface.
///
/// Fans are numbered: first come the samples that reached into the block before its sampling began,
/// ascending, then the new samples of the block in order.
class FrontFans {
public:
	/// Begins anew. earlier: samples that reach into the block, ascending. firstNew: the number of
	/// the first new sample of the block.
	void clear(std::vector<int> earlier, int firstNew)
	{
		earlier_  = std::move(earlier);
		firstNew_ = firstNew;
		fans_.clear();
		near_.clear();
		newcomers_.clear();
	}

	const std::vector<int>& earlier() const { return earlier_; }

	/// Adds a fan with the samples in `near`. maxCrossings: the most faces of a walk to an
	/// intersection of the fan.
	void add(const std::vector<int>& near, int maxCrossings)
	{
		const int first = int(near_.size());
		near_.insert(near_.end(), near.begin(), near.end());
		fans_.push_back({first, int(near_.size()), maxCrossings, -1});
	}
	int last() const { return int(fans_.size()) - 1; }
	int maxCrossings(int fan) const { return fans_[fan].maxCrossings; }

	/// Adds `newcomer`, placed near `sample`, to the fan of `sample`, if there is such a fan.
	void tellNewcomer(int sample, int newcomer)
	{
		const int fan = fanOf(sample);
		if (fan < 0) return;
		newcomers_.push_back({newcomer, fans_[fan].newest});
		fans_[fan].newest = int(newcomers_.size()) - 1;
	}

	/// Whether isIt(sample) holds for any sample near when the fan was made.
	template <class IsIt>
	bool anyNear(int fan, const IsIt& isIt) const
	{
		return std::any_of(near_.begin() + fans_[fan].firstNear, near_.begin() + fans_[fan].endNear,
						   isIt);
	}
	/// Whether isIt(sample) holds for any sample placed near since then; the newest comes first.
	template <class IsIt>
	bool anyNewcomer(int fan, const IsIt& isIt) const
	{
		for (int i = fans_[fan].newest; i >= 0; i = newcomers_[i].older) {
			if (isIt(newcomers_[i].sample)) return true;
		}
		return false;
	}

private:
	struct Fan {
		int firstNear, endNear; ///< in near_
		int maxCrossings;
		int newest; ///< index of the latest newcomer; -1: none
	};
	struct Newcomer {
		int sample;
		int older; ///< index of the fan's newcomer before; -1: none
	};

	std::vector<int>      earlier_;
	int                   firstNew_ = 0;
	std::vector<Fan>      fans_;
	std::vector<int>      near_;
	std::vector<Newcomer> newcomers_; ///< a list for each fan

	int fanOf(int sample) const
	{
		const int earlierNum = int(earlier_.size());
		const int own        = earlierNum + sample - firstNew_;
		if (sample >= firstNew_ && own <= last()) return own;
		return placeIn(earlier_, sample);
	}
};

} // namespace gpr

#endif
