// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <tests/support/mesh_audit.h>
#include <tests/support/mesh_builders.h>
#include <tests/support/mesh_zoo.h>
#include <tests/support/stages.h>
#include <tests/support/transforms.h>
#include <vcg_extras/core/mesh/connect.h>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace gpr::test {

namespace {

struct Repaired {
	CleanCounts      counts;
	TriangleMesh     before, after;
	std::vector<int> source; ///< per face after: the caller's
	bool             connects = false;

	explicit Repaired(const TriangleMesh& mesh, int threads = 1, bool keepsPlaces = false)
	{
		Workers     workers(threads, nullptr);
		IndexedMesh m = loaded(mesh, workers);
		Buffer<int> start;
		orderSpatially(m, workers, start);
		before = meshOf(m);
		repair(m, workers, counts, keepsPlaces);
		source.assign(m.sourceFace.begin(), m.sourceFace.begin() + m.faceNum);
		after = meshOf(m);
		Buffer<int> faceStart;
		Surface     surface;
		surface.grid = orderSpatially(m, workers, faceStart);
		connects     = connect(m, faceStart, workers, surface);
	}

	/// The corners of the caller's face.
	std::vector<std::int32_t>::const_iterator cornersOf(int face) const
	{
		const auto at = std::find(source.begin(), source.end(), face) - source.begin();
		return after.triangles.begin() + std::ptrdiff_t(3 * at);
	}
};

/// Expects a manifold, for any input.
void expectManifold(const Repaired& r)
{
	EXPECT_TRUE(r.connects);
	EXPECT_TRUE(factsOf(r.after).isManifold()) << factsOf(r.after).complaints();
}

class RepairZoo : public ::testing::TestWithParam<ZooMesh> {};

TEST_P(RepairZoo, LeavesManifoldsAloneAndMakesTheOthersManifold)
{
	const Repaired r(GetParam().mesh);
	expectManifold(r);
	EXPECT_EQ(r.counts.changedInput(), !GetParam().isManifold);
	if (GetParam().isManifold) {
		EXPECT_EQ(r.after.triangles, r.before.triangles);
	}
	else if (r.counts.duplicateFaces == 0) {
		const Repaired inPlace(GetParam().mesh, 1, true);
		EXPECT_NEAR(factsOf(inPlace.after).area, factsOf(r.before).area, 1e-6) << "nothing is lost";
	}
}

INSTANTIATE_TEST_SUITE_P(, RepairZoo, ::testing::ValuesIn(meshZoo()),
						 zooName<::testing::TestParamInfo<ZooMesh>>);

TEST(RepairManifold, DropsDuplicateFacesWhateverTheirOrder)
{
	TriangleMesh mesh = grid(3, 3);
	const auto   t    = mesh.triangles;
	mesh.triangles.insert(mesh.triangles.end(), {t[1], t[2], t[0], t[5], t[4], t[3]});
	const Repaired r(mesh);
	expectManifold(r);
	EXPECT_EQ(r.counts.duplicateFaces, 2);
	EXPECT_EQ(r.after.triangles, Repaired(grid(3, 3)).after.triangles);
}

/// Two faces go straight on from each other, but have the same direction at the edge: a join would
/// turn one face over. The third face, at 90°, has the opposite direction.
TEST(RepairManifold, KeepsFacesTogetherThatAreOrientedAlike)
{
	TriangleMesh mesh;
	mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, -1, 0}, {0.5, 0, 1}};
	mesh.triangles = {0, 1, 2, 0, 1, 3, 1, 0, 4};
	const Repaired r(mesh);
	expectManifold(r);
	EXPECT_EQ(r.counts.nonManifoldEdges, 1);
	EXPECT_EQ(r.counts.reorientedFaces, 0);
}

///  Seen along the edge: 0° and 180° go straight on, the fin at 90° is cut off.
TEST(RepairManifold, KeepsTheSmoothestPairOfAFinnedEdgeTogether)
{
	TriangleMesh mesh;
	mesh.positions = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0.5}, {-1, 0, 0.5}, {0, 1, 0.5}};
	mesh.triangles = {0, 1, 2, 0, 1, 4, 1, 0, 3};
	const Repaired r(mesh);
	expectManifold(r);
	EXPECT_EQ(r.counts.nonManifoldEdges, 1);
	const SurfaceFacts facts = factsOf(r.after);
	EXPECT_EQ(facts.components, 2);
	EXPECT_EQ(facts.borderEdges, 7) << "a pair with four, a fin with three";
	// The pair still shares an edge: faces 0 and 2 have two vertices in common.
	const auto first = r.cornersOf(0), other = r.cornersOf(2);
	int        shared = 0;
	for (int k = 0; k < 3; ++k)
		shared += int(std::count(other, other + 3, first[k]));
	EXPECT_EQ(shared, 2);
}

