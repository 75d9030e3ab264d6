// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_INPUT_SPLIT_LONG_EDGES_H
#define VCG_EXTRAS_CORE_INPUT_SPLIT_LONG_EDGES_H

#include "load.h"

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/mesh/indexed_mesh.h>

#include <cstdint>
#include <vector>

namespace gpr {

/// Longest edge of the mesh that the sampling works on, in r.
constexpr float longestEdgeInRadii = 0.8f;
/// Where few edges are longer, up to this: single long edges in a dense scan do no harm, and
/// splitting them all would make a tenth more of everything.
constexpr float longestSingleEdge = 1.1f;
/// How many times longer than allowed the longest edge of a needle is. Halving makes 81 faces of
/// this one where a strip has 32; below that the two are alike.
constexpr float minNeedleLength = 16;

/// Stage::SplitLongEdges: splits edges longer than maxLength at their midpoints, as often as
/// needed, so that a disk always covers a few vertices. Where the mesh has sizes an edge may be
/// maxLength times the lesser size of its ends; new vertices take the mean of the two. This removes
/// both weaknesses that the paper admits (§4): stray huge triangles, and targets near the input's
/// own vertex number. The surface stays where it is. A face so thin and long that only one row of
/// faces has room in it becomes such a row at once. Only faces with a long edge are looked at
/// again; their midpoints are found by hashing. Returns the number of edges split; throws
/// Failure{OutOfMemory} where the result would have more than maxFaces faces.
std::int64_t splitLongEdges(IndexedMesh& mesh, float maxLength, std::int64_t maxFaces,
							Workers& workers);

/// Faces with an edge that is too long, ascending. Cost: a parallel pass.
std::vector<int> findLongFaces(const IndexedMesh& mesh, float maxLength, Workers& workers);
/// The same for a mesh without sizes whose faces were measured. Cost: a parallel pass over the
/// groups of faces that have such an edge.
std::vector<int> findLongFaces(const IndexedMesh& mesh, const FaceExtents& extents, float maxLength,
							   Workers& workers);
/// The same for a surface that is connected.
std::vector<int> findLongFaces(const Surface& surface, float maxLength, Workers& workers);
/// Those among some faces. Cost: theirs alone.
std::vector<int> findLongFaces(const IndexedMesh& mesh, float maxLength,
							   const std::vector<int>& among, Workers& workers);
/// The same for long faces that are known already. Cost: theirs alone.
std::int64_t splitLongEdges(IndexedMesh& mesh, const std::vector<int>& longFaces, float maxLength,
							std::int64_t maxFaces, Workers& workers);

/// What long faces are split into.
struct SplitFaces {
	struct Face {
		int corner[3]; ///< from the mesh's number of vertices on: the new ones, in their order
		int source;    ///< the caller's face it is part of
	};
	std::vector<Face>  faces;
	std::vector<Vec3f> position; ///< of the new vertices, working coordinates; one for each split
	std::vector<float> size;     ///< of the new vertices; empty where the mesh has no sizes
};

/// The same for the long faces of a surface, which stays as it is: refineSurface puts them in.
SplitFaces splitLongFaces(const Surface& surface, const std::vector<int>& longFaces,
						  float maxLength, std::int64_t maxFaces, Workers& workers);

} // namespace gpr

#endif
