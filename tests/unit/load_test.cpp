// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <tests/support/mesh_audit.h>
#include <tests/support/mesh_builders.h>
#include <tests/support/stages.h>
#include <tests/support/transforms.h>
#include <vcg_extras/core/base/failure.h>
#include <vcg_extras/core/input/load.h>
#include <vcg_extras/core/remesh.h>

#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <limits>

namespace gpr::test {

namespace {

class LoadInput : public ::testing::Test {
protected:
	Workers     workers{1, nullptr};
	CleanCounts counts;

	IndexedMesh load(const TriangleMesh& mesh) { return loadInput(mesh.view(), workers, counts); }

	Status statusOf(const TriangleMesh& mesh)
	{
		try {
			load(mesh);
		}
		catch (const Failure& f) {
			EXPECT_FALSE(f.message.empty());
			EXPECT_EQ(f.message.back(), '.') << f.message;
			return f.status;
		}
		return Status::Ok;
	}
};

bool isPowerOfTwo(double x)
{
	int exponent = 0;
	return std::frexp(x, &exponent) == 0.5;
}

double largestExtent(const IndexedMesh& m)
{
	double most = 0;
	for (int v = 0; v < m.vertexNum; ++v) {
		const Vec3f d = m.position[v] - m.position[0];
		most =
			std::max({most, std::abs(double(d.x)), std::abs(double(d.y)), std::abs(double(d.z))});
	}
	return most;
}

TEST_F(LoadInput, ACleanMeshComesOverAsItIs)
{
	const TriangleMesh sphere = icosphere(2);
	const IndexedMesh  m      = load(sphere);
	ASSERT_EQ(m.vertexNum, int(sphere.vertexNum()));
	ASSERT_EQ(m.faceNum, int(sphere.faceNum()));
	EXPECT_TRUE(std::equal(sphere.triangles.begin(), sphere.triangles.end(), m.triangle.begin()));
	for (int f = 0; f < m.faceNum; ++f)
		EXPECT_EQ(m.sourceFace[f], f);
	EXPECT_FALSE(counts.changedInput());
	EXPECT_EQ(counts.unreferencedVertices, 0);
}

/// Float coordinates near the origin must survive working coordinates and back bit by bit.
TEST_F(LoadInput, FloatCoordinatesNearTheOriginAreTakenOverExactly)
{
	Random random(5);
	for (double size : {1.0, 3.7, 1e-9, 1e9, 0.02, 4096.0}) {
		const FloatMesh   mesh(scaled(noisySphere(2, 0.3, random), size));
		const IndexedMesh m = loadInput(mesh.view(), workers, counts);
		EXPECT_TRUE(isPowerOfTwo(m.frame.scale)) << m.frame.scale;
		for (int v = 0; v < m.vertexNum; ++v) {
			ASSERT_EQ(Vec3f(m.frame.toCaller(m.position[v])), mesh.positions[v]) << "size " << size;
		}
	}
}

TEST_F(LoadInput, WorkingCoordinatesHaveMagnitudeOne)
{
	for (double size : {1e-9, 1e-3, 1.0, 1e9}) {
		const IndexedMesh m = load(scaled(icosphere(2), size));
		EXPECT_GT(largestExtent(m), 0.24) << "size " << size;
		EXPECT_LE(largestExtent(m), 1.0) << "size " << size;
	}
}

/// A scan of 100 m at UTM coordinates of millions: there a float resolves a tenth of a metre.
TEST_F(LoadInput, FarOffsetsAreRemovedWithoutLoss)
{
	Random             random(6);
	const Vec3d        offset(455123.25, 4978321.5, 812.75);
	const TriangleMesh utm = shifted(scaled(noisySphere(2, 0.2, random), 50), offset);
	const IndexedMesh  m   = load(utm);
	EXPECT_LE(largestExtent(m), 1.0);
	for (int v = 0; v < m.vertexNum; ++v) {
		const Vec3d back = m.frame.toCaller(m.position[v]);
		ASSERT_LT(length(back - utm.positions[v]), 1e-5) << "metres, vertex " << v;
	}
}

TEST_F(LoadInput, NotFiniteVerticesGoWithTheirFaces)
{
	TriangleMesh mesh     = grid(4, 4);
	mesh.positions[12].x  = std::numeric_limits<double>::quiet_NaN();
	mesh.positions[0].y   = std::numeric_limits<double>::infinity();
	const IndexedMesh m   = load(mesh);
	const auto        has = [&](int f, int v) {
        const std::int32_t* t = &mesh.triangles[3 * f];
        return t[0] == v || t[1] == v || t[2] == v;
	};
	int touched = 0;
	for (int f = 0; f < int(mesh.faceNum()); ++f)
		touched += has(f, 12) || has(f, 0);
	EXPECT_EQ(counts.nonFiniteVertices, 2);
	EXPECT_EQ(counts.unreferencedVertices, 0) << "the two are counted once";
	EXPECT_EQ(m.faceNum, int(mesh.faceNum()) - touched);
	EXPECT_EQ(m.vertexNum, 23);
	for (int f = 0; f < m.faceNum; ++f)
		EXPECT_FALSE(has(m.sourceFace[f], 12) || has(m.sourceFace[f], 0));
	EXPECT_EQ(factsOf(meshOf(m)).notFinite, 0);
}

TEST_F(LoadInput, NotFiniteVerticesOfNoFaceAreNotMistakenForUnused)
{
	TriangleMesh mesh = grid(2, 2);
	mesh.positions.push_back({NAN, 0, 0});
	mesh.positions.push_back({9, 9, 9});
	load(mesh);
	EXPECT_EQ(counts.nonFiniteVertices, 1);
	EXPECT_EQ(counts.unreferencedVertices, 1);
}

TEST_F(LoadInput, FacesWithAVertexTwiceAreDropped)
{
	TriangleMesh mesh = grid(3, 3);
	mesh.triangles.insert(mesh.triangles.end(), {1, 1, 2, 4, 5, 4, 3, 3, 3});
	const IndexedMesh m = load(mesh);
	EXPECT_EQ(counts.repeatedIndexFaces, 3);
	EXPECT_EQ(m.faceNum, 18);
}

/// An outlier in no face must not enlarge the box, the unit of all measures.
TEST_F(LoadInput, UnreferencedVerticesAreDroppedAndDoNotCountForTheFrame)
{
	TriangleMesh mesh = grid(3, 3);
	mesh.positions.insert(mesh.positions.begin(), {1e12, 0, 0});
	for (std::int32_t& v : mesh.triangles)
		++v;
	const IndexedMesh m = load(mesh);
	EXPECT_EQ(counts.unreferencedVertices, 1);
	EXPECT_EQ(m.vertexNum, 16);
	EXPECT_GT(largestExtent(m), 0.24);
	EXPECT_TRUE(isSoundSurface(meshOf(m)));
}

TEST_F(LoadInput, ASoupIsWeldedWithinAMillionthOfTheBox)
{
	Random             random(7);
	const TriangleMesh sphere = icosphere(3, 10);
	for (double noise : {0.0, 1e-7, 1e-6}) { // of a box 20 wide: tolerance 2e-5 to 3.2e-5
		counts              = CleanCounts();
		const IndexedMesh m = load(soupOf(sphere, noise, random));
		EXPECT_EQ(m.vertexNum, int(sphere.vertexNum())) << "noise " << noise;
		EXPECT_EQ(m.faceNum, int(sphere.faceNum()));
		EXPECT_EQ(counts.weldedVertices, std::int64_t(3 * sphere.faceNum() - sphere.vertexNum()));
		EXPECT_TRUE(isSoundSurface(meshOf(m)));
	}
}

TEST_F(LoadInput, ASoupFarBeyondTheToleranceStaysASoup)
{
	Random             random(8);
	const TriangleMesh sphere = icosphere(2, 10);
	const IndexedMesh  m      = load(soupOf(sphere, 0.01, random));
	EXPECT_EQ(m.vertexNum, int(3 * sphere.faceNum()));
	EXPECT_EQ(counts.weldedVertices, 0);
}

/// A mesh with shared vertices is no soup: two vertices at one place may be meant as two (a slit).
TEST_F(LoadInput, VerticesAtEqualPlacesStayTwoWhereVerticesAreShared)
{
	const TriangleMesh mesh = joined(grid(3, 3), shifted(grid(3, 3), {1, 0, 0}));
	EXPECT_EQ(load(mesh).vertexNum, int(mesh.vertexNum()));
	EXPECT_EQ(counts.weldedVertices, 0);
}

TEST_F(LoadInput, FacesOfASoupThatShrinkToNothingAreDropped)
{
	TriangleMesh soup;
	soup.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {0, 0, 0}, {1, 0, 0}};
	soup.triangles = {0, 1, 2, 3, 4, 5};
	EXPECT_EQ(load(soup).faceNum, 1);
	EXPECT_EQ(counts.zeroAreaFaces, 1);
}

/// Found by fuzzing: the third corner of a dropped face stayed, in no face.
TEST_F(LoadInput, CornersOfDroppedFacesGoToo)
{
	TriangleMesh soup;
	soup.positions         = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {3, 3, 3}, {3, 3, 3}, {9, 0, 0}};
	soup.triangles         = {0, 1, 2, 3, 4, 5};
	const IndexedMesh mesh = load(soup);
	EXPECT_EQ(mesh.faceNum, 1);
	EXPECT_EQ(mesh.vertexNum, 3);
	EXPECT_EQ(counts.weldedVertices, 1);
}

