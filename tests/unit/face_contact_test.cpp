// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The exact side of a plane, and contacts of faces.

#include <tests/support/mesh_builders.h>
#include <tests/support/random_source.h>
#include <tests/support/stages.h>
#include <tests/support/transforms.h>
#include <vcg_extras/core/base/orientation.h>
#include <vcg_extras/core/mesh/face_contact.h>
#include <vcg_extras/core/mesh/mesh_edit.h>

#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>

namespace gpr::test {

namespace {

__extension__ using Wide = __int128;

int signOf(Wide x)
{
	return (x > 0) - (x < 0);
}

struct WholePoint {
	std::int64_t x, y, z;

	Vec3f point() const { return {float(x), float(y), float(z)}; }
};

WholePoint operator-(const WholePoint& a, const WholePoint& b)
{
	return {a.x - b.x, a.y - b.y, a.z - b.z};
}

int wholeOrientation(const WholePoint& a, const WholePoint& b, const WholePoint& c,
					 const WholePoint& d)
{
	const WholePoint u = b - a, v = c - a, w = d - a;
	return signOf((Wide(u.x) * v.y - Wide(u.y) * v.x) * w.z +
				  (Wide(u.y) * v.z - Wide(u.z) * v.y) * w.x +
				  (Wide(u.z) * v.x - Wide(u.x) * v.z) * w.y);
}

/// A number that a float holds: 24 bits, and `zeros` zeros behind.
std::int64_t wholeNumber(Random& random, int zeros)
{
	return (std::int64_t(random.between(0, 4194304)) - 2097152) * (std::int64_t(1) << zeros);
}

WholePoint wholePoint(Random& random, int zeros)
{
	return {wholeNumber(random, zeros), wholeNumber(random, zeros), wholeNumber(random, zeros)};
}

NamedTriangle triangle(int a, int b, int c, const Vec3f& p, const Vec3f& q, const Vec3f& r)
{
	return {{a, b, c}, {p, q, r}};
}

const NamedTriangle flat = triangle(0, 1, 2, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});

/// All pairs of all faces.
std::vector<FacePair> touchingPairsOneByOne(const HalfEdgeMesh& m)
{
	std::vector<FacePair> pairs;
	for (int f = 0; f < m.faceNum; ++f) {
		for (int g = f + 1; g < m.faceNum; ++g) {
			if (touch(triangleOf(m, f), triangleOf(m, g))) pairs.emplace_back(f, g);
		}
	}
	return pairs;
}

} // namespace

TEST(Orientation, IsTheSignOfWholeNumbers)
{
	Random random(1);
	int    zeroNum = 0;
	for (int i = 0; i < 20000; ++i) {
		// Points far from and near to each other: differences are exact in a double or are not.
		const WholePoint a = wholePoint(random, i % 3 == 0 ? 14 : 0);
		const WholePoint b = wholePoint(random, 0), c = wholePoint(random, i % 5 == 0 ? 12 : 0);
		// In the plane of the other points, or a unit off.
		WholePoint d{b.x + c.x - a.x, b.y + c.y - a.y, b.z + c.z - a.z};
		if (double(float(d.x)) != double(d.x) || double(float(d.y)) != double(d.y) ||
			double(float(d.z)) != double(d.z))
			d = i % 2 == 0 ? a : wholePoint(random, 0);
		else if (i % 4 == 1)
			d.z = d.z / 2 * 2;
		const int expected = wholeOrientation(a, b, c, d);
		zeroNum += expected == 0;
		EXPECT_EQ(orientation(a.point(), b.point(), c.point(), d.point()), expected);
	}
	EXPECT_GT(zeroNum, 1000);
}

