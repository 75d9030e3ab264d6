// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GPR_TESTS_SUPPORT_STAGES_H
#define GPR_TESTS_SUPPORT_STAGES_H

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/features/boundary_curves.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/mesh/half_edge_mesh.h>
#include <vcg_extras/core/mesh/indexed_mesh.h>
#include <vcg_extras/core/mesh_view.h>
#include <vcg_extras/core/report.h>
#include <vcg_extras/core/surface/result_mesh.h>
#include <vcg_extras/core/surface/surface_distance.h>

namespace gpr::test {

// Ways into the middle of the engine, and out of the engine again.

/// The mesh after loadInput.
IndexedMesh loaded(const TriangleMesh& mesh, Workers& workers);
/// Loaded, ordered and connected; throws std::logic_error if the mesh is not manifold.
Surface surfaceOf(const TriangleMesh& mesh, Workers& workers);
Surface surfaceOf(IndexedMesh&& mesh, Workers& workers);
/// For each half-edge: whether the faces at its edge turn by more than `degrees`.
Buffer<char> edgesThatTurn(const Surface& surface, double degrees);
/// Orders a mesh and repairs the mesh, even if the mesh is manifold.
void repair(IndexedMesh& mesh, Workers& workers, CleanCounts& counts, bool keepsPlaces = false);
/// A half-edge mesh in the numbering of the mesh, opposites found by comparing all edges. The mesh
/// must be manifold. There is room for as many more vertices and faces as asked.
HalfEdgeMesh halfEdgesOf(const TriangleMesh& mesh, int spareVertices = 0, int spareFaces = 0);
HalfEdgeMesh copyOf(const HalfEdgeMesh& mesh);

/// A result with the surface's vertices at their places: the start of tests of the stages that
/// improve a result. Border vertices know their curve.
ResultMesh resultOf(const Surface& surface, const BoundaryCurves& boundary);

/// The triangles in use, in working coordinates, without unused vertices.
TriangleMesh meshOf(const HalfEdgeMesh& mesh);
TriangleMesh meshOf(const IndexedMesh& mesh);

/// Of two meshes in the same units.
SampledDistance sampledBetween(const HalfEdgeMesh& input, const HalfEdgeMesh& result,
							   Workers& workers);

} // namespace gpr::test

#endif
