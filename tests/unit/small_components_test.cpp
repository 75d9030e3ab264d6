// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <tests/support/mesh_audit.h>
#include <tests/support/mesh_builders.h>
#include <tests/support/transforms.h>
#include <vcg_extras/core/remesh.h>

#include <gtest/gtest.h>

namespace gpr::test {

namespace {

/// A sphere of 320 faces, a grid of 18 and a tetrahedron-like fan of 3.
TriangleMesh threePieces()
{
	return joined(joined(icosphere(2), shifted(grid(3, 3), {3, 0, 0})),
				  shifted(fansSharingVertex(1), {6, 0, 0}));
}

TEST(DropComponentsBelow, DropsThoseWithFewerFaces)
{
	RemeshOptions options;
	const struct {
		int least, num, faces;
	} cases[] = {{3, 0, 0}, {4, 1, 3}, {18, 1, 3}, {19, 2, 21}, {320, 2, 21}};
	for (const auto& c : cases) {
		options.dropComponentsBelow = c.least;
		const RemeshResult r        = remesh(threePieces().view(), options);
		ASSERT_EQ(r.status, Status::Ok) << r.message;
		EXPECT_EQ(r.report.cleaned.droppedComponents, c.num) << c.least;
		EXPECT_EQ(r.report.cleaned.droppedFaces, c.faces) << c.least;
	}
}

TEST(DropComponentsBelow, LeavesTheOthersAsIfTheyWereAlone)
{
	RemeshOptions options;
	options.targetMode          = TargetMode::EdgeLength;
	options.targetEdgeLen       = 0.3;
	options.dropComponentsBelow = 100;
	const RemeshResult r        = remesh(threePieces().view(), options);
	ASSERT_EQ(r.status, Status::Ok) << r.message;
	EXPECT_TRUE(hasSameTopology(r.mesh, icosphere(2)));
	EXPECT_EQ(r.report.cleaned.droppedComponents, 2);
	EXPECT_EQ(r.report.cleaned.droppedFaces, 21);
	EXPECT_EQ(r.report.cleanedInput.components, 1);
	options.dropComponentsBelow = 0;
	const RemeshResult alone    = remesh(icosphere(2).view(), options);
	EXPECT_EQ(r.report.targetVertexNum, alone.report.targetVertexNum) << "the area of what is left";
}

/// Components are counted after the cuts: fins with only an edge in common are components.
TEST(DropComponentsBelow, WorksOnWhatIsNotManifold)
{
	RemeshOptions options;
	options.targetMode          = TargetMode::VertexNum;
	options.targetVertexNum     = 50;
	options.dropComponentsBelow = 4;
	const RemeshResult r =
		remesh(joined(icosphere(2), shifted(finsOnEdge(5), {3, 0, 0})).view(), options);
	ASSERT_EQ(r.status, Status::Ok) << r.message;
	EXPECT_TRUE(hasSameTopology(r.mesh, icosphere(2)));
	EXPECT_EQ(r.report.cleaned.droppedFaces, 5);
}

TEST(DropComponentsBelow, RefusesWhereNothingWouldBeLeft)
{
	RemeshOptions options;
	options.dropComponentsBelow = 321;
	EXPECT_EQ(remesh(threePieces().view(), options).status, Status::UnusableInput);
	options.dropComponentsBelow = -1;
	EXPECT_EQ(remesh(threePieces().view(), options).status, Status::BadOptions);
}

} // namespace

} // namespace gpr::test