TEST(Orientation, SeesTheLastBitOfAFloat)
{
	const Vec3f a(0.1f, 0.1f, 0.1f), b(0.7f, 0.1f, 0.1f), c(0.1f, 0.9f, 0.1f);
	EXPECT_EQ(orientation(a, b, c, {0.3f, 0.3f, 0.1f}), 0);
	EXPECT_EQ(orientation(a, b, c, {0.3f, 0.3f, std::nextafter(0.1f, 1.0f)}), 1);
	EXPECT_EQ(orientation(a, b, c, {0.3f, 0.3f, std::nextafter(0.1f, 0.0f)}), -1);
	// Differences that do not fit in a double.
	const Vec3f tiny(1e-25f, 0, 0);
	EXPECT_EQ(orientation(tiny, {1, 0, 0}, {0, 1, 0}, {0, 0, 1e-20f}), 1);
	EXPECT_EQ(orientation(tiny, {1, 0, 0}, {0, 1, 0}, {0.5f, 0.5f, 0}), 0);
}

TEST(Orientation, InThePlane)
{
	EXPECT_EQ(orientation(Vec2f{0, 0}, Vec2f{1, 0}, Vec2f{0, 1e-30f}), 1);
	EXPECT_EQ(orientation(Vec2f{0, 0}, Vec2f{0.1f, 0.1f}, Vec2f{0.3f, 0.3f}), 0);
	EXPECT_EQ(orientation(Vec2f{0, 0}, Vec2f{0.1f, 0.1f}, Vec2f{0.3f, std::nextafter(0.3f, 0.f)}),
			  -1);
}

TEST(Touch, OfTrianglesThatShareNothing)
{
	const auto with = [](const Vec3f& p, const Vec3f& q, const Vec3f& r) {
		const NamedTriangle t = triangle(3, 4, 5, p, q, r);
		EXPECT_EQ(touch(flat, t), touch(t, flat));
		return touch(flat, t);
	};
	EXPECT_TRUE(with({0.2f, 0.2f, -1}, {0.2f, 0.2f, 1}, {5, 5, 1})) << "through the inside";
	EXPECT_TRUE(with({0.2f, 0.2f, 0}, {0.2f, 0.2f, 1}, {5, 5, 1})) << "a corner on the inside";
	EXPECT_TRUE(with({0.5f, 0.5f, 0}, {1, 1, 1}, {1, 1, -1})) << "a corner on an edge";
	EXPECT_TRUE(with({0, 0, 0}, {-1, 0, 1}, {-1, 0, -1})) << "corner at corner";
	EXPECT_TRUE(with({0.1f, 0.1f, 0}, {0.2f, 0.1f, 0}, {0.1f, 0.2f, 0})) << "inside, in the plane";
	EXPECT_TRUE(with({1, 1, 0}, {0, 0.5f, 0}, {2, 2, 0})) << "overlapping in the plane";
	EXPECT_FALSE(with({1, 1, 0}, {0.75f, 0.75f, 0}, {2, 2, 0})) << "beside it in the plane";
	EXPECT_FALSE(with({0.2f, 0.2f, 1e-30f}, {0.2f, 0.2f, 1}, {5, 5, 1})) << "just above";
	EXPECT_FALSE(with({2, 2, -1}, {2, 2, 1}, {5, 5, 1})) << "past it";
}

TEST(Touch, OfTrianglesThatShareACorner)
{
	const auto with = [](const Vec3f& p, const Vec3f& q) {
		const NamedTriangle t = triangle(0, 4, 5, {0, 0, 0}, p, q);
		EXPECT_EQ(touch(flat, t), touch(t, flat));
		return touch(flat, t);
	};
	EXPECT_TRUE(with({0.5f, 0.5f, -1}, {0.5f, 0.5f, 1})) << "an edge on the far edge";
	EXPECT_TRUE(with({0.2f, 0.2f, -1}, {0.2f, 0.2f, 1})) << "an edge through the inside";
	EXPECT_TRUE(with({0.5f, 0, 0}, {0, 0, 1})) << "along an edge";
	EXPECT_TRUE(with({0.2f, 0.2f, 0}, {-1, -1, 0})) << "overlapping in the plane";
	EXPECT_FALSE(with({0.2f, 0.2f, 1}, {0.3f, 0.2f, 1})) << "above";
	EXPECT_FALSE(with({-1, 0, 0}, {0, -1, 0})) << "beside it in the plane";
	EXPECT_FALSE(with({-1, 0, 1}, {0, -1, -1})) << "past the corner";
}

