// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fine_spots.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace gpr {

namespace {

/// How strongly the next trial reacts to places beyond the error bound.
struct Effort {
	double reachInEdges; ///< radius of smaller triangles round a place, in ideal edges
	/// Factor on the size that would suffice if the error were proportional to the size, as on
	/// creases and rims. Below 1, because each trial places samples elsewhere.
	double caution;
};

/// The first trial leaves many far places, the second fewer; later trials shall leave none.
constexpr Effort effortOfTrial[] = {{1.2, 0.75}, {1.5, 0.6}, {1.5, 0.5}};
constexpr double leastOfTrial = 0.3, mostOfTrial = 0.8;

/// A grid whose cells list the spots that reach into the cell.
class SpotGrid {
public:
	SpotGrid(std::vector<FineSpot> spots, const Frame& frame)
	{
		// Each list begins with the smallest factor: a search ends at the first spot in reach,
		// which matters where thousands of spots overlap.
		std::stable_sort(spots.begin(), spots.end(),
						 [](const FineSpot& a, const FineSpot& b) { return a.factor < b.factor; });
		for (const FineSpot& s : spots)
			cell_ = std::max(cell_, float(s.reach * frame.scale));
		if (!(cell_ > 0)) return;
		for (const FineSpot& s : spots)
			add({frame.toWorking(s.position), float(s.reach * frame.scale), float(s.factor)});
	}

	/// The smallest factor of the spots that reach p.
	float factorAt(const Vec3f& p) const
	{
		const auto found = spots_.find(keyOf(cellOf(p.x), cellOf(p.y), cellOf(p.z)));
		if (found == spots_.end()) return 1;
		const auto reaches = [&](const Spot& s) {
			return squaredLength(p - s.centre) <= s.reach * s.reach;
		};
		const std::vector<Spot>& near = found->second;
		const auto               spot = std::find_if(near.begin(), near.end(), reaches);
		return spot != near.end() ? spot->factor : 1;
	}

private:
	struct Spot {
		Vec3f centre;
		float reach, factor;
	};

	float                                                cell_ = 0;
	std::unordered_map<std::uint64_t, std::vector<Spot>> spots_;

	/// The bounding box measures about one working unit, so 21 bits are enough for all cells that
	/// matter.
	int cellOf(float x) const
	{
		return int(std::floor(std::min(1e6f, std::max(-1e6f, x / std::max(cell_, 1e-30f)))));
	}
	static std::uint64_t keyOf(int i, int j, int k)
	{
		const auto part = [](int n) { return std::uint64_t(n) & 0x1fffff; };
		return part(i) << 42 | part(j) << 21 | part(k);
	}

	void add(const Spot& s)
	{
		const Vec3f reach(s.reach, s.reach, s.reach);
		const Vec3f low = s.centre - reach, high = s.centre + reach;
		for (int i = cellOf(low.x); i <= cellOf(high.x); ++i)
			for (int j = cellOf(low.y); j <= cellOf(high.y); ++j)
				for (int k = cellOf(low.z); k <= cellOf(high.z); ++k)
					spots_[keyOf(i, j, k)].push_back(s);
	}
};

} // namespace

void addSpots(const std::vector<FarPlace>& places, const TrialOfSpots& trial, const Frame& frame,
			  std::vector<FineSpot>& spots)
{
	const Effort& effort = effortOfTrial[std::min<std::size_t>(trial.before, 2)];
	for (const FarPlace& place : places) {
		FineSpot spot;
		spot.position = frame.toCaller(Vec3f(place.position));
		spot.reach    = (effort.reachInEdges * trial.edge + place.distance) / frame.scale;
		spot.factor =
			std::clamp(effort.caution * trial.goal / place.distance, leastOfTrial, mostOfTrial);
		spots.push_back(spot);
	}
}

Buffer<float> factorsOf(const FineSpots& spots, const Surface& surface, Workers& workers)
{
	const HalfEdgeMesh& m = surface.mesh;
	Buffer<float>       factor(std::size_t(m.vertexNum), 1.0f);
	for (const std::vector<FineSpot>& ofTrial : spots) {
		if (ofTrial.empty()) continue;
		const SpotGrid grid(ofTrial, surface.frame);
		workers.forEach(factor.size(),
						[&](int v) { factor[v] *= grid.factorAt(m.position[std::size_t(v)]); });
	}
	workers.forEach(factor.size(), [&](int v) { factor[v] = std::max(leastFactor, factor[v]); });
	return factor;
}

} // namespace gpr
