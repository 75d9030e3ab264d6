// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces of several regions: their borders are lines, and labels go with the faces.
#include <tests/support/mesh_audit.h>
#include <tests/support/mesh_builders.h>
#include <tests/support/run_options.h>
#include <vcg_extras/core/remesh.h>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <numeric>
#include <set>

namespace gpr::test {

namespace {

using Labels = std::vector<std::int32_t>;

double areaOf(const TriangleMesh& mesh, std::size_t f)
{
	const auto at = [&](std::size_t k) {
		return mesh.positions[std::size_t(mesh.triangles[3 * f + k])];
	};
	return length(cross(at(1) - at(0), at(2) - at(0))) / 2;
}

/// The faces with an edge in common, as pairs.
std::vector<std::pair<int, int>> neighbours(const TriangleMesh& mesh)
{
	std::map<std::pair<int, int>, int> first;
	std::vector<std::pair<int, int>>   pairs;
	for (std::size_t c = 0; c < mesh.triangles.size(); ++c) {
		const auto edge =
			std::minmax({mesh.triangles[c], mesh.triangles[c % 3 == 2 ? c - 2 : c + 1]});
		const auto [known, isNew] = first.emplace(edge, int(c / 3));
		if (!isNew) pairs.push_back({known->second, int(c / 3)});
	}
	return pairs;
}

/// The labels of components of the same label, ascending.
std::vector<std::int32_t> piecesOf(const TriangleMesh& mesh, const Labels& label)
{
	std::vector<int> parent(mesh.faceNum());
	std::iota(parent.begin(), parent.end(), 0);
	const auto root = [&](int f) {
		while (parent[std::size_t(f)] != f)
			f = parent[std::size_t(f)];
		return f;
	};
	for (const auto& [f, g] : neighbours(mesh)) {
		if (label[std::size_t(f)] == label[std::size_t(g)]) parent[std::size_t(root(f))] = root(g);
	}
	std::vector<std::int32_t> pieces;
	for (std::size_t f = 0; f < parent.size(); ++f) {
		if (parent[f] == int(f)) pieces.push_back(label[f]);
	}
	std::sort(pieces.begin(), pieces.end());
	return pieces;
}

std::map<std::int32_t, double> areasOf(const TriangleMesh& mesh, const Labels& label)
{
	std::map<std::int32_t, double> areas;
	for (std::size_t f = 0; f < mesh.faceNum(); ++f)
		areas[label[f]] += areaOf(mesh, f);
	return areas;
}

/// Each face belongs to the nearest of some random points.
Labels voronoiLabels(const TriangleMesh& mesh, int num, Random& random)
{
	std::vector<Vec3d> site;
	for (int i = 0; i < num; ++i)
		site.push_back(middleOf(mesh, std::size_t(random.below(int(mesh.faceNum())))));
	Labels label;
	for (std::size_t f = 0; f < mesh.faceNum(); ++f) {
		const Vec3d p      = middleOf(mesh, f);
		const auto  isNear = [&](const Vec3d& a, const Vec3d& b) {
            return squaredLength(a - p) < squaredLength(b - p);
		};
		label.push_back(
			std::int32_t(std::min_element(site.begin(), site.end(), isNear) - site.begin()));
	}
	return label;
}

RemeshResult remeshRegions(const TriangleMesh& mesh, const Labels& label, std::int64_t vertexNum,
						   int threads = 2)
{
	MeshView view             = mesh.view();
	view.region               = label.data();
	RemeshOptions options     = countOptions(vertexNum);
	options.threads           = threads;
	options.allowNearest      = true;
	const RemeshResult result = remesh(view, options);
	EXPECT_EQ(result.status, Status::Ok) << result.message;
	return result;
}

bool areFollowed(const RemeshResult& result)
{
	return result.report.featureEdgeNum > 0 && result.notes.empty();
}

/// Two halves of a plate, parted by a circle.
Labels circleLabels(const TriangleMesh& mesh, double radius)
{
	Labels label;
	for (std::size_t f = 0; f < mesh.faceNum(); ++f) {
		const Vec3d p = middleOf(mesh, f);
		label.push_back(p.z > std::sqrt(1 - radius * radius));
	}
	return label;
}

TEST(Regions, RandomVoronoiCellsStayConnectedAndKeepTheirAreas)
{
	int followed = 0;
	for (std::uint32_t seed : testSeeds(12)) {
		SCOPED_TRACE("seed " + std::to_string(seed));
		Random             random(seed);
		const int          level  = 4;
		const TriangleMesh mesh   = random.below(2) == 0 ? icosphere(level) : torus(90, 40);
		const Labels       label  = voronoiLabels(mesh, 2 + random.below(10), random);
		const RemeshResult result = remeshRegions(mesh, label, std::int64_t(mesh.vertexNum() / 4));
		ASSERT_EQ(result.region.size(), result.mesh.faceNum());
		EXPECT_TRUE(isSoundSurface(result.mesh));
		EXPECT_TRUE(hasSameTopology(result.mesh, mesh));
		if (!areFollowed(result)) continue;
		++followed;
		EXPECT_EQ(piecesOf(result.mesh, result.region), piecesOf(mesh, label));
		const auto   before = areasOf(mesh, label), after = areasOf(result.mesh, result.region);
		const double whole =
			std::accumulate(before.begin(), before.end(), 0.0,
							[](double sum, const auto& one) { return sum + one.second; });
		for (const auto& [region, area] : before)
			EXPECT_NEAR(after.at(region), area, 0.005 * area + 0.002 * whole) << region;
	}
	EXPECT_GT(followed, 6);
}

TEST(Regions, ACircleOnASphereIsABorderWithoutZigzag)
{
	const TriangleMesh mesh   = icosphere(5);
	const Labels       label  = circleLabels(mesh, 0.6);
	const RemeshResult result = remeshRegions(mesh, label, 1000);
	EXPECT_EQ(piecesOf(result.mesh, result.region).size(), 2u);
	EXPECT_NEAR(areasOf(result.mesh, result.region)[1], areasOf(mesh, label)[1],
				0.005 * areasOf(mesh, label)[1]);
}

TEST(Regions, TheLabelIsThatOfTheFaceThatStandsForEach)
{
	Random             random(1);
	const TriangleMesh mesh   = icosphere(4);
	const Labels       label  = voronoiLabels(mesh, 6, random);
	const RemeshResult result = remeshRegions(mesh, label, 200);
	for (std::size_t f = 0; f < result.mesh.faceNum(); ++f)
		EXPECT_EQ(result.region[f], label[std::size_t(result.facePoints[f].face)]);
}

TEST(Regions, ARegionOfOneFaceKeepsOne)
{
	const TriangleMesh mesh = icosphere(4);
	Labels             label(mesh.faceNum(), 7);
	label[100]                = 3;
	const RemeshResult result = remeshRegions(mesh, label, 300);
	EXPECT_EQ(std::count(result.region.begin(), result.region.end(), 3), 1);
	EXPECT_TRUE(result.notes.empty());
}

TEST(Regions, WhereNoLineCanBeFollowedBordersAreStillEvenedOut)
{
	Random             random(2);
	const TriangleMesh mesh   = icosphere(4);
	const Labels       label  = voronoiLabels(mesh, 3, random);
	MeshView           view   = mesh.view();
	view.region               = label.data();
	RemeshOptions options     = countOptions(200);
	options.preset            = Preset::Paper; // follows no lines
	const RemeshResult result = remesh(view, options);
	ASSERT_EQ(result.status, Status::Ok) << result.message;
	EXPECT_EQ(piecesOf(result.mesh, result.region).size(), 3u);
}

TEST(Regions, OneLabelForAllChangesNothing)
{
	const TriangleMesh mesh = icosphere(4);
	const Labels       label(mesh.faceNum(), 7);
	const RemeshResult with    = remeshRegions(mesh, label, 300);
	const RemeshResult without = remesh(mesh.view(), countOptions(300));
	EXPECT_EQ(with.mesh.triangles, without.mesh.triangles);
	EXPECT_TRUE(with.mesh.positions == without.mesh.positions);
	EXPECT_EQ(with.region, Labels(with.mesh.faceNum(), 7));
}

TEST(Regions, AnyNumberOfThreadsGivesTheSame)
{
	Random             random(3);
	const TriangleMesh mesh  = torus(90, 40);
	const Labels       label = voronoiLabels(mesh, 5, random);
	const RemeshResult one   = remeshRegions(mesh, label, 500, 1),
					   three = remeshRegions(mesh, label, 500, 3);
	EXPECT_EQ(one.mesh.triangles, three.mesh.triangles);
	EXPECT_EQ(one.region, three.region);
}

TEST(Regions, FacesBesideASelectionKeepTheirLabels)
{
	Random                    random(4);
	const TriangleMesh        mesh  = icosphere(4);
	const Labels              label = voronoiLabels(mesh, 3, random);
	std::vector<std::uint8_t> selected;
	for (std::size_t f = 0; f < mesh.faceNum(); ++f)
		selected.push_back(middleOf(mesh, f).x > 0);
	MeshView view                = mesh.view();
	view.region                  = label.data();
	view.selectedFace            = selected.data();
	RemeshOptions options        = countOptions(300);
	options.selectedOnly         = true;
	options.surfacePointsOfFaces = true;
	const RemeshResult result    = remesh(view, options);
	ASSERT_EQ(result.status, Status::Ok) << result.message;
	ASSERT_EQ(result.region.size(), result.mesh.faceNum());
	for (std::size_t f = 0; f < result.mesh.faceNum(); ++f)
		EXPECT_EQ(result.region[f], label[std::size_t(result.facePoints[f].face)]);
}

} // namespace

} // namespace gpr::test
