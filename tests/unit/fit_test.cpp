// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The fit to the input and its parts: the closest-face map, self-intersections, small symmetric
// matrices. Results are coarse meshes laid on fine meshes.

#include <tests/support/laid.h>
#include <tests/support/mesh_audit.h>
#include <tests/support/mesh_builders.h>
#include <tests/support/on_surface.h>
#include <tests/support/oracles.h>
#include <tests/support/stages.h>
#include <tests/support/transforms.h>
#include <vcg_extras/core/base/sort_unique.h>
#include <vcg_extras/core/base/symmetric_matrix.h>
#include <vcg_extras/core/base/triangle.h>
#include <vcg_extras/core/features/curve_slide.h>
#include <vcg_extras/core/mesh/face_contact.h>
#include <vcg_extras/core/mesh/face_plane.h>
#include <vcg_extras/core/mesh/face_quality.h>
#include <vcg_extras/core/optimization/face_goals.h>
#include <vcg_extras/core/optimization/fit.h>
#include <vcg_extras/core/optimization/terms.h>
#include <vcg_extras/core/optimization/worst_distances.h>
#include <vcg_extras/core/surface/closest_face_map.h>
#include <vcg_extras/core/surface/normal_agreement.h>
#include <vcg_extras/core/surface/surface_distance.h>
#include <vcg_extras/core/surface/surface_gap.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>

namespace gpr::test {

namespace {

std::vector<Vec3f> positionsOf(const HalfEdgeMesh& m)
{
	return std::vector<Vec3f>(m.position.begin(), m.position.begin() + m.vertexNum);
}

} // namespace

// ---- matrices

TEST(PackedMeasure, IsTrueToAFifthOfAPercentFromTinyToHuge)
{
	for (float x = 1e-30f; x < 1e30f; x *= 1.7f)
		EXPECT_NEAR(PackedMeasure(x).value() / x, 1, 2e-3) << x;
	EXPECT_EQ(PackedMeasure(0.0f).value(), 0);
}

TEST(SymmetricMatrix, SolveUndoesTheProduct)
{
	Random random(3);
	for (int i = 0; i < 100; ++i) {
		SymmetricMatrix m;
		const auto      vector = [&] {
            return Vec3f(
					 Vec3d(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)));
		};
		for (int k = 0; k < 3; ++k)
			m.addOuter(vector(), float(random.between(0.5, 2)));
		m.addDiagonal(0.1f);
		const Vec3f x = vector();
		EXPECT_LT(length(m.solve(m * x).value() - x), 1e-4f) << i;
	}
}

TEST(SymmetricMatrix, ASingularOneHasNoSolution)
{
	SymmetricMatrix m;
	EXPECT_FALSE(m.solve({1, 2, 3}).has_value());
}

// ---- self-intersections

TEST(IntersectingFaces, AreFoundWhereTwoSpheresMeet)
{
	Workers                workers(2, nullptr);
	const TriangleMesh     both  = joined(icosphere(3), shifted(icosphere(3), {1, 0.01, 0.02}));
	const HalfEdgeMesh     m     = halfEdgesOf(both);
	const std::vector<int> found = facesOf(findTouchingPairs(m, workers));
	// The circle they meet in lies at x = ½ and has a radius of ½√3; an edge is about 0.14 long.
	EXPECT_GT(found.size(), 2 * 3.14 * 0.86 / 0.14);
	for (int f : found) {
		for (int k = 0; k < 3; ++k)
			EXPECT_NEAR(m.position[m.origin[3 * f + k]].x, 0.5, 0.2) << f;
	}
}

TEST(IntersectingFaces, AreNotThoseThatShareEdgesOrVertices)
{
	Workers workers(2, nullptr);
	Random  random(1);
	for (const TriangleMesh& mesh : {icosphere(4), torus(60, 30), jitteredGrid(40, 0.3, random),
									 cube(8), thinPlate(10, 0.001), twoSheets(20, 1e-4)})
		EXPECT_TRUE(findTouchingPairs(halfEdgesOf(mesh), workers).empty());
}

TEST(IntersectingFaces, AreFoundBeyondASharedVertex)
{
	// Four faces round the origin: the third's far edge runs through the first.
	TriangleMesh mesh;
	mesh.positions = {{0, 0, 0}, {2, -1, 0}, {2, 1, 0}, {1, 0, -1}, {1, 0.1, 1}};
	mesh.triangles = {0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 1};
	Workers      workers(1, nullptr);
	HalfEdgeMesh m = halfEdgesOf(mesh);
	EXPECT_EQ(facesOf(findTouchingPairs(m, workers)), (std::vector<int>{0, 2}));
	m.position[3] = {1, 0, 0.5f};
	EXPECT_TRUE(findTouchingPairs(m, workers).empty());
}

