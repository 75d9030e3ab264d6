// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Claims keep operations of several faces apart.

#include <tests/support/mesh_builders.h>
#include <tests/support/stages.h>
#include <tests/support/transforms.h>
#include <vcg_extras/core/edit/claims.h>
#include <vcg_extras/core/mesh/mesh_edit.h>

#include <algorithm>
#include <gtest/gtest.h>
#include <set>

namespace gpr::test {

namespace {

/// The vertices within some rings round a face; ascending.
std::vector<int> ringsRound(const HalfEdgeMesh& m, int face, int rings)
{
	std::vector<int> vertices = verticesOf(m, {face});
	for (int ring = 0; ring < rings; ++ring)
		vertices = verticesOf(m, facesRound(m, vertices));
	return vertices;
}

} // namespace

TEST(Claims, AllowChangesWithinTwoRings)
{
	const HalfEdgeMesh m = halfEdgesOf(lattice(20, 20));
	const int          f = m.faceNum / 2 + 10;
	Claims             claims(m.vertexNum);
	const int          name    = claims.claim(m, f);
	const auto         allowed = ringsRound(m, f, 2);
	EXPECT_TRUE(claims.allow(name, allowed));
	EXPECT_FALSE(claims.allow(name + 1, allowed));
	for (int v = 0; v < m.vertexNum; ++v)
		EXPECT_EQ(claims.allow(name, {v}), std::count(allowed.begin(), allowed.end(), v) == 1);
}

/// No face has corners with two owners, and no operation reads beyond its claim.
TEST(Claims, AreFourRingsThatDoNotMeet)
{
	const HalfEdgeMesh         m = halfEdgesOf(lattice(40, 40));
	Claims                     claims(m.vertexNum);
	std::vector<int>           face;
	std::vector<std::set<int>> claimed;
	for (int f = 0; f < m.faceNum; f += 7) {
		const std::vector<int> rings = ringsRound(m, f, 4);
		bool                   meets = false;
		for (const std::set<int>& other : claimed) {
			for (int v : rings)
				meets = meets || other.count(v) > 0;
		}
		EXPECT_EQ(claims.claim(m, f) == 0, meets);
		if (!meets) claimed.emplace_back(rings.begin(), rings.end());
	}
	EXPECT_GT(claimed.size(), 10u);
	claims.clear();
	EXPECT_GT(claims.claim(m, 0), 0) << "given back";
}

/// Walks round a vertex with very many neighbours would cost the whole mesh for each face.
TEST(Claims, TakeEverythingRoundAHub)
{
	const HalfEdgeMesh m = halfEdgesOf(joined(lattice(20, 20), cone(5000, 1, 1, 1)));
	Claims             claims(m.vertexNum);
	EXPECT_GT(claims.claim(m, 0), 0);
	EXPECT_EQ(claims.claim(m, m.faceNum - 1), Claims::everything);
	EXPECT_TRUE(claims.allow(Claims::everything, {0, 1, 2}));
	EXPECT_GT(claims.claim(m, m.faceNum / 30), 0) << "leaves no mark";
}

} // namespace gpr::test
