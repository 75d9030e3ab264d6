// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Contacts of a result that the input has, too.

#include <tests/support/mesh_builders.h>
#include <tests/support/stages.h>
#include <tests/support/transforms.h>
#include <vcg_extras/core/guard/input_contacts.h>

#include <algorithm>
#include <gtest/gtest.h>

namespace gpr::test {

namespace {

/// Two spheres round (x, 0, 0), `apart` from each other.
TriangleMesh spheres(int level, double x, double apart)
{
	return joined(shifted(icosphere(level), {x - apart / 2, 0.01, 0.02}),
				  shifted(icosphere(level), {x + apart / 2, 0, 0}));
}

} // namespace

TEST(InputContacts, AreOnlyThoseNearby)
{
	Workers            workers(2, nullptr);
	const HalfEdgeMesh input  = halfEdgesOf(joined(spheres(4, 0, 1.5), spheres(4, 10, 3)));
	const HalfEdgeMesh result = halfEdgesOf(joined(spheres(2, 0, 1.5), spheres(2, 10, 1.5)));
	const std::vector<FacePair> pairs = findTouchingPairs(result, workers);
	const InputContacts         contacts(input, result, pairs, 0.1f, workers);
	EXPECT_EQ(contacts.faceNum(), std::int64_t(findTouchingFaces(input, workers).size()));
	const std::vector<FacePair> others = contacts.withoutInputs(result, pairs);
	ASSERT_FALSE(others.empty());
	EXPECT_LT(others.size(), pairs.size());
	for (const FacePair& pair : pairs) {
		const bool isFar   = result.faceCentre(pair.first).x > 5;
		const bool isOther = std::find(others.begin(), others.end(), pair) != others.end();
		EXPECT_EQ(isOther, isFar);
	}
}

namespace {

/// Two spheres that intersect each other in the result only.
struct OnlyInResult {
	Workers                     workers{2, nullptr};
	const HalfEdgeMesh          input  = halfEdgesOf(spheres(4, 0, 3));
	const HalfEdgeMesh          result = halfEdgesOf(spheres(2, 0, 1.5));
	const std::vector<FacePair> pairs  = findTouchingPairs(result, workers);
	const InputContacts         contacts{input, result, pairs, 0.1f, workers};
};

} // namespace

TEST(InputContacts, AreNoneWhereOnlyTheResultIntersectsItself)
{
	const OnlyInResult is;
	ASSERT_FALSE(is.pairs.empty());
	EXPECT_EQ(is.contacts.faceNum(), 0);
	EXPECT_EQ(is.contacts.withoutInputs(is.result, is.pairs), is.pairs);
}

/// Contacts of the input elsewhere are not looked for.
TEST(InputContacts, FarFromThePairsAreNotCounted)
{
	Workers                     workers(2, nullptr);
	const HalfEdgeMesh          input  = halfEdgesOf(joined(spheres(3, 0, 3), spheres(3, 20, 1.5)));
	const HalfEdgeMesh          result = halfEdgesOf(spheres(2, 0, 1.5));
	const std::vector<FacePair> pairs  = findTouchingPairs(result, workers);
	EXPECT_EQ(InputContacts(input, result, pairs, 0.1f, workers).faceNum(), 0);
}

/// Two triangles that cut each other, a unit long from x on.
static TriangleMesh crossing(double x)
{
	return {{{x, 0, 0},
			 {x + 1, -0.5, 0},
			 {x + 1, 0.5, 0},
			 {x, 0, 0.1},
			 {x + 1, 0, -0.5},
			 {x + 1, 0, 0.5}},
			{0, 1, 2, 3, 4, 5}};
}

TEST(InputContacts, CountUpToADistanceFromThePairs)
{
	Workers            workers(1, nullptr);
	const HalfEdgeMesh input = halfEdgesOf(crossing(0)), result = halfEdgesOf(crossing(1.05));
	const std::vector<FacePair> pairs = findTouchingPairs(result, workers);
	ASSERT_EQ(pairs.size(), 1u);
	for (const float distance : {0.04f, 0.1f}) {
		const InputContacts contacts(input, result, pairs, distance, workers);
		const bool          isNear = distance > 0.05f;
		EXPECT_EQ(contacts.faceNum(), isNear ? 2 : 0);
		EXPECT_EQ(contacts.withoutInputs(result, pairs).empty(), isNear);
	}
}

TEST(InputContacts, OthersAreThoseOfTheWantedFaces)
{
	OnlyInResult is;
	ASSERT_GT(is.pairs.size(), 1u);
	const FacePair&       one = is.pairs.front();
	std::vector<char>     wanted(std::size_t(is.result.faceNum), 0);
	std::vector<FacePair> expected;
	wanted[std::size_t(one.second)] = 1;
	for (const FacePair& pair : is.pairs) {
		if (pair.first == one.second || pair.second == one.second) expected.push_back(pair);
	}
	ASSERT_LT(expected.size(), is.pairs.size());
	EXPECT_EQ(is.contacts.othersIn(is.result, wanted, is.workers), expected);
}

/// Along cuts of the input, both sides have separate vertices at the same places.
TEST(InputContacts, AreFoundAlongCuts)
{
	Workers            workers(1, nullptr);
	const TriangleMesh sheet = grid(1, 1);
	const HalfEdgeMesh whole = halfEdgesOf(sheet), cut = halfEdgesOf(cutApart(sheet, {0, 1}));
	const HalfEdgeMesh result         = halfEdgesOf(crossing(0));
	const std::vector<FacePair> pairs = findTouchingPairs(result, workers);
	EXPECT_EQ(InputContacts(whole, result, pairs, 0.1f, workers).faceNum(), 0);
	EXPECT_EQ(InputContacts(cut, result, pairs, 0.1f, workers).faceNum(), 2);
}

} // namespace gpr::test