// ---- the closest-face map

namespace {

/// The face of each assigned vertex of the input; -1: none.
std::vector<int> facesOf(const ClosestFaceMap& map, const Laid& laid)
{
	std::vector<int> face(laid.surface.mesh.vertexNum, -1);
	for (int f = 0; f < laid.result.mesh.faceNum; ++f) {
		for (const int* i = map.begin(f); i != map.end(f); ++i)
			face[*i] = f;
	}
	return face;
}

/// The number of vertices of the input that are nearer to another face than to their face.
int numNotNearest(const ClosestFaceMap& map, const Laid& laid)
{
	const HalfEdgeMesh&    m = laid.result.mesh;
	Workers                workers(1, nullptr);
	const NearestOnMesh    tree(m, workers);
	const std::vector<int> face  = facesOf(map, laid);
	int                    wrong = 0;
	for (int p = 0; p < laid.surface.mesh.vertexNum; ++p) {
		const Vec3f at = laid.surface.mesh.position[p];
		const int*  c  = &m.origin[3 * face.at(p)];
		const Vec3f foot =
			nearestOnTriangle(at, m.position[c[0]], m.position[c[1]], m.position[c[2]]);
		wrong += length(foot - at) > 1.001f * length(tree.nearest(at).position - at) + 1e-4f;
	}
	return wrong;
}

} // namespace

TEST(ClosestFaceMap, HoldTheVerticesNearestToTheirFace)
{
	const Laid           laid(icosphere(5), icosphere(2));
	Workers              workers(2, nullptr);
	const ClosestFaceMap map(laid.surface, laid.result, workers);
	EXPECT_LE(numNotNearest(map, laid), laid.surface.mesh.vertexNum / 200);
}

/// After moves of vertices, some assigned points stay at their face, and some go to another face.
TEST(ClosestFaceMap, FollowTheFacesThatMove)
{
	Random         random(7);
	Laid           laid(icosphere(5), icosphere(2));
	Workers        workers(2, nullptr);
	ClosestFaceMap map(laid.surface, laid.result, workers);
	const auto     before = facesOf(map, laid);
	const float    far    = 0.2f * laid.meanEdge();
	for (int v = 0; v < laid.result.mesh.vertexNum; ++v) {
		const Vec3f step(float(random.between(-1, 1)), float(random.between(-1, 1)),
						 float(random.between(-1, 1)));
		laid.result.mesh.position[v] += tangential(step, laid.result.vertex[v].normal) * far;
	}
	map.update(laid.result, workers);
	const auto after = facesOf(map, laid);
	int        moved = 0;
	for (std::size_t p = 0; p < after.size(); ++p) {
		ASSERT_GE(after[p], 0) << p;
		moved += after[p] != before[p];
	}
	EXPECT_GT(moved, int(after.size()) / 50);
	EXPECT_LE(numNotNearest(map, laid), laid.surface.mesh.vertexNum / 200);
	int listed = 0;
	for (int f = 0; f < laid.result.mesh.faceNum; ++f)
		listed += int(map.end(f) - map.begin(f));
	EXPECT_EQ(listed, laid.surface.mesh.vertexNum);
}

TEST(ClosestFaceMap, AreListedOnceEachAndSumUpToTheArea)
{
	const Laid           laid(torus(120, 60), torus(30, 15));
	Workers              workers(2, nullptr);
	const ClosestFaceMap map(laid.surface, laid.result, workers);
	std::vector<int>     seen(laid.surface.mesh.vertexNum, 0);
	double               area = 0, whole = 0;
	for (int f = 0; f < laid.result.mesh.faceNum; ++f) {
		for (const int* i = map.begin(f); i != map.end(f); ++i) {
			++seen[*i];
			area += double(laid.surface.area[*i].value());
		}
	}
	for (int f = 0; f < laid.surface.mesh.faceNum; ++f)
		whole += 0.5 * double(length(laid.surface.mesh.faceCross(f)));
	EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), std::ptrdiff_t(seen.size()));
	EXPECT_NEAR(area / whole, 1, 1e-4);
}