TEST_F(LoadInput, WhatIsNoSurfaceIsRefusedWithASentence)
{
	EXPECT_EQ(statusOf({}), Status::UnusableInput) << "empty";
	EXPECT_EQ(statusOf({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}}), Status::UnusableInput) << "points";
	EXPECT_EQ(statusOf({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 1, 3}}), Status::UnusableInput);
	EXPECT_EQ(statusOf({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 1, -1}}), Status::UnusableInput);
	EXPECT_EQ(statusOf({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 1, 1}}), Status::UnusableInput);
	EXPECT_EQ(statusOf({{{2, 2, 2}, {2, 2, 2}, {2, 2, 2}}, {0, 1, 2}}), Status::UnusableInput);
	EXPECT_EQ(statusOf({{{0, 0, 0}, {NAN, 0, 0}, {0, 1, 0}}, {0, 1, 2}}), Status::UnusableInput);
}

/// Refused by the counts alone: there is nothing behind these pointers.
TEST_F(LoadInput, MoreThanTheIndicesHoldIsRefused)
{
	for (const std::size_t num :
		 {std::size_t(1) << 30, std::size_t(1) << 31, std::size_t(1) << 40}) {
		MeshView view;
		view.vertexNum = 3;
		view.faceNum   = num;
		EXPECT_EQ(remesh(view, RemeshOptions()).status, Status::UnusableInput);
		std::swap(view.vertexNum, view.faceNum);
		EXPECT_EQ(remesh(view, RemeshOptions()).status, Status::UnusableInput);
	}
}

