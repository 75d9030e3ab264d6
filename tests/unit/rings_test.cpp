// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The rings of all vertices in a row: the same spokes and faces as a turn round each vertex.

#include <tests/support/mesh_builders.h>
#include <tests/support/stages.h>
#include <vcg_extras/core/optimization/rings.h>

#include <gtest/gtest.h>

namespace gpr::test {

namespace {

/// Closed with several pieces of vertices, with a border, and with a vertex in no face.
std::vector<TriangleMesh> meshesWithRings()
{
	TriangleMesh withLoneVertex = icosphere(1);
	withLoneVertex.positions.push_back({9, 9, 9});
	return {icosphere(5), grid(40, 30), withLoneVertex};
}

} // namespace

TEST(Rings, HaveTheSpokesAndFacesOfATurnRoundEachVertex)
{
	for (const TriangleMesh& mesh : meshesWithRings()) {
		const HalfEdgeMesh m = halfEdgesOf(mesh);
		Workers            workers(2, nullptr);
		const Rings        rings(m, workers);
		EXPECT_EQ(rings.spokeNum(), m.halfEdgeNum());
		std::vector<int> seen(std::size_t(m.vertexNum), 0);
		rings.forEach<int>(
			workers, [](int f) { return f; },
			[&](int v, const Rings::Ring<int>& ring) {
				++seen[std::size_t(v)];
				int i = 0;
				forEachOutgoing(m, v, [&](int h) {
					EXPECT_LT(i, ring.size);
					EXPECT_EQ(ring.spoke[i].target, m.target(h));
					EXPECT_EQ(ring.term(i), h / 3);
					EXPECT_EQ(ring.corner(i), h % 3);
					++i;
				});
				EXPECT_EQ(i, ring.size);
				EXPECT_EQ(ring.isClosed, !m.isBorderVertex(v));
			});
		EXPECT_EQ(seen, std::vector<int>(std::size_t(m.vertexNum), 1));
	}
}

} // namespace gpr::test
