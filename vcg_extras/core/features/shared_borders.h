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
/// All these borders get the same samples, so that no gap opens between the sheets. Segment i of a
/// curve goes from point i to the next point.
class SharedBorders {
public:
	/// Finds equal positions along the border loops; sewSeams has made positions equal. Cost:
	/// O(B log B) for B points.
	SharedBorders(const HalfEdgeMesh& mesh, const std::vector<Curve>& curves);

	/// Whether any segment of the curve is shared.
	bool isAnyShared(int curve) const;
	bool isShared(int curve, int segment) const;
	/// Whether point i is an end of a shared segment.
	bool isOnShared(int curve, int i) const;

	/// Whether all curves through point i get a sample there, as at a fork.
	bool isStop(int curve, int i) const;
	/// Needs a border loop, as all functions below.
	void addStop(int curve, int i);

	/// Whether a curve has given the segment its samples.
	bool isSampled(int curve, int segment) const { return lineOf(curve, segment).isSampled; }
	void markSampled(int curve, int segment) { lineOf(curve, segment).isSampled = true; }
	/// share: part of the way along the segment, in the direction of the curve.
	void addSample(int curve, int segment, float share, const Vec3f& position);
	/// Calls visit(share, position) in the order of addSample.
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
		float share; ///< from the end with the smaller place
		Vec3f position;
	};
	struct Line {
		std::vector<int>    curves; ///< the curves along the line, ascending
		std::vector<Sample> samples;
		bool                isSampled = false;
	};
	std::vector<std::vector<int>>       place_;  ///< number per curve and point; empty: no loop
	std::map<std::pair<int, int>, Line> line_;   ///< by the places of both ends
	std::vector<char>                   isStop_; ///< per place

	void numberPlaces(const HalfEdgeMesh& mesh, const std::vector<Curve>& curves);
	void findStops();
	int  placeAt(int curve, int i) const;
	bool runsForward(int curve, int segment) const
	{
		return placeAt(curve, segment) < placeAt(curve, segment + 1);
	}
	std::pair<int, int> endsOf(int curve, int segment) const;
	const Line& lineOf(int curve, int segment) const { return line_.at(endsOf(curve, segment)); }
	Line&       lineOf(int curve, int segment) { return line_.at(endsOf(curve, segment)); }
};

/// Gives all border vertices at the same place the smallest of their sizes, so that edges there are
/// split alike. Needs sizes.
void equalizeSizes(Surface& surface);

} // namespace gpr

#endif
