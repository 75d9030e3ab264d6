// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_SURFACE_DISK_FLOOD_H
#define VCG_EXTRAS_CORE_SURFACE_DISK_FLOOD_H

#include "surface_point.h"
#include "walk.h"

#include <vcg_extras/core/mesh/connect.h>

#include <vector>

namespace gpr {

/// A sample of the surface: its place, the normal of its face, and the size of its disk.
struct Sample {
	SurfacePoint point;
	Vec3f        normal;
	float        size = 1; ///< radius of its disk over r, in (0, 1]
};

/// Distances of every vertex of the working surface to its nearest sample. Distance and sample lie
/// side by side, and so do trial distance and stamp, because both are read together.
struct NearestField {
	struct Nearest {
		float distance; ///< along the surface, over the sample's size; to the nearest sample so far
		int   sample;   ///< nearest sample so far; -1: none
	};
	struct Trial {
		float distance;
		int   stamp; ///< 2·flood: reached by this flood; 2·flood + 1: settled by this flood
	};
	Buffer<Nearest> nearest;
	Buffer<Trial>   trial;
};

/// The surface of a flood. The mesh may grow between floods. Under a density (paper §3.1.2, eq.
/// (4)) every edge is longer by the mean stretch of its ends.
struct FloodGround {
	const HalfEdgeMesh&         mesh;
	const Buffer<PackedNormal>& normal;            ///< per vertex
	const Buffer<float>*        stretch = nullptr; ///< per vertex, >= 1; nullptr = 1 everywhere
	bool useChords = true; ///< chords on flat disks without a stretch; false: unfolding everywhere
};

/// Computes geodesic distances from a sample up to the disk radius r, and assigns every vertex
/// nearer to this sample than to its present sample (paper §3, step 3).
///
/// Metric. If all normals of the disk are within 37° of the sample's normal n_s, the distance is
/// the chord times (1 + (1 - n·n_s)/12), computed in a plain queue: no heap, and exact to third
/// order on spheres. Otherwise the front is propagated by unfolding triangles (Kimmel & Sethian
/// 1998; Novotni & Klein 2002). A settled vertex is visited again if a shorter way turns up: at
/// obtuse angles the triangle of the shortest way may be settled late. Accuracy:
/// docs/accuracy_of_distances.md. The check of normals keeps a flood from the other side of a thin
/// sheet. Lengths are divided by the sample's size, so that every disk ends at r. A vertex belongs
/// to the sample with the smallest distance over its size. The first vertices without an
/// improvement keep their trial distances, so that updates stay accurate at the borders of Voronoi
/// cells. With a stretch all distances are propagated by unfolding.
class DiskFlood {
public:
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
	/// samples of reached vertices within r, and visited() the reached vertices. Writes trial
	/// distances only.
	void explore(const Sample& sample);
	/// Assigns the vertices of the last explored disk to the sample, now called `id`, if nearer to
	/// this sample than to their present sample.
	void commit(int id);
	void run(int id, const Sample& sample)
	{
		explore(sample);
		commit(id);
	}

	const std::vector<int>& metSamples() const { return met_; }
	const std::vector<int>& visited() const { return queue_; }

	/// Floods of a thread are numbered. In a later round of the sampling the numbers must begin
	/// above all numbers of earlier rounds.
	int  floodNumber() const { return flood_; }
	void setFloodNumber(int n) { flood_ = n; }

private:
	struct HeapEntry {
		float distance;
		int   vertex;
	};
	/// A neighbour of the vertex being settled; its distance without a stretch.
	struct Spoke {
		int   vertex;
		float length;
	};

	const HalfEdgeMesh&         m_;
	const Buffer<PackedNormal>& normal_;
	const Buffer<float>*        stretch_;
	bool                        useChords_;
	NearestField&               field_;
	float                       radius_;
	int                         flood_           = 0;
	int                         visitedAgainNum_ = 0; ///< in this flood
	float                       scale_ = 1; ///< of lengths: 1 over the size of the sample explored
	std::vector<int>            met_;
	std::vector<int>            queue_;
	std::vector<HeapEntry>      heap_;
	std::vector<Spoke>          ring_; ///< counter-clockwise

	bool      exploreFlat(const Sample& sample);
	void      exploreUnfolding(const Sample& sample);
	void      settle(int vertex, float distance, const Sample& sample);
	float     stretchAt(int v) const { return stretch_ == nullptr ? 1.0f : (*stretch_)[v]; }
	float     wayFrom(const Sample& sample, int corner) const;
	void      tryDistance(int vertex, float distance);
	void      unfoldBetween(int v, const Spoke& a, const Spoke& b, const Sample& sample);
	void      unfoldOver(int v, const Spoke& known, const Spoke& wanted, float between,
						 const Sample& sample);
	void      meet(int vertex);
	void      pushHeap(HeapEntry e);
	HeapEntry popHeap();
};

/// Distance of the third corner a of a triangle from a source, by unfolding: d1 is the distance at
/// v, d2 the distance at b; the lengths of v-b, v-a and a-b are given. Infinite if the straight
/// line would not cross the edge v-b.
float unfoldedDistance(float d1, float d2, float lengthVB, float lengthVA, float lengthAB);

} // namespace gpr

#endif
