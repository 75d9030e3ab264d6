// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Parts of a result, cut out and put back, leave the result unchanged.

#include <tests/support/mesh_builders.h>
#include <tests/support/random_source.h>
#include <tests/support/stages.h>
#include <vcg_extras/core/guard/face_sets.h>
#include <vcg_extras/core/guard/patch_part.h>
#include <vcg_extras/core/mesh/mesh_edit.h>

#include <algorithm>
#include <gtest/gtest.h>
#include <numeric>

namespace gpr::test {

namespace {

struct Sheet {
	Random     random{3};
	Workers    workers{1, nullptr};
	Surface    surface = surfaceOf(jitteredGrid(40, 0.2, random), workers);
	ResultMesh result  = resultOf(surface, BoundaryCurves());
	FaceBoxes  tree{result.mesh, workers};

	PatchPart partRound(int face)
	{
		return cutPart(result, tree, widened(result.mesh, {face}, 1), 0, workers);
	}

	/// A part round a face, filled with its own faces.
	FilledPart unchangedPart(int face)
	{
		FilledPart p;
		p.part          = partRound(face);
		p.replaced      = widened(result.mesh, {face}, 1 + ringsChanged);
		p.filled.mesh   = copyMesh(p.part.result.mesh, workers);
		p.filled.vertex = p.part.result.vertex;
		p.filled.oldVertex.resize(p.part.vertex.size());
		std::iota(p.filled.oldVertex.begin(), p.filled.oldVertex.end(), 0);
		return p;
	}
};

std::vector<std::vector<Vec3f>> sortedFaces(const HalfEdgeMesh& m)
{
	const auto less = [](const Vec3f& a, const Vec3f& b) {
		return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
	};
	std::vector<std::vector<Vec3f>> faces;
	for (int f = 0; f < m.faceNum; ++f) {
		std::vector<Vec3f> corners;
		for (int h = 3 * f; h < 3 * f + 3; ++h)
			corners.push_back(m.position[m.origin[h]]);
		std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end(), less),
					corners.end());
		faces.push_back(corners);
	}
	std::sort(faces.begin(), faces.end(), [&](const auto& a, const auto& b) {
		return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), less);
	});
	return faces;
}

} // namespace

TEST(PatchPart, LeavesTheWholeAsItWasWhenItIsPutBack)
{
	Sheet                   sheet;
	std::vector<FilledPart> parts;
	for (int face : {0, sheet.result.mesh.faceNum - 1})
		parts.push_back(sheet.unchangedPart(face));
	const auto       before    = sortedFaces(sheet.result.mesh);
	const int        vertexNum = sheet.result.mesh.vertexNum;
	std::vector<int> newIndex;
	putBack(parts, sheet.result, newIndex);
	const HalfEdgeMesh& m = sheet.result.mesh;
	EXPECT_EQ(sortedFaces(m), before);
	EXPECT_EQ(m.vertexNum, vertexNum);
	for (int h = 0; h < m.halfEdgeNum(); ++h) {
		if (m.opposite[h] < 0) continue;
		EXPECT_EQ(m.opposite[m.opposite[h]], h);
		EXPECT_EQ(m.target(m.opposite[h]), m.origin[h]);
	}
	for (int v = 0; v < vertexNum; ++v)
		EXPECT_EQ(newIndex[std::size_t(v)], v);
}

TEST(PatchPart, OfJoinedSheetsIsPutBackIntoJoinedSheets)
{
	Sheet sheet;
	sheet.result.mesh.meetsAtPlaces = true;
	std::vector<FilledPart> parts;
	parts.push_back(sheet.unchangedPart(0));
	std::vector<int> newIndex;
	putBack(parts, sheet.result, newIndex);
	EXPECT_TRUE(sheet.result.mesh.meetsAtPlaces);
}

TEST(PatchPart, KeepsFeatureLines)
{
	Sheet         sheet;
	HalfEdgeMesh& m = sheet.result.mesh;
	m.crease.reset(m.halfEdgeNum());
	for (int h = 0; h < m.halfEdgeNum(); ++h)
		m.crease[h] = m.opposite[h] >= 0 && std::min(h, m.opposite[h]) % 5 == 0;
	const auto lengthOfLines = [&] {
		double sum = 0;
		for (int h = 0; h < m.halfEdgeNum(); ++h)
			sum +=
				m.isCreaseEdge(h) ? length(m.position[m.target(h)] - m.position[m.origin[h]]) : 0;
		return sum;
	};
	const double            before = lengthOfLines();
	std::vector<FilledPart> parts;
	parts.push_back(sheet.unchangedPart(m.faceNum / 2));
	std::vector<int> newIndex;
	putBack(parts, sheet.result, newIndex);
	EXPECT_GT(before, 0);
	EXPECT_NEAR(lengthOfLines(), before, 1e-6 * before);
}

TEST(PatchPart, HasRoomUnlessMarksComeNearItsRim)
{
	Sheet             sheet;
	const int         face = sheet.result.mesh.faceNum / 2 + 40;
	const PatchPart   part = sheet.partRound(face);
	std::vector<char> marked(part.face.size(), 0);
	for (std::size_t f = 0; f < marked.size(); ++f)
		marked[f] = part.face[f] == face;
	EXPECT_TRUE(part.hasRoomFor(marked));
	EXPECT_EQ(part.inWhole(marked), std::vector<int>{face});
	std::fill(marked.begin(), marked.end(), char(1));
	EXPECT_FALSE(part.hasRoomFor(marked));
}

} // namespace gpr::test