TEST(ClosestFaceMap, NeverReachOverToAnotherSheet)
{
	const Laid             laid(shifted(twoSheets(60, 0.004), {0, 0, -0.002}),
								shifted(twoSheets(12, 0.004), {0, 0, -0.002}));
	Workers                workers(2, nullptr);
	const ClosestFaceMap   map(laid.surface, laid.result, workers);
	const std::vector<int> face = facesOf(map, laid);
	for (int p = 0; p < laid.surface.mesh.vertexNum; ++p) {
		const int corner = laid.result.mesh.origin[3 * face.at(p)];
		EXPECT_EQ(laid.surface.mesh.position[p].z > 0, laid.result.mesh.position[corner].z > 0);
	}
}

TEST(ClosestFaceMap, OfAComponentWithoutResultAreEmpty)
{
	const Laid           laid(joined(icosphere(3), shifted(icosphere(2), {9, 0, 0})), icosphere(1));
	Workers              workers(2, nullptr);
	const ClosestFaceMap map(laid.surface, laid.result, workers);
	const std::vector<int> face = facesOf(map, laid);
	EXPECT_EQ(std::count(face.begin(), face.end(), -1), std::ptrdiff_t(icosphere(2).vertexNum()));
}

/// The force on a vertex and its own matrix are the derivatives of the squared distances over its
/// shift.
TEST(DistanceTerm, HasTheDerivativesOfTheSquaredDistances)
{
	const Laid           laid(icosphere(4), icosphere(1));
	Workers              workers(2, nullptr);
	const ClosestFaceMap map(laid.surface, laid.result, workers);
	const HalfEdgeMesh&  m = laid.result.mesh;
	const Rings          rings(m, workers);
	DistanceTerm         term(m, rings);
	term.assemble(laid.surface, map, false, workers);
	const Vec3d unit(0.6, 0.64, 0.48);
	for (int v : {0, 7, 20}) {
		const auto energy = [&](double shift) {
			double sum = 0;
			forEachOutgoing(m, v, [&](int h) {
				const FacePlane plane(m, h / 3);
				for (const int* i = map.begin(h / 3); i != map.end(h / 3); ++i) {
					const Vec3f  at   = laid.surface.mesh.position[*i];
					const Foot   foot = plane.nearestFoot(at);
					const Vec3d  n(laid.surface.normal[*i].unpack());
					const double off = dot(n, Vec3d(at) - Vec3d(plane.pointAt(foot))) -
									   shift * double(foot.weight[h % 3]) * dot(n, unit);
					sum += 0.5 * double(laid.surface.area[*i].value()) * off * off;
				}
			});
			return sum;
		};
		const double step  = 0.01 * double(laid.meanEdge());
		const double slope = (energy(step) - energy(-step)) / (2 * step);
		const double bend  = (energy(step) - 2 * energy(0) + energy(-step)) / (step * step);
		EXPECT_NEAR(dot(Vec3d(term.force(v).xyz()), unit), -slope, 2e-3 * std::abs(slope)) << v;
		EXPECT_NEAR(dot(Vec3d((term.own(v) * Float4(Vec3f(unit))).xyz()), unit), bend, 2e-3 * bend)
			<< v;
	}
}

// ---- the fit

/// For a triangle of edge h inscribed in a sphere of radius R, a move outwards by h²/8R gives the
/// least squared distance: at a distance of s from the centre, the triangle is (h²/3 - s²)/2R below
/// the sphere, and the mean of s² is h²/12.
TEST(Fit, MovesAnInscribedMeshOutByAnEighthOfItsSquaredEdge)
{
	Laid   laid(icosphere(6), icosphere(3));
	double squaredEdge = 0;
	for (int h = 0; h < laid.result.mesh.halfEdgeNum(); ++h)
		squaredEdge += double(squaredLength(laid.result.mesh.position[laid.result.mesh.target(h)] -
											laid.result.mesh.position[laid.result.mesh.origin[h]]));
	squaredEdge /=
		laid.result.mesh.halfEdgeNum() * laid.surface.frame.scale * laid.surface.frame.scale;
	const double rmsBefore = laid.rms();
	laid.fit();
	double mean = 0;
	for (int v = 0; v < laid.result.mesh.vertexNum; ++v)
		mean += length(laid.at(v)) / laid.result.mesh.vertexNum;
	EXPECT_NEAR((mean - 1) / (squaredEdge / 8), 1, 0.1);
	// Mean squared height before over mean squared height after: √5 in theory.
	EXPECT_LT(laid.rms(), rmsBefore / 2);
}