TEST(RepairManifold, ManyFinsPairUp)
{
	for (int fins = 3; fins <= 12; ++fins) {
		const Repaired r(finsOnEdge(fins));
		expectManifold(r);
		EXPECT_EQ(r.counts.nonManifoldEdges, 1);
		EXPECT_EQ(factsOf(r.after).components, (fins + 1) / 2);
		EXPECT_NEAR(factsOf(r.after).area, factsOf(r.before).area, 1e-5);
	}
}

/// Far more sides than the repair compares at once.
TEST(RepairManifold, HundredsOfFinsPairUp)
{
	for (int fins : {64, 65, 129, 400}) {
		const Repaired r(finsOnEdge(fins));
		expectManifold(r);
		EXPECT_EQ(factsOf(r.after).components, (fins + 1) / 2) << fins;
	}
}

TEST(RepairManifold, OrientsAlikeTheSideWithMoreAreaWins)
{
	Random       random(11);
	TriangleMesh mesh   = icosphere(2);
	int          turned = 0;
	for (std::size_t f = 0; f < mesh.faceNum(); ++f) {
		if (!random.chance(0.3)) continue;
		std::swap(mesh.triangles[3 * f + 1], mesh.triangles[3 * f + 2]);
		++turned;
	}
	const Repaired r(mesh);
	expectManifold(r);
	EXPECT_EQ(r.counts.reorientedFaces, turned);
	const Repaired good(icosphere(2));
	for (int f = 0; f < int(mesh.faceNum()); ++f) {
		const auto at = good.cornersOf(f), is = r.cornersOf(f);
		EXPECT_TRUE(std::equal(at, at + 3, is)) << f;
	}
	EXPECT_EQ(factsOf(r.after).againstEachOther, 0);
}

TEST(RepairManifold, GivesEachFanAVertexOfItsOwn)
{
	for (int fans = 2; fans <= 5; ++fans) {
		const Repaired r(fansSharingVertex(fans));
		expectManifold(r);
		EXPECT_EQ(r.counts.nonManifoldVertices, fans - 1);
		EXPECT_EQ(r.after.vertexNum(), r.before.vertexNum() + std::size_t(fans) - 1);
		EXPECT_EQ(factsOf(r.after).components, fans);
		EXPECT_DOUBLE_EQ(factsOf(r.after).area, factsOf(r.before).area);
	}
}

TEST(RepairManifold, CutsAMoebiusStripOpen)
{
	const Repaired r(moebiusStrip(24, 3));
	expectManifold(r);
	EXPECT_GE(r.counts.nonOrientableCuts, 3) << "a cut across is at least three edges long";
	EXPECT_LE(r.counts.nonOrientableCuts, 6) << "and along diagonals twice that at most";
	EXPECT_EQ(factsOf(r.after).components, 1);
	EXPECT_EQ(factsOf(r.after).boundaryLoops, 1) << "a strip cut through is a disk";
	EXPECT_EQ(factsOf(r.after).euler(), 1);
	EXPECT_NEAR(factsOf(r.after).area, factsOf(r.before).area, 1e-5);
}

TEST(RepairManifold, CutsAKleinBottleOpen)
{
	const Repaired r(kleinBottle(24, 12));
	expectManifold(r);
	EXPECT_GT(r.counts.nonOrientableCuts, 0);
	EXPECT_EQ(factsOf(r.after).components, 1);
	EXPECT_GT(factsOf(r.after).boundaryLoops, 0);
	EXPECT_NEAR(factsOf(r.after).area, factsOf(r.before).area, 1e-5);
}

/// A second repair with maps and sets of the whole mesh, written as the rules say.
class PlainRepair {
public:
	explicit PlainRepair(const TriangleMesh& mesh)
	{
		for (const Vec3d& p : mesh.positions)
			position_.push_back(Vec3f(p));
		std::set<std::set<int>> known;
		for (std::size_t f = 0; f < mesh.faceNum(); ++f) {
			const auto t = mesh.triangles.begin() + std::ptrdiff_t(3 * f);
			if (known.insert(std::set<int>(t, t + 3)).second)
				corner_.insert(corner_.end(), t, t + 3);
		}
		link_.assign(corner_.size(), -1);
	}

	TriangleMesh run()
	{
		for (const auto& [ends, sides] : sidesByEdge())
			joinSmoothest(sides);
		orient();
		separateFans();
		openSlits();
		TriangleMesh mesh;
		for (const Vec3f& p : position_)
			mesh.positions.push_back(Vec3d(p));
		mesh.triangles.assign(corner_.begin(), corner_.end());
		return mesh;
	}

private:
	using Edge = std::pair<int, int>;

	std::vector<Vec3f> position_;
	std::vector<int>   corner_, link_;

