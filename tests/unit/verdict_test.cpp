// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Which meshes are taken, and what is tried next where one is not.

#include <tests/support/random_source.h>
#include <vcg_extras/core/run/verdict.h>

#include <algorithm>
#include <gtest/gtest.h>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace gpr::test {

namespace {

using Kind = Verdict::Kind;

const Request order{true, false, 0};
const Request wish{true, true, 0};
const Request inexact{false, false, 0};

Outcome reached(std::int64_t vertexNum)
{
	return {vertexNum, false, false};
}

Outcome withoutAreas(std::int64_t vertexNum)
{
	return {vertexNum, false, true};
}

bool says(const Verdict& verdict, const std::string& part)
{
	return verdict.sentence.find(part) != std::string::npos;
}

Attempt byTopology(std::int64_t vertexNum)
{
	Attempt attempt = firstAttempt(vertexNum);
	attempt.way     = Way::ByTopology;
	return attempt;
}

/// The verdicts on the attempts that follow from each other, where outcomeOf tells what each comes
/// to; the last one accepts or refuses.
template <class OutcomeOf>
std::vector<Verdict> verdictsOn(const Request& request, std::int64_t vertexNum,
								const OutcomeOf& outcomeOf)
{
	constexpr std::size_t most    = 100;
	Attempt               attempt = firstAttempt(vertexNum);
	std::vector<Verdict>  verdicts;
	while (verdicts.size() < most) {
		verdicts.push_back(judge(request, attempt, outcomeOf(attempt)));
		if (verdicts.back().kind != Kind::TryNext) break;
		attempt = verdicts.back().next;
	}
	return verdicts;
}

} // namespace

TEST(Verdict, AcceptsTheCountWithoutAWord)
{
	for (const Request& request : {order, wish}) {
		const Verdict verdict = judge(request, firstAttempt(500), reached(500));
		EXPECT_EQ(verdict.kind, Kind::Accept);
		EXPECT_EQ(verdict.sentence, "");
	}
}

TEST(Verdict, AcceptsAnyCountWhereNoneIsPromised)
{
	EXPECT_EQ(judge(inexact, firstAttempt(500), reached(480)).kind, Kind::Accept);
	EXPECT_EQ(judge(inexact, firstAttempt(500), withoutAreas(480)).kind, Kind::Accept)
		<< "among many vertices another count changes nothing";
}

/// Nothing is promised of the count, but faces without area are withheld by the audit.
TEST(Verdict, LooksForAreasWhereNoCountIsPromised)
{
	const std::vector<Verdict> verdicts = verdictsOn(inexact, 8, [](const Attempt& a) {
		return a.vertexNum < 13 ? withoutAreas(a.vertexNum - 1) : reached(a.vertexNum - 1);
	});
	EXPECT_EQ(verdicts.back().kind, Kind::Accept);
	EXPECT_TRUE(says(verdicts.back(), "some triangles would have no area"));
}

TEST(Verdict, GivesUpFeatureLinesThatDoHarm)
{
	for (const Outcome& outcome : {Outcome{501, true, false}, Outcome{500, true, true}}) {
		const Verdict verdict = judge(order, firstAttempt(500), outcome);
		ASSERT_EQ(verdict.kind, Kind::TryNext);
		EXPECT_EQ(verdict.next.way, Way::WithoutFeatureLines);
		EXPECT_EQ(verdict.next.vertexNum, 500);
		EXPECT_TRUE(says(verdict, "feature lines")) << verdict.sentence;
	}
	EXPECT_EQ(judge(order, firstAttempt(500), {500, true, false}).kind, Kind::Accept);
}

TEST(Verdict, GivesUpASmoothBorderWithWhichTrianglesHaveNoArea)
{
	const Verdict verdict = judge(order, firstAttempt(500), {500, false, true, true});
	ASSERT_EQ(verdict.kind, Kind::TryNext);
	EXPECT_TRUE(verdict.next.keepsRaggedBorder);
	EXPECT_EQ(verdict.next.vertexNum, 500);
	EXPECT_TRUE(says(verdict, "smooth border")) << verdict.sentence;
	EXPECT_EQ(judge(order, verdict.next, reached(500)).kind, Kind::Accept);
	EXPECT_EQ(judge(order, firstAttempt(500), {500, false, false, true}).kind, Kind::Accept);
	// It is not tried again with another count.
	const Verdict smallest =
		judge(wish, {Way::ByTopology, 500, 500, false, 0, 0, true}, reached(600));
	ASSERT_EQ(smallest.kind, Kind::TryNext);
	EXPECT_TRUE(smallest.next.keepsRaggedBorder);
}