/// On a sphere a ring lies h²/2R below its vertex, of which a third is h²/6R.
TEST(Fit, WithoutRoundsRaisesVerticesByAThirdOfTheirHeightOverTheRing)
{
	Laid         laid(icosphere(6), icosphere(3));
	const double edge      = double(laid.meanEdge() / laid.surface.frame.scale);
	const double rmsBefore = laid.rms();
	EXPECT_EQ(laid.fit(32, 0).map, nullptr);
	double mean = 0;
	for (int v = 0; v < laid.result.mesh.vertexNum; ++v)
		mean += length(laid.at(v)) / laid.result.mesh.vertexNum;
	EXPECT_NEAR((mean - 1) / (edge * edge / 6), 1, 0.1);
	EXPECT_LT(laid.rms(), 0.6 * rmsBefore);
}

TEST(Fit, StaysInAPlane)
{
	for (const int rounds : {0, 4}) {
		Random random(5);
		Laid   laid(grid(60, 60), jitteredGrid(12, 0.3, random));
		laid.fit(32, rounds);
		for (int v = 0; v < laid.result.mesh.vertexNum; ++v)
			EXPECT_NEAR(laid.at(v).z, 0, 1e-6) << v;
		EXPECT_TRUE(isSoundSurface(meshOf(laid.result.mesh)));
	}
}

TEST(Fit, LowersNoAngleBelowTheBound)
{
	for (std::uint32_t seed : testSeeds(4)) {
		Random                   random(seed);
		const TriangleMesh       fine = noisySphere(5, 0.02, random);
		Laid                     laid(fine, noisySphere(3, 0.08, random));
		const std::vector<float> before = laid.minAngles();
		laid.fit(32);
		const std::vector<float> after = laid.minAngles();
		const float              bound = 32 * 3.14159265f / 180;
		for (std::size_t f = 0; f < before.size(); ++f)
			EXPECT_GE(after[f], 0.999f * std::min(bound, before[f])) << "seed " << seed;
	}
}

/// On a surface rougher than the triangles, the fit alone would turn triangles away from the
/// surface.
TEST(Fit, LetsNoFaceLookAwayFromTheSurface)
{
	int away = 0;
	for (std::uint32_t seed : testSeeds(4)) {
		Random              random(seed);
		const TriangleMesh  fine = noisySphere(6, 0.03, random);
		Laid                laid(fine, noisySphere(4, 0.03, random));
		const Buffer<Vec3f> before = smoothNormals(laid.surface, laid.result, laid.workers);
		std::vector<float>  then;
		for (int f = 0; f < laid.result.mesh.faceNum; ++f)
			then.push_back(normalAgreement(laid.result.mesh, before, f));
		laid.fit(0, 1);
		for (int f = 0; f < laid.result.mesh.faceNum; ++f) {
			const float now = normalAgreement(laid.result.mesh, before, f);
			away += now < 0.3f && now < then[f] - 1e-3f;
		}
	}
	EXPECT_EQ(away, 0);
}

/// The smooth normal of a vertex changes as its record follows the vertex: a face that was right at
/// the old records can be inverted at the new ones.
TEST(Fit, LeavesNoMovedFaceInvertedAtItsNewRecords)
{
	for (std::uint32_t seed : testSeeds(4)) {
		Random                   random(seed);
		const TriangleMesh       fine = noisySphere(6, 0.06, random);
		Laid                     laid(fine, noisySphere(4, 0.06, random));
		const HalfEdgeMesh&      m      = laid.result.mesh;
		const std::vector<Vec3f> before = positionsOf(m);
		laid.fit(0, 0);
		const auto hasMoved = [&](int f) {
			return std::any_of(&m.origin[3 * f], &m.origin[3 * f] + 3,
							   [&](int v) { return !(m.position[v] == before[v]); });
		};
		const Buffer<Vec3f> normal = smoothNormals(laid.surface, laid.result, laid.workers);
		int                 moved  = 0;
		for (int f = 0; f < m.faceNum; ++f) {
			if (!hasMoved(f)) continue;
			++moved;
			EXPECT_GE(normalAgreement(m, normal, f), 0) << "face " << f << ", seed " << seed;
		}
		EXPECT_GT(moved, m.faceNum / 2);
	}
}

