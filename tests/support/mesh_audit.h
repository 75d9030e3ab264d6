// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GPR_TESTS_SUPPORT_MESH_AUDIT_H
#define GPR_TESTS_SUPPORT_MESH_AUDIT_H

#include <vcg_extras/core/mesh/half_edge_mesh.h>
#include <vcg_extras/core/mesh_view.h>

#include <cstdint>
#include <gtest/gtest.h>
#include <string>

namespace gpr::test {

/// Facts about a list of triangles, computed from the list alone, without half-edges and without
/// the engine.
struct SurfaceFacts {
	std::int64_t indicesOutOfRange = 0;
	std::int64_t repeatedCorners   = 0; ///< faces with the same vertex twice
	std::int64_t unusedVertices    = 0;
	std::int64_t notFinite         = 0; ///< vertices
	std::int64_t crowdedEdges      = 0; ///< more than two faces
	std::int64_t againstEachOther  = 0; ///< edges whose two faces give the same direction
	std::int64_t brokenFans        = 0; ///< vertices whose faces are no single fan and no full ring
	std::int64_t duplicateFaces    = 0; ///< the same three vertices in any order
	std::int64_t zeroAreaFaces     = 0;
	std::int64_t usedVertices      = 0;
	std::int64_t edges             = 0;
	std::int64_t faces             = 0;
	std::int64_t borderEdges       = 0;
	std::int64_t components        = 0; ///< faces linked over edges
	std::int64_t boundaryLoops     = 0;
	double       area              = 0;

	std::int64_t euler() const { return usedVertices - edges + faces; }
	/// An oriented 2-manifold with border, shape aside.
	bool isManifold() const;
	/// A sentence of all faults; empty for a sound surface.
	std::string complaints() const;
};

SurfaceFacts factsOf(const TriangleMesh& mesh);

/// The centroid of a face.
Vec3d middleOf(const TriangleMesh& mesh, std::size_t face);

/// Whether the mesh is an oriented 2-manifold with border, without unused vertices and without
/// degenerate faces.
::testing::AssertionResult isSoundSurface(const TriangleMesh& mesh);

/// Equal numbers of components and border loops, and equal Euler characteristic.
::testing::AssertionResult hasSameTopology(const TriangleMesh& a, const TriangleMesh& b);

/// Whether the half-edge table agrees with its triangles: opposites are found by comparing all
/// edges; outgoing[v] leaves v and is a border edge if v has a border edge. Unused faces and
/// vertices are skipped.
::testing::AssertionResult isSoundTable(const HalfEdgeMesh& mesh);

} // namespace gpr::test

#endif