TEST_F(LoadInput, StridedPositionsAreRead)
{
	struct Vertex {
		float colour[4];
		float position[3];
		int   flags;
	};
	const TriangleMesh  plain = grid(3, 3);
	std::vector<Vertex> vertices(plain.vertexNum());
	for (std::size_t v = 0; v < vertices.size(); ++v) {
		const Vec3f p = Vec3f(plain.positions[v]);
		vertices[v]   = {{9, 9, 9, 9}, {p.x, p.y, p.z}, -1};
	}
	MeshView view            = plain.view();
	view.positions           = vertices[0].position;
	view.doublePrecision     = false;
	view.positionStrideBytes = sizeof(Vertex);
	const IndexedMesh m      = loadInput(view, workers, counts);
	for (int v = 0; v < m.vertexNum; ++v)
		EXPECT_EQ(Vec3f(m.frame.toCaller(m.position[v])), Vec3f(plain.positions[v]));
}

TEST_F(LoadInput, SurfaceAreaHasTheSameBitsForAnyNumberOfThreads)
{
	Random            random(9);
	const IndexedMesh m = load(noisySphere(5, 0.1, random));
	Workers           one(1, nullptr);
	const double      alone = measureFaces(m, one).area;
	for (int threads = 2; threads <= 4; ++threads) {
		Workers several(threads, nullptr);
		EXPECT_EQ(measureFaces(m, several).area, alone);
	}
	EXPECT_NEAR(alone, factsOf(meshOf(m)).area, 1e-6);
}

/// Boxes are joined from pieces of 4096 vertices; a piece without a used vertex must not count.
TEST_F(LoadInput, TakesLongRunsOfUnusedVertices)
{
	TriangleMesh mesh;
	mesh.positions.assign(3 * 4096, Vec3d(5, 5, 5));
	mesh.positions[0]        = Vec3d(0, 0, 0);
	mesh.positions[1]        = Vec3d(1, 0, 0);
	mesh.positions[2]        = Vec3d(0, 1, 0);
	mesh.positions[3]        = Vec3d(0, 0, 1);
	mesh.triangles           = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};
	const IndexedMesh loaded = load(mesh);
	EXPECT_EQ(loaded.vertexNum, 4);
	EXPECT_EQ(counts.unreferencedVertices, 3 * 4096 - 4);
}

} // namespace

} // namespace gpr::test