TEST(Fit, KeepsVerticesOfBordersCreasesAndTips)
{
	const Laid start(squareFrame(60, 20), squareFrame(15, 5));
	Laid       laid(squareFrame(60, 20), squareFrame(15, 5));
	laid.result.mesh.crease = Buffer<char>(std::size_t(laid.result.mesh.halfEdgeNum()), 0);
	Buffer<char>& crease    = laid.result.mesh.crease;
	for (int h = 0; h < 60; ++h) {
		if (laid.result.mesh.opposite[h] >= 0) crease[h] = crease[laid.result.mesh.opposite[h]] = 1;
	}
	const int tip                    = laid.result.mesh.vertexNum / 2;
	laid.result.vertex[tip].isCorner = true;
	laid.fit();
	int moved = 0;
	for (int v = 0; v < laid.result.mesh.vertexNum; ++v) {
		const bool same = laid.result.mesh.position[v] == start.result.mesh.position[v];
		moved += !same;
		if (v == tip || laid.result.mesh.isCurveVertex(v)) {
			EXPECT_TRUE(same) << v;
		}
	}
	EXPECT_GT(moved, 20);
}

TEST(Fit, LeavesSurfacePointsOnTheSurfaceBelowTheVertices)
{
	for (const int rounds : {0, 4}) {
		Laid laid(torus(160, 80), torus(32, 16));
		laid.fit(32, rounds);
		const float         farthest = farthestFromSurface(laid.result);
		const HalfEdgeMesh& s        = laid.surface.mesh;
		for (int v = 0; v < laid.result.mesh.vertexNum; ++v) {
			const SurfacePoint& a = laid.result.vertex[v].point;
			const auto corner = [&](int k) { return Vec3d(s.position[s.origin[3 * a.face + k]]); };
			EXPECT_LT(distanceToTriangle(Vec3d(a.position), corner(0), corner(1), corner(2)), 1e-5);
		}
		// About h²/8R over the tube.
		EXPECT_LT(double(farthest) / laid.surface.frame.scale, 0.05);
		EXPECT_GT(farthest, 0);
	}
}

// ---- the largest distances

/// A sphere pressed flat and tilted against the mesh: its equator is a sharp rim.
TriangleMesh lens(int level)
{
	TriangleMesh mesh = rotated(icosphere(level), {1, 0.4, 0.2}, 0.5);
	for (Vec3d& p : mesh.positions)
		p.z = std::copysign(1.1 * (1 - std::hypot(p.x, p.y)), p.z);
	return mesh;
}

/// The coarse mesh has no edges along the rim: with the least mean of squares, faces cut off some
/// parts of the rim and stand out elsewhere.
TEST(WorstDistances, ShrinkAtARimAtLittleCost)
{
	const TriangleMesh fine = lens(6), coarse = lens(3);
	Laid               mean(fine, coarse), worst(fine, coarse);
	mean.fit(15);
	worst.fit(15, 4, 4);
	EXPECT_LT(worst.farthest(), 0.9f * mean.farthest());
	EXPECT_LT(worst.rms(), 1.2 * mean.rms());
	const std::vector<float> before = mean.minAngles(), after = worst.minAngles();
	const float              bound = 15 * 3.14159265f / 180;
	for (std::size_t f = 0; f < before.size(); ++f)
		EXPECT_GE(after[f], 0.999f * std::min(bound, before[f])) << f;
	EXPECT_TRUE(isSoundSurface(meshOf(worst.result.mesh)));
}

/// Two squares side by side with a slit between, and two triangles over both squares: the nearest
/// point for a point beyond the slit is found from a corner beyond the slit.
TEST(SurfaceGaps, AreNoWiderThanASlit)
{
	constexpr double     slit = 0.05;
	Laid                 laid(joined(grid(20, 20), shifted(grid(20, 20), {1 + slit, 0, 0})),
							  grid(1, 1, 2 + slit, 1));
	const ClosestFaceMap map(laid.surface, laid.result, laid.workers);
	Buffer<SurfacePoint> point(laid.result.mesh.vertexNum);
	for (int v = 0; v < laid.result.mesh.vertexNum; ++v)
		point[v] = laid.result.vertex[v].point;
	const SurfaceGaps gaps(laid.surface, map, laid.result.mesh, point, 1e-4f);
	for (int f = 0; f < laid.result.mesh.faceNum; ++f) {
		const double gap = std::sqrt(double(gaps.gapAt(f).squared)) / laid.surface.frame.scale;
		EXPECT_NEAR(gap, 0.5 * slit, 1e-4);
	}
}

