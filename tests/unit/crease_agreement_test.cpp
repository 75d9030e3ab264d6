// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <tests/support/mesh_builders.h>
#include <tests/support/stages.h>
#include <vcg_extras/core/features/crease_lines.h>
#include <vcg_extras/core/features/curve_slide.h>
#include <vcg_extras/core/mesh/mesh_edit.h>
#include <vcg_extras/core/optimization/face_repair.h>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace gpr::test {

namespace {

/// A cylinder of eight sides with its own rims as feature lines.
class FacesAtCreases : public ::testing::Test {
protected:
	static constexpr int lidValence = 8;

	Workers        workers{2, nullptr};
	Surface        surface;
	BoundaryCurves curves;
	ResultMesh     result;

	void SetUp() override
	{
		surface = surfaceOf(closedCylinder(lidValence, 4, 1, 3), workers);
		CreaseRules rules;
		rules.mode      = FeatureMode::Lines;
		rules.strongDeg = 60;
		markCreases(rules, workers, surface);
		curves = sampleBoundary(surface, 0.5f, 0.5f, workers);
		result = resultOf(surface, curves);
		ASSERT_TRUE(result.mesh.hasCreases());
	}

	float minAgreement() const
	{
		float least = 1;
		for (int h = 0; h < result.mesh.halfEdgeNum(); ++h)
			least = std::min(least, creaseAgreement(surface, curves, result, h));
		return least;
	}

	int creaseVertex() const
	{
		for (int v = 0; v < result.mesh.vertexNum; ++v) {
			if (result.mesh.isCreaseVertex(v)) return v;
		}
		return -1;
	}

	bool isLidCentre(int v) const
	{
		const Vec3d p = surface.frame.toCaller(result.mesh.position[v]);
		return std::abs(p.x) + std::abs(p.y) < 1e-3;
	}

	int wallEdge(int v) const
	{
		int edge = -1;
		forEachOutgoing(result.mesh, v, [&](int h) {
			const bool isWall = !result.mesh.isCreaseEdge(h) && !isLidCentre(result.mesh.target(h));
			if (isWall && canFlip(result.mesh, h)) edge = h;
		});
		return edge;
	}

	/// Flips the edges from v to the wall: the last wall face at v lies in the plane of the lid.
	void cutOff(int v)
	{
		for (int h = wallEdge(v); h >= 0; h = wallEdge(v))
			flip(result.mesh, h);
		ASSERT_EQ(result.mesh.valence(v), 3);
	}
};

TEST_F(FacesAtCreases, AgreeWhereTheyAreTheInputsOwn)
{
	EXPECT_GT(minAgreement(), 0.99f);
	repairInvertedFaces(surface, curves, false, result, workers);
	EXPECT_EQ(result.flipNum, 0);
}

TEST_F(FacesAtCreases, OnesAcrossALineAreTurned)
{
	cutOff(creaseVertex());
	EXPECT_LT(minAgreement(), 0.2f);
	repairInvertedFaces(surface, curves, false, result, workers);
	EXPECT_GE(result.flipNum, 1);
	EXPECT_GT(minAgreement(), 0.8f);
}

TEST_F(FacesAtCreases, EdgesOffTheLinesAgree)
{
	for (int h = 0; h < result.mesh.halfEdgeNum(); ++h) {
		if (result.mesh.isCreaseEdge(h)) continue;
		EXPECT_EQ(creaseAgreement(surface, curves, result, h), 1);
	}
}

} // namespace

} // namespace gpr::test
