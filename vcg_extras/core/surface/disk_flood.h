// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_SURFACE_DISK_FLOOD_H
#define VCG_EXTRAS_CORE_SURFACE_DISK_FLOOD_H

#include "surface_point.h"
#include "walk.h"

#include <vcg_extras/core/mesh/connect.h>

#include <vector>

namespace gpr {

/// A sample of the surface: where it lies, the normal of its face, and how large its disk is.
struct Sample {
	SurfacePoint point;
	Vec3f        normal;
	float        size = 1; ///< radius of its disk over r, in (0, 1]
};

/// What the sampling knows about every vertex of the input. Distance and sample, trial distance and
/// stamp lie side by side because they are read together.
struct NearestField {
	struct Nearest {
		float distance; ///< geodesic over the sample's size, to the nearest sample so far
		int   sample;   ///< that sample; -1 while there is none
	};
	struct Trial {
		float distance;
		int   stamp; ///< 2·flood: reached by that flood; 2·flood + 1: settled by it
	};
	Buffer<Nearest> nearest;
	Buffer<Trial>   trial;
};

/// What floods run on. The mesh may grow between them. Under a density (paper §3.1.2, eq. (4))
/// every way is longer by the mean stretch of the ends of its edges.
struct FloodGround {
	const HalfEdgeMesh&         mesh;
	const Buffer<PackedNormal>& normal;            ///< per vertex
	const Buffer<float>*        stretch = nullptr; ///< per vertex, >= 1; nullptr = 1 everywhere
	bool useChords = true; ///< where all is flat and not stretched; false: unfolding everywhere
};

/// Computes geodesic distances from a sample up to the disk radius r and takes every vertex that is
/// nearer to it than to its present sample (paper §3, step 3).
///
/// Metric. Where all normals met are within 37° of the sample's, the distance is the chord,
/// lengthened by (1 + (1 - n·n_s)/12), in a plain queue: no heap, and exact to third order on
/// spheres. Otherwise the front is propagated by unfolding triangles (Kimmel & Sethian 1998;
/// Novotni & Klein 2002), and vertices are visited again where a shorter way turns up: at obtuse
/// angles the triangle that holds it may be settled late. Accuracy: docs/accuracy_of_distances.md.
/// Since normals are looked at along the flood, a thin sheet's other side is never taken for near.
/// Lengths are divided by the sample's size, so that every disk ends at r and a vertex belongs to
/// the sample that it lies deepest in the disk of. The ring that did not improve keeps its trial
/// distance, so that updates stay accurate where Voronoi cells meet. Under a stretch all is
/// propagated by unfolding.
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

	/// Finds the disk of a sample that may still be given up: afterwards metSamples() are the
	/// samples that own vertices within r that the flood came to, and visited() the vertices it
	/// looked at. Nothing but trial distances is written.
	void explore(const Sample& sample);
	/// Takes the vertices of the disk explored last that are nearer to the sample, now called `id`,
	/// than to their present one.
	void commit(int id);
	void run(int id, const Sample& sample)
	{
		explore(sample);
		commit(id);
	}

	const std::vector<int>& metSamples() const { return met_; }
	const std::vector<int>& visited() const { return queue_; }

	/// Floods of one thread are numbered; a later phase must begin above every number of an earlier
	/// one.
	int  floodNumber() const { return flood_; }
	void setFloodNumber(int n) { flood_ = n; }

private:
	struct HeapEntry {
		float distance;
		int   vertex;
	};
	/// A neighbour of the vertex being settled, and how far off it is without a stretch.
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
	int                         visitedAgainNum_ = 0; ///< by this flood
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

/// Distance of the third corner of a triangle from a source whose distances to the other two are
/// known, by unfolding: d1 at v, d2 at b, lengths of v-b, v-a and a-b given. Infinite where the
/// straight line would leave the edge v-b.
float unfoldedDistance(float d1, float d2, float lengthVB, float lengthVA, float lengthAB);

} // namespace gpr

#endif