TEST(Verdict, LeavesSeamsOpenWithWhichTrianglesHaveNoArea)
{
	const Verdict verdict = judge(order, firstAttempt(500), {500, false, true, false, true});
	ASSERT_EQ(verdict.kind, Kind::TryNext);
	EXPECT_TRUE(verdict.next.leavesSeamsOpen);
	EXPECT_EQ(verdict.next.vertexNum, 500);
	EXPECT_TRUE(says(verdict, "seams")) << verdict.sentence;
	EXPECT_EQ(judge(order, verdict.next, reached(500)).kind, Kind::Accept);
	EXPECT_EQ(judge(order, firstAttempt(500), {500, false, false, false, true}).kind, Kind::Accept);
	// They are not sewn again for another count.
	const Verdict smallest =
		judge(wish, {Way::ByTopology, 500, 500, false, 0, 0, false, true}, reached(600));
	ASSERT_EQ(smallest.kind, Kind::TryNext);
	EXPECT_TRUE(smallest.next.leavesSeamsOpen);
}

TEST(Verdict, ReachesAMissedCountByTopology)
{
	const Verdict verdict = judge(order, firstAttempt(500), reached(501));
	ASSERT_EQ(verdict.kind, Kind::TryNext);
	EXPECT_EQ(verdict.next.way, Way::ByTopology);
	EXPECT_EQ(verdict.next.vertexNum, 500);
	EXPECT_EQ(judge(order, verdict.next, reached(500)).kind, Kind::Accept);
}

TEST(Verdict, RefusesWhatTopologyForbidsAndNamesTheSmallest)
{
	const Verdict verdict = judge(order, byTopology(3), reached(7));
	ASSERT_EQ(verdict.kind, Kind::Refuse);
	EXPECT_EQ(verdict.smallestVertexNum, 7);
	EXPECT_TRUE(says(verdict, "with 3 vertices")) << verdict.sentence;
	EXPECT_TRUE(says(verdict, "number is 7")) << verdict.sentence;
}

TEST(Verdict, RaisesAWishToTheSmallestAndMeshesAnew)
{
	const Verdict verdict = judge(wish, byTopology(3), reached(7));
	ASSERT_EQ(verdict.kind, Kind::TryNext);
	EXPECT_EQ(verdict.next.vertexNum, 7);
	EXPECT_EQ(verdict.next.way, Way::WithoutFeatureLines);
	EXPECT_TRUE(says(verdict, "7 vertices instead of 3")) << verdict.sentence;
	const Verdict last = judge(wish, verdict.next, reached(7));
	EXPECT_EQ(last.kind, Kind::Accept);
	EXPECT_EQ(last.sentence, "") << "it has been said";
}

TEST(Verdict, TakesTheNearestWithKeptVerticesOrRefuses)
{
	const Request keepsAndWishes{true, true, 40}, keeps{true, false, 40};
	const Verdict taken = judge(keepsAndWishes, firstAttempt(50), reached(55));
	EXPECT_EQ(taken.kind, Kind::Accept);
	EXPECT_TRUE(says(taken, "55 vertices instead of 50")) << taken.sentence;
	const Verdict refused = judge(keeps, firstAttempt(50), reached(55));
	EXPECT_EQ(refused.kind, Kind::Refuse);
	EXPECT_EQ(refused.smallestVertexNum, 55);
	EXPECT_TRUE(says(refused, "the 40 to be kept")) << refused.sentence;
	EXPECT_EQ(judge(keeps, firstAttempt(50), withoutAreas(50)).kind, Kind::Accept)
		<< "no other count is looked for";
}

TEST(Verdict, LooksForACountThatLeavesRoomForAreas)
{
	const auto hasAreasFrom = [](std::int64_t least) {
		return [least](const Attempt& a) {
			return a.vertexNum < least ? withoutAreas(a.vertexNum) : reached(a.vertexNum);
		};
	};
	// 8, 8 again, 10, 12, 15
	const std::vector<Verdict> taken = verdictsOn(wish, 8, hasAreasFrom(13));
	EXPECT_EQ(taken.size(), 5u);
	EXPECT_EQ(taken.back().kind, Kind::Accept);
	EXPECT_TRUE(says(taken.back(), "15 vertices instead of 8")) << taken.back().sentence;
	const std::vector<Verdict> refused = verdictsOn(order, 8, hasAreasFrom(13));
	EXPECT_EQ(refused.size(), 5u);
	EXPECT_EQ(refused.back().kind, Kind::Refuse);
	EXPECT_EQ(refused.back().smallestVertexNum, 15);
	EXPECT_TRUE(says(refused.back(), "With 8 vertices")) << refused.back().sentence;
}

