// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <tests/support/mesh_builders.h>
#include <tests/support/stages.h>
#include <vcg_extras/core/features/close_lines.h>
#include <vcg_extras/core/features/crease_lines.h>

#include <cmath>
#include <gtest/gtest.h>

namespace gpr::test {

namespace {

class CloseLines : public ::testing::Test {
protected:
	Workers workers{2, nullptr};
	Surface surface;

	Vec3d place(int v) const { return surface.frame.toCaller(surface.mesh.position[v]); }

	/// Marks the edges with both ends on a line.
	template <class IsOn>
	void markWhere(const IsOn& isOn)
	{
		HalfEdgeMesh& m = surface.mesh;
		if (m.crease.empty()) {
			m.crease.reset(m.halfEdgeNum());
			m.crease.fill(0);
		}
		for (int h = 0; h < m.halfEdgeNum(); ++h) {
			const bool isInside = m.opposite[h] >= 0;
			if (isInside && isOn(place(m.origin[h])) && isOn(place(m.target(h)))) m.crease[h] = 1;
		}
	}

	std::vector<int> find(double gap)
	{
		return findCloseLines(surface, float(gap * surface.frame.scale), workers);
	}

	double lengthOf(const std::vector<int>& edges) const
	{
		double sum = 0;
		for (int h : edges)
			sum += length(place(surface.mesh.target(h)) - place(surface.mesh.origin[h]));
		return sum;
	}
};

bool isNear(double a, double b)
{
	return std::abs(a - b) < 1e-6;
}

/// Between the lower and the upper border of a square of side 1.
bool isInside(const Vec3d& p)
{
	return p.y > 0.09 && p.y < 0.91;
}

/// Two floors of a square of side 1, joined by a step at x = 0.5.
TriangleMesh stepped(double height)
{
	TriangleMesh mesh = grid(21, 20, 1.05, 1);
	for (Vec3d& p : mesh.positions) {
		if (p.x < 0.51) continue;
		p.x -= 0.05;
		p.z = height;
	}
	return mesh;
}

TEST_F(CloseLines, OneLineOfALowStepStays)
{
	CreaseRules rules;
	surface      = surfaceOf(stepped(0.005), workers);
	rules.minGap = float(0.01 * surface.frame.scale);
	EXPECT_EQ(markCreases(rules, workers, surface).edgeNum, 20);
	rules.minGap = float(0.004 * surface.frame.scale);
	surface      = surfaceOf(stepped(0.005), workers);
	EXPECT_EQ(markCreases(rules, workers, surface).edgeNum, 2 * 20) << "far enough apart";
}

/// FeatureMode::Lines keeps all crease edges.
TEST_F(CloseLines, AllStayWhereTheyAreAskedFor)
{
	CreaseRules rules;
	surface      = surfaceOf(stepped(0.005), workers);
	rules.mode   = FeatureMode::Lines;
	rules.minGap = float(0.01 * surface.frame.scale);
	EXPECT_EQ(markCreases(rules, workers, surface).edgeNum, 2 * 20);
}

/// Only both outlines keep the two sides of the plate apart.
TEST_F(CloseLines, BothOutlinesOfAThinPlateStay)
{
	CreaseRules rules;
	surface      = surfaceOf(thinPlate(20, 0.005), workers);
	rules.minGap = float(0.02 * surface.frame.scale);
	EXPECT_EQ(markCreases(rules, workers, surface).edgeNum, 8 * 20 + 4);
}

TEST_F(CloseLines, BesideABorderTwiceAsFar)
{
	surface = surfaceOf(grid(20, 20), workers);
	markWhere([](const Vec3d& p) { return isNear(p.x, 0.05) && isInside(p); });
	EXPECT_TRUE(find(0.02).empty());
	EXPECT_NEAR(lengthOf(find(0.03)), 0.8, 1e-6);
}

TEST_F(CloseLines, WhereTheyMeetTheyAreNotClose)
{
	surface = surfaceOf(grid(20, 20), workers);
	markWhere([](const Vec3d& p) { return isNear(p.y, 0.5); });
	markWhere([](const Vec3d& p) { return isNear(p.x, p.y) || isNear(p.x, 1 - p.y); });
	EXPECT_TRUE(find(0.04).empty()) << "half a cell from the middle they are 0.025 apart";
}

/// Two parallel lines, one half as long as the other: the longer line stays whole.
TEST_F(CloseLines, OnlyTheStretchBesideGoes)
{
	surface = surfaceOf(grid(20, 20), workers);
	markWhere([](const Vec3d& p) { return isNear(p.x, 0.5) && isInside(p); });
	markWhere([](const Vec3d& p) { return isNear(p.x, 0.55) && isInside(p) && p.y < 0.51; });
	const std::vector<int> close = find(0.06);
	EXPECT_NEAR(lengthOf(close), 0.4, 1e-6);
	for (int h : close)
		EXPECT_NEAR(place(surface.mesh.origin[h]).x, 0.55, 1e-6);
}

} // namespace

} // namespace gpr::test