/// A vertex pushed out of a sphere comes back.
TEST(WorstDistances, BringASpikeBack)
{
	Laid laid(icosphere(6), icosphere(3));
	laid.fit();
	const ClosestFaceMap map(laid.surface, laid.result, laid.workers);
	const int            spike  = 100;
	Vec3f&               at     = laid.result.mesh.position[spike];
	const float          height = 0.3f * laid.meanEdge();
	at += laid.result.vertex[spike].normal * height;
	const float before = laid.farthest();
	lowerWorstDistances(laid.surface, map, 0.5f, 4, laid.result, laid.workers);
	EXPECT_GT(before, 0.28f);
	EXPECT_LT(laid.farthest(), 0.4f * before);
}

/// Gains of a triangle must not cost other triangles.
TEST(WorstDistances, NeverGrow)
{
	for (unsigned seed : {20u, 23u, 31u}) {
		Random random(seed);
		Laid   laid(noisySphere(4, 0.05, random), icosphere(2));
		laid.fit(15);
		const ClosestFaceMap map(laid.surface, laid.result, laid.workers);
		const float          before = laid.farthest() * laid.meanEdge();
		lowerWorstDistances(laid.surface, map, 0.2f, 4, laid.result, laid.workers);
		EXPECT_LE(laid.farthest() * laid.meanEdge(), 1.001f * before) << seed;
	}
}

/// A record that stays behind its vertex is farther from the vertex than the surface is.
TEST(WorstDistances, TakeTheRecordsAlong)
{
	for (unsigned seed : {20u, 23u, 31u}) {
		Random random(seed);
		Laid   laid(noisySphere(4, 0.05, random), icosphere(2));
		laid.fit(15);
		const std::vector<Vec3f> start = positionsOf(laid.result.mesh);
		const ClosestFaceMap     map(laid.surface, laid.result, laid.workers);
		lowerWorstDistances(laid.surface, map, 0.2f, 4, laid.result, laid.workers);
		const NearestOnMesh tree(laid.surface.mesh, laid.workers);
		float               sum = 0, movedNum = 0;
		for (int v = 0; v < laid.result.mesh.vertexNum; ++v) {
			const Vec3f p = laid.result.mesh.position[v];
			if (p == start[v]) continue;
			++movedNum;
			sum += length(p - laid.result.vertex[v].point.position);
			sum -= length(p - tree.nearest(p).position);
		}
		EXPECT_GT(movedNum, 50);
		EXPECT_LT(sum / movedNum, 0.008f * laid.meanEdge()) << seed;
	}
}

TEST(WorstDistances, LeaveAloneWhatIsNear)
{
	Laid laid(icosphere(6), icosphere(3));
	laid.fit();
	ASSERT_LT(laid.farthest(), 0.1f);
	const std::vector<Vec3f> before = positionsOf(laid.result.mesh);
	const ClosestFaceMap     map(laid.surface, laid.result, laid.workers);
	lowerWorstDistances(laid.surface, map, 0.5f, 4, laid.result, laid.workers);
	EXPECT_EQ(positionsOf(laid.result.mesh), before);
}

/// Planes with common crease edges, which are also edges of the result: the result lies on the
/// surface.
TEST(WorstDistances, LeaveAPrismAlone)
{
	Laid laid(lPrism(24), lPrism(4));
	ASSERT_LT(laid.farthest(), 1e-4f);
	const std::vector<Vec3f> before = positionsOf(laid.result.mesh);
	const ClosestFaceMap     map(laid.surface, laid.result, laid.workers);
	lowerWorstDistances(laid.surface, map, 0.5f, 4, laid.result, laid.workers);
	EXPECT_EQ(positionsOf(laid.result.mesh), before);
}

TEST(WorstDistances, KeepVerticesOfCreasesAndTips)
{
	Laid laid(icosphere(6), icosphere(3));
	laid.fit();
	const ClosestFaceMap map(laid.surface, laid.result, laid.workers);
	for (ResultVertex& v : laid.result.vertex)
		v.isCorner = true;
	laid.result.mesh.position[100] += laid.result.vertex[100].normal * (0.3f * laid.meanEdge());
	const std::vector<Vec3f> before = positionsOf(laid.result.mesh);
	lowerWorstDistances(laid.surface, map, 0.5f, 4, laid.result, laid.workers);
	EXPECT_EQ(positionsOf(laid.result.mesh), before);
}