TEST(Touch, OfTrianglesThatShareAnEdge)
{
	const auto with = [](const Vec3f& apex) {
		return touch(flat, triangle(1, 0, 5, {1, 0, 0}, {0, 0, 0}, apex));
	};
	EXPECT_TRUE(with({0.3f, 0.3f, 0})) << "folded flat";
	EXPECT_FALSE(with({0.3f, 0.3f, 1e-30f})) << "nearly";
	EXPECT_FALSE(with({0.3f, -0.3f, 0})) << "flat ground";
	EXPECT_TRUE(touch(flat, flat)) << "twice the same";
}

TEST(TouchingPairs, AreThoseOfAllPairs)
{
	Random             random(3);
	const TriangleMesh one   = noisySphere(2, 0.1, random);
	const TriangleMesh two   = noisySphere(2, 0.1, random);
	const HalfEdgeMesh m     = halfEdgesOf(joined(one, shifted(two, {0.7, 0.2, 0.1})));
	const auto         pairs = touchingPairsOneByOne(m);
	ASSERT_GT(pairs.size(), 20u);
	for (const int threads : {1, 3}) {
		Workers workers(threads, nullptr);
		EXPECT_EQ(findTouchingPairs(m, workers), pairs);
	}
	Workers               workers(1, nullptr);
	const int             first = 2 * m.faceNum / 3;
	std::vector<FacePair> late;
	for (const FacePair& pair : pairs) {
		if (pair.second >= first) late.push_back(pair);
	}
	std::vector<char> wanted(std::size_t(m.faceNum), 1);
	std::fill_n(wanted.begin(), first, char(0));
	EXPECT_EQ(findTouchingPairs(m, workers, Seams::Joined, wanted), late);
}

TEST(TouchingFaces, AreThoseOfThePairs)
{
	Random             random(4);
	const TriangleMesh one   = noisySphere(2, 0.1, random);
	const TriangleMesh two   = noisySphere(2, 0.1, random);
	HalfEdgeMesh       m     = halfEdgesOf(joined(one, shifted(two, {0.7, 0.2, 0.1})));
	const auto         faces = facesOf(touchingPairsOneByOne(m));
	ASSERT_GT(faces.size(), 20u);
	for (const int threads : {1, 3}) {
		Workers workers(threads, nullptr);
		EXPECT_EQ(findTouchingFaces(m, workers), faces);
	}
	Workers workers(1, nullptr);
	m.mirrorAxis = 0;
	EXPECT_EQ(findTouchingFaces(m, workers), facesOf(findTouchingPairs(m, workers)));
	EXPECT_GT(findTouchingFaces(m, workers).size(), faces.size()) << "half the sphere lies beyond";
	const HalfEdgeMesh cut = halfEdgesOf(joined(grid(4, 4), shifted(grid(4, 4), {1, 0, 0})));
	EXPECT_TRUE(findTouchingFaces(cut, workers).empty());
	EXPECT_FALSE(findTouchingFaces(cut, workers, Seams::Apart).empty());
}

/// If border vertices at one place have the same name, a degenerate face has a name twice.
TEST(TouchingFaces, MayHaveANameTwice)
{
	const NamedTriangle line = triangle(1, 1, 5, {1, 0, 0}, {1, 0, 0}, {2, 0, 0});
	EXPECT_TRUE(touch(flat, line));
	EXPECT_TRUE(touch(line, flat));
	EXPECT_TRUE(touch(line, line));
}

