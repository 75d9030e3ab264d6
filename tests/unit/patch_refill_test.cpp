// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The input's triangles in the place of patches of a result: the mesh is whole again, and nothing
// else has changed.

#include <tests/support/mesh_audit.h>
#include <tests/support/mesh_builders.h>
#include <tests/support/random_source.h>
#include <tests/support/stages.h>
#include <tests/support/transforms.h>
#include <vcg_extras/core/guard/face_sets.h>
#include <vcg_extras/core/guard/patch_input.h>
#include <vcg_extras/core/guard/patch_refill.h>
#include <vcg_extras/core/mesh/measure.h>
#include <vcg_extras/core/retriangulation/vertex_removal.h>
#include <vcg_extras/core/surface/nearest_samples.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <numeric>
#include <set>

namespace gpr::test {

namespace {

/// At a share of the height.
float heightAt(const HalfEdgeMesh& m, float share)
{
	float low = HUGE_VALF, high = -HUGE_VALF;
	for (int v = 0; v < m.vertexNum; ++v) {
		low  = std::min(low, m.position[v].z);
		high = std::max(high, m.position[v].z);
	}
	return low + share * (high - low);
}

/// A surface and a coarser mesh of the surface.
class CoarseResult {
public:
	/// No vertex lies in the uppermost part of the height, `bare`.
	CoarseResult(const TriangleMesh& mesh, float spacing, Random& random, float bare = 0) :
			surface_(surfaceOf(mesh, workers))
	{
		Sampling    sampling;
		const float top = heightAt(surface_.mesh, 1 - bare);
		sampling.radius = spacing;
		for (int v : spacedVertices(spacing, random)) {
			if (surface_.mesh.position[v].z > top) continue;
			const int face = surface_.mesh.outgoing[v] / 3;
			sampling.samples.push_back(
				{{surface_.mesh.position[v], face}, surface_.mesh.faceNormal(face), 1});
		}
		sampling.nearest  = assignToSamples(surface_, sampling.samples, workers);
		result_           = removeVertices(surface_, sampling, BoundaryCurves(),
										   figuresOf(surface_.mesh, 1, workers), workers);
		result_.idealEdge = 1.2f * spacing;
	}

	Workers           workers{2, nullptr};
	const Surface&    surface() const { return surface_; }
	const ResultMesh& result() const { return result_; }

	bool refill(std::vector<char>& marked, RefilledMesh& refilled,
				const std::vector<int>& kept = {})
	{
		return refillPatches(surface_, result_, kept, marked, workers, refilled);
	}

	/// A mark on the faces round some vertices, and on further rings of faces.
	std::vector<char> marksRound(const std::vector<int>& vertices, int rings = 0) const
	{
		std::vector<char> marked(std::size_t(result_.mesh.faceNum), 0);
		for (int f : widened(result_.mesh, facesRound(result_.mesh, vertices), rings))
			marked[std::size_t(f)] = 1;
		return marked;
	}

private:
	Surface    surface_;
	ResultMesh result_;