TEST(Fit, DoesNotDependOnTheThreads)
{
	Random             random(2);
	const TriangleMesh fine = noisySphere(5, 0.01, random), coarse = icosphere(3);
	Laid               one(fine, coarse, 1);
	one.fit();
	for (int threads : {2, 3}) {
		Laid other(fine, coarse, threads);
		other.fit();
		EXPECT_EQ(positionsOf(other.result.mesh), positionsOf(one.result.mesh)) << threads;
	}
}

// ---- angles after the fit

namespace {

/// A roof with a ridge of 90° along y, and a jittered mesh without edges along the ridge.
Laid jitteredOnRoof(int threads = 2)
{
	const auto roof = [](TriangleMesh mesh) {
		for (Vec3d& p : mesh.positions)
			p.z = -std::abs(p.x - 0.51);
		return mesh;
	};
	Random random(7);
	return Laid(roof(grid(90, 90)), roof(jitteredGrid(18, 0.33, random)), threads);
}

int numBelow(const Laid& laid, float angleDeg)
{
	const std::vector<float> angles = laid.minAngles();
	return int(std::count_if(angles.begin(), angles.end(),
							 [&](float a) { return a < angleDeg * 3.14159265f / 180; }));
}

/// By moves and flips. False if the budget ended the search.
template <class OnMesh>
bool raiseAngles(OnMesh& on, float angleDeg)
{
	const ClosestFaceMap map(on.surface, on.result, on.workers);
	Assignment           assignment(on.surface, map, numbersBelow(on.result.mesh.faceNum));
	std::int64_t         work = 100000000;
	LocalSearch          search(on.surface, on.boundary, &assignment, work, on.result, on.workers);
	return search.run(smallAngles(search, angleDeg * radians));
}

} // namespace

TEST(SmallAngles, RaisesMostOfThemAndKeepsTheDistance)
{
	Laid               laid   = jitteredOnRoof();
	const TriangleMesh before = meshOf(laid.result.mesh);
	const double       error  = laid.rms();
	const int          poor   = numBelow(laid, 30);
	ASSERT_GT(poor, 20);
	ASSERT_TRUE(findTouchingPairs(laid.result.mesh, laid.workers).empty());
	EXPECT_TRUE(raiseAngles(laid, 32));
	EXPECT_LT(numBelow(laid, 30), 0.3 * poor);
	EXPECT_LT(laid.rms(), 1.05 * error);
	EXPECT_TRUE(isSoundTable(laid.result.mesh));
	EXPECT_TRUE(hasSameTopology(meshOf(laid.result.mesh), before));
	EXPECT_TRUE(findTouchingPairs(laid.result.mesh, laid.workers).empty());
}

TEST(SmallAngles, LeavesBordersAndPinnedVerticesAlone)
{
	Laid laid = jitteredOnRoof();
	for (int v = 0; v < laid.result.mesh.vertexNum; v += 3)
		laid.result.vertex[v].isPinned = true;
	const std::vector<Vec3f> before = positionsOf(laid.result.mesh);
	raiseAngles(laid, 32);
	EXPECT_NE(positionsOf(laid.result.mesh), before);
	for (int v = 0; v < laid.result.mesh.vertexNum; ++v) {
		if (v % 3 == 0 || laid.result.mesh.isBorderVertex(v)) {
			EXPECT_EQ(laid.result.mesh.position[v], before[v]) << v;
		}
	}
}

TEST(SmallAngles, ChangesNothingWhereNoAngleIsPoor)
{
	Laid                     laid   = jitteredOnRoof();
	const std::vector<Vec3f> before = positionsOf(laid.result.mesh);
	EXPECT_TRUE(raiseAngles(laid, 0.001f));
	EXPECT_EQ(positionsOf(laid.result.mesh), before);
}

TEST(SmallAngles, DoesNotDependOnThreads)
{
	Laid one = jitteredOnRoof(1), three = jitteredOnRoof(3);
	raiseAngles(one, 32);
	raiseAngles(three, 32);
	EXPECT_EQ(positionsOf(one.result.mesh), positionsOf(three.result.mesh));
	EXPECT_EQ(one.result.flipNum, three.result.flipNum);
}

std::size_t numAbove(const Laid& laid, float angle)
{
	Workers workers(1, nullptr);
	return findObtuseFaces(laid.result.mesh, angle, workers).size();
}

float smallestOf(const Laid& laid)
{
	const std::vector<float> angles = laid.minAngles();
	return *std::min_element(angles.begin(), angles.end());
}