TEST(TouchingPairs, AreNoneOnSoundSurfaces)
{
	Workers workers(2, nullptr);
	for (const TriangleMesh& mesh :
		 {icosphere(3), cube(6), torus(30, 12), grid(9, 7), cone(20, 5, 1, 9)})
		EXPECT_TRUE(findTouchingPairs(halfEdgesOf(mesh), workers).empty());
}

TEST(TouchingPairs, AreNoneAlongCutsButWhereBordersRunThroughFaces)
{
	Workers            workers(1, nullptr);
	const TriangleMesh left = grid(4, 4), right = shifted(grid(4, 4), {1, 0, 0});
	const HalfEdgeMesh cut = halfEdgesOf(joined(left, right));
	EXPECT_TRUE(findTouchingPairs(cut, workers).empty());
	EXPECT_FALSE(findTouchingPairs(cut, workers, Seams::Apart).empty());
	const TriangleMesh fine = shifted(grid(4, 8), {1, 0, 0});
	EXPECT_FALSE(findTouchingPairs(halfEdgesOf(joined(left, fine)), workers).empty())
		<< "a vertex on an edge of the other touches it";
}

/// Two squares that meet at a corner only.
TEST(TouchingPairs, AreNoneAtASingleCommonPlaceOfBorders)
{
	Workers            workers(1, nullptr);
	const HalfEdgeMesh m = halfEdgesOf(joined(grid(4, 4), shifted(grid(4, 4), {1, 1, 0})));
	EXPECT_TRUE(findTouchingPairs(m, workers).empty());
	EXPECT_TRUE(findTouchingPairs(m, workers, Seams::Apart).empty());
}

/// Thousands of faces at one place have millions of pairs; some hundreds for each face suffice.
TEST(TouchingPairs, AreSomeHundredsForEachFaceAtMost)
{
	Workers       workers(2, nullptr);
	constexpr int num = 3000;
	TriangleMesh  mesh;
	for (int i = 0; i < 3 * num; ++i)
		mesh.positions.push_back({double(i % 3 == 1), double(i % 3 == 2), 0});
	for (int i = 0; i < 3 * num; ++i)
		mesh.triangles.push_back(i);
	const std::vector<FacePair> pairs = findTouchingPairs(halfEdgesOf(mesh), workers, Seams::Apart);
	EXPECT_GE(pairs.size(), std::size_t(num));
	EXPECT_LE(pairs.size(), std::size_t(300 * num));
	EXPECT_EQ(facesOf(pairs).size(), std::size_t(num));
	EXPECT_EQ(findTouchingFaces(halfEdgesOf(mesh), workers, Seams::Apart).size(), std::size_t(num));
	Workers one(1, nullptr);
	EXPECT_EQ(pairs, findTouchingPairs(halfEdgesOf(mesh), one, Seams::Apart));
}

/// A face of half a symmetric mesh may lie on the mirror plane with its border only.
TEST(TouchingPairs, OfFacesThatReachTheMirrorImageAreTwiceTheSameFace)
{
	Workers      workers(2, nullptr);
	HalfEdgeMesh mesh = halfEdgesOf(grid(4, 4));
	mesh.mirrorAxis   = 0;
	EXPECT_TRUE(findTouchingPairs(mesh, workers).empty());
	const int inner = 12; // the middle of the grid
	ASSERT_FALSE(mesh.isBorderVertex(inner));
	for (const float x : {0.0f, -0.1f}) {
		mesh.position[inner] = {x, 0.5f, 0.5f};
		int touching         = 0;
		for (const FacePair& pair : findTouchingPairs(mesh, workers))
			touching += pair.first == pair.second;
		EXPECT_EQ(touching, mesh.valence(inner));
	}
	mesh.mirrorAxis = -1;
	for (const FacePair& pair : findTouchingPairs(mesh, workers))
		EXPECT_NE(pair.first, pair.second);
}

} // namespace gpr::test