	/// Vertices at least `spacing` apart.
	std::vector<int> spacedVertices(float spacing, Random& random) const
	{
		std::vector<int> order(std::size_t(surface_.mesh.vertexNum)), chosen;
		std::iota(order.begin(), order.end(), 0);
		random.shuffle(order);
		for (int v : order) {
			const Vec3f p = surface_.mesh.position[v];
			if (std::all_of(chosen.begin(), chosen.end(), [&](int w) {
					return length(surface_.mesh.position[w] - p) >= spacing;
				}))
				chosen.push_back(v);
		}
		return chosen;
	}
};

using Places = std::array<std::array<float, 3>, 3>;

Places placesOf(const HalfEdgeMesh& m, int f)
{
	Places places;
	for (int k = 0; k < 3; ++k) {
		const Vec3f p          = m.position[m.origin[3 * f + k]];
		places[std::size_t(k)] = {p.x, p.y, p.z};
	}
	std::rotate(places.begin(), std::min_element(places.begin(), places.end()), places.end());
	return places;
}

/// Whether every face without a mark is still there.
void expectRestIsThere(const ResultMesh& result, const std::vector<char>& marked,
					   const HalfEdgeMesh& m)
{
	std::set<Places> there;
	for (int f = 0; f < m.faceNum; ++f)
		there.insert(placesOf(m, f));
	for (int f = 0; f < result.mesh.faceNum; ++f) {
		if (marked[std::size_t(f)]) continue;
		EXPECT_EQ(there.count(placesOf(result.mesh, f)), 1u);
	}
}

void expectWhole(CoarseResult& coarse, const std::vector<char>& marked, const RefilledMesh& made)
{
	const HalfEdgeMesh& m = made.guarded->mesh;
	EXPECT_TRUE(isSoundTable(m));
	EXPECT_TRUE(factsOf(meshOf(m)).isManifold()) << factsOf(meshOf(m)).complaints();
	EXPECT_TRUE(hasSameTopology(meshOf(m), meshOf(coarse.surface().mesh)));
	expectRestIsThere(coarse.result(), marked, m);
	for (int v = 0; v < m.vertexNum; ++v) {
		const bool isOld = made.resultVertex[std::size_t(v)] >= 0;
		EXPECT_EQ(made.guarded->vertex[std::size_t(v)].isFixed, isOld);
		EXPECT_EQ(made.inputVertex[std::size_t(v)] >= 0, !isOld);
	}
}

/// A vertex whose neighbours are inside, too.
int vertexInside(const HalfEdgeMesh& m)
{
	for (int v = 0; v < m.vertexNum; ++v) {
		bool isInside = !m.isBorderVertex(v);
		forEachNeighbour(m, v, [&](int w) { isInside = isInside && !m.isBorderVertex(w); });
		if (isInside) return v;
	}
	return -1;
}

int borderVertex(const HalfEdgeMesh& m)
{
	int v = 0;
	while (!m.isBorderVertex(v))
		++v;
	return v;
}

/// A sphere with a thin tube upright on its pole, which takes six tenths of the height.
TriangleMesh sphereWithTube()
{
	constexpr double width = 0.2, radius = 0.03;
	TriangleMesh     mesh = icosphere(6);
	for (Vec3d& p : mesh.positions) {
		const double away = std::hypot(p.x, p.y);
		if (p.z > 0 && away < width)
			p = {p.x / width * radius, p.y / width * radius, 4 - 3 * away / width};
	}
	return mesh;
}

struct Shape {
	const char*  name;
	TriangleMesh mesh;
	float        spacing;
};

std::vector<Shape> shapes(Random& random)
{
	return {{"sphere", icosphere(5), 0.2f},
			{"rough sphere", noisySphere(5, 0.002, random), 0.2f},
			{"torus", torus(160, 60), 0.2f},
			{"sheet", jitteredGrid(60, 0.2, random), 0.1f},
			{"tube", openCylinder(60, 120, 0.3, 2), 0.12f},
			{"two spheres", joined(icosphere(4), shifted(icosphere(4), {3, 0, 0})), 0.25f}};
}

} // namespace

TEST(PatchRefill, LeavesTheRestAndTheTopology)
{
	for (const std::uint32_t seed : {1u, 2u, 3u}) {
		Random random(seed);
		for (const Shape& shape : shapes(random)) {
			SCOPED_TRACE(shape.name);
			CoarseResult      coarse(shape.mesh, shape.spacing, random);
			std::vector<int>  centres = {random.below(coarse.result().mesh.vertexNum),
										 random.below(coarse.result().mesh.vertexNum)};
			std::vector<char> marked  = coarse.marksRound(centres, 1);
			RefilledMesh      made;
			ASSERT_TRUE(coarse.refill(marked, made));
			expectWhole(coarse, marked, made);
			const std::size_t newNum =
				std::size_t(std::count(made.resultVertex.begin(), made.resultVertex.end(), -1));
			EXPECT_GT(newNum, 20u);
		}
	}
}

/// The edges of an input no finer than the result are split.
TEST(PatchRefill, SplitsAnInputThatIsCoarse)
{
	Random            random(4);
	CoarseResult      coarse(icosphere(3), 0.1f, random);
	std::vector<char> marked = coarse.marksRound({0, coarse.result().mesh.vertexNum / 2});
	RefilledMesh      made;
	ASSERT_TRUE(coarse.refill(marked, made));
	expectWhole(coarse, marked, made);
	EXPECT_GT(made.guarded->mesh.vertexNum, coarse.result().mesh.vertexNum + 5);
}

TEST(PatchRefill, FixesTheVerticesToBeKept)
{
	Random            random(5);
	CoarseResult      coarse(icosphere(5), 0.2f, random);
	const int         centre = 7;
	std::vector<char> marked = coarse.marksRound({centre});
	const int         face   = coarse.result().vertex[centre].point.face;
	const int         kept   = coarse.surface().mesh.origin[3 * face];
	RefilledMesh      made;
	ASSERT_TRUE(coarse.refill(marked, made, {kept}));
	int fixedNum = 0;
	for (std::size_t v = 0; v < made.resultVertex.size(); ++v) {
		if (made.resultVertex[v] >= 0 || !made.guarded->vertex[v].isFixed) continue;
		++fixedNum;
		EXPECT_EQ(made.inputVertex[v], kept);
	}
	EXPECT_EQ(fixedNum, 1);
}

TEST(PatchRefill, IsRefusedWhereOtherBordersHaveTheirVertices)
{
	Random       random(6);
	CoarseResult coarse(jitteredGrid(40, 0.2, random), 0.1f, random);
	ResultMesh   result                         = copyResult(coarse.result(), coarse.workers);
	const int    border                         = borderVertex(result.mesh);
	result.vertex[std::size_t(border)].isShared = true;
	std::vector<char> marked                    = coarse.marksRound({border});
	RefilledMesh      made;
	EXPECT_FALSE(refillPatches(coarse.surface(), result, {}, marked, coarse.workers, made));
}

/// The areas of vertices come from the input: their sum is the area of the input.
TEST(PatchRefill, VerticesHaveAssignedPointsOfTheInput)
{
	Random            random(7);
	CoarseResult      coarse(icosphere(5), 0.2f, random);
	std::vector<char> marked(std::size_t(coarse.result().mesh.faceNum), 1);
	RefilledMesh      made;
	ASSERT_TRUE(coarse.refill(marked, made));
	double area = 0, wanted = 0;
	for (const GuardedVertex& v : made.guarded->vertex)
		area += double(v.area);
	for (int f = 0; f < coarse.surface().mesh.faceNum; ++f)
		wanted += double(length(coarse.surface().mesh.faceCross(f))) / 2;
	EXPECT_NEAR(area, wanted, 1e-4 * wanted);
}

/// Three vertices round a patch may lie in a line and get a triangle of the input: its corners
/// stay, so the triangle would stay degenerate.
TEST(PatchRefill, WidensAPatchWithATriangleInALine)
{
	Random        random(8);
	CoarseResult  coarse(jitteredGrid(60, 0.2, random), 0.1f, random);
	ResultMesh    result = copyResult(coarse.result(), coarse.workers);
	const int     h      = result.mesh.outgoing[vertexInside(result.mesh)];
	const int     v      = result.mesh.origin[h];
	HalfEdgeMesh& m      = result.mesh;
	m.position[v]        = (m.position[m.target(h)] + m.position[m.apex(h)]) * 0.5f;
	std::vector<char> marked(std::size_t(m.faceNum), 0);
	marked[std::size_t(h / 3)] = 1;
	RefilledMesh made;
	ASSERT_TRUE(refillPatches(coarse.surface(), result, {}, marked, coarse.workers, made));
	EXPECT_GT(std::count(marked.begin(), marked.end(), 1), 1);
	const HalfEdgeMesh& filled = made.guarded->mesh;
	for (int f = 0; f < filled.faceNum; ++f)
		EXPECT_FALSE(squaredLength(filled.faceCross(f)) < 1e-12f) << f;
}

/// The input can reach far beyond a coarse result: the patch follows the input, and stays small.
TEST(PatchRefill, FollowsTheInputInside)
{
	for (const std::uint32_t seed : {1u, 2u, 3u}) {
		Random              random(seed);
		CoarseResult        coarse(sphereWithTube(), 0.05f, random, 0.62f);
		const HalfEdgeMesh& result = coarse.result().mesh;
		const float         top    = heightAt(result, 0.95f);
		std::vector<int>    upper;
		for (int v = 0; v < result.vertexNum; ++v) {
			if (result.position[v].z > top) upper.push_back(v);
		}
		std::vector<char> marked = coarse.marksRound(upper, 1);
		RefilledMesh      made;
		ASSERT_TRUE(coarse.refill(marked, made));
		expectWhole(coarse, marked, made);
		EXPECT_NEAR(heightAt(made.guarded->mesh, 1), heightAt(coarse.surface().mesh, 1), 1e-5f);
		EXPECT_LT(double(std::count(marked.begin(), marked.end(), 1)), 0.7 * result.faceNum);
	}
}

/// A tube on the border of a patch would be drawn together to a single vertex.
TEST(PatchRefill, WidensAPatchWhereTheInputReachesFarFromItsBorder)
{
	Random              random(1);
	CoarseResult        coarse(sphereWithTube(), 0.05f, random, 0.62f);
	const HalfEdgeMesh& result = coarse.result().mesh;
	int                 top    = 0;
	for (int v = 0; v < result.vertexNum; ++v) {
		if (result.position[v].z > result.position[top].z) top = v;
	}
	std::vector<char> marked = coarse.marksRound({result.target(result.outgoing[top])});
	RefilledMesh      made;
	ASSERT_TRUE(coarse.refill(marked, made));
	expectWhole(coarse, marked, made);
	EXPECT_NEAR(heightAt(made.guarded->mesh, 1), heightAt(coarse.surface().mesh, 1), 1e-5f);
}

/// A result with a hole that the input does not have.
TEST(PatchRefill, ClosesNoHole)
{
	Random       random(9);
	CoarseResult coarse(icosphere(4), 0.3f, random);
	ResultMesh   result  = copyResult(coarse.result(), coarse.workers);
	TriangleMesh pierced = meshOf(result.mesh);
	ASSERT_EQ(int(pierced.vertexNum()), result.mesh.vertexNum);
	pierced.triangles.resize(pierced.triangles.size() - 3);
	std::vector<char> marked(pierced.faceNum(), 1);
	result.mesh = halfEdgesOf(pierced);
	RefilledMesh made;
	EXPECT_FALSE(refillPatches(coarse.surface(), result, {}, marked, coarse.workers, made));
}

namespace {

/// A vertex and the rings round the vertex: three rings inside, then the border, then two beyond.
std::vector<PatchRole> rolesRound(const HalfEdgeMesh& m, int centre)
{
	constexpr PatchRole    ofRing[] = {PatchRole::Inside, PatchRole::Inside, PatchRole::Inside,
									   PatchRole::Border, PatchRole::Near,   PatchRole::Near};
	std::vector<PatchRole> role(std::size_t(m.vertexNum), PatchRole::Far);
	std::vector<int>       front = {centre};
	for (PatchRole here : ofRing) {
		std::vector<int> next;
		for (int v : front)
			role[std::size_t(v)] = here;
		for (int v : front)
			forEachNeighbour(m, v, [&](int w) {
				if (role[std::size_t(w)] == PatchRole::Far) next.push_back(w);
			});
		front = std::move(next);
	}
	return role;
}

} // namespace

TEST(PatchInput, IsOnlyWhatLiesNearThePatch)
{
	Random                       random(10);
	CoarseResult                 coarse(icosphere(5), 0.06f, random);
	const std::vector<PatchRole> role = rolesRound(coarse.result().mesh, 5);
	const PatchInput             local =
		collectPatchInput(coarse.surface(), coarse.result(), role, 1, coarse.workers);
	EXPECT_LE(local.share, 1);
	EXPECT_GT(local.ownNum, 100);
	EXPECT_LT(local.ownNum, coarse.surface().mesh.vertexNum / 2);
}

TEST(PatchInput, HasShortEdges)
{
	Random                       random(11);
	CoarseResult                 coarse(icosphere(3), 0.02f, random);
	const ResultMesh&            result = coarse.result();
	const std::vector<PatchRole> role   = rolesRound(result.mesh, 5);
	const PatchInput local = collectPatchInput(coarse.surface(), result, role, 1, coarse.workers);
	const std::vector<char> isDeep   = deepVertices(result.mesh, role);
	const auto              isInside = [&](int v) {
        return isDeep[std::size_t(local.byEdges[std::size_t(v)])] != 0;
	};
	const auto longest = [&](int v) {
		return longestEdgeAt(result.mesh, local.byEdges[std::size_t(v)]);
	};
	int num = 0;
	for (int h = 0; h < local.mesh.halfEdgeNum(); ++h) {
		const int a = local.mesh.origin[h], b = local.mesh.target(h);
		if (!isInside(a) || !isInside(b)) continue;
		++num;
		EXPECT_LE(length(local.mesh.position[a] - local.mesh.position[b]),
				  0.6f * std::max(longest(a), longest(b)));
	}
	EXPECT_GT(num, 10);
}

/// A patch that grows finds the labels that a collection round the grown patch has.
TEST(PatchInput, HasTheLabelsOfAGrownPatch)
{
	Random                       random(13);
	CoarseResult                 coarse(icosphere(5), 0.06f, random);
	const HalfEdgeMesh&          m     = coarse.result().mesh;
	const std::vector<PatchRole> role  = rolesRound(m, 5);
	std::vector<PatchRole>       grown = role;
	for (int v = 0; v < m.vertexNum; ++v) {
		if (role[std::size_t(v)] != PatchRole::Border) continue;
		grown[std::size_t(v)] = PatchRole::Inside;
		forEachNeighbour(m, v, [&](int w) {
			if (role[std::size_t(w)] == PatchRole::Near) grown[std::size_t(w)] = PatchRole::Border;
		});
	}
	const auto labelsOf = [&](const std::vector<PatchRole>& collected) {
		const PatchInput local =
			collectPatchInput(coarse.surface(), coarse.result(), collected, 1, coarse.workers);
		const std::vector<int> label = local.labels(m, grown);
		std::map<int, int>     ofInput;
		for (int v = 0; v < local.ownNum; ++v) {
			if (grown[std::size_t(label[std::size_t(v)])] != PatchRole::Near)
				ofInput[local.inputVertex[std::size_t(v)]] = label[std::size_t(v)];
		}
		return ofInput;
	};
	EXPECT_GT(labelsOf(grown).size(), 20u);
	EXPECT_EQ(labelsOf(role), labelsOf(grown));
}

TEST(PatchInput, KnowsTheInputsBorderFromWhereItWasCut)
{
	Random                       random(12);
	CoarseResult                 coarse(jitteredGrid(60, 0.2, random), 0.04f, random);
	const HalfEdgeMesh&          input = coarse.surface().mesh;
	const std::vector<PatchRole> role =
		rolesRound(coarse.result().mesh, borderVertex(coarse.result().mesh));
	const PatchInput local =
		collectPatchInput(coarse.surface(), coarse.result(), role, 1, coarse.workers);
	int cutNum = 0, borderNum = 0;
	for (int h = 0; h < local.mesh.halfEdgeNum(); ++h) {
		const auto isOnBorder = [&](int v) {
			return input.isBorderVertex(local.inputVertex[std::size_t(v)]);
		};
		const bool isMarked = local.mesh.crease[h] != 0;
		EXPECT_TRUE(!isMarked || local.mesh.isBorderEdge(h));
		EXPECT_TRUE(!isMarked ||
					(isOnBorder(local.mesh.origin[h]) && isOnBorder(local.mesh.target(h))));
		borderNum += isMarked;
		cutNum += local.mesh.isBorderEdge(h) && !isMarked;
	}
	EXPECT_GT(cutNum, 10);
	EXPECT_GT(borderNum, 5);
}

TEST(FaceSets, GrowByRings)
{
	const HalfEdgeMesh     m    = halfEdgesOf(lattice(20, 20));
	const std::vector<int> face = {m.faceNum / 2 + 10};
	EXPECT_EQ(widened(m, face, 0), face);
	EXPECT_EQ(widened(m, face, 1).size(), 13u);
	EXPECT_EQ(widened(m, face, 2).size(), 37u);
}

namespace {

/// Labels on a square grid: 0 (inside) left of the middle; right of the middle the border's cells
/// 1, 2, 3 from below.
struct LabelledGrid {
	static constexpr int n = 24;

