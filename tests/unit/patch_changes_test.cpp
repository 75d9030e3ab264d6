// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Contacts of a patch are removed by flips and moves, within the patch and without new vertices.

#include <tests/support/mesh_builders.h>
#include <tests/support/on_surface.h>
#include <vcg_extras/core/guard/face_sets.h>
#include <vcg_extras/core/guard/patch_changes.h>
#include <vcg_extras/core/surface/walk.h>

#include <algorithm>
#include <gtest/gtest.h>

namespace gpr::test {

namespace {

constexpr std::int64_t enough = 100'000'000;

/// The vertex at the top of the arch has moved, so that faces of the arch cross the leaf.
class LeafInArch {
public:
	OnSurface             on{archOverLeaf()};
	std::vector<FacePair> pairs;
	std::vector<char>     marked; ///< per face of the part: in the patch
	FilledPart            filled;

	LeafInArch()
	{
		const HalfEdgeMesh& m   = on.m();
		const Vec3f         top = on.surface.frame.toWorking(Vec3d(0, 2, 1));
		int                 v   = 0;
		for (int w = 0; w < m.vertexNum; ++w) {
			if (squaredLength(m.position[w] - top) < squaredLength(m.position[v] - top)) v = w;
		}
		SurfacePoint& at = on.result.vertex[std::size_t(v)].point;
		EXPECT_TRUE(walk(on.surface.mesh, at, {on.result.idealEdge, 0, 0}));
		on.m().position[v] = at.position;
		pairs              = findTouchingPairs(m, on.workers);
	}

	bool change(std::int64_t work)
	{
		const HalfEdgeMesh& m = on.m();
		const FaceBoxes     tree(m, on.workers);
		const auto          faces = widened(m, facesOf(pairs), PatchFilling::ringsAround);
		PatchPart           part  = cutPart(on.result, tree, faces, 0, on.workers);
		for (int f : part.face)
			marked.push_back(std::binary_search(faces.begin(), faces.end(), f));
		const InputContacts    ofInput(on.surface.mesh, m, pairs, 0.1f, on.workers);
		const std::vector<int> kept;
		return changePatch({on.surface, on.boundary, kept}, ofInput, part, marked, work, on.workers,
						   filled);
	}

	void putBack()
	{
		std::vector<FilledPart> parts;
		parts.push_back(std::move(filled));
		std::vector<int> newIndex;
		gpr::putBack(parts, on.result, newIndex);
	}
};

} // namespace

TEST(PatchChanges, RemoveContactsWithoutNewVertices)
{
	LeafInArch leaf;
	ASSERT_FALSE(leaf.pairs.empty());
	const int vertexNum = leaf.on.m().vertexNum, faceNum = leaf.on.m().faceNum;
	ASSERT_TRUE(leaf.change(enough));
	EXPECT_LT(leaf.filled.replaced.size(), std::size_t(faceNum)) << "changed faces only";
	leaf.putBack();
	leaf.on.expectSound();
	leaf.on.expectOnSurface();
	EXPECT_TRUE(findTouchingPairs(leaf.on.m(), leaf.on.workers).empty());
	EXPECT_EQ(leaf.on.m().vertexNum, vertexNum);
	EXPECT_EQ(leaf.on.m().faceNum, faceNum);
}

TEST(PatchChanges, LeaveAPatchWithMoreContactsThanTheWorkAllows)
{
	LeafInArch leaf;
	EXPECT_FALSE(leaf.change(1));
	EXPECT_TRUE(leaf.filled.replaced.empty());
}

} // namespace gpr::test
