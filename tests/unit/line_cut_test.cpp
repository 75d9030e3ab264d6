// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <tests/support/mesh_builders.h>
#include <tests/support/stages.h>
#include <vcg_extras/core/mesh/line_cut.h>
#include <vcg_extras/core/mesh/measure.h>
#include <vcg_extras/core/mesh/mesh_edit.h>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace gpr::test {

namespace {

/// Whether the first values of a buffer are all values of another.
bool areEqual(const Buffer<int>& first, const Buffer<int>& all)
{
	return std::equal(all.begin(), all.end(), first.begin());
}

class LineCutTest : public ::testing::Test {
protected:
	Workers workers{2, nullptr};

	/// Cuts a surface, compares it with the surface before, calls look(cut), and closes the cut.
	template <class Look>
	void cut(Surface& surface, const Buffer<char>& lines, const Look& look)
	{
		HalfEdgeMesh& m = surface.mesh;
		fillRings(surface);
		const HalfEdgeMesh    before = copyMesh(m, workers);
		const Buffer<RingSum> ring   = copyOf(surface.ring, workers);
		{
			const LineCut cut(surface, lines, workers);
			EXPECT_EQ(m.vertexNum, before.vertexNum + int(cut.copyOf().size()));
			compare(m, before, lines);
			EXPECT_EQ(cornersOf(surface), m.halfEdgeNum()); // every corner at its vertex, once
			look(cut);
		}
		expectAsBefore(surface, before, ring);
	}

private:
	void fillRings(Surface& surface)
	{
		surface.ring.reset(std::size_t(surface.mesh.vertexNum));
		for (int v = 0; v < surface.mesh.vertexNum; ++v)
			surface.ring[v] = ringSum(surface.mesh, v);
	}

	static void compare(const HalfEdgeMesh& m, const HalfEdgeMesh& before,
						const Buffer<char>& lines)
	{
		for (int h = 0; h < m.halfEdgeNum(); ++h) {
			EXPECT_EQ(m.opposite[h], lines[h] ? -1 : before.opposite[h]);
			EXPECT_TRUE(m.position[m.origin[h]] == before.position[before.origin[h]]);
		}
	}

	/// Compares the rings, too.
	static int cornersOf(const Surface& surface)
	{
		const HalfEdgeMesh& m   = surface.mesh;
		int                 num = 0;
		for (int v = 0; v < m.vertexNum; ++v) {
			const int first = m.outgoing[v];
			EXPECT_EQ(m.origin[first], v);
			bool isAtBorder = false;
			forEachOutgoing(m, v, [&](int h) {
				EXPECT_EQ(m.origin[h], v);
				isAtBorder = isAtBorder || m.isBorderEdge(h);
				++num;
			});
			EXPECT_EQ(isAtBorder, m.isBorderEdge(first));
			EXPECT_EQ(surface.ring[v].area, ringSum(m, v).area);
		}
		return num;
	}

	static void expectAsBefore(const Surface& surface, const HalfEdgeMesh& before,
							   const Buffer<RingSum>& ring)
	{
		const HalfEdgeMesh& m = surface.mesh;
		ASSERT_EQ(m.vertexNum, before.vertexNum);
		EXPECT_TRUE(areEqual(m.origin, before.origin));
		EXPECT_TRUE(areEqual(m.opposite, before.opposite));
		EXPECT_TRUE(areEqual(m.outgoing, before.outgoing));
		for (int v = 0; v < m.vertexNum; ++v) {
			EXPECT_TRUE(m.position[v] == before.position[v]);
			EXPECT_TRUE(surface.ring[v].normal == ring[v].normal);
			EXPECT_EQ(surface.ring[v].area, ring[v].area);
		}
	}
};

TEST_F(LineCutTest, ABoxFallsIntoItsSides)
{
	Surface box = surfaceOf(gpr::test::box(4, 4, 4, {1, 1, 1}), workers);
	cut(box, edgesThatTurn(box, 30), [&](const LineCut&) {
		EXPECT_EQ(box.mesh.vertexNum, 6 * 25);
		EXPECT_EQ(figuresOf(box.mesh, 1, workers).components, 6);
	});
}

TEST_F(LineCutTest, LinesThatCrossBeginAndEndAtTheBorder)
{
	Surface roof = surfaceOf(crossedCreases(8, 1), workers);
	cut(roof, edgesThatTurn(roof, 30), [&](const LineCut&) {
		EXPECT_EQ(roof.mesh.vertexNum, 4 * 25);
		EXPECT_EQ(figuresOf(roof.mesh, 1, workers).components, 4);
	});
}

TEST_F(LineCutTest, ALineWithAFreeEndIsASlit)
{
	Surface      sheet = surfaceOf(grid(6, 6), workers);
	Buffer<char> lines(std::size_t(sheet.mesh.halfEdgeNum()), char(0));
	for (int h = 0; h < sheet.mesh.halfEdgeNum(); ++h) {
		const Vec3d a = sheet.frame.toCaller(sheet.mesh.position[sheet.mesh.origin[h]]);
		const Vec3d b = sheet.frame.toCaller(sheet.mesh.position[sheet.mesh.target(h)]);
		lines[h] =
			std::abs(a.x - 0.5) < 1e-6 && std::abs(b.x - 0.5) < 1e-6 && std::max(a.y, b.y) < 0.6;
	}
	cut(sheet, lines, [&](const LineCut& slit) {
		EXPECT_EQ(slit.copyOf().size(), 3u); // not the free end
		EXPECT_EQ(figuresOf(sheet.mesh, 1, workers).components, 1);
	});
}

TEST_F(LineCutTest, NoMarksCutNothing)
{
	Surface       sheet = surfaceOf(grid(3, 3), workers);
	const int     num   = sheet.mesh.vertexNum;
	const LineCut cut(sheet, {}, workers);
	EXPECT_TRUE(cut.copyOf().empty());
	EXPECT_EQ(sheet.mesh.vertexNum, num);
}

} // namespace

} // namespace gpr::test
