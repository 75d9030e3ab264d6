// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <tests/support/mesh_builders.h>
#include <tests/support/stages.h>
#include <tests/support/transforms.h>
#include <vcg_extras/core/mesh/measure.h>
#include <vcg_extras/core/mesh/mesh_edit.h>
#include <vcg_extras/core/output/audit.h>
#include <vcg_extras/core/output/face_point.h>
#include <vcg_extras/core/surface/normal_agreement.h>

#include <cmath>
#include <functional>
#include <gtest/gtest.h>

namespace gpr::test {

namespace {

/// A good result, damaged by `damage`, and audited.
AuditFigures auditAfter(const TriangleMesh& mesh, const std::function<void(HalfEdgeMesh&)>& damage,
						std::int64_t target = 0)
{
	Workers           workers(2, nullptr);
	const Surface     surface = surfaceOf(mesh, workers);
	ResultMesh        result  = resultOf(surface, {});
	const MeshFigures input   = figuresOf(surface.mesh, 1, workers);
	damage(result.mesh);
	const MeshFigures  output  = figuresOf(result.mesh, 1, workers);
	const AuditFigures figures = audit(surface, result, input, output, target, workers);
	EXPECT_EQ(figures.passed, describeFailure(figures).empty());
	return figures;
}

void nothing(HalfEdgeMesh&) {}

TEST(Audit, PassesWhatIsGood)
{
	Random random(1);
	for (const TriangleMesh& mesh : {icosphere(3), grid(9, 7), torus(20, 12), twoSheets(5, 0.1),
									 withHoles(grid(20, 20), 2, random)}) {
		const AuditFigures a = auditAfter(mesh, nothing, std::int64_t(mesh.vertexNum()));
		EXPECT_TRUE(a.passed) << describeFailure(a);
		EXPECT_TRUE(a.countExact && a.componentsKept && a.boundaryLoopsKept && a.eulerKept);
	}
}

TEST(Audit, CatchesAnotherCountThanPromised)
{
	const AuditFigures a = auditAfter(icosphere(2), nothing, 163);
	EXPECT_FALSE(a.passed);
	EXPECT_FALSE(a.countExact);
}

TEST(Audit, CatchesAWrongOpposite)
{
	EXPECT_FALSE(
		auditAfter(icosphere(2), [](HalfEdgeMesh& m) { m.opposite[30] = m.opposite[60]; }).passed);
	EXPECT_FALSE(auditAfter(icosphere(2), [](HalfEdgeMesh& m) { m.opposite[30] = -1; }).passed);
}

/// The input figures are the good result's: only the table is wrong.
TEST(Audit, CatchesAVertexTwiceInAFace)
{
	Workers           workers(1, nullptr);
	const Surface     surface = surfaceOf(icosphere(2), workers);
	ResultMesh        result  = resultOf(surface, {});
	const MeshFigures good    = figuresOf(result.mesh, 1, workers);
	result.mesh.origin[33]    = result.mesh.origin[34];
	EXPECT_FALSE(audit(surface, result, good, good, 0, workers).passed);
}

TEST(Audit, CatchesADuplicateFace)
{
	// Two faces with the same corners, glued along all three sides, beside the rest.
	const AuditFigures a = auditAfter(
		joined(icosphere(1), {{{3, 0, 0}, {4, 0, 0}, {3, 1, 0}}, {0, 1, 2}}), [](HalfEdgeMesh& m) {
			const int f = [&] {
				for (int h = 0; h < m.halfEdgeNum(); h += 3)
					if (m.opposite[h] < 0 && m.opposite[h + 1] < 0) return h / 3;
				return -1;
			}();
			reserve(m, m.vertexNum, m.faceNum + 1);
			const int e     = 3 * m.faceNum++;
			m.origin[e]     = m.origin[3 * f];
			m.origin[e + 1] = m.origin[3 * f + 2];
			m.origin[e + 2] = m.origin[3 * f + 1];
			for (int k = 0; k < 3; ++k) {
				m.opposite[3 * f + k] = e + 2 - k;
				m.opposite[e + 2 - k] = 3 * f + k;
			}
		});
	EXPECT_FALSE(a.passed);
	EXPECT_EQ(a.duplicateFaces, 1);
}

TEST(Audit, CatchesAFaceTurnedOver)
{
	const AuditFigures a =
		auditAfter(icosphere(2), [](HalfEdgeMesh& m) { std::swap(m.origin[30], m.origin[31]); });
	EXPECT_FALSE(a.passed);
	EXPECT_GT(a.nonManifoldEdges, 0);
}

TEST(Audit, CatchesADroppedFace)
{
	const AuditFigures a = auditAfter(icosphere(2), [](HalfEdgeMesh& m) {
		// Properly taken out, with borders round the hole: only the topology tells.
		const int last = m.faceNum - 1;
		for (int h = 3 * last; h < 3 * last + 3; ++h) {
			const int g             = m.opposite[h];
			m.opposite[g]           = -1;
			m.outgoing[m.origin[g]] = g;
		}
		m.faceNum = last;
	});
	EXPECT_FALSE(a.passed);
	EXPECT_EQ(a.nonManifoldEdges, 0);
	EXPECT_FALSE(a.boundaryLoopsKept);
	EXPECT_FALSE(a.eulerKept);
}

/// Each figure of the topology alone is wrong.
TEST(Audit, CatchesEachChangeOfTopology)
{
	Workers           workers(1, nullptr);
	const Surface     surface = surfaceOf(icosphere(2), workers);
	const ResultMesh  result  = resultOf(surface, {});
	const MeshFigures good    = figuresOf(result.mesh, 1, workers);
	const auto        against = [&](std::int64_t MeshFigures::*figure) {
        MeshFigures input = good;
        input.*figure += 1;
        const AuditFigures a = audit(surface, result, input, good, 0, workers);
        EXPECT_FALSE(a.passed);
        EXPECT_FALSE(describeFailure(a).empty());
        return a;
	};
	EXPECT_FALSE(against(&MeshFigures::components).componentsKept);
	EXPECT_FALSE(against(&MeshFigures::boundaryLoops).boundaryLoopsKept);
	EXPECT_FALSE(against(&MeshFigures::eulerCharacteristic).eulerKept);
	EXPECT_TRUE(audit(surface, result, good, good, 0, workers).passed);
}

TEST(Audit, CatchesCoordinatesThatAreNotFinite)
{
	for (float bad : {NAN, HUGE_VALF}) {
		const AuditFigures a =
			auditAfter(icosphere(2), [bad](HalfEdgeMesh& m) { m.position[7].z = bad; });
		EXPECT_FALSE(a.passed);
		EXPECT_EQ(a.nonFinitePositions, 1);
	}
}

TEST(Audit, CatchesAFaceWithoutArea)
{
	const AuditFigures a = auditAfter(
		icosphere(2), [](HalfEdgeMesh& m) { m.position[m.origin[0]] = m.position[m.origin[1]]; });
	EXPECT_FALSE(a.passed);
	EXPECT_EQ(a.zeroAreaFaces, 2);
}

/// A vertex pushed beyond its ring folds faces over: counted, and told apart from broken promises.
TEST(Audit, CountsFacesThatLookAgainstTheSurface)
{
	const AuditFigures a = auditAfter(grid(9, 9), [](HalfEdgeMesh& m) {
		for (int v = 0; v < m.vertexNum; ++v) {
			if (m.isBorderVertex(v)) continue;
			m.position[v].x +=
				1.4f / 9; // beyond the next column; a working unit is two of the mesh's
			return;
		}
	});
	EXPECT_GT(a.invertedFaces, 0);
	EXPECT_TRUE(a.passed);
}

/// The inverted faces are exactly the faces that look down, although corners of their neighbours
/// look down, too.
TEST(Audit, CountsAsInvertedWhatLooksAgainstWhatItStandsFor)
{
	Random       random(4);
	std::int64_t num = 0;
	for (int i = 0; i < 20; ++i) {
		int         down = 0;
		const Vec3f push = {float(random.between(-0.2, 0.2)), float(random.between(-0.2, 0.2)), 0};
		const AuditFigures figures = auditAfter(grid(9, 9), [&](HalfEdgeMesh& m) {
			m.position[m.vertexNum / 2] += push;
			for (int f = 0; f < m.faceNum; ++f)
				down += m.faceCross(f).z < 0;
		});
		EXPECT_EQ(figures.invertedFaces, down);
		num += down;
	}
	EXPECT_GT(num, 0);
}

/// The corners of a face on a thin plate may lie on its rim, whose normals point aside or down.
TEST(Audit, CountsNoFaceAsInvertedForTheRimThatItsCornersLieOn)
{
	Workers             workers(1, nullptr);
	const Surface       surface   = surfaceOf(thinPlate(12, 0.02), workers);
	const ResultMesh    result    = resultOf(surface, {});
	const HalfEdgeMesh& m         = surface.mesh;
	const auto          looksDown = [&](int f) {
        return smoothNormal(surface, {m.faceCentre(f), f}).z < -0.9f;
	};
	int below = 0;
	while (!looksDown(below))
		++below;
	int suspects = 0;
	for (int f = 0; f < m.faceNum; ++f) {
		if (m.faceNormal(f).z < 0.9f) continue;
		ResultMesh damaged = copyResult(result, workers);
		for (int h = 3 * f; h < 3 * f + 2; ++h)
			damaged.vertex[std::size_t(m.origin[h])].point = {m.faceCentre(below), below};
		if (normalAgreement(damaged.mesh, smoothNormals(surface, damaged, workers), f) >= 0)
			continue;
		++suspects;
		EXPECT_FALSE(isInverted(surface, damaged, f));
	}
	EXPECT_GT(suspects, 50);
}

} // namespace

} // namespace gpr::test
