// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <tests/support/mesh_builders.h>
#include <tests/support/stages.h>
#include <vcg_extras/core/mesh/cut_mesh.h>
#include <vcg_extras/core/mesh/measure.h>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace gpr::test {

namespace {

class CutMeshTest : public ::testing::Test {
protected:
	Workers workers{2, nullptr};

	/// Cuts a mesh and compares both meshes.
	CutMesh cut(const HalfEdgeMesh& m, const Buffer<char>& lines)
	{
		CutMesh cut = cutAlong(m, lines, workers);
		EXPECT_EQ(cut.mesh.vertexNum, m.vertexNum + int(cut.copyOf.size()));
		for (int h = 0; h < m.halfEdgeNum(); ++h) {
			EXPECT_EQ(cut.mesh.opposite[h], lines[h] ? -1 : m.opposite[h]);
			EXPECT_TRUE(cut.mesh.position[cut.mesh.origin[h]] == m.position[m.origin[h]]);
		}
		for (int v = 0; v < cut.mesh.vertexNum; ++v) {
			const int first = cut.mesh.outgoing[v];
			EXPECT_EQ(cut.mesh.origin[first], v);
			bool isAtBorder = false;
			int  num        = 0;
			forEachOutgoing(cut.mesh, v, [&](int h) {
				EXPECT_EQ(cut.mesh.origin[h], v);
				isAtBorder = isAtBorder || cut.mesh.isBorderEdge(h);
				++num;
			});
			EXPECT_EQ(isAtBorder, cut.mesh.isBorderEdge(first));
			seen_ += num;
		}
		EXPECT_EQ(seen_, m.halfEdgeNum()); // every corner at its vertex, once
		return cut;
	}

private:
	int seen_ = 0;
};

TEST_F(CutMeshTest, ABoxFallsIntoItsSides)
{
	const Surface box   = surfaceOf(gpr::test::box(4, 4, 4, {1, 1, 1}), workers);
	const CutMesh sides = cut(box.mesh, edgesThatTurn(box, 30));
	EXPECT_EQ(sides.mesh.vertexNum, 6 * 25);
	EXPECT_EQ(figuresOf(sides.mesh, 1, workers).components, 6);
}

TEST_F(CutMeshTest, LinesThatCrossBeginAndEndAtTheBorder)
{
	const Surface roof  = surfaceOf(crossedCreases(8, 1), workers);
	const CutMesh sides = cut(roof.mesh, edgesThatTurn(roof, 30));
	EXPECT_EQ(sides.mesh.vertexNum, 4 * 25);
	EXPECT_EQ(figuresOf(sides.mesh, 1, workers).components, 4);
}

TEST_F(CutMeshTest, ALineWithAFreeEndIsASlit)
{
	const Surface sheet = surfaceOf(grid(6, 6), workers);
	Buffer<char>  lines(std::size_t(sheet.mesh.halfEdgeNum()), char(0));
	for (int h = 0; h < sheet.mesh.halfEdgeNum(); ++h) {
		const Vec3d a = sheet.frame.toCaller(sheet.mesh.position[sheet.mesh.origin[h]]);
		const Vec3d b = sheet.frame.toCaller(sheet.mesh.position[sheet.mesh.target(h)]);
		lines[h] =
			std::abs(a.x - 0.5) < 1e-6 && std::abs(b.x - 0.5) < 1e-6 && std::max(a.y, b.y) < 0.6;
	}
	const CutMesh slit = cut(sheet.mesh, lines);
	EXPECT_EQ(slit.copyOf.size(), 3u); // not the free end
	EXPECT_EQ(figuresOf(slit.mesh, 1, workers).components, 1);
}

} // namespace

} // namespace gpr::test