	int  at(int h) const { return corner_[std::size_t(h)]; }
	int& linkOf(int h) { return link_[std::size_t(h)]; }

	std::map<Edge, std::vector<int>> sidesByEdge() const
	{
		std::map<Edge, std::vector<int>> sides;
		for (int h = 0; h < int(corner_.size()); ++h)
			sides[std::minmax({at(h), at(nextInFace(h))})].push_back(h);
		return sides;
	}

	Vec3f inwardFrom(int h) const
	{
		const Vec3f a = position_[std::size_t(at(h))];
		const Vec3f e = normalized(position_[std::size_t(at(nextInFace(h)))] - a);
		return normalized(tangential(position_[std::size_t(at(prevInFace(h)))] - a, e));
	}

	void joinSmoothest(std::vector<int> sides)
	{
		while (sides.size() > 1) {
			std::tuple<float, std::size_t, std::size_t> best(HUGE_VALF, 0, 1);
			for (std::size_t i = 0; i < sides.size(); ++i) {
				for (std::size_t k = i + 1; k < sides.size(); ++k) {
					const float turned = at(sides[i]) == at(sides[k]) ? 2 : 0;
					best               = std::min(
									  best, {dot(inwardFrom(sides[i]), inwardFrom(sides[k])) + turned, i, k});
				}
			}
			const auto [bend, i, k] = best;
			linkOf(sides[i])        = sides[k];
			linkOf(sides[k])        = sides[i];
			sides.erase(sides.begin() + std::ptrdiff_t(k));
			sides.erase(sides.begin() + std::ptrdiff_t(i));
		}
	}

	double areaOf(int f) const
	{
		const Vec3f a = position_[std::size_t(at(3 * f))];
		return double(length(cross(position_[std::size_t(at(3 * f + 1))] - a,
								   position_[std::size_t(at(3 * f + 2))] - a)));
	}

	void orient()
	{
		std::map<int, bool> turned;
		for (int seed = 0; 3 * seed < int(corner_.size()); ++seed) {
			if (turned.count(seed) > 0) continue;
			double           area[2] = {0, 0};
			std::vector<int> component{seed};
			turned[seed] = false;
			for (std::size_t i = 0; i < component.size(); ++i) {
				const int f = component[i];
				area[turned[f]] += areaOf(f);
				for (int h = 3 * f; h < 3 * f + 3; ++h) {
					const int g = linkOf(h);
					if (g < 0) continue;
					const bool wanted = turned[f] != (at(g) == at(h));
					if (turned.emplace(g / 3, wanted).second)
						component.push_back(g / 3);
					else if (turned[g / 3] != wanted)
						linkOf(h) = linkOf(g) = -1;
				}
			}
			for (int f : component)
				turned[f] = turned[f] != (area[1] > area[0]);
		}
		for (const auto& [f, isTurned] : turned) {
			if (!isTurned) continue;
			std::swap(corner_[std::size_t(3 * f + 1)], corner_[std::size_t(3 * f + 2)]);
			std::swap(linkOf(3 * f), linkOf(3 * f + 2));
			for (int h : {3 * f, 3 * f + 2}) {
				if (linkOf(h) >= 0) linkOf(linkOf(h)) = h;
			}
		}
	}

	void separateFans()
	{
		std::vector<int> fan(corner_.size()); // for each corner: the first corner of its fan
		std::iota(fan.begin(), fan.end(), 0);
		const auto firstOf = [&](int c) {
			while (fan[std::size_t(c)] != c)
				c = fan[std::size_t(c)];
			return c;
		};
		const auto join = [&](int c, int d) {
			const auto [low, high] = std::minmax({firstOf(c), firstOf(d)});
			fan[std::size_t(high)] = low;
		};
		for (int h = 0; h < int(link_.size()); ++h) {
			if (linkOf(h) < 0) continue;
			join(h, nextInFace(linkOf(h)));
			join(nextInFace(h), linkOf(h));
		}
		std::set<int>    taken, split;
		std::vector<int> named = corner_;
		for (int c = 0; c < int(corner_.size()); ++c) {
			if (firstOf(c) == c && !taken.insert(at(c)).second) {
				named[std::size_t(c)] = int(position_.size());
				split.insert({at(c), int(position_.size())});
				position_.push_back(position_[std::size_t(at(c))]);
			}
			named[std::size_t(c)] = named[std::size_t(firstOf(c))];
		}
		corner_ = named;
		drawApart(split);
	}

