// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_FEATURES_SHARED_BORDERS_H
#define VCG_EXTRAS_CORE_FEATURES_SHARED_BORDERS_H

#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/surface/curve.h>

#include <map>
#include <utility>
#include <vector>

namespace gpr {

/// Borders that lie at the same place but stay cut, as when three sheets meet (see sew_seams.h).
/// Such borders are sampled once, and all get the same samples, so that no gap opens between the
/// sheets. Segment i of a curve goes from point i to the next point.
class SharedBorders {
public:
	/// Finds equal positions along the closed curves at the border. Sewing has given equal
	/// positions to edges at the same place. Cost: O(B log B) for B points of the border.
	SharedBorders(const HalfEdgeMesh& mesh, const std::vector<Curve>& curves);

	/// Whether any segment of the curve is shared.
	bool isAnyShared(int curve) const;
	bool isShared(int curve, int segment) const;
	/// Whether point i is an end of a shared segment.
	bool isOnShared(int curve, int i) const;

	/// Whether every curve through point i must have a sample there.
	bool isStop(int curve, int i) const;
	void addStop(int curve, int i);

	/// Whether the segment has got its samples from one of its curves.
	bool isSampled(int curve, int segment) const;
	void markSampled(int curve, int segment);
	/// share: part of the way along the segment, in the direction of the curve.
	void addSample(int curve, int segment, float share, const Vec3f& position);
	/// Calls visit(share, position).
	template <class Visit>
	void forEachSample(int curve, int segment, const Visit& visit) const
	{
		const Line& line      = lineOf(curve, segment);
		const bool  isForward = runsForward(curve, segment);
		for (const Sample& s : line.samples)
			visit(isForward ? s.share : 1 - s.share, s.position);
	}

private:
	struct Sample {
		float share; ///< from the end with the smaller number
		Vec3f position;
	};
	struct Line {
		std::vector<int>    curves; ///< the curves along the line, ascending
		std::vector<Sample> samples;
		bool                isSampled = false;
	};
	std::vector<std::vector<int>>       place_;  ///< per curve and point; empty: not of the border
	std::map<std::pair<int, int>, Line> line_;   ///< by the places of both ends
	std::vector<char>                   isStop_; ///< per place

	void        numberPlaces(const HalfEdgeMesh& mesh, const std::vector<Curve>& curves);
	void        findStops();
	int         placeAt(int curve, int i) const;
	bool        runsForward(int curve, int segment) const;
	const Line& lineOf(int curve, int segment) const;
	Line&       lineOf(int curve, int segment);
};

/// Gives all border vertices at the same place the smallest of their sizes, so that the edges there
/// are split alike.
void equalizeSizes(Surface& surface);

} // namespace gpr

#endif
