// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The rings of all vertices in a row: the same spokes and faces as a turn round each vertex.

#include <tests/support/mesh_builders.h>
#include <tests/support/stages.h>
#include <vcg_extras/core/optimization/rings.h>
#include <vcg_extras/core/optimization/terms.h>

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

/// What a face says at all its corners at once is what it says to each of them.
TEST(ConformalFace, IsThePullAtEachCorner)
{
	const Vec3f         corner[] = {{0, 0, 0}, {1, 0.2f, 0.1f}, {0.3f, 0.9f, -0.2f}};
	const ConformalFace face(corner[0], corner[1], corner[2]);
	for (int k = 0; k < 3; ++k) {
		const Vec3f   a = corner[(k + 1) % 3] - corner[k], b = corner[(k + 2) % 3] - corner[k];
		const Vec3f   n       = cross(a, b);
		const float   inverse = 1 / length(n);
		ConformalPull pull;
		pull.add(a, b, n, inverse, inverse);
		EXPECT_NEAR(face.force[k][0], pull.force.x, 1e-5f);
		EXPECT_NEAR(face.force[k][1], pull.force.y, 1e-5f);
		EXPECT_NEAR(face.force[k][2], pull.force.z, 1e-5f);
		EXPECT_NEAR(face.force[k][3], pull.stiffness, 1e-5f);
		EXPECT_NEAR(face.squaredEdge[k], squaredLength(a), 1e-6f);
		EXPECT_NEAR(face.normal[2], n.z, 1e-6f);
	}
}

} // namespace gpr::test