	void drawApart(const std::set<int>& split)
	{
		std::map<int, std::vector<Vec3f>> ways;
		std::set<int>                     open;
		for (int h = 0; h < int(corner_.size()); ++h) {
			const int v = at(h);
			if (split.count(v) == 0) continue;
			ways[v].push_back(position_[std::size_t(at(nextInFace(h)))] -
							  position_[std::size_t(v)]);
			if (linkOf(h) < 0 || linkOf(prevInFace(h)) < 0) open.insert(v);
		}
		std::map<int, Vec3f> drawn;
		for (const auto& [v, round] : ways) {
			const Vec3f sum = std::accumulate(round.begin(), round.end(), Vec3f());
			if (open.count(v) > 0) continue;
			drawn[v] = position_[std::size_t(v)] + sum * (0.03125f / float(round.size()));
		}
		for (const auto& [v, place] : drawn)
			position_[std::size_t(v)] = place;
	}

	void openSlits()
	{
		std::set<int> slits;
		for (const auto& [ends, sides] : sidesByEdge()) {
			const auto joined =
				std::find_if(sides.begin(), sides.end(), [&](int h) { return linkOf(h) >= 0; });
			const int keeper = joined != sides.end() ? *joined : sides.front();
			for (int h : sides) {
				if (h != keeper && linkOf(h) != keeper) slits.insert(h);
			}
		}
		std::map<int, int> middle;
		const int          faceNum = int(corner_.size()) / 3;
		for (int f = 0; f < faceNum; ++f) {
			std::vector<int> outline;
			std::size_t      start = 0;
			for (int h = 3 * f; h < 3 * f + 3; ++h) {
				outline.push_back(at(h));
				if (slits.count(h) == 0) continue;
				if (start == 0) start = outline.size();
				if (linkOf(h) >= 0 && middle.count(linkOf(h)) > 0) {
					outline.push_back(middle[linkOf(h)]);
					continue;
				}
				outline.push_back(middle[h] = int(position_.size()));
				position_.push_back(
					(position_[std::size_t(at(h))] + position_[std::size_t(at(nextInFace(h)))]) *
					0.5f);
			}
			std::rotate(outline.begin(), outline.begin() + std::ptrdiff_t(start), outline.end());
			std::copy_n(outline.begin(), 3, corner_.begin() + std::ptrdiff_t(3 * f));
			for (std::size_t k = 2; k + 1 < outline.size(); ++k)
				corner_.insert(corner_.end(), {outline[0], outline[k], outline[k + 1]});
		}
	}
};

void expectAsPlainly(const Repaired& r)
{
	const TriangleMesh plain = PlainRepair(r.before).run();
	EXPECT_EQ(r.after.triangles, plain.triangles);
	EXPECT_TRUE(r.after.positions == plain.positions);
}

class RepairRandom : public ::testing::TestWithParam<std::uint32_t> {};

/// For any list of triangles: the result is manifold, lies at the place of the input, and only
/// duplicate faces are dropped.
TEST_P(RepairRandom, AnythingBecomesManifold)
{
	Random random(GetParam());
	SCOPED_TRACE("seed " + std::to_string(GetParam()));
	for (int round = 0; round < 10; ++round) {
		const TriangleMesh base = round % 2 == 0 ? icosphere(1 + round % 3) : grid(3 + round, 4);
		const TriangleMesh mesh = damaged(base, 1 + random.below(40), random);
		const Repaired     r(mesh, 1 + round % 3);
		expectManifold(r);
		expectAsPlainly(r);
		EXPECT_GE(r.after.faceNum() + std::size_t(r.counts.duplicateFaces), r.before.faceNum());
		if (r.counts.duplicateFaces == 0) {
			const Repaired inPlace(mesh, 1, true);
			EXPECT_EQ(inPlace.after.triangles, r.after.triangles);
			EXPECT_NEAR(factsOf(inPlace.after).area, factsOf(r.before).area, 1e-4);
		}
	}
}

/// A handful of vertices and random faces: all faults at once.
TEST_P(RepairRandom, CrowdsOfFacesOverFewVerticesBecomeManifold)
{
	Random random(GetParam());
	SCOPED_TRACE("seed " + std::to_string(GetParam()));
	for (int round = 0; round < 30; ++round) {
		TriangleMesh mesh;
		const int    n = 4 + random.below(6);
		for (int v = 0; v < n; ++v)
			mesh.positions.push_back(
				{double(random.below(4)), double(random.below(4)), random.unit()});
		for (int f = 2 + random.below(25); f > 0; --f) {
			const int a = random.below(n), b = random.below(n), c = random.below(n);
			if (a != b && b != c && c != a) mesh.triangles.insert(mesh.triangles.end(), {a, b, c});
		}
		if (mesh.faceNum() == 0) continue;
		const Repaired r(mesh, 1 + round % 3);
		expectManifold(r);
		expectAsPlainly(r);
	}
}

INSTANTIATE_TEST_SUITE_P(Seeds, RepairRandom, ::testing::ValuesIn(testSeeds(10)));

} // namespace

} // namespace gpr::test