TEST(Verdict, TakesTheSameCountWhereASecondMeshHasAreas)
{
	int                        meshNum  = 0;
	const std::vector<Verdict> verdicts = verdictsOn(order, 8, [&](const Attempt& a) {
		return ++meshNum == 1 ? withoutAreas(a.vertexNum) : reached(a.vertexNum);
	});
	EXPECT_EQ(verdicts.size(), 2u);
	EXPECT_EQ(verdicts.back().kind, Kind::Accept);
	EXPECT_EQ(verdicts.back().sentence, "");
}

TEST(Verdict, LooksForNoOtherCountAmongManyVertices)
{
	EXPECT_EQ(judge(order, firstAttempt(64), withoutAreas(64)).kind, Kind::TryNext);
	EXPECT_EQ(judge(order, firstAttempt(65), withoutAreas(65)).kind, Kind::Accept);
}

TEST(Verdict, ComesBackToTheFirstCountAfterASearchInVain)
{
	std::vector<std::int64_t>  tried;
	const std::vector<Verdict> verdicts = verdictsOn(order, 8, [&](const Attempt& a) {
		tried.push_back(a.vertexNum);
		return withoutAreas(a.vertexNum);
	});
	EXPECT_EQ(verdicts.back().kind, Kind::Accept) << "the audit withholds it";
	EXPECT_EQ(tried, (std::vector<std::int64_t>{8, 8, 10, 12, 15, 18, 22, 27, 33, 8}));
}

TEST(Verdict, RefusesAfterASearchInVainBelowTheSmallest)
{
	const std::vector<Verdict> verdicts = verdictsOn(order, 3, [](const Attempt& a) {
		return withoutAreas(std::max<std::int64_t>(7, a.vertexNum));
	});
	EXPECT_EQ(verdicts.back().kind, Kind::Refuse);
	EXPECT_EQ(verdicts.back().smallestVertexNum, 7);
	EXPECT_TRUE(says(verdicts.back(), "cannot be meshed with 3")) << verdicts.back().sentence;
}

/// Whatever the attempts come to: the same attempt comes to the same, as in a run.
TEST(Verdict, AlwaysComesToAnEnd)
{
	for (std::uint32_t seed : testSeeds(2000)) {
		SCOPED_TRACE("seed " + std::to_string(seed));
		Random             random(seed);
		const std::int64_t asked = 1 + random.below(80), kept = random.chance(0.2) ? asked / 2 : 0;
		const Request      request{random.chance(0.8), random.chance(0.5), kept};
		const double       hit = random.between(0, 1), flat = random.between(0, 1);
		const bool         isSmooth = random.chance(0.5), isSewn = random.chance(0.5);
		std::map<std::tuple<Way, std::int64_t, bool, bool>, Outcome> known;
		std::int64_t                                                 last = 0;
		const std::vector<Verdict> verdicts = verdictsOn(request, asked, [&](const Attempt& a) {
			Outcome outcome{random.chance(hit) ? a.vertexNum : 1 + random.below(90),
							a.way == Way::WithFeatureLines && random.chance(0.5),
							random.chance(flat), isSmooth && !a.keepsRaggedBorder,
							isSewn && !a.leavesSeamsOpen};
			outcome =
				known
					.insert({{a.way, a.vertexNum, a.keepsRaggedBorder, a.leavesSeamsOpen}, outcome})
					.first->second;
			last = outcome.vertexNum;
			return outcome;
		});
		EXPECT_LE(verdicts.size(), 25u);
		const Verdict& verdict = verdicts.back();
		ASSERT_NE(verdict.kind, Kind::TryNext);
		if (verdict.kind == Kind::Refuse) {
			EXPECT_FALSE(request.isTargetWish) << "a wish is never refused";
			EXPECT_TRUE(says(verdict, std::to_string(verdict.smallestVertexNum)));
		}
		else if (request.exactCount && !request.isTargetWish && kept > 0) {
			EXPECT_EQ(last, asked);
		}
	}
}

} // namespace gpr::test
