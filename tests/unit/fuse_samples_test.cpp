// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <tests/support/mesh_audit.h>
#include <tests/support/mesh_builders.h>
#include <tests/support/oracles.h>
#include <tests/support/stages.h>
#include <vcg_extras/core/sampling/fused_mesh.h>

#include <gtest/gtest.h>
#include <set>

namespace gpr::test {

namespace {

class FuseSamples : public ::testing::Test {
protected:
	Workers        workers{2, nullptr};
	Surface        surface;
	Sampling       sampling;
	BoundaryCurves boundary;

	void begin(const TriangleMesh& mesh) { surface = surfaceOf(mesh, workers); }

	Vec3f corner(int face, int k) const
	{
		return surface.mesh.position[surface.mesh.origin[3 * face + k]];
	}
	/// Adds a sample by the weights of a face's corners.
	void add(int face, float a, float b, float c)
	{
		const Vec3f p = corner(face, 0) * a + corner(face, 1) * b + corner(face, 2) * c;
		sampling.samples.push_back({{p, face}, surface.mesh.faceNormal(face)});
	}
	FusedMesh fuse() { return fuseSamples(surface, sampling, boundary, workers); }

	void expectSound(const FusedMesh& fused)
	{
		EXPECT_TRUE(isSoundTable(fused.mesh));
		EXPECT_TRUE(isSoundSurface(meshOf(fused.mesh)));
		EXPECT_TRUE(hasSameTopology(meshOf(fused.mesh), meshOf(surface.mesh)));
		EXPECT_NEAR(factsOf(meshOf(fused.mesh)).area, factsOf(meshOf(surface.mesh)).area, 1e-4);
		expectParents(fused);
		std::set<int> seen;
		for (std::size_t s = 0; s < sampling.samples.size(); ++s) {
			const int v = fused.sampleVertex[s];
			if (v < 0) continue;
			EXPECT_TRUE(seen.insert(v).second) << "vertex " << v << " is two samples'";
			EXPECT_LT(length(fused.mesh.position[v] - sampling.samples[s].point.position), 1e-5);
		}
	}

private:
	/// Every face lies in its parent face.
	void expectParents(const FusedMesh& fused)
	{
		for (int f = 0; f < fused.mesh.faceNum; ++f) {
			const int parent = fused.parentFace[f];
			ASSERT_GE(parent, 0);
			ASSERT_LT(parent, surface.mesh.faceNum);
			Vec3f middle;
			for (int k = 0; k < 3; ++k)
				middle += fused.mesh.position[fused.mesh.origin[3 * f + k]] * (1 / 3.0f);
			EXPECT_LT(distanceToTriangle(Vec3d(middle), Vec3d(corner(parent, 0)),
										 Vec3d(corner(parent, 1)), Vec3d(corner(parent, 2))),
					  1e-3);
		}
	}
};

TEST_F(FuseSamples, OnVerticesChangeNothing)
{
	begin(icosphere(2));
	const int half = surface.mesh.vertexNum / 2;
	for (int v = 0; v < half; ++v) {
		const int face = surface.mesh.outgoing[v] / 3;
		sampling.samples.push_back(
			{{surface.mesh.position[v], face}, surface.mesh.faceNormal(face)});
	}
	const FusedMesh fused = fuse();
	expectSound(fused);
	EXPECT_EQ(fused.mesh.vertexNum, surface.mesh.vertexNum);
	EXPECT_EQ(fused.mesh.faceNum, surface.mesh.faceNum);
	for (int v = 0; v < half; ++v)
		EXPECT_EQ(fused.sampleVertex[v], v);
}

TEST_F(FuseSamples, OnAnEdgeSplitItAndInsideSplitTheFace)
{
	begin(icosphere(1));
	add(0, 0.5f, 0.5f, 0);
	FusedMesh fused = fuse();
	expectSound(fused);
	EXPECT_EQ(fused.mesh.faceNum, surface.mesh.faceNum + 2);
	EXPECT_EQ(fused.mesh.valence(fused.sampleVertex[0]), 4);
	sampling.samples.clear();
	add(0, 0.3f, 0.3f, 0.4f);
	fused = fuse();
	expectSound(fused);
	EXPECT_EQ(fused.mesh.faceNum, surface.mesh.faceNum + 2);
	EXPECT_EQ(fused.mesh.valence(fused.sampleVertex[0]), 3);
}

TEST_F(FuseSamples, OnBorderEdgesSplitOneFace)
{
	begin(grid(2, 2));
	for (int f = 0; f < surface.mesh.faceNum; ++f) {
		for (int k = 0; k < 3; ++k) {
			if (!surface.mesh.isBorderEdge(3 * f + k)) continue;
			float weight[3]     = {0, 0, 0};
			weight[k]           = 0.25f;
			weight[(k + 1) % 3] = 0.75f;
			add(f, weight[0], weight[1], weight[2]);
		}
	}
	const FusedMesh fused = fuse();
	expectSound(fused);
	EXPECT_EQ(fused.mesh.vertexNum, 9 + 8);
	for (int v : fused.sampleVertex)
		EXPECT_TRUE(fused.mesh.isBorderVertex(v));
}

/// Of two samples at one place, the second sample has no vertex.
TEST_F(FuseSamples, InOnePlaceShareNoVertex)
{
	begin(icosphere(1));
	for (int twice = 0; twice < 2; ++twice) {
		add(0, 1, 0, 0);
		add(1, 0.5f, 0.5f, 0);
		add(2, 0.3f, 0.3f, 0.4f);
	}
	const FusedMesh fused = fuse();
	expectSound(fused);
	for (int s = 0; s < 3; ++s) {
		EXPECT_GE(fused.sampleVertex[s], 0);
		EXPECT_EQ(fused.sampleVertex[s + 3], -1);
	}
}

/// Dozens of samples a face, many on its edges and in line with each other.
TEST_F(FuseSamples, ManyToAFaceAllBecomeVertices)
{
	begin(icosphere(0));
	Random random(1);
	for (int i = 0; i < 600; ++i) {
		const int   face  = random.below(surface.mesh.faceNum);
		const bool  isOff = random.chance(0.5);
		const float a     = isOff ? float(1 + random.below(7)) / 8 : float(random.unit());
		const float b     = isOff ? float(random.unit()) * (1 - a) : 1 - a;
		add(face, a, b, 1 - a - b);
	}
	const FusedMesh fused = fuse();
	expectSound(fused);
	int without = 0;
	for (int v : fused.sampleVertex)
		without += v < 0;
	EXPECT_EQ(without, 0);
	EXPECT_GE(fused.mesh.vertexNum, 600);
}

/// Border samples split the border in their order; other samples on the border get no vertex.
TEST_F(FuseSamples, OfTheBorderBecomeItsVerticesAlone)
{
	begin(openCylinder(24, 6, 1, 1));
	boundary                    = sampleBoundary(surface, 0.3f, 0.31f, workers);
	sampling.boundarySampleNum  = int(boundary.samples.size());
	const int boundarySampleNum = sampling.boundarySampleNum;
	ASSERT_GT(boundarySampleNum, 10);
	for (const CurveSample& s : boundary.samples)
		sampling.samples.push_back({s.point, surface.mesh.faceNormal(s.point.face)});
	for (int h = 0; h < surface.mesh.halfEdgeNum(); ++h) {
		if (!surface.mesh.isBorderEdge(h)) continue;
		const Vec3f middle = (surface.mesh.position[surface.mesh.origin[h]] +
							  surface.mesh.position[surface.mesh.target(h)]) *
							 0.5f;
		const Vec3f end = surface.mesh.position[surface.mesh.origin[h]];
		for (const Vec3f& p : {middle, end})
			sampling.samples.push_back({{p, h / 3}, surface.mesh.faceNormal(h / 3)});
	}
	const FusedMesh fused = fuse();
	expectSound(fused);
	for (int s = 0; s < int(sampling.samples.size()); ++s) {
		if (s >= boundarySampleNum) {
			EXPECT_EQ(fused.sampleVertex[s], -1);
			continue;
		}
		ASSERT_GE(fused.sampleVertex[s], 0);
		EXPECT_TRUE(fused.mesh.isBorderVertex(fused.sampleVertex[s]));
	}
}

} // namespace

} // namespace gpr::test
