// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A good result with one random fault of each kind: the audit finds each fault.

#include <tests/support/mesh_builders.h>
#include <tests/support/stages.h>
#include <vcg_extras/core/mesh/measure.h>
#include <vcg_extras/core/output/audit.h>

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace gpr::test {

namespace {

/// Makes a fault in the mesh; false if nothing has changed.
struct Mutation {
	const char* name;
	bool (*apply)(HalfEdgeMesh& m, Random& random);
};

std::ostream& operator<<(std::ostream& out, const Mutation& mutation)
{
	return out << mutation.name;
}

bool put(int& place, int value)
{
	const bool isNew = place != value;
	place            = value;
	return isNew;
}

int anyHalfEdge(const HalfEdgeMesh& m, Random& random)
{
	return random.below(m.halfEdgeNum());
}

int anyVertex(const HalfEdgeMesh& m, Random& random)
{
	return random.below(m.vertexNum);
}

bool turnFaceOver(HalfEdgeMesh& m, Random& random)
{
	const int f = random.below(m.faceNum);
	std::swap(m.origin[3 * f], m.origin[3 * f + 1]);
	return true;
}

bool copyFace(HalfEdgeMesh& m, Random& random)
{
	const int f = random.below(m.faceNum), g = random.below(m.faceNum);
	for (int k = 0; k < 3; ++k)
		m.origin[3 * f + k] = m.origin[3 * g + k];
	return f != g;
}

/// Removes the link of both halves of an edge: a slit that the figures of the mesh do not show.
bool cutEdge(HalfEdgeMesh& m, Random& random)
{
	const int h = anyHalfEdge(m, random), g = m.opposite[h];
	if (g < 0) return false;
	m.opposite[h] = m.opposite[g] = -1;
	return true;
}

bool swapOpposites(HalfEdgeMesh& m, Random& random)
{
	const int h = anyHalfEdge(m, random), g = anyHalfEdge(m, random);
	std::swap(m.opposite[h], m.opposite[g]);
	return m.opposite[h] != m.opposite[g];
}

/// A vertex takes over the faces of a vertex far away: two fans at one vertex.
bool mergeVertices(HalfEdgeMesh& m, Random& random)
{
	const int v = anyVertex(m, random), w = anyVertex(m, random);
	for (int h = 0; h < m.halfEdgeNum(); ++h) {
		if (m.origin[h] == v) m.origin[h] = w;
	}
	return v != w;
}

bool collapseCorner(HalfEdgeMesh& m, Random& random)
{
	const int h             = anyHalfEdge(m, random);
	m.position[m.origin[h]] = m.position[m.target(h)];
	return true;
}

template <int kind>
bool spoilPosition(HalfEdgeMesh& m, Random& random)
{
	const float  bad[] = {NAN, HUGE_VALF, -HUGE_VALF};
	float* const of[]  = {&m.position[anyVertex(m, random)].x, &m.position[anyVertex(m, random)].y,
						  &m.position[anyVertex(m, random)].z};
	*of[random.below(3)] = bad[kind];
	return true;
}

const Mutation mutations[] = {
	{"OriginRenamed",
	 [](HalfEdgeMesh& m, Random& r) { return put(m.origin[anyHalfEdge(m, r)], anyVertex(m, r)); }},
	{"OriginNegative",
	 [](HalfEdgeMesh& m, Random& r) { return put(m.origin[anyHalfEdge(m, r)], -1); }},
	{"OriginBeyondTheEnd",
	 [](HalfEdgeMesh& m, Random& r) {
		 return put(m.origin[anyHalfEdge(m, r)], std::numeric_limits<int>::max());
	 }},
	{"OppositeRenamed",
	 [](HalfEdgeMesh& m, Random& r) {
		 return put(m.opposite[anyHalfEdge(m, r)], anyHalfEdge(m, r));
	 }},
	{"OppositeForgotten",
	 [](HalfEdgeMesh& m, Random& r) { return put(m.opposite[anyHalfEdge(m, r)], -1); }},
	{"OppositeBeyondTheEnd",
	 [](HalfEdgeMesh& m, Random& r) {
		 return put(m.opposite[anyHalfEdge(m, r)], std::numeric_limits<int>::max());
	 }},
	{"OppositesSwapped", swapOpposites},
	{"EdgeCut", cutEdge},
	{"OutgoingOfAnother",
	 [](HalfEdgeMesh& m, Random& r) {
		 const int v = anyVertex(m, r), h = anyHalfEdge(m, r);
		 return m.origin[h] != v && put(m.outgoing[v], h);
	 }},
	{"OutgoingForgotten",
	 [](HalfEdgeMesh& m, Random& r) { return put(m.outgoing[anyVertex(m, r)], -1); }},
	{"OutgoingBeyondTheEnd",
	 [](HalfEdgeMesh& m, Random& r) {
		 return put(m.outgoing[anyVertex(m, r)], std::numeric_limits<int>::max());
	 }},
	{"FaceTurnedOver", turnFaceOver},
	{"FaceCopied", copyFace},
	{"VerticesMerged", mergeVertices},
	{"CornersAtOnePlace", collapseCorner},
	{"NotANumber", spoilPosition<0>},
	{"Infinite", spoilPosition<1>},
	{"MinusInfinite", spoilPosition<2>},
};

class AuditMutation : public ::testing::TestWithParam<Mutation> {};

/// The input figures are the good result's: only the audit's own look at the table can find the
/// fault.
TEST_P(AuditMutation, IsCaught)
{
	Workers workers(1, nullptr);
	Random  holes(7);
	int     caught = 0;
	for (const TriangleMesh& mesh :
		 {icosphere(2), torus(12, 8), withHoles(grid(12, 12), 2, holes), twoSheets(4, 0.2)}) {
		const Surface     surface = surfaceOf(mesh, workers);
		const MeshFigures good    = figuresOf(surface.mesh, 1, workers);
		for (std::uint32_t seed : testSeeds(60)) {
			Random     random(seed);
			ResultMesh result = resultOf(surface, {});
			if (!GetParam().apply(result.mesh, random)) continue;
			const AuditFigures a = audit(surface, result, good, good, 0, workers);
			EXPECT_FALSE(a.passed) << "seed " << seed;
			EXPECT_FALSE(describeFailure(a).empty());
			++caught;
		}
	}
	EXPECT_GT(caught, 60);
}

INSTANTIATE_TEST_SUITE_P(, AuditMutation, ::testing::ValuesIn(mutations),
						 [](const auto& test) { return std::string(test.param.name); });

} // namespace

} // namespace gpr::test