	HalfEdgeMesh           mesh = halfEdgesOf(grid(n, n));
	std::vector<PatchRole> role = {PatchRole::Inside, PatchRole::Border, PatchRole::Border,
								   PatchRole::Border};
	std::vector<int>       label;
	Workers                workers{1, nullptr};

	LabelledGrid()
	{
		for (int v = 0; v < mesh.vertexNum; ++v) {
			const Vec3f p = mesh.position[v];
			label.push_back(p.x < 0.5f ? 0 : 1 + std::min(2, int(3 * p.y)));
		}
	}

	int near(float x, float y) const
	{
		int best = 0;
		for (int v = 1; v < mesh.vertexNum; ++v) {
			const Vec3f p(x, y, 0);
			if (length(mesh.position[v] - p) < length(mesh.position[best] - p)) best = v;
		}
		return best;
	}
	void put(float x, float y, int wanted) { label[std::size_t(near(x, y))] = wanted; }

	void expectCleanedTo(const std::vector<int>& wanted)
	{
		cleanLabels(mesh, role, label, workers);
		for (int v = 0; v < mesh.vertexNum; ++v)
			EXPECT_EQ(label[std::size_t(v)], wanted[std::size_t(v)])
				<< v % (n + 1) << ", " << v / (n + 1);
	}
};

} // namespace

TEST(PatchLabels, AreLeftWhereCellsAreWhole)
{
	LabelledGrid           g;
	const std::vector<int> before = g.label;
	g.expectCleanedTo(before);
}

TEST(PatchLabels, PiecesOfACellGoToWhatIsRoundThem)
{
	LabelledGrid           g;
	const std::vector<int> before = g.label;
	g.put(0.2f, 0.5f, 2); // inside
	g.put(0.8f, 0.9f, 1); // in another cell
	g.put(0.9f, 0.1f, 3); // the same, and its first vertex is the cell's first
	g.expectCleanedTo(before);
}

TEST(PatchLabels, WhatIsEnclosedByOneCellGoesToIt)
{
	LabelledGrid           g;
	const std::vector<int> before = g.label;
	g.put(0.75f, 0.5f, 0);
	g.put(0.8f, 0.5f, 0);
	g.expectCleanedTo(before);
}

namespace {

/// Cell 2 has an arm round two inner vertices; the lower vertex meets the cell on two sides.
struct Pocket : LabelledGrid {
	const int upper = near(11.0f / n, 12.0f / n), lower = near(11.0f / n, 11.0f / n);

