// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <tests/support/mesh_audit.h>
#include <tests/support/mesh_builders.h>
#include <tests/support/stages.h>
#include <vcg_extras/core/input/border_spikes.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>

namespace gpr::test {

namespace {

using Keep = std::function<bool(int i, int j)>;

/// Squares of side 1.
TriangleMesh cells(const Keep& keep)
{
	return gridWhere(40, 40, keep);
}

std::vector<int> spikesOf(const TriangleMesh& mesh, float width)
{
	return findBorderSpikes(halfEdgesOf(mesh), width);
}

bool isWithin(int i, int low, int high)
{
	return i >= low && i < high;
}

/// A square of side 20, in the corner at the origin.
bool isInSquare(int i, int j)
{
	return i < 20 && j < 20;
}

TriangleMesh without(const TriangleMesh& mesh, const std::vector<int>& faces)
{
	TriangleMesh left;
	left.positions = mesh.positions;
	for (int f = 0; f < int(mesh.faceNum()); ++f) {
		if (std::binary_search(faces.begin(), faces.end(), f)) continue;
		for (int k = 0; k < 3; ++k)
			left.triangles.push_back(mesh.triangles[std::size_t(3 * f + k)]);
	}
	return left;
}

double middleX(const TriangleMesh& mesh, int f)
{
	double sum = 0;
	for (int k = 0; k < 3; ++k)
		sum += mesh.positions[std::size_t(mesh.triangles[std::size_t(3 * f + k)])].x;
	return sum / 3;
}

TEST(BorderSpikes, SmoothBordersHaveNone)
{
	for (const TriangleMesh& mesh :
		 {grid(30, 30, 30, 30), openCylinder(60, 20, 10, 20), icosphere(3), cone(40, 20, 10, 10)}) {
		for (float width : {0.5f, 3.0f, 8.0f})
			EXPECT_TRUE(spikesOf(mesh, width).empty()) << width;
	}
}

TEST(BorderSpikes, ASpikeGoesThatIsNarrowerThanTheWidth)
{
	const TriangleMesh mesh =
		cells([](int i, int j) { return isInSquare(i, j) || (i < 35 && isWithin(j, 9, 12)); });
	EXPECT_TRUE(spikesOf(mesh, 2.5f).empty());
	const std::vector<int> spikes = spikesOf(mesh, 4);
	// All of it but what a disk of diameter 4 reaches in the two corners beside it.
	EXPECT_GE(int(spikes.size()), 2 * 3 * 13);
	for (int f : spikes)
		EXPECT_GT(middleX(mesh, f), 20);
	EXPECT_TRUE(std::is_sorted(spikes.begin(), spikes.end()));
	EXPECT_TRUE(hasSameTopology(without(mesh, spikes), mesh));
}

TEST(BorderSpikes, WhatHardlySticksOutStays)
{
	const TriangleMesh mesh =
		cells([](int i, int j) { return isInSquare(i, j) || (i == 20 && isWithin(j, 9, 12)); });
	EXPECT_TRUE(spikesOf(mesh, 6).empty());
}

TEST(BorderSpikes, NarrowPartsThatTheTopologyNeedsStay)
{
	const auto         isInOtherSquare = [](int i, int j) { return i >= 28 && j < 12; };
	const auto         isInBridge      = [](int i, int j) { return isWithin(j, 4, 6) && i < 40; };
	const TriangleMesh bridge          = cells([&](int i, int j) {
        return isInSquare(i, j) || isInOtherSquare(i, j) || isInBridge(i, j);
    });
	EXPECT_TRUE(spikesOf(bridge, 4).empty());
	const TriangleMesh strip = cells([](int, int j) { return j < 2; });
	EXPECT_TRUE(spikesOf(strip, 4).empty());
	const TriangleMesh ring = cells([](int i, int j) {
		const double r = std::hypot(i - 19.5, j - 19.5);
		return r > 15 && r < 18;
	});
	EXPECT_TRUE(spikesOf(ring, 6).empty());
	// A handle of a mug, seen from above: narrow, and there is a hole behind it.
	const TriangleMesh mug = cells([](int i, int j) {
		const bool isHandle = i < 30 && isWithin(j, 4, 16);
		const bool isBehind = i < 28 && isWithin(j, 6, 14);
		return isInSquare(i, j) || (isHandle && !isBehind);
	});
	EXPECT_TRUE(spikesOf(mug, 4).empty());
	// A spike with a window: without it a hole would be gone.
	const TriangleMesh window = cells([](int i, int j) {
		const bool isSpike = i < 35 && isWithin(j, 8, 13);
		return isInSquare(i, j) || (isSpike && !(i == 28 && j == 10));
	});
	EXPECT_TRUE(spikesOf(window, 8).empty());
}

/// Two of them may meet in a vertex, so that only one may go.
TEST(BorderSpikes, TheTopologyStaysWhereTheyAreNearToEachOther)
{
	int spikeNum = 0;
	for (double inner = 10; inner < 17; inner += 0.25) {
		const TriangleMesh ring = cells([&](int i, int j) {
			const double r = std::hypot(i - 19.5, j - 19.5);
			return r > inner && r < inner + 2.5;
		});
		if (!factsOf(ring).isManifold()) continue;
		for (float width = 1.5f; width < 5; width += 0.25f) {
			const std::vector<int> spikes = spikesOf(ring, width);
			spikeNum += int(spikes.size());
			EXPECT_TRUE(hasSameTopology(without(ring, spikes), ring)) << inner << ' ' << width;
			EXPECT_EQ(factsOf(without(ring, spikes)).brokenFans, 0) << inner << ' ' << width;
		}
	}
	EXPECT_GT(spikeNum, 100);
}

TEST(BorderSpikes, TheTopologyStaysOnRandomBorders)
{
	int spikeNum = 0;
	for (unsigned seed = 1; seed <= 30; ++seed) {
		Random           random(seed);
		std::vector<int> reach, start;
		for (int j = 0; j < 40; ++j) {
			start.push_back(random.below(3) == 0 ? 6 : 8);
			reach.push_back(26 + random.below(14));
		}
		const TriangleMesh     mesh   = cells([&](int i, int j) {
            const bool isHole = isWithin(i, 14, 19) && isWithin(j, 10, 30);
            return i >= start[j] && i < reach[j] && !isHole;
        });
		const std::vector<int> spikes = spikesOf(mesh, 3 + 0.2f * float(seed));
		spikeNum += int(spikes.size());
		const TriangleMesh left = without(mesh, spikes);
		EXPECT_EQ(factsOf(left).brokenFans, 0) << seed;
		EXPECT_TRUE(hasSameTopology(left, mesh)) << seed;
	}
	EXPECT_GT(spikeNum, 1000);
}

} // namespace

} // namespace gpr::test
