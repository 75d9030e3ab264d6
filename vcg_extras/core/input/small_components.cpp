// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "small_components.h"

#include <algorithm>

namespace gpr {

namespace {

class ComponentSearch {
public:
	ComponentSearch(const HalfEdgeMesh& mesh, Workers& workers) :
			m_(mesh), workers_(workers), seen_(mesh.faceNum, 0)
	{
	}

	bool isSeen(int f) const { return seen_[f] != 0; }

	/// All faces joined to f, which was not seen before.
	const std::vector<int>& collect(int f)
	{
		faces_.clear();
		add(f);
		for (std::size_t i = 0; i < faces_.size(); ++i) {
			if ((i & 0xffff) == 0) workers_.poll();
			for (int h = 3 * faces_[i]; h < 3 * faces_[i] + 3; ++h) {
				if (m_.opposite[h] >= 0) add(m_.opposite[h] / 3);
			}
		}
		return faces_;
	}

private:
	const HalfEdgeMesh& m_;
	Workers&            workers_;
	std::vector<char>   seen_; ///< per face
	std::vector<int>    faces_;

	void add(int f)
	{
		if (seen_[f]) return;
		seen_[f] = 1;
		faces_.push_back(f);
	}
};

} // namespace

SmallComponents findSmallComponents(const HalfEdgeMesh& mesh, std::int64_t minFaceNum,
									Workers& workers)
{
	SmallComponents small;
	ComponentSearch search(mesh, workers);
	for (int f = 0; f < mesh.faceNum; ++f) {
		if (search.isSeen(f)) continue;
		const std::vector<int>& faces = search.collect(f);
		if (std::int64_t(faces.size()) >= minFaceNum) continue;
		++small.num;
		small.faces.insert(small.faces.end(), faces.begin(), faces.end());
	}
	std::sort(small.faces.begin(), small.faces.end());
	return small;
}

} // namespace gpr