	Pocket()
	{
		for (int j : {11, 12, 13})
			put(10.0f / n, float(j) / n, 2);
		put(11.0f / n, 13.0f / n, 2);
	}
};

} // namespace

TEST(PatchLabels, NotchesAreFilled)
{
	Pocket           g;
	std::vector<int> filled      = g.label;
	filled[std::size_t(g.upper)] = 2;
	filled[std::size_t(g.lower)] = 2;
	g.expectCleanedTo(filled);
}

/// Vertices beyond the border are joined to the cells, from both ends of the gap.
TEST(PatchLabels, GapsBetweenCellsAreClosed)
{
	LabelledGrid           g;
	const std::vector<int> before = g.label;
	g.role.push_back(PatchRole::Near);
	for (float y : {0.5f, 0.55f})
		g.put(0.51f, y, 4);
	ASSERT_NE(g.label, before);
	g.expectCleanedTo(before);
}

/// Inner vertices beside three cells are not enclosed by a cell.
TEST(PatchLabels, WhatMeetsThreeCellsStays)
{
	LabelledGrid g;
	for (int v = 0; v < g.mesh.vertexNum; ++v) {
		if (g.mesh.position[v].x > 0.8f) g.label[std::size_t(v)] = 3;
	}
	g.put(0.79f, 0.33f, 0);
	const std::vector<int> before = g.label;
	g.expectCleanedTo(before);
}

/// A ring round a tube has no inside: joining its two ends would close the tube.
TEST(PatchLabels, ATubeBetweenTwoCellsStays)
{
	const HalfEdgeMesh           tube = halfEdgesOf(openCylinder(12, 30, 0.1, 3));
	const std::vector<PatchRole> role = {PatchRole::Inside, PatchRole::Border, PatchRole::Border};
	std::vector<int>             label;
	for (int v = 0; v < tube.vertexNum; ++v) {
		const float z = tube.position[v].z;
		label.push_back(z < 1 ? 1 : z > 2 ? 2 : 0);
	}
	const std::vector<int> before = label;
	Workers                workers(1, nullptr);
	cleanLabels(tube, role, label, workers);
	EXPECT_EQ(label, before);
}

} // namespace gpr::test
