// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_INPUT_SPLIT_LONG_EDGES_H
#define VCG_EXTRAS_CORE_INPUT_SPLIT_LONG_EDGES_H

#include "load.h"

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/connect.h>

#include <cstdint>
#include <vector>

namespace gpr {

/// Longest edge of the working surface, in disk radii.
constexpr float longestEdgeInRadii = 0.8f;
/// The longest edge if few edges are longer than longestEdgeInRadii: single long edges in a dense
/// scan do no harm, and splitting all of these would make a tenth more vertices and faces.
constexpr float longestSingleEdge = 1.1f;
/// Least longest edge of a needle, as a multiple of the allowed length. Halving makes 81 faces of
/// such a needle, a strip has 32; for shorter needles both are alike.
constexpr float minNeedleLength = 16;

/// Stage::SplitLongEdges: splits edges of known long faces that are longer than maxLength at their
/// midpoints, as often as needed, so that a disk always covers a few vertices. In a mesh with sizes
/// an edge may be maxLength times the smaller size of its ends; a new vertex takes the mean of both
/// sizes. This removes both weaknesses admitted by the paper (§4): stray huge triangles, and
/// targets near the input's own number of vertices. The surface stays in place. A face so thin and
/// long that only one row of faces fits becomes a row of faces at once. Returns the number of split
/// edges; throws Failure{OutOfMemory} if the mesh would get more than maxFaces faces. Cost: each
/// round visits long faces only; midpoints are found by hashing.
std::int64_t splitLongEdges(IndexedMesh& mesh, const std::vector<int>& longFaces, float maxLength,
							std::int64_t maxFaces, Workers& workers);

/// Faces with an edge that is too long, ascending, of a mesh without sizes and with known extents.
/// Cost: a parallel pass over the groups of faces with such an edge.
std::vector<int> findLongFaces(const IndexedMesh& mesh, const FaceExtents& extents, float maxLength,
							   Workers& workers);
/// The long faces among given faces. Cost: a look at the given faces.
std::vector<int> findLongFaces(const IndexedMesh& mesh, float maxLength,
							   const std::vector<int>& among, Workers& workers);

/// Most faces after splitting long edges, for a mesh of faceNum faces and a result of vertexNum
/// vertices.
std::int64_t maxFacesFor(std::int64_t vertexNum, std::int64_t faceNum);

/// Faces with edges that are too long for the sampling.
struct LongFaces {
	std::vector<int> faces;
	float            longest = 0; ///< edges longer than this are split, working units
};

/// The faces of a mesh that are too long for disks of this radius.
LongFaces findTooLong(const IndexedMesh& mesh, const FaceExtents& extents, float radius,
					  Workers& workers);

/// The faces of a surface with an edge above `longest` times the smaller size of its ends.
LongFaces findTooLong(const Surface& surface, float longest, Workers& workers);

/// Raises the sizes at the corners of long faces, until no edge is too long.
void raiseSizes(const LongFaces& tooLong, Surface& surface);

} // namespace gpr

#endif