bool lowerLargeAngles(Laid& laid, float smallestDeg)
{
	const ClosestFaceMap map(laid.surface, laid.result, laid.workers);
	Assignment           assignment(laid.surface, map, numbersBelow(laid.result.mesh.faceNum));
	std::int64_t         work = 100000000;
	LocalSearch search(laid.surface, laid.boundary, &assignment, work, laid.result, laid.workers);
	return search.run(largeAngles(search, smallestDeg * radians));
}

TEST(LargeAngles, AsPoorAsSmallOnes)
{
	EXPECT_FLOAT_EQ(asPoorAs(32 * radians), 110 * radians);
	EXPECT_FLOAT_EQ(asPoorAs(0), 180 * radians);
}

TEST(LargeAngles, LowersMostOfThemAndNoSmallOneFallsFurther)
{
	Laid               laid   = jitteredOnRoof();
	const TriangleMesh before = meshOf(laid.result.mesh);
	const float        limit  = asPoorAs(28 * radians);
	const std::size_t  large  = numAbove(laid, limit);
	const int          small  = numBelow(laid, 28);
	const float        worst  = smallestOf(laid);
	const double       error  = laid.rms();
	ASSERT_GT(large, 8u);
	EXPECT_TRUE(lowerLargeAngles(laid, 28));
	EXPECT_LT(numAbove(laid, limit), 0.4 * double(large));
	EXPECT_LE(numBelow(laid, 28), small);
	EXPECT_GE(smallestOf(laid), worst);
	EXPECT_LT(laid.rms(), 1.05 * error);
	EXPECT_TRUE(hasSameTopology(meshOf(laid.result.mesh), before));
	EXPECT_TRUE(findTouchingPairs(laid.result.mesh, laid.workers).empty());
}

/// Every fourth vertex of the side y = 0 of a square lies close to the next vertex.
OnSurface crowdedBorder()
{
	constexpr int n    = 16;
	TriangleMesh  mesh = grid(n, n);
	for (int i = 4; i < n; i += 4)
		mesh.positions[i].x += 0.75 / n;
	return OnSurface(mesh);
}

TEST(SmallAngles, SlidesVerticesAlongTheBorder)
{
	OnSurface    on   = crowdedBorder();
	const double area = factsOf(meshOf(on.m())).area;
	ASSERT_LT(on.minAngleDeg(), 20);
	EXPECT_TRUE(raiseAngles(on, 32));
	EXPECT_GT(on.minAngleDeg(), 32);
	EXPECT_NEAR(factsOf(meshOf(on.m())).area / area, 1, 1e-5);
	on.expectOnSurface();
	on.expectSound();
}

TEST(SmallAngles, LeavesPinnedVerticesOfTheBorder)
{
	OnSurface on = crowdedBorder();
	for (ResultVertex& v : on.result.vertex)
		v.isPinned = v.curve >= 0;
	const HalfEdgeMesh before = copyOf(on.m());
	raiseAngles(on, 32);
	for (int v = 0; v < before.vertexNum; ++v) {
		if (!before.isBorderVertex(v)) continue;
		EXPECT_EQ(on.m().position[v], before.position[v]) << v;
	}
	EXPECT_LT(on.minAngleDeg(), 32) << "the vertices inside cannot repair that alone";
}

TEST(SlideKeepsSpacing, UnlessVerticesWereCrowdedBefore)
{
	OnSurface on = crowdedBorder();
	int       v  = 0; // between two vertices a step away
	for (; v < on.m().vertexNum; ++v) {
		const Vec3d p = on.surface.frame.toCaller(on.m().position[v]);
		if (p.y == 0 && std::abs(p.x - 2.0 / 16) < 1e-6) break;
	}
	ASSERT_LT(v, on.m().vertexNum);
	const float     edge = on.result.idealEdge;
	const SlideRoom even{edge, edge}, crowded{0.4f * edge, 1.6f * edge};
	const auto      keeps = [&](const SlideRoom& room, float share) {
        return slideKeepsSpacing(on.result, on.boundary, v, room, share * edge);
	};
	EXPECT_TRUE(keeps(even, 0.29f));
	EXPECT_FALSE(keeps(even, 0.31f));
	EXPECT_FALSE(keeps(even, -0.31f));
	EXPECT_TRUE(keeps(crowded, 0.5f));
	EXPECT_FALSE(keeps(crowded, -0.1f)) << "more crowded still";
	EXPECT_FALSE(keeps(crowded, 1.3f)) << "as crowded on the other side";
}

} // namespace gpr::test
