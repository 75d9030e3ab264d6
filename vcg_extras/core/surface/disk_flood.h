// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_SURFACE_DISK_FLOOD_H
#define VCG_EXTRAS_CORE_SURFACE_DISK_FLOOD_H

#include "surface_point.h"
#include "walk.h"

#include <vcg_extras/core/base/poller.h>
#include <vcg_extras/core/mesh/connect.h>

#include <cmath>
#include <optional>
#include <vector>

namespace gpr {

/// A sample of the surface: its place, the normal of its face, and the size of its disk.
struct Sample {
	SurfacePoint point;
	Vec3f        normal;
	float        size = 1; ///< radius of its disk over r, in (0, 1]
};

/// Distances of every vertex of the working surface to its nearest sample. Distance and sample lie
/// side by side, and so do both parts of a mark, because both are read together.
struct NearestField {
	struct Nearest {
		float distance; ///< along the surface, over the sample's size; to the nearest sample so far
		int   sample;   ///< nearest sample so far; -1: none
	};
	/// The last flood that reached a vertex, and the place of the vertex among the reached
	/// vertices.
	struct Mark {
		int flood, place;
	};
	Buffer<Nearest> nearest;
	Buffer<Mark>    mark;
};

/// The surface of a flood. The mesh may grow between floods. Under a density (paper §3.1.2, eq.
/// (4)) every edge is longer by the mean stretch of its ends.
struct FloodGround {
	const HalfEdgeMesh&         mesh;
	const Buffer<PackedNormal>& normal;            ///< per vertex
	const Buffer<float>*        stretch = nullptr; ///< per vertex, >= 1; nullptr = 1 everywhere
	bool useChords = true; ///< chords on flat disks without a stretch; false: unfolding everywhere
};

/// The straight way from a source over an edge to a vertex, in the plane.
struct UnfoldedWay {
	float distance   = HUGE_VALF; ///< infinite if the straight line does not cross the edge
	float share      = 0;         ///< of the edge, from its first end to the crossing
	float toCrossing = 0;         ///< distance from the source to the crossing
};

/// Computes geodesic distances from a sample up to the disk radius r, and assigns every vertex
/// nearer to this sample than to its present sample (paper §3, step 3).
///
/// Metric. Ways are straight as long as the surface is nearly flat: from an anchor, first the
/// sample, to all vertices with normals within 37° of the anchor's normal n_a, the way is the chord
/// times (1 + (1 - n·n_a)/12), exact to third order on spheres. Beyond, triangles are unfolded
/// (Kimmel and Sethian 1998; Novotni and Klein 2002). Where edges are shorter than a sixth of r,
/// the point at which a way crosses an edge is the next anchor: then only ways over creases and
/// tips are unfolded, and only there. A vertex with a noisy normal changes nothing, and a flood
/// goes to the other side of a thin sheet round its rim only. Accuracy:
/// docs/accuracy_of_distances.md.
///
/// Vertices pass their distances on in a plain queue, without a heap, and once more if a way
/// shorter by a thousandth turns up. Lengths are divided by the sample's size, so that every disk
/// ends at r. A vertex belongs to the sample with the smallest distance over its size. The first
/// vertices without an improvement keep their distances, so that updates stay accurate at the
/// borders of Voronoi cells. With a stretch all distances are found by unfolding.
class DiskFlood {
public:
	/// A vertex reached by a flood.
	struct Reached {
		int   vertex;
		float distance;
		int   anchor;
		bool  isWaiting; ///< has to pass its distance on
	};

	DiskFlood(const FloodGround& ground, NearestField& field, float radius) :
			m_(ground.mesh), normal_(ground.normal), stretch_(ground.stretch),
			useChords_(ground.useChords && ground.stretch == nullptr), field_(field),
			radius_(radius)
	{
	}
	DiskFlood(const Surface& surface, NearestField& field, float radius) :
			DiskFlood(FloodGround{surface.mesh, surface.normal}, field, radius)
	{
	}

	/// Finds the disk of a sample that may still be dropped. Afterwards metSamples() are the
	/// samples of reached vertices within r, and reached() the reached vertices.
	void explore(const Sample& sample);
	/// Assigns the vertices of the last explored disk to the sample, now called `id`, if nearer to
	/// this sample than to their present sample.
	void commit(int id);
	void run(int id, const Sample& sample)
	{
		explore(sample);
		commit(id);
	}

	const std::vector<int>&     metSamples() const { return met_; }
	const std::vector<Reached>& reached() const { return reached_; }

	/// Floods have different numbers, so that no flood takes a mark of another thread for its own.
	/// The next numbers are last + step, last + 2 step and so on.
	void numberFrom(int last, int step)
	{
		flood_ = last;
		step_  = step;
	}

	/// A disk may be as large as the surface: floods then ask whether to go on.
	void askBy(const Poller& poller) { poller_ = poller; }

private:
	/// A point of the surface from which ways go on straight.
	struct Anchor {
		Vec3f place, normal;
		float distance = 0; ///< from the sample
	};
	static constexpr int noAnchor = -1;
	/// A neighbour of the vertex that passes on.
	struct Spoke {
		int   vertex;
		float length;   ///< without a stretch
		bool  isHidden; ///< the anchor does not see the neighbour
	};

	const HalfEdgeMesh&         m_;
	const Buffer<PackedNormal>& normal_;
	const Buffer<float>*        stretch_;
	bool                        useChords_;
	NearestField&               field_;
	float                       radius_;
	int                         flood_ = 0;
	int                         step_  = 1;
	std::optional<Poller>       poller_;
	float                       scale_  = 1; ///< of lengths: 1 over the size of the sample explored
	bool                        isFine_ = false; ///< new anchors are made
	bool                        isFlat_ = false; ///< all ways so far are straight
	Vec3f                       centre_;
	std::vector<int>            met_;
	std::vector<Reached>        reached_;
	std::vector<int>            again_; ///< places of reached vertices to be visited again
	std::vector<Anchor>         anchors_;
	std::vector<Spoke>          ring_; ///< counter-clockwise

	bool           isReached(int v) const { return field_.mark[v].flood == flood_; }
	const Reached& reachedAt(int v) const { return reached_[field_.mark[v].place]; }
	float          lengthOf(const Vec3f& a, const Vec3f& b) const { return length(b - a) * scale_; }
	float          stretchAt(int v) const { return stretch_ == nullptr ? 1.0f : (*stretch_)[v]; }
	bool           isFineAt(int face) const;
	float          wayFrom(const Sample& sample, int corner) const;
	void           passOn(int place);
	bool           goStraight(const Reached& from, const Anchor& anchor);
	void           goOverBends(const Reached& from, const Anchor& anchor);
	void           goAlong(const Reached& from, const Spoke& to);
	void           goBetween(const Reached& from, const Spoke& a, const Spoke& b);
	void           goOver(const Reached& from, const Spoke& known, const Spoke& to, float between,
						  const Vec3f& normal);
	void           goOn(int v, float distance, const Anchor& next);
	bool           reach(int v, float distance, int anchor);
	bool           reachFirst(int v, float distance, int anchor);
	bool           reachAgain(int v, float distance, int anchor);
	void           meet(int vertex);
};

/// The way to the third corner a of a triangle, by unfolding: d1 is the distance of the source from
/// v, d2 from b; the lengths of v-b, v-a and a-b are given.
UnfoldedWay unfold(float d1, float d2, float lengthVB, float lengthVA, float lengthAB);

} // namespace gpr

#endif
