// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Borders whose vertices depend on the border and the edge length alone.
#include <tests/support/mesh_audit.h>
#include <tests/support/mesh_builders.h>
#include <tests/support/run_options.h>
#include <vcg_extras/core/input/matched_border.h>
#include <vcg_extras/core/remesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <set>

namespace gpr::test {

namespace {

using Place = std::array<double, 3>;

double heightAt(double x, double y)
{
	return 0.1 * std::sin(5 * x + y) + 0.05 * std::cos(7 * y);
}

/// A tile of a terrain from x = first on, its faces turned and numbered by `random`.
TriangleMesh tile(double first, int side, double shift, Random& random)
{
	TriangleMesh mesh;
	for (int i = 0; i <= side; ++i) {
		for (int j = 0; j <= side; ++j) {
			const bool   isInside = i > 0 && i < side && j > 0 && j < side;
			const double x        = first + (double(i) + (isInside ? shift : 0)) / side;
			const double y        = double(j) / side;
			mesh.positions.push_back({x, y, heightAt(x, y)});
		}
	}
	std::vector<std::array<std::int32_t, 3>> faces;
	for (int i = 0; i < side; ++i) {
		for (int j = 0; j < side; ++j) {
			const std::int32_t a = i * (side + 1) + j, b = a + side + 1;
			faces.push_back({a, b, b + 1});
			faces.push_back({a, b + 1, a + 1});
		}
	}
	random.shuffle(faces);
	for (const auto& f : faces)
		mesh.triangles.insert(mesh.triangles.end(), f.begin(), f.end());
	return mesh;
}

RemeshResult matched(const MeshView& mesh, double edgeLength, std::uint32_t seed)
{
	RemeshOptions options;
	options.targetMode           = TargetMode::EdgeLength;
	options.targetEdgeLen        = edgeLength;
	options.boundary             = BoundaryMode::Match;
	options.seed                 = seed;
	options.threads              = 2;
	options.surfacePointsOfFaces = true;
	const RemeshResult result    = remesh(mesh, options);
	EXPECT_EQ(result.status, Status::Ok) << result.message;
	return result;
}

std::set<Place> placesAt(const TriangleMesh& mesh, double x)
{
	std::set<Place> places;
	for (const Vec3d& p : mesh.positions) {
		if (p.x == x) places.insert({p.x, p.y, p.z});
	}
	return places;
}

TEST(MatchedBorder, TilesGetTheSameVerticesInSeparateRuns)
{
	for (std::uint32_t seed : testSeeds(6)) {
		SCOPED_TRACE("seed " + std::to_string(seed));
		Random             random(seed);
		const double       edge = 0.05 + 0.1 * random.unit();
		const TriangleMesh west = tile(0, 40, 0.2, random), east = tile(1, 40, -0.1, random);
		const RemeshResult a = matched(west.view(), edge, seed),
						   b = matched(east.view(), edge, seed + 1);
		EXPECT_TRUE(isSoundSurface(a.mesh));
		EXPECT_TRUE(hasSameTopology(a.mesh, west));
		const std::set<Place> seam = placesAt(a.mesh, 1);
		EXPECT_EQ(seam, placesAt(b.mesh, 1));
		EXPECT_NEAR(double(seam.size()), 1.05 / edge, 0.1 / edge + 2);
	}
}

TEST(MatchedBorder, PointsAreOnTheCallersFaces)
{
	Random             random(1);
	const TriangleMesh mesh   = tile(0, 20, 0.1, random);
	const RemeshResult result = matched(mesh.view(), 0.11, 1);
	for (std::size_t v = 0; v < result.mesh.vertexNum(); ++v) {
		const BarycentricPoint& at = result.surfacePoints[v];
		Vec3d                   p;
		for (int k = 0; k < 3; ++k)
			p += mesh.positions[std::size_t(mesh.triangles[std::size_t(3 * at.face + k)])] *
				 double(at.weight[k]);
		EXPECT_NEAR(p.x, result.mesh.positions[v].x, 0.03);
		EXPECT_NEAR(p.y, result.mesh.positions[v].y, 0.03);
	}
	for (const BarycentricPoint& at : result.facePoints)
		EXPECT_LT(std::size_t(at.face), mesh.faceNum());
}

TEST(MatchedBorder, SplitFacesMakeTheSameSurfaceWithTheSameMarks)
{
	Random                    random(2);
	const TriangleMesh        mesh = tile(0, 6, 0, random);
	std::vector<std::uint8_t> line(3 * mesh.faceNum(), 1);
	std::vector<std::int32_t> region(mesh.faceNum());
	for (std::size_t f = 0; f < region.size(); ++f)
		region[f] = std::int32_t(f);
	std::vector<std::uint8_t> selected; // the half with small x
	for (const Vec3d& p : mesh.positions)
		selected.push_back(p.x <= 0.5);
	MeshView view = mesh.view();
	view.line     = line.data();
	view.region   = region.data();
	view.selected = selected.data();
	Workers             workers(1, nullptr);
	const MatchedBorder to = matchBorder(view, 0.06, {}, workers); // several samples on each edge
	const TriangleMesh  split{to.positions, to.triangles};
	EXPECT_TRUE(isSoundSurface(split));
	EXPECT_TRUE(hasSameTopology(split, mesh));
	std::vector<double> area(mesh.faceNum(), 0);
	std::int64_t        lineNum = 0;
	for (std::size_t f = 0; f < split.faceNum(); ++f) {
		const auto at = [&](std::size_t k) {
			return split.positions[std::size_t(split.triangles[3 * f + k])];
		};
		area[std::size_t(to.faceOf[f])] += length(cross(at(1) - at(0), at(2) - at(0))) / 2;
		EXPECT_EQ(to.region[f], to.faceOf[f]);
		lineNum += to.line[3 * f] + to.line[3 * f + 1] + to.line[3 * f + 2];
	}
	for (std::size_t f = 0; f < mesh.faceNum(); ++f) {
		const auto at = [&](std::size_t k) {
			return mesh.positions[std::size_t(mesh.triangles[3 * f + k])];
		};
		EXPECT_NEAR(area[f], length(cross(at(1) - at(0), at(2) - at(0))) / 2, 1e-12);
	}
	const auto added = std::int64_t(split.vertexNum()) - std::int64_t(mesh.vertexNum());
	EXPECT_GT(added, 40);
	EXPECT_EQ(lineNum, std::int64_t(line.size()) + added); // no line along a cut
	for (std::size_t v = 0; v < split.vertexNum(); ++v)
		EXPECT_EQ(to.selected[v] != 0, split.positions[v].x <= 0.5) << split.positions[v].x;
}

TEST(MatchedBorder, ALoopWithoutCornersHasNoBeginOfItsNumbers)
{
	TriangleMesh mesh;
	const int    num = 90;
	mesh.positions.push_back({0, 0, 0.3});
	for (int i = 0; i < num; ++i) {
		const double t = 2 * 3.14159265358979 * i / num;
		mesh.positions.push_back({std::cos(t), std::sin(t), 0});
		mesh.triangles.insert(mesh.triangles.end(), {0, i + 1, (i + 1) % num + 1});
	}
	TriangleMesh turned = mesh; // the other numbers, and the other direction
	std::reverse(turned.positions.begin(), turned.positions.end());
	for (std::int32_t& v : turned.triangles)
		v = num - v;
	for (std::size_t f = 0; f < turned.faceNum(); ++f)
		std::swap(turned.triangles[3 * f], turned.triangles[3 * f + 1]);
	const auto kept = [](const TriangleMesh& of) {
		Workers             workers(1, nullptr);
		const MatchedBorder border = matchBorder(of.view(), 0.37, {}, workers);
		std::set<Place>     places;
		for (std::size_t v = 0; v < border.positions.size(); ++v) {
			const Vec3d p = border.positions[v];
			if (border.isKept[v]) places.insert({p.x, p.y, p.z});
		}
		return places;
	};
	EXPECT_EQ(kept(mesh), kept(turned));
	EXPECT_EQ(kept(mesh).size(), 17u);
}

TEST(MatchedBorder, PlacesThatAreNoneAndBordersWithoutEndDoNoHarm)
{
	Random       random(3);
	TriangleMesh mesh     = tile(0, 20, 0, random);
	mesh.positions[210].x = std::nan("");
	mesh.positions[20].z  = HUGE_VAL;
	EXPECT_EQ(matched(mesh.view(), 0.11, 1).report.cleaned.nonFiniteVertices, 2);
	RemeshOptions options;
	options.targetMode    = TargetMode::EdgeLength;
	options.targetEdgeLen = 1e-12;
	options.boundary      = BoundaryMode::Match;
	EXPECT_EQ(remesh(mesh.view(), options).status, Status::OutOfMemory);
}

/// A sheet over the unit square, periodic along both axes, its vertices off by `noise`; shiftEnd
/// moves the end along x.
TriangleMesh periodicSheet(int side, double noise, double shiftEnd, Random& random)
{
	TriangleMesh mesh = tile(0, side, 0.3, random);
	for (Vec3d& p : mesh.positions) {
		p.z = 0.1 * std::sin(2 * pi * p.x) + 0.07 * std::cos(2 * pi * p.y + 1);
		if (p.x == 1) p.y += shiftEnd * p.y * (1 - p.y);
		p = p + Vec3d(random.unit() - 0.5, random.unit() - 0.5, random.unit() - 0.5) * noise;
	}
	return mesh;
}

RemeshOptions periodicOptions(double edge)
{
	RemeshOptions options;
	options.targetMode    = TargetMode::EdgeLength;
	options.targetEdgeLen = edge;
	options.period        = {1, 1, 0};
	options.threads       = 2;
	return options;
}

TEST(PeriodicBorder, VerticesAtTheEndsMatchBitForBit)
{
	for (std::uint32_t seed : testSeeds(6)) {
		SCOPED_TRACE("seed " + std::to_string(seed));
		Random             random(seed);
		const TriangleMesh mesh   = periodicSheet(40, 1e-5, 0, random);
		const double       edge   = 0.04 + 0.06 * random.unit();
		const RemeshResult result = remesh(mesh.view(), periodicOptions(edge));
		ASSERT_EQ(result.status, Status::Ok) << result.message;
		EXPECT_TRUE(isSoundSurface(result.mesh));
		EXPECT_TRUE(hasSameTopology(result.mesh, mesh));
		std::set<Place> places, ends;
		for (const Vec3d& p : result.mesh.positions) {
			places.insert({p.x, p.y, p.z});
			if (p.x > 0.9999) ends.insert({p.x - 1, p.y, p.z});
			if (p.y > 0.9999) ends.insert({p.x, p.y - 1, p.z});
		}
		EXPECT_NEAR(double(ends.size()), 2.1 / edge, 0.3 / edge + 2);
		for (const Place& at : ends) {
			const bool isThere = std::any_of(places.begin(), places.end(), [&](const Place& p) {
				return (p[0] == at[0] || p[0] + 1 == at[0] + 1) &&
					   (p[1] == at[1] || p[1] + 1 == at[1] + 1) && p[2] == at[2];
			});
			EXPECT_TRUE(isThere) << at[0] << " " << at[1] << " " << at[2];
		}
	}
}

TEST(PeriodicBorder, EndsThatDifferAreRefusedWithTheLargestMismatch)
{
	Random             random(1);
	const TriangleMesh mesh   = periodicSheet(20, 0, 0.1, random);
	const RemeshResult result = remesh(mesh.view(), periodicOptions(0.1));
	EXPECT_EQ(result.status, Status::UnusableInput);
	EXPECT_NE(result.message.find("not periodic along X"), std::string::npos) << result.message;
	EXPECT_NE(result.message.find("is 0.025 away"), std::string::npos) << result.message;
	EXPECT_TRUE(result.mesh.positions.empty());
}

/// All vertices of the border match, but a face is missing at one end.
TEST(PeriodicBorder, EdgesThatDifferAreNamed)
{
	Random       random(1);
	TriangleMesh mesh    = periodicSheet(20, 0, 0, random);
	const auto   isAtEnd = [&](std::size_t corner) {
        return mesh.positions[std::size_t(mesh.triangles[corner])].x > 0.9999;
	};
	for (std::size_t c = 0; c < mesh.triangles.size(); c += 3) {
		const int atEnd = isAtEnd(c) + isAtEnd(c + 1) + isAtEnd(c + 2);
		if (atEnd != 2) continue;
		const auto first = mesh.triangles.begin() + std::ptrdiff_t(c);
		mesh.triangles.erase(first, first + 3);
		break;
	}
	const RemeshResult result = remesh(mesh.view(), periodicOptions(0.1));
	EXPECT_EQ(result.status, Status::UnusableInput);
	EXPECT_NE(result.message.find("not periodic along X: its edges differ"), std::string::npos)
		<< result.message;
}

TEST(PeriodicBorder, WithoutABorderOrWithAnotherPeriodItIsRefused)
{
	Random        random(1);
	RemeshOptions options = periodicOptions(0.1);
	EXPECT_EQ(remesh(icosphere(3).view(), options).status, Status::UnusableInput);
	options.period = {0, 1.5, 0};
	EXPECT_EQ(remesh(periodicSheet(20, 0, 0, random).view(), options).status,
			  Status::UnusableInput);
	for (const double tiny : {1e-20, 1e-300, 0.1}) { // 0.1 fits ten times into the side
		options.period = {0, tiny, 0};
		EXPECT_EQ(remesh(periodicSheet(20, 0, 0, random).view(), options).status,
				  Status::UnusableInput);
	}
	options.period = {-1, 1, 0};
	EXPECT_EQ(remesh(periodicSheet(20, 0, 0, random).view(), options).status, Status::BadOptions);
	options          = periodicOptions(0.1);
	options.boundary = BoundaryMode::Free;
	EXPECT_EQ(remesh(periodicSheet(20, 0, 0, random).view(), options).status, Status::BadOptions);
}

TEST(MatchedBorder, AnErrorInPercentIsThatInMeshUnits)
{
	Random             random(3);
	const TriangleMesh mesh = tile(0, 20, 0, random);
	RemeshOptions      percent;
	percent.targetMode        = TargetMode::MaxError;
	percent.boundary          = BoundaryMode::Match;
	percent.targetMaxError    = 3;
	percent.maxErrorIsPercent = true;
	RemeshOptions units       = percent;
	units.maxErrorIsPercent   = false;
	const RemeshResult a      = remesh(mesh.view(), percent);
	ASSERT_EQ(a.status, Status::Ok) << a.message;
	EXPECT_EQ(a.report.input.faces, std::int64_t(mesh.triangles.size() / 3)) << "the caller's";
	units.targetMaxError = 0.03 * a.report.input.diagonal;
	EXPECT_EQ(remesh(mesh.view(), units).mesh.vertexNum(), a.mesh.vertexNum());
}

/// A tile with a wall below its middle column: three faces meet at each edge there.
TriangleMesh tileOnAWall(int side, Random& random)
{
	TriangleMesh       mesh  = tile(0, side, 0.2, random);
	const std::int32_t first = std::int32_t(mesh.vertexNum()), top = side / 2 * (side + 1);
	const int          depth = side / 4;
	for (int k = 1; k <= depth; ++k) {
		for (int j = 0; j <= side; ++j)
			mesh.positions.push_back(mesh.positions[std::size_t(top + j)] -
									 Vec3d(0, 0, double(k) / side));
	}
	for (int k = 0; k < depth; ++k) {
		for (int j = 0; j < side; ++j) {
			const std::int32_t a = (k == 0 ? top : first + (k - 1) * (side + 1)) + j,
							   b = first + k * (side + 1) + j;
			mesh.triangles.insert(mesh.triangles.end(), {a, b, b + 1, a, b + 1, a + 1});
		}
	}
	return mesh;
}

TEST(MatchedBorder, JunctionsAreSpacedLikeTheBorder)
{
	for (std::uint32_t seed : testSeeds(3)) {
		for (const JunctionMode junctions : {JunctionMode::Cut, JunctionMode::Keep}) {
			SCOPED_TRACE("seed " + std::to_string(seed));
			Random             random(seed);
			const TriangleMesh mesh = tileOnAWall(24, random);
			RemeshOptions      options;
			options.targetMode        = TargetMode::EdgeLength;
			options.targetEdgeLen     = 0.08;
			options.boundary          = BoundaryMode::Match;
			options.junctions         = junctions;
			options.check             = true;
			options.seed              = seed;
			const RemeshResult result = remesh(mesh.view(), options);
			ASSERT_EQ(result.status, Status::Ok) << result.message;
			EXPECT_GT(result.report.quality.minAngleDeg, 20);
			EXPECT_EQ(result.report.audit.guarded.vertexNum, 0);
			if (junctions == JunctionMode::Keep) {
				EXPECT_EQ(result.report.check.intersectingFaces, 0);
			}
		}
	}
}

/// The vertices of a mesh that are kept with edges of length 10.
std::vector<std::uint8_t> keptOf(const TriangleMesh& mesh)
{
	Workers             workers(1, nullptr);
	const MatchedBorder matched = matchBorder(mesh.view(), 10, {}, workers);
	EXPECT_EQ(matched.positions.size(), mesh.vertexNum());
	return matched.isKept;
}

TEST(MatchedBorder, ShortJunctionsWithTheSameEndsGetAVertexEach)
{
	// Three slices of an orange: four curves with three faces each lead from end to end.
	TriangleMesh mesh;
	mesh.positions = {{-1, 0, 0},  {1, 0, 0},      {0, 0, 0},
					  {0, 0.3, 0}, {0, -0.2, 0.2}, {0, -0.2, -0.2}};
	for (const auto& [m, n] : {std::pair(2, 3), {2, 4}, {2, 5}, {3, 4}, {4, 5}, {5, 3}})
		mesh.triangles.insert(mesh.triangles.end(), {0, m, n, 1, n, m});
	EXPECT_EQ(keptOf(mesh), std::vector<std::uint8_t>(6, 1));
}

TEST(MatchedBorder, AVertexStaysWhereTheNumberOfFacesAtAJunctionChanges)
{
	// Three pages of a book; a tetrahedron shares the second edge of the spine.
	TriangleMesh mesh;
	mesh.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
	for (const auto& [y, z] : {std::pair(1, 0), {-1, 1}, {-1, -1}}) {
		const auto first = std::int32_t(mesh.vertexNum());
		for (int x = 0; x < 3; ++x)
			mesh.positions.push_back({double(x), double(y), double(z)});
		for (int a = 0; a < 2; ++a)
			mesh.triangles.insert(mesh.triangles.end(),
								  {a, a + 1, first + a, a + 1, first + a + 1, first + a});
	}
	EXPECT_EQ(keptOf(mesh)[1], 0);
	const auto tip = std::int32_t(mesh.vertexNum());
	mesh.positions.insert(mesh.positions.end(), {{1.5, 0.1, 0.3}, {1.5, 0.3, 0.1}});
	mesh.triangles.insert(mesh.triangles.end(), {1, 2, tip, 2, 1, tip + 1, 1, tip, tip + 1});
	mesh.triangles.insert(mesh.triangles.end(), {2, tip + 1, tip});
	EXPECT_EQ(keptOf(mesh)[1], 1);
}

TEST(MatchedBorder, AClosedSurfaceIsRemeshedAsWithoutIt)
{
	const TriangleMesh mesh    = icosphere(4);
	RemeshOptions      options = countOptions(300);
	const RemeshResult without = remesh(mesh.view(), options);
	options.boundary           = BoundaryMode::Match;
	EXPECT_EQ(remesh(mesh.view(), options).mesh.triangles, without.mesh.triangles);
}

} // namespace

} // namespace gpr::test
