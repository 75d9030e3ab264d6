// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <tests/support/mesh_builders.h>
#include <tests/support/stages.h>
#include <tests/support/transforms.h>
#include <vcg_extras/core/mesh/octree_blocks.h>

#include <cmath>
#include <gtest/gtest.h>

namespace gpr::test {

namespace {

class CutIntoBlocks : public ::testing::TestWithParam<double> {
protected:
	Workers workers{2, nullptr};
};

TEST_P(CutIntoBlocks, EveryVertexIsInOneBlockAndCellsAreWideEnough)
{
	const Surface      s = surfaceOf(torus(120, 60), workers);
	const OctreeBlocks p = cutIntoBlocks(s, float(GetParam()), workers);
	if (p.blocks.size() > 1) {
		EXPECT_GE(double(p.cellSize), GetParam());
	}
	int next = 0;
	for (const Block& b : p.blocks) {
		EXPECT_EQ(b.begin, next);
		EXPECT_GT(b.end, b.begin) << "no empty blocks";
		next = b.end;
	}
	EXPECT_EQ(next, s.mesh.vertexNum);
	std::vector<int> seen(p.blocks.size(), 0);
	for (int colour = 0; colour < 8; ++colour) {
		const std::vector<int>& ids = p.byColour[colour];
		for (std::size_t i = 0; i < ids.size(); ++i) {
			++seen[ids[i]];
			if (i == 0) continue;
			const Block &a = p.blocks[ids[i - 1]], &b = p.blocks[ids[i]];
			EXPECT_GE(a.end - a.begin, b.end - b.begin) << "largest first";
		}
	}
	EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), std::ptrdiff_t(seen.size()));
}

/// Between two blocks of a colour lies at least a cell's width, so threads may work on both at
/// once.
TEST_P(CutIntoBlocks, BlocksOfAColourLieAtLeastACellApart)
{
	Random             random(1);
	const Surface      s     = surfaceOf(noisySphere(4, 0.1, random), workers);
	const OctreeBlocks p     = cutIntoBlocks(s, float(GetParam()), workers);
	const float        least = p.cellSize * 0.9999f;
	for (const std::vector<int>& ids : p.byColour) {
		for (std::size_t i = 0; i < ids.size(); ++i) {
			for (std::size_t k = i + 1; k < ids.size(); ++k) {
				const Block &a = p.blocks[ids[i]], &b = p.blocks[ids[k]];
				for (int v = a.begin; v < a.end; ++v) {
					for (int w = b.begin; w < b.end; ++w)
						ASSERT_GE(length(s.mesh.position[v] - s.mesh.position[w]), least);
				}
			}
		}
	}
}

INSTANTIATE_TEST_SUITE_P(Widths, CutIntoBlocks, ::testing::Values(0.05, 0.11, 0.3, 2.0));

} // namespace

} // namespace gpr::test
