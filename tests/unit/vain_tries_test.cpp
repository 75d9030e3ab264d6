// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <tests/support/mesh_builders.h>
#include <tests/support/stages.h>
#include <vcg_extras/core/mesh/mesh_edit.h>
#include <vcg_extras/core/mesh/vain_tries.h>

#include <gtest/gtest.h>

namespace gpr::test {

namespace {

/// A flat grid; faces 2i and 2i + 1 are those of square i, row by row.
class VainTriesOnAGrid : public ::testing::Test {
protected:
	static constexpr int n = 20;
	HalfEdgeMesh         m = halfEdgesOf(grid(n, n));
	VainTries            tries{m.vertexNum};
	int                  face = 2 * (n * (n / 2) + n / 2);
};

TEST_F(VainTriesOnAGrid, KnowsOnlyWhatItWasTold)
{
	EXPECT_FALSE(tries.isVain(m, face));
	tries.noteVain(m, face);
	EXPECT_TRUE(tries.isVain(m, face));
	EXPECT_FALSE(tries.isVain(m, face + 1));
	EXPECT_FALSE(tries.isVain(m, face, 1)) << "another kind of treatment";
}

TEST_F(VainTriesOnAGrid, ForgetsWhereSomethingNearChanges)
{
	for (int v = 0; v < m.vertexNum; ++v) {
		tries.noteVain(m, face);
		tries.noteChange(v);
		const Vec3f corner = m.position[m.origin[3 * face]];
		const float away   = length(m.position[v] - corner) * n;
		if (away >= 2.9f && away <= 7) continue;
		EXPECT_EQ(tries.isVain(m, face), away > 7) << away;
	}
}

/// Flipped and back, the two faces of an edge have each other's numbers.
TEST_F(VainTriesOnAGrid, KnowsFacesWhateverTheirNumber)
{
	int h = 3 * face;
	while (!canFlip(m, h))
		++h;
	const int other = m.opposite[h] / 3;
	tries.noteVain(m, face);
	flip(m, h);
	EXPECT_FALSE(tries.isVain(m, face));
	flip(m, nextInFace(h));
	EXPECT_NE(tries.isVain(m, face), tries.isVain(m, other));
}

} // namespace

} // namespace gpr::test
