// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Patches made anew keep the result's number of vertices, or report that the number has changed.

#include <tests/support/laid.h>
#include <tests/support/mesh_audit.h>
#include <tests/support/mesh_builders.h>
#include <tests/support/random_source.h>
#include <tests/support/stages.h>
#include <vcg_extras/core/guard/contact_removal.h>

#include <algorithm>
#include <deque>
#include <gtest/gtest.h>

namespace gpr::test {

namespace {

/// A sheet, and a result with a nest of vertices in one triangle. The input has no vertices there.
class NestInSheet {
public:
	explicit NestInSheet(int nestNum) : random_(3)
	{
		surface_ = surfaceOf(jitteredGrid(8, 0.2, random_), workers);
		surface_.mesh.crease.reset(std::size_t(surface_.mesh.halfEdgeNum()));
		std::fill(surface_.mesh.crease.begin(), surface_.mesh.crease.end(), char(0));
		const ResultMesh sheet = resultOf(surface_, BoundaryCurves());
		const int        face  = faceInside(sheet.mesh);
		TriangleMesh     mesh  = meshOf(sheet.mesh);
		std::deque<int>  toSplit{face};
		for (int i = 0; i < nestNum; ++i) {
			const int next = int(mesh.faceNum());
			toSplit.insert(toSplit.end(), {toSplit.front(), next, next + 1});
			splitFace(mesh, toSplit.front());
			toSplit.pop_front();
		}
		result_.mesh        = halfEdgesOf(mesh);
		result_.vertex      = sheet.vertex;
		result_.idealEdge   = sheet.idealEdge;
		ResultVertex record = sheet.vertex[std::size_t(sheet.mesh.origin[3 * face])];
		record.point.face   = face;
		for (int v = int(result_.vertex.size()); v < result_.mesh.vertexNum; ++v) {
			record.point.position = result_.mesh.position[v];
			result_.vertex.push_back(record);
		}
	}

	Workers           workers{1, nullptr};
	const Surface&    surface() const { return surface_; }
	const ResultMesh& result() const { return result_; }

	/// A mark on the faces at the nest.
	std::vector<char> marks() const
	{
		std::vector<char> marked(std::size_t(result_.mesh.faceNum), 0);
		for (int v = surface_.mesh.vertexNum; v < result_.mesh.vertexNum; ++v)
			forEachOutgoing(result_.mesh, v, [&](int h) { marked[std::size_t(h / 3)] = 1; });
		return marked;
	}

private:
	Random     random_;
	Surface    surface_;
	ResultMesh result_;

	static int faceInside(const HalfEdgeMesh& m)
	{
		for (int f = 0; f < m.faceNum; ++f) {
			const int* v = &m.origin[3 * f];
			if (std::none_of(v, v + 3, [&](int w) { return m.isBorderVertex(w); })) return f;
		}
		return -1;
	}

	/// A vertex in its middle; the two new faces come last.
	static void splitFace(TriangleMesh& mesh, int f)
	{
		const std::int32_t v = std::int32_t(mesh.vertexNum());
		std::int32_t*      t = &mesh.triangles[3 * std::size_t(f)];
		const std::int32_t a = t[0], b = t[1], c = t[2];
		const auto         at = [&](std::int32_t w) { return mesh.positions[std::size_t(w)]; };
		mesh.positions.push_back((at(a) + at(b) + at(c)) * (1.0 / 3));
		t[2] = v;
		for (std::int32_t w : {b, c, v, c, a, v})
			mesh.triangles.push_back(w);
	}
};

} // namespace

TEST(PatchFilling, TellsWhereTheInputHasTooFewVertices)
{
	NestInSheet            nest(600);
	const std::vector<int> kept;
	const BoundaryCurves   curves;
	const MakingOfVertices making{nest.surface(), curves, kept};
	std::vector<char>      marked = nest.marks();
	PatchFilling           filling(making, nest.result(), nest.workers);
	ASSERT_TRUE(filling.fill(marked));
	ASSERT_LT(filling.mesh().vertexNum, nest.result().mesh.vertexNum);
	EXPECT_FALSE(filling.isSound());
}

/// The largest distance of the surface near a point from the result.
float farthestNear(const Laid& on, const Vec3f& place, float reach)
{
	Workers             workers(1, nullptr);
	const NearestOnMesh tree(on.result.mesh, workers);
	float               far = 0;
	for (int v = 0; v < on.surface.mesh.vertexNum; ++v) {
		const Vec3f p = on.surface.mesh.position[v];
		if (length(p - place) < reach) far = std::max(far, length(tree.nearest(p).position - p));
	}
	return far;
}

TEST(MakeFiner, BringsAPlaceNearerWithMoreVertices)
{
	Laid on(icosphere(5), icosphere(3));
	on.result.idealEdge        = length(on.result.mesh.edgeVector(0));
	const ResultMesh    before = copyResult(on.result, on.workers);
	const HalfEdgeMesh& m      = before.mesh;
	const int           face   = 100;
	const Vec3f         place  = m.position[m.origin[3 * face]];
	const float         reach  = on.result.idealEdge;
	const float         far    = farthestNear(on, place, reach);

	const std::vector<int> noneKept;
	makeFiner({on.surface, on.boundary, noneKept}, {face}, on.result, on.workers);
	EXPECT_GT(on.result.mesh.vertexNum, before.mesh.vertexNum + 5);
	EXPECT_LT(on.result.mesh.vertexNum, before.mesh.vertexNum + 60) << "only there";
	EXPECT_LT(farthestNear(on, place, reach), 0.75f * far);
	EXPECT_TRUE(isSoundTable(on.result.mesh));
	EXPECT_TRUE(findTouchingPairs(on.result.mesh, on.workers).empty());
}

} // namespace gpr::test
