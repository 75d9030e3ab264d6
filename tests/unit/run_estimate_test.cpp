// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <tests/support/mesh_builders.h>
#include <vcg_extras/core/run_estimate.h>

#include <cmath>
#include <gtest/gtest.h>

namespace gpr::test {

namespace {

RemeshOptions withPercent(double percent)
{
	RemeshOptions options;
	options.targetPercent = percent;
	options.threads       = 1;
	return options;
}

/// A view of which nothing but the sizes is looked at.
MeshView ofSize(std::size_t vertexNum, std::size_t faceNum)
{
	MeshView view;
	view.vertexNum = vertexNum;
	view.faceNum   = faceNum;
	return view;
}

TEST(RunEstimate, GrowsWithFacesVerticesAndEffort)
{
	const MeshView    mesh = ofSize(500000, 1000000);
	const RunEstimate one  = estimateRun(mesh, withPercent(10));
	EXPECT_DOUBLE_EQ(one.vertexNum, 50000);
	EXPECT_GT(one.seconds, 0.5);
	EXPECT_LT(one.seconds, 10);
	EXPECT_GT(one.bytes, 50e6);
	EXPECT_LT(one.bytes, 500e6);

	const RunEstimate dense = estimateRun(mesh, withPercent(200));
	EXPECT_GT(dense.seconds, 3 * one.seconds);
	EXPECT_GT(dense.bytes, 2 * one.bytes);
	const RunEstimate large = estimateRun(ofSize(5000000, 10000000), withPercent(10));
	EXPECT_NEAR(large.seconds, 10 * one.seconds, 0.01 * large.seconds);

	RemeshOptions fast = withPercent(10);
	fast.preset        = Preset::Fast;
	EXPECT_LT(estimateRun(mesh, fast).seconds, one.seconds);
	fast.threads = 4;
	EXPECT_LT(estimateRun(mesh, fast).seconds, 0.5 * estimateRun(mesh, withPercent(10)).seconds);
}

TEST(RunEstimate, LengthsAndErrorsAskForVerticesByArea)
{
	const TriangleMesh sphere = icosphere(4);
	RemeshOptions      options;
	options.targetMode    = TargetMode::EdgeLength;
	options.targetEdgeLen = 0.1;
	const double vertices = 4 * M_PI * 2 / (std::sqrt(3.0) * 0.01);
	EXPECT_NEAR(estimateRun(sphere.view(), options).vertexNum, vertices, 0.01 * vertices);

	options.targetMode     = TargetMode::MaxError;
	options.targetMaxError = 0.02; // of which five make an edge
	EXPECT_NEAR(estimateRun(sphere.view(), options).vertexNum, vertices, 0.01 * vertices);
	const double once = estimateRun(sphere.view(), options, SamplingTool).seconds;
	EXPECT_GT(estimateRun(sphere.view(), options).seconds, 3 * once);
}

TEST(RunEstimate, OfASelectedPartOnlyThatCounts)
{
	const TriangleMesh        sphere = icosphere(4);
	std::vector<std::uint8_t> selected(sphere.faceNum());
	std::fill(selected.begin(), selected.begin() + long(selected.size() / 4), 1);
	MeshView view             = sphere.view();
	view.selectedFace         = selected.data();
	RemeshOptions     options = withPercent(10);
	const RunEstimate whole   = estimateRun(view, options);
	options.selectedOnly      = true;
	EXPECT_NEAR(estimateRun(view, options).seconds, whole.seconds / 4, 1e-3 * whole.seconds);
}

TEST(RunEstimate, IsToldWithTwoDigits)
{
	EXPECT_EQ(estimateText({1, 12.34, 0.68e9}), "about 12 s and 0.68 GB of memory");
	EXPECT_EQ(estimateText({1, 0.0001, 1000}), "about 0.1 s and 0.01 GB of memory");
	EXPECT_EQ(estimateText({1, 1234, 12.3e9}), "about 1200 s and 12 GB of memory");
}

TEST(RunEstimate, NothingAtAllIsEstimatedToo)
{
	for (const TargetMode mode : {TargetMode::VertexNum, TargetMode::Percent,
								  TargetMode::EdgeLength, TargetMode::MaxError}) {
		RemeshOptions options;
		options.targetMode = mode;
		EXPECT_GE(estimateRun(MeshView(), options).bytes, 0);
	}
}

} // namespace

} // namespace gpr::test
