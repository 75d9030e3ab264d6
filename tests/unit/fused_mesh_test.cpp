// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The mutual tessellation: samples become vertices by splits, and nothing else changes.

#include <tests/support/mesh_audit.h>
#include <tests/support/mesh_builders.h>
#include <tests/support/stages.h>
#include <vcg_extras/core/sampling/fused_mesh.h>

#include <cmath>
#include <gtest/gtest.h>
#include <set>

namespace gpr::test {

namespace {

Vec3f centreOf(const HalfEdgeMesh& m, int f)
{
	return (m.position[m.origin[3 * f]] + m.position[m.origin[3 * f + 1]] +
			m.position[m.origin[3 * f + 2]]) *
		   (1 / 3.0f);
}

/// Every face of the tessellation lies in its parent: so do its centre and its normal, and the
/// areas of a parent's faces add up to its own.
void expectInParents(const FusedMesh& fused, const Surface& surface)
{
	std::vector<double> area(surface.mesh.faceNum, 0.0);
	for (int f = 0; f < fused.mesh.faceNum; ++f) {
		const int parent = fused.parentFace[f];
		ASSERT_TRUE(parent >= 0 && parent < surface.mesh.faceNum);
		area[parent] += double(length(fused.mesh.faceCross(f)));
		const Vec3f n    = surface.mesh.faceNormal(parent);
		const Vec3f from = surface.mesh.position[surface.mesh.origin[3 * parent]];
		ASSERT_NEAR(double(dot(n, centreOf(fused.mesh, f) - from)), 0, 1e-6);
	}
	for (int f = 0; f < surface.mesh.faceNum; ++f) {
		const double whole = double(length(surface.mesh.faceCross(f)));
		ASSERT_NEAR(area[f], whole, 1e-5 * whole + 1e-9);
	}
}

TEST(FusedMesh, SplitsInnerAndBorderEdgesWithinTheirParents)
{
	Workers       workers(1, nullptr);
	const Surface surface = surfaceOf(grid(4, 3), workers);
	FusedMesh     fused   = beginFusion(surface, workers);
	for (int i = 0; i < 400; ++i) {
		const int   h     = (i * 7919) % fused.mesh.halfEdgeNum();
		const int   begin = fused.mesh.origin[h];
		const Vec3f a = fused.mesh.position[begin], b = fused.mesh.position[fused.mesh.target(h)];
		const int   v = splitAt(fused, h, a + (b - a) * 0.4f);
		EXPECT_EQ(v, surface.mesh.vertexNum + i);
		EXPECT_EQ(fused.mesh.origin[h], begin);
		EXPECT_EQ(fused.mesh.target(h), v);
	}
	EXPECT_TRUE(isSoundTable(fused.mesh));
	EXPECT_TRUE(hasSameTopology(meshOf(fused.mesh), meshOf(surface.mesh)));
	expectInParents(fused, surface);
}

/// Whatever the spacing: several samples on a segment, or many segments to a sample.
TEST(FuseBoundary, MakesEverySampleABorderVertexAtItsPlace)
{
	Workers workers(1, nullptr);
	for (const TriangleMesh& mesh : {squareFrame(12, 4), openCylinder(24, 5, 0.5, 1), grid(2, 2)}) {
		const Surface surface = surfaceOf(mesh, workers);
		for (float spacing : {0.013f, 0.1f, 0.4f}) {
			const BoundaryCurves boundary = sampleBoundary(surface, spacing, spacing, workers);
			FusedMesh            fused    = beginFusion(surface, workers);
			fuseBoundary(boundary, fused);
			ASSERT_EQ(fused.sampleVertex.size(), boundary.samples.size());
			const std::set<int> different(fused.sampleVertex.begin(), fused.sampleVertex.end());
			EXPECT_EQ(different.size(), boundary.samples.size());
			for (std::size_t s = 0; s < boundary.samples.size(); ++s) {
				const int v = fused.sampleVertex[s];
				ASSERT_TRUE(fused.mesh.isBorderVertex(v));
				ASSERT_LE(length(fused.mesh.position[v] - boundary.samples[s].point.position),
						  1e-5f);
			}
			EXPECT_TRUE(isSoundTable(fused.mesh));
			EXPECT_TRUE(hasSameTopology(meshOf(fused.mesh), mesh));
			expectInParents(fused, surface);
		}
	}
}

} // namespace

} // namespace gpr::test
