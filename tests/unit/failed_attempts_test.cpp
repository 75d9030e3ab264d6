// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <tests/support/mesh_builders.h>
#include <tests/support/stages.h>
#include <vcg_extras/core/edit/failed_attempts.h>
#include <vcg_extras/core/mesh/mesh_edit.h>

#include <gtest/gtest.h>

namespace gpr::test {

namespace {

/// A flat grid; square i, row by row, has the faces 2i and 2i + 1.
class FailedAttemptsOnAGrid : public ::testing::Test {
protected:
	static constexpr int n = 20;
	HalfEdgeMesh         m = halfEdgesOf(grid(n, n));
	FailedAttempts       attempts{m.vertexNum};
	int                  face = 2 * (n * (n / 2) + n / 2);
};

TEST_F(FailedAttemptsOnAGrid, KnowsOnlyWhatItWasTold)
{
	EXPECT_FALSE(attempts.isKnown(m, face));
	attempts.noteFailure(m, face);
	EXPECT_TRUE(attempts.isKnown(m, face));
	EXPECT_FALSE(attempts.isKnown(m, face + 1));
}

TEST_F(FailedAttemptsOnAGrid, ForgetsWhereSomethingNearChanges)
{
	for (int v = 0; v < m.vertexNum; ++v) {
		attempts.noteFailure(m, face);
		attempts.noteChange(m, {v});
		const Vec3f corner = m.position[m.origin[3 * face]];
		const float away   = length(m.position[v] - corner) * n;
		if (away >= 2.9f && away <= 7) continue;
		EXPECT_EQ(attempts.isKnown(m, face), away > 7) << away;
	}
}

TEST_F(FailedAttemptsOnAGrid, CountsWhatAChangeLooksAt)
{
	const int        changed = m.origin[3 * face];
	std::vector<int> walked  = {changed};
	for (int ring = 0; ring < 2; ++ring)
		walked = verticesOf(m, facesRound(m, walked));
	std::int64_t neighbourNum = 0;
	for (int v : walked)
		neighbourNum += m.valence(v);
	EXPECT_EQ(attempts.noteChange(m, {changed}), neighbourNum);
	EXPECT_EQ(FailedAttempts(m.vertexNum).noteChange(m, {}), 0);
}

/// Flipped and back, the two faces of an edge have exchanged their numbers.
TEST_F(FailedAttemptsOnAGrid, KnowsFacesWhateverTheirNumber)
{
	int h = 3 * face;
	while (!canFlip(m, h))
		++h;
	const int other = m.opposite[h] / 3;
	attempts.noteFailure(m, face);
	flip(m, h);
	EXPECT_FALSE(attempts.isKnown(m, face));
	flip(m, nextInFace(h));
	EXPECT_NE(attempts.isKnown(m, face), attempts.isKnown(m, other));
}

} // namespace

} // namespace gpr::test
