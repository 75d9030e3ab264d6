// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The table of the plan, row by row: which fact leads to which decision, and from which step the
// run goes on.

#include <tests/support/random_source.h>
#include <vcg_extras/core/base/failure.h>
#include <vcg_extras/core/run/plan.h>

#include <algorithm>
#include <functional>
#include <gtest/gtest.h>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace gpr::test {

namespace {

RemeshOptions order(std::int64_t vertexNum)
{
	RemeshOptions options;
	options.targetMode      = TargetMode::VertexNum;
	options.targetVertexNum = vertexNum;
	return options;
}

RemeshOptions wish(std::int64_t vertexNum)
{
	RemeshOptions options = order(vertexNum);
	options.allowNearest  = true;
	return options;
}

RemeshOptions inexact(std::int64_t vertexNum)
{
	RemeshOptions options = order(vertexNum);
	options.preset        = Preset::Paper;
	return options;
}

RemeshOptions keeping(RemeshOptions options)
{
	options.boundary = BoundaryMode::Keep;
	return options;
}

RelaxationFacts reached(std::int64_t vertexNum)
{
	return {{vertexNum}};
}

RelaxationFacts withoutAreas(std::int64_t vertexNum)
{
	return {{vertexNum}, false, true};
}

/// A run with steps whose outcomes the test decides. By default the outcome of a step needs no
/// decision.
class PlannedRun {
public:
	explicit PlannedRun(RemeshOptions options, Purpose purpose = Purpose::Answer) :
			options_(std::move(options)), plan_(options_, 1000, Request{purpose})
	{
	}

	std::int64_t keptNum      = 0;
	std::int64_t euler        = 2; ///< of a surface without border
	std::int64_t countStep    = 1; ///< of vertices
	double       borderLength = 0;
	SizeFacts    ofSizes; ///< vertexNum and borderEdgeNum, with sizes in mesh units
	std::function<LineFacts(const Decisions&)>       lines;
	std::function<SampleFacts(const Decisions&)>     samples;
	std::function<RelaxationFacts(const Decisions&)> mesh;
	std::function<ContactFacts(const Decisions&)>    contacts;
	bool                                             mustSew    = false;
	bool                                             areCrowded = false;

	std::vector<Step>        steps; ///< in the order in which they were taken
	std::vector<std::string> told;
	std::vector<Decisions>   attempts; ///< of every mesh
	std::optional<Failure>   failure;  ///< at the end of the run

	/// Takes steps until the run is done or refused.
	PlannedRun& go()
	{
		try {
			while (plan_.next() != Step::Done && steps.size() < 10000)
				take(plan_.next());
		}
		catch (const Failure& f) {
			failure = f;
		}
		return *this;
	}

	const Decisions& decisions() const { return plan_.decisions(); }
	bool             isTaken() const { return !failure && plan_.next() == Step::Done; }
	std::ptrdiff_t   numOf(Step step) const { return std::count(steps.begin(), steps.end(), step); }

	bool says(const std::string& part) const
	{
		const auto has = [&](const std::string& s) { return s.find(part) != std::string::npos; };
		return (failure && has(failure->message)) || std::any_of(told.begin(), told.end(), has);
	}

private:
	RemeshOptions options_;
	Plan          plan_;

	std::int64_t facesOf(std::int64_t vertexNum) const { return 2 * (vertexNum - euler); }

	SizeFacts sizesOf(const Decisions& d) const
	{
		SizeFacts facts{keptNum, euler};
		facts.countStep     = d.faceNum > 0 ? 2 : countStep;
		facts.borderLength  = borderLength;
		facts.vertexNum     = ofSizes.vertexNum;
		facts.borderEdgeNum = ofSizes.borderEdgeNum;
		return facts;
	}

	void take(Step step)
	{
		steps.push_back(step);
		try {
			judge(step);
		}
		catch (const Failure& f) {
			plan_.judge(f);
		}
	}

	void judge(Step step)
	{
		const Decisions d = plan_.decisions();
		switch (step) {
		case Step::Input:
			return tell(plan_.judge(InputFacts{1, 1}));
		case Step::Surface:
			return tell(plan_.judge(SurfaceFacts{mustSew && d.sewing == Sewing::NotYet}));
		case Step::Sizes:
			return tell(plan_.judge(sizesOf(d)));
		case Step::Lines:
			return tell(plan_.judge(lines ? lines(d) : LineFacts()));
		case Step::Samples:
			return tell(plan_.judge(samples ? samples(d) : SampleFacts()));
		case Step::Relaxation: {
			attempts.push_back(d);
			RelaxationFacts facts = mesh ? mesh(d) : reached(d.vertexNum);
			facts.faceNum         = facesOf(facts.vertexNum);
			return tell(plan_.judge(facts));
		}
		case Step::Fit:
			return tell(plan_.judge(FitFacts{areCrowded}));
		case Step::Contacts:
			return tell(plan_.judge(
				contacts ? contacts(d)
						 : ContactFacts{{d.vertexNum, facesOf(d.vertexNum)}, d.vertexNum}));
		case Step::Export:
			return tell(plan_.judge(ExportFacts{{d.vertexNum, facesOf(d.vertexNum)}}));
		default:
			return plan_.goOn();
		}
	}

	void tell(const std::string& sentence)
	{
		if (!sentence.empty()) told.push_back(sentence);
	}
};

/// The run in which each attempt at a mesh comes to meshOf(decisions).
template <class MeshOf>
PlannedRun runWith(const RemeshOptions& options, const MeshOf& meshOf, std::int64_t keptNum = 0)
{
	PlannedRun run(options);
	run.mesh    = meshOf;
	run.keptNum = keptNum;
	run.go();
	return run;
}

std::vector<std::int64_t> countsOf(const PlannedRun& run)
{
	std::vector<std::int64_t> counts;
	for (const Decisions& d : run.attempts)
		counts.push_back(d.vertexNum);
	return counts;
}

} // namespace

TEST(Plan, TakesTheStepsInTheirOrderWithoutAWord)
{
	for (const RemeshOptions& options : {order(500), wish(500)}) {
		const PlannedRun run = PlannedRun(options).go();
		EXPECT_TRUE(run.isTaken());
		EXPECT_TRUE(run.told.empty());
		EXPECT_TRUE(std::is_sorted(run.steps.begin(), run.steps.end()));
		EXPECT_EQ(run.numOf(Step::Forecast) + run.numOf(Step::GivenSamples) +
					  run.numOf(Step::Release) + run.numOf(Step::Refinement) +
					  run.numOf(Step::Error),
				  0);
		EXPECT_EQ(run.steps.front(), Step::Region);
		EXPECT_EQ(run.steps.back(), Step::Export);
	}
}

TEST(Plan, StopsAtTheSamplesWhereTheyAreWantedAlone)
{
	const PlannedRun run = PlannedRun(order(500), Purpose::SamplesOnly).go();
	EXPECT_TRUE(run.isTaken());
	EXPECT_EQ(run.numOf(Step::Samples), 1);
	EXPECT_EQ(run.numOf(Step::Triangles), 0);
	EXPECT_EQ(run.steps.back(), Step::Export);
}

TEST(Plan, SewsSeamsBeforeTheInputIsConnectedAgain)
{
	PlannedRun run(order(500));
	run.mustSew = true;
	run.go();
	EXPECT_EQ(run.numOf(Step::Input), 2);
	EXPECT_EQ(run.decisions().sewing, Sewing::First);
	EXPECT_TRUE(run.isTaken());
}

// Counts of faces.

RemeshOptions faces(std::int64_t faceNum)
{
	RemeshOptions options;
	options.targetMode    = TargetMode::FaceNum;
	options.targetFaceNum = faceNum;
	return options;
}

TEST(Plan, MakesAsManyVerticesAsTheFacesNeed)
{
	for (const std::int64_t euler : {2, 0, -20}) {
		PlannedRun run(faces(1000));
		run.euler = euler;
		run.go();
		EXPECT_TRUE(run.isTaken());
		EXPECT_EQ(run.decisions().vertexNum, 500 + euler);
		EXPECT_EQ(run.decisions().faceNum, 1000);
		EXPECT_TRUE(run.told.empty());
		EXPECT_EQ(run.numOf(Step::Input), 1);
	}
	PlannedRun handles(faces(1000));
	handles.euler = -200;
	EXPECT_EQ(handles.go().numOf(Step::Input), 2) << "edges are split for other sizes";
}

/// F = 2 V - 2 χ - B: half the faces, half the border vertices and the Euler characteristic.
TEST(Plan, MakesAsManyVerticesAsAnEdgeLengthNeedsAtTheBorder)
{
	RemeshOptions options;
	options.targetMode = TargetMode::EdgeLength;
	options.targetEdgeLen =
		std::sqrt(4 / std::sqrt(3.0) / 1000); // a thousand faces on an area of 1
	for (const int onBorder : {0, 100}) {
		PlannedRun run(options);
		run.euler        = 1;
		run.borderLength = onBorder * options.targetEdgeLen;
		EXPECT_TRUE(run.go().isTaken());
		EXPECT_EQ(run.decisions().vertexNum, 501 + onBorder / 2);
	}
	options.preset = Preset::Paper;
	PlannedRun paper(options);
	paper.borderLength = 100 * options.targetEdgeLen;
	EXPECT_EQ(paper.go().decisions().vertexNum, 500) << "as published";

	options            = RemeshOptions();
	options.targetMode = TargetMode::Sizes;
	options.maxEdge    = 1;
	PlannedRun sizes(options);
	sizes.euler                 = 1;
	sizes.ofSizes.vertexNum     = 300;
	sizes.ofSizes.borderEdgeNum = 80;
	EXPECT_EQ(sizes.go().decisions().vertexNum, 341);
}

TEST(Plan, NamesTheTwoEvenNumbersBesideAnOddOneOfAClosedSurface)
{
	const PlannedRun run = PlannedRun(faces(1001)).go();
	ASSERT_TRUE(run.failure);
	EXPECT_EQ(run.failure->status, Status::PromiseBroken);
	EXPECT_TRUE(run.says("1001 faces; the nearest possible numbers found are 1000 and 1002"));

	RemeshOptions nearest = faces(1001);
	nearest.allowNearest  = true;
	const PlannedRun even = PlannedRun(nearest).go();
	EXPECT_TRUE(even.isTaken());
	EXPECT_EQ(even.decisions().faceNum, 1000);
	EXPECT_TRUE(even.says("1000 faces (502 vertices) instead of 1001 faces"));
}

/// Two halves that do not touch the mirror plane have an even number of vertices together.
TEST(Plan, CountsOfTwoHalvesAreEven)
{
	PlannedRun ordered(order(501));
	ordered.countStep = 2;
	EXPECT_FALSE(ordered.go().isTaken());
	EXPECT_EQ(ordered.failure->status, Status::PromiseBroken);
	EXPECT_TRUE(ordered.says("500 and 502"));
	PlannedRun wished(wish(501));
	wished.countStep = 2;
	EXPECT_TRUE(wished.go().isTaken());
	EXPECT_EQ(wished.decisions().vertexNum, 500);
	EXPECT_TRUE(wished.says("500 vertices instead of 501"));
	PlannedRun even(order(500));
	even.countStep = 2;
	EXPECT_TRUE(even.go().isTaken());
	EXPECT_TRUE(even.told.empty());
}

TEST(Plan, NamesTwoNumbersOfFacesThatWereMadeWhereOneIsTooSmall)
{
	const PlannedRun run = runWith(faces(6), [](const Decisions& d) {
		return reached(std::max<std::int64_t>(9, d.vertexNum));
	});
	ASSERT_TRUE(run.failure);
	EXPECT_EQ(run.failure->status, Status::CountTooSmall);
	EXPECT_EQ(run.failure->possible.vertexNum, 9);
	EXPECT_TRUE(run.says("numbers found are 14 and 16 (9 and 10 vertices)"));
}

// Vertices to be kept.

TEST(Plan, KeepsTheCountWhereTheKeptVerticesFit)
{
	for (const RemeshOptions& options : {keeping(order(100)), keeping(wish(100))}) {
		PlannedRun run(options);
		run.keptNum = 100;
		run.go();
		EXPECT_EQ(run.decisions().vertexNum, 100);
		EXPECT_TRUE(run.told.empty());
	}
}

TEST(Plan, RaisesTheCountForABorderThatIsKeptWhereItIsAWish)
{
	PlannedRun run(keeping(wish(30)));
	run.keptNum = 100;
	run.go();
	EXPECT_EQ(run.decisions().vertexNum, 180) << "the border, half as many, and those asked for";
	EXPECT_TRUE(run.says("raised from 30 to 180 vertices"));
	EXPECT_EQ(run.numOf(Step::Input), 2) << "edges are split for another radius";
}

TEST(Plan, RefusesACountBelowTheKeptVertices)
{
	for (Purpose purpose : {Purpose::Answer, Purpose::SamplesOnly}) {
		PlannedRun run(keeping(order(99)), purpose);
		run.keptNum = 100;
		run.go();
		ASSERT_TRUE(run.failure);
		EXPECT_EQ(run.failure->status, Status::CountTooSmall);
	}
}

TEST(Plan, RefusesARegionThatDoesNotFitEvenWhereTheCountIsAWish)
{
	RemeshOptions options = wish(99);
	options.preset        = Preset::Paper;
	PlannedRun run(options);
	run.keptNum = 100;
	run.go();
	ASSERT_TRUE(run.failure);
	EXPECT_TRUE(run.says("give a feature disk scale"));
}

// Lines and samples.

TEST(Plan, FollowsFewerLinesUntilTheyFit)
{
	std::vector<int> limits;
	PlannedRun       run(order(500));
	run.lines = [&](const Decisions& d) {
		limits.push_back(d.lineLimit);
		return LineFacts{d.lineLimit < 3 ? 2.0 : 0.9};
	};
	run.go();
	EXPECT_EQ(limits, (std::vector<int>{0, 1, 2, 3}));
	EXPECT_TRUE(run.isTaken());
}

TEST(Plan, PassesOverLimitsThatDropNoLine)
{
	std::vector<int> limits;
	PlannedRun       run(order(500));
	run.lines = [&](const Decisions& d) {
		limits.push_back(d.lineLimit);
		return LineFacts{d.lineLimit < 10 ? 2.0 : 0.9, 4};
	};
	run.go();
	EXPECT_EQ(limits, (std::vector<int>{0, 1, 6, 11}));
	EXPECT_TRUE(run.isTaken());
}

TEST(Plan, LeavesCloseLinesOutWhereLinesTakeOverHalfOfTheVertices)
{
	PlannedRun run(order(500));
	run.lines = [](const Decisions& d) { return LineFacts{d.lineLimit == 0 ? 0.6 : 0.55}; };
	run.go();
	EXPECT_EQ(run.decisions().lineLimit, 1) << "what is left of them fits";
}

TEST(Plan, CorrectsARadiusThatMissesTheCountByMuch)
{
	PlannedRun run(order(1000));
	run.samples = [](const Decisions& d) {
		const float radius = d.radius.value_or(1);
		return SampleFacts{true, d.radius ? 985 : 700, 10, radius, 1};
	};
	run.go();
	EXPECT_EQ(run.numOf(Step::Samples), 2);
	ASSERT_TRUE(run.decisions().radius);
	EXPECT_NEAR(*run.decisions().radius, std::sqrt(700 / 985.0), 1e-6);
}

TEST(Plan, CorrectsTheRadiusAtMostTwice)
{
	for (const bool mayMiss : {true, false}) {
		PlannedRun run(order(1000));
		run.samples = [&](const Decisions& d) {
			return SampleFacts{mayMiss, 700, 10, d.radius.value_or(1), 1};
		};
		run.go();
		EXPECT_EQ(run.numOf(Step::Samples), 3);
	}
}

/// Noise costs many samples; a tenth fewer is usual, and components may take nearly all vertices.
TEST(Plan, CorrectsTheRadiusOfAUsualSamplingForLargeLacksOnly)
{
	const std::map<int, int> samplings = {{100, 1}, {390, 1}, {400, 2},
										  {830, 2}, {840, 1}, {1500, 1}};
	for (const auto& [num, wanted] : samplings) {
		PlannedRun run(order(1000));
		run.samples = [n = num](const Decisions& d) {
			return SampleFacts{false, d.radius ? 985 : n, 10, d.radius.value_or(1), 1};
		};
		run.go();
		EXPECT_EQ(run.numOf(Step::Samples), wanted) << num;
	}
}

TEST(Plan, LeavesTheRadiusOfThePaper)
{
	RemeshOptions options = order(1000);
	options.preset        = Preset::Paper;
	PlannedRun run(options);
	run.samples = [](const Decisions&) { return SampleFacts{false, 700, 10, 1, 1}; };
	run.go();
	EXPECT_EQ(run.numOf(Step::Samples), 1);
}

TEST(Plan, CorrectsNoRadiusWhereTheCurvesTakeMostOfTheSamples)
{
	PlannedRun run(order(1000));
	run.samples = [](const Decisions&) { return SampleFacts{true, 1500, 701, 1, 1}; };
	run.go();
	EXPECT_EQ(run.numOf(Step::Samples), 1);
}

// The numbered rules.

TEST(Plan, AcceptsAnyCountWhereNoneIsPromised)
{
	EXPECT_EQ(runWith(inexact(500), [](const Decisions&) { return reached(480); }).attempts.size(),
			  1u);
	EXPECT_EQ(
		runWith(inexact(500), [](const Decisions&) { return withoutAreas(480); }).attempts.size(),
		1u)
		<< "among many vertices another count changes nothing";
}

/// Nothing is promised about the count, but the audit withholds degenerate faces.
TEST(Plan, LooksForAreasWhereNoCountIsPromised)
{
	const PlannedRun run = runWith(inexact(8), [](const Decisions& d) {
		return d.vertexNum < 13 ? withoutAreas(d.vertexNum - 1) : reached(d.vertexNum - 1);
	});
	EXPECT_TRUE(run.isTaken());
	EXPECT_TRUE(run.says("some triangles would be degenerate"));
}

TEST(Plan, GivesUpFeatureLinesThatDoHarm)
{
	for (const RelaxationFacts& facts :
		 {RelaxationFacts{{501}, true, false}, RelaxationFacts{{500}, true, true}}) {
		const PlannedRun run = runWith(order(500), [&](const Decisions& d) {
			return d.way == Way::WithFeatureLines ? facts : reached(500);
		});
		ASSERT_TRUE(run.isTaken());
		ASSERT_EQ(run.attempts.size(), 2u);
		EXPECT_EQ(run.attempts[1].way, Way::WithoutFeatureLines);
		EXPECT_EQ(run.attempts[1].vertexNum, 500);
		EXPECT_EQ(run.numOf(Step::Input), 1) << "the surface fits";
		EXPECT_TRUE(run.says("feature lines"));
	}
	const PlannedRun harmless = runWith(order(500), [](const Decisions&) {
		return RelaxationFacts{{500}, true, false};
	});
	EXPECT_EQ(harmless.attempts.size(), 1u);
}

TEST(Plan, GivesUpASmoothBorderWithWhichTrianglesHaveNoArea)
{
	const PlannedRun run = runWith(order(500), [](const Decisions& d) {
		return d.keepsRaggedBorder ? reached(500) : RelaxationFacts{{500}, false, true, true};
	});
	ASSERT_EQ(run.attempts.size(), 2u);
	EXPECT_TRUE(run.attempts[1].keepsRaggedBorder);
	EXPECT_EQ(run.attempts[1].vertexNum, 500);
	EXPECT_TRUE(run.says("smooth border"));
	// No second trial with another count.
	const PlannedRun raised = runWith(wish(500), [](const Decisions& d) {
		return d.keepsRaggedBorder ? reached(600) : RelaxationFacts{{500}, false, true, true};
	});
	EXPECT_EQ(raised.decisions().vertexNum, 600);
	EXPECT_TRUE(raised.attempts.back().keepsRaggedBorder);
}

TEST(Plan, LeavesSeamsOpenWithWhichTrianglesHaveNoArea)
{
	const auto facts = [](const Decisions& d, std::int64_t reachedNum) {
		const bool isSewn = d.sewing != Sewing::Never;
		return RelaxationFacts{{isSewn ? 500 : reachedNum}, false, isSewn, false, isSewn};
	};
	const PlannedRun run = runWith(order(500), [&](const Decisions& d) { return facts(d, 500); });
	ASSERT_EQ(run.attempts.size(), 2u);
	EXPECT_EQ(run.attempts[1].sewing, Sewing::Never);
	EXPECT_EQ(run.numOf(Step::Input), 2);
	EXPECT_TRUE(run.says("seams"));
	// No second sewing for another count.
	const PlannedRun raised = runWith(wish(500), [&](const Decisions& d) { return facts(d, 600); });
	EXPECT_EQ(raised.decisions().vertexNum, 600);
	EXPECT_EQ(raised.attempts.back().sewing, Sewing::Never);
}

TEST(Plan, ReachesAMissedCountByTopology)
{
	const PlannedRun run = runWith(order(500), [](const Decisions& d) {
		return reached(d.way == Way::ByTopology ? 500 : 501);
	});
	ASSERT_EQ(run.attempts.size(), 2u);
	EXPECT_EQ(run.attempts[1].way, Way::ByTopology);
	EXPECT_EQ(run.attempts[1].spacedFor(), 1);
	EXPECT_TRUE(run.isTaken());
}

TEST(Plan, RefusesWhatTopologyForbidsAndNamesTheSmallest)
{
	RemeshOptions options = order(3);
	options.guard         = false; // no trial of the named count
	const PlannedRun run  = runWith(options, [](const Decisions&) { return reached(7); });
	ASSERT_TRUE(run.failure);
	EXPECT_EQ(run.failure->possible.vertexNum, 7);
	EXPECT_TRUE(run.says("with 3 vertices"));
	EXPECT_TRUE(run.says("number is 7"));
}

TEST(Plan, RaisesAWishToTheSmallestAndMeshesAnew)
{
	const PlannedRun run = runWith(wish(3), [](const Decisions&) { return reached(7); });
	ASSERT_TRUE(run.isTaken());
	EXPECT_EQ(countsOf(run), (std::vector<std::int64_t>{3, 3, 7}));
	EXPECT_EQ(run.attempts.back().way, Way::WithoutFeatureLines);
	EXPECT_EQ(run.told.size(), 1u);
	EXPECT_TRUE(run.says("7 vertices instead of 3"));
}

TEST(Plan, AWishTakesAFewVerticesMoreThanTheSmallest)
{
	const auto atLeast640 = [](const Decisions& d) {
		return reached(d.way == Way::ByTopology ? 640 : std::max<std::int64_t>(640, d.vertexNum));
	};
	const PlannedRun run = runWith(wish(30), atLeast640);
	ASSERT_TRUE(run.isTaken());
	EXPECT_EQ(countsOf(run), (std::vector<std::int64_t>{30, 30, 660}));
	EXPECT_TRUE(run.says("660 vertices instead of 30 vertices, a few more than the smallest number "
						 "reached, 640 vertices."));
}

TEST(Plan, TakesTheSmallestAtOnceIfTheRightSpacingCannotReachIt)
{
	const auto stuckAbove = [](std::int64_t smallest) {
		return [smallest](const Decisions& d) {
			const bool isShaped = d.way != Way::ByTopology && d.vertexNum < smallest;
			return reached(smallest + isShaped);
		};
	};
	const PlannedRun run = runWith(wish(30), stuckAbove(65));
	ASSERT_TRUE(run.isTaken());
	EXPECT_EQ(countsOf(run), (std::vector<std::int64_t>{30, 30}));
	EXPECT_EQ(run.decisions().vertexNum, 65);
	EXPECT_TRUE(run.says("65 vertices instead of 30"));
	// Few vertices are quick to mesh anew, and may come out better.
	EXPECT_EQ(countsOf(runWith(wish(30), stuckAbove(64))), (std::vector<std::int64_t>{30, 30, 64}));
}

TEST(Plan, TakesTheNearestWithKeptVerticesOrRefuses)
{
	const auto       mesh  = [](const Decisions&) { return reached(55); };
	const PlannedRun taken = runWith(keeping(wish(50)), mesh, 40);
	EXPECT_TRUE(taken.isTaken());
	EXPECT_EQ(taken.decisions().vertexNum, 55);
	EXPECT_TRUE(taken.says("55 vertices instead of 50"));
	RemeshOptions options    = keeping(order(50));
	options.guard            = false;
	const PlannedRun refused = runWith(options, mesh, 40);
	ASSERT_TRUE(refused.failure);
	EXPECT_EQ(refused.failure->possible.vertexNum, 55);
	EXPECT_TRUE(refused.says("the 40 vertices to be kept"));
	const auto       flat  = [](const Decisions&) { return withoutAreas(50); };
	const PlannedRun other = runWith(options, flat, 40);
	EXPECT_EQ(other.attempts.size(), 1u) << "no other count is looked for";
}

TEST(Plan, LooksForACountThatLeavesRoomForAreas)
{
	const auto hasAreasFrom13 = [](const Decisions& d) {
		return d.vertexNum < 13 ? withoutAreas(d.vertexNum) : reached(d.vertexNum);
	};
	const std::vector<std::int64_t> counts{8, 8, 10, 12, 15};
	const PlannedRun                taken = runWith(wish(8), hasAreasFrom13);
	EXPECT_EQ(countsOf(taken), counts);
	EXPECT_TRUE(taken.isTaken());
	EXPECT_TRUE(taken.says("15 vertices instead of 8"));
	RemeshOptions options    = order(8);
	options.guard            = false;
	const PlannedRun refused = runWith(options, hasAreasFrom13);
	EXPECT_EQ(countsOf(refused), counts);
	ASSERT_TRUE(refused.failure);
	EXPECT_EQ(refused.failure->possible.vertexNum, 15);
	EXPECT_TRUE(refused.says("With 8 vertices"));
}

TEST(Plan, TakesTheSameCountWhereASecondMeshHasAreas)
{
	int              meshNum = 0;
	const PlannedRun run     = runWith(order(8), [&](const Decisions& d) {
        return ++meshNum == 1 ? withoutAreas(d.vertexNum) : reached(d.vertexNum);
    });
	EXPECT_EQ(run.attempts.size(), 2u);
	EXPECT_TRUE(run.isTaken());
	EXPECT_TRUE(run.told.empty());
}

TEST(Plan, LooksForNoOtherCountAmongManyVertices)
{
	const auto flat = [](const Decisions& d) { return withoutAreas(d.vertexNum); };
	EXPECT_GT(runWith(order(64), flat).attempts.size(), 1u);
	EXPECT_EQ(runWith(order(65), flat).attempts.size(), 1u);
}

TEST(Plan, ComesBackToTheFirstCountAfterASearchThatFailed)
{
	const PlannedRun run =
		runWith(order(8), [](const Decisions& d) { return withoutAreas(d.vertexNum); });
	EXPECT_TRUE(run.isTaken()) << "the audit withholds it";
	EXPECT_EQ(countsOf(run), (std::vector<std::int64_t>{8, 8, 10, 12, 15, 18, 22, 27, 33, 8}));
}

TEST(Plan, RefusesAfterASearchThatFailedBelowTheSmallest)
{
	RemeshOptions options = order(3);
	options.guard         = false;
	const PlannedRun run  = runWith(options, [](const Decisions& d) {
        return withoutAreas(std::max<std::int64_t>(7, d.vertexNum));
    });
	ASSERT_TRUE(run.failure);
	EXPECT_EQ(run.failure->possible.vertexNum, 7);
	EXPECT_TRUE(run.says("cannot be meshed with 3"));
}

// From the mesh to the result.

TEST(Plan, ReleasesCrowdedLinesOnce)
{
	PlannedRun run(order(500));
	run.areCrowded = true;
	run.go();
	EXPECT_EQ(run.numOf(Step::Release), 1);
	EXPECT_EQ(run.numOf(Step::Fit), 1);
	EXPECT_EQ(run.numOf(Step::Angles), 1);
	EXPECT_EQ(run.numOf(Step::Contacts), 1);
}

TEST(Plan, TakesTheCountThatIsFreeOfContacts)
{
	PlannedRun run(wish(500));
	run.contacts = [](const Decisions& d) {
		EXPECT_TRUE(d.mayEndAbove);
		return ContactFacts{{520}, 500};
	};
	run.go();
	EXPECT_EQ(run.decisions().vertexNum, 520);
	EXPECT_TRUE(run.says("520 vertices instead of 500"));
}

TEST(Plan, RefusesACountThatHasContacts)
{
	PlannedRun run(order(500));
	run.contacts = [](const Decisions& d) {
		EXPECT_FALSE(d.mayEndAbove);
		return ContactFacts{{520}, d.vertexNum, d.vertexNum < 520};
	};
	run.go();
	ASSERT_TRUE(run.failure);
	EXPECT_EQ(run.failure->possible.vertexNum, 520);
	EXPECT_EQ(run.numOf(Step::Region), 2) << "the count named is tried";
}

/// The count named has contacts itself.
TEST(Plan, NamesACountThatWasMade)
{
	PlannedRun run(order(500));
	run.contacts = [](const Decisions& d) {
		return ContactFacts{{d.vertexNum < 520 ? 520 : 600}, d.vertexNum, d.vertexNum < 600};
	};
	run.go();
	ASSERT_TRUE(run.failure);
	EXPECT_EQ(run.failure->possible.vertexNum, 600);
	EXPECT_EQ(countsOf(run), (std::vector<std::int64_t>{500, 520, 600}));
	EXPECT_TRUE(run.says("the smallest possible number found is 600"));
}

namespace {

/// A run whose sheets at junctions intersect below a count.
PlannedRun runWithSheets(const RemeshOptions& options, std::int64_t least)
{
	PlannedRun run(options);
	run.contacts = [least](const Decisions& d) {
		return ContactFacts{{d.vertexNum, 2 * (d.vertexNum - 2)}, d.vertexNum, d.vertexNum < least};
	};
	run.go();
	return run;
}

} // namespace

TEST(Plan, TakesMoreVerticesForSheetsThatWouldIntersect)
{
	const PlannedRun run = runWithSheets(wish(500), 700);
	EXPECT_TRUE(run.isTaken());
	EXPECT_EQ(countsOf(run), (std::vector<std::int64_t>{500, 750}));
	EXPECT_TRUE(run.says("With 500 vertices sheets that meet in junctions would intersect"));
	EXPECT_EQ(run.told.size(), 1u);
}

TEST(Plan, EndsWithMoreVerticesForSheetsThatIntersectAlways)
{
	const PlannedRun run = runWithSheets(wish(500), 1000000);
	ASSERT_TRUE(run.failure);
	EXPECT_EQ(run.attempts.size(), 6u);
	EXPECT_LE(run.attempts.back().vertexNum, 8 * 500);
}

/// Sheets at one place get more and more vertices, which do not help.
TEST(Plan, RaisesNoCountThatGrewByItself)
{
	PlannedRun run(wish(5));
	run.contacts = [](const Decisions&) { return ContactFacts{{3000, 5996}, 3000, true}; };
	run.go();
	ASSERT_TRUE(run.failure);
	EXPECT_EQ(run.attempts.size(), 1u);
}

TEST(Plan, RefusesACountAtWhichSheetsIntersect)
{
	const PlannedRun byVertices = runWithSheets(order(500), 700);
	ASSERT_TRUE(byVertices.failure);
	EXPECT_TRUE(byVertices.says("or about 750 vertices, are needed"));
	const PlannedRun byFaces = runWithSheets(faces(50000), 1000000);
	ASSERT_TRUE(byFaces.failure);
	EXPECT_TRUE(byFaces.says("With 50000 faces sheets"));
	EXPECT_TRUE(byFaces.says("faces ("));
}

// Several meshes for a result.

namespace {

/// A run whose meshes have contacts below a count, and would need `missed` vertices more each.
PlannedRun runThatMisses(int asked, std::int64_t missed, std::int64_t least)
{
	PlannedRun run(order(asked));
	run.contacts = [missed, least](const Decisions& d) {
		return d.vertexNum >= least ? ContactFacts{{d.vertexNum}, d.vertexNum}
									: ContactFacts{{d.vertexNum + missed}, d.vertexNum, true};
	};
	run.go();
	return run;
}

} // namespace

TEST(Plan, NamesACountThatCanBeHad)
{
	const PlannedRun run = runThatMisses(8, 5, 20);
	EXPECT_EQ(countsOf(run), (std::vector<std::int64_t>{8, 13, 18, 23}));
	ASSERT_TRUE(run.failure);
	EXPECT_EQ(run.failure->status, Status::CountTooSmall);
	EXPECT_EQ(run.failure->possible.vertexNum, 23);
	EXPECT_TRUE(run.says("cannot be meshed with 8 vertices"));
	EXPECT_TRUE(run.says("the smallest possible number found is 23"));
}

/// Each number of vertices misses by as much as the number before, as on thin parts.
TEST(Plan, GrowsItsStepsToACountThatCanBeHad)
{
	const PlannedRun run = runThatMisses(2000, 50, 2500);
	EXPECT_EQ(countsOf(run),
			  (std::vector<std::int64_t>{2000, 2050, 2100, 2150, 2200, 2300, 2450, 2650}));
	ASSERT_TRUE(run.failure);
	EXPECT_EQ(run.failure->possible.vertexNum, 2650);
	EXPECT_TRUE(run.says("the smallest possible number found is 2650"));
}

TEST(Plan, KeepsItsSentenceWhereTheCountNamedCanBeHad)
{
	const PlannedRun run = runWith(order(3), [](const Decisions& d) {
		return reached(std::max<std::int64_t>(7, d.vertexNum));
	});
	ASSERT_TRUE(run.failure);
	EXPECT_EQ(run.failure->possible.vertexNum, 7);
	EXPECT_TRUE(run.says("the smallest possible number is 7"));
}

namespace {

/// Drives the trials for an error; errorOf(vertexNum).
class ErrorRun {
public:
	std::vector<std::int64_t> tried;
	std::vector<double>       shares; ///< progress at the begin of each trial
	int                       refinementNum = 0;
	int                       addedATime    = 0;
	Plan                      plan;

	ErrorRun(const RemeshOptions& options, double goal) :
			plan(options, 1000, Request{Purpose::Forecast, 0, ErrorGoal{goal, 300, 100000}, 1})
	{
	}

	template <class ErrorOf>
	void go(const ErrorOf& errorOf)
	{
		while (plan.next() != Step::Done) {
			const Decisions d = plan.decisions();
			if (plan.beginsRun() && d.purpose == Purpose::Trial) {
				tried.push_back(d.vertexNum);
				shares.push_back(plan.share().from);
			}
			switch (plan.next()) {
			case Step::Forecast:
				plan.judge(ForecastFacts{1000});
				break;
			case Step::Input:
				plan.judge(InputFacts{1, 1});
				break;
			case Step::Surface:
				plan.judge(SurfaceFacts{});
				break;
			case Step::Sizes:
				plan.judge(SizeFacts{0});
				break;
			case Step::Relaxation:
				plan.judge(reached(d.vertexNum));
				break;
			case Step::Refinement:
				++refinementNum;
				plan.judge(RefinementFacts{addedATime, addedATime > 0});
				break;
			case Step::Error:
				plan.judge(ErrorFacts{errorOf(d.wholeNum()), 1e-4});
				break;
			case Step::Export:
				plan.judge(ExportFacts{{d.wholeNum()}});
				break;
			default:
				plan.goOn();
			}
		}
	}
};

RemeshOptions forError()
{
	RemeshOptions options;
	options.targetMode     = TargetMode::MaxError;
	options.targetMaxError = 1;
	return options;
}

} // namespace

TEST(Plan, TriesTheCountOfTheForecastFirst)
{
	const RemeshOptions options = forError();
	ErrorRun            run(options, 1);
	run.go([](std::int64_t) { return 0.98; });
	EXPECT_EQ(run.tried.front(), 1000);
	EXPECT_NE(run.plan.outcomeForError().find("is proven to be"), std::string::npos);
}

TEST(Plan, TriesOtherCountsUntilTheErrorIsMet)
{
	const RemeshOptions options = forError();
	ErrorRun            run(options, 1);
	run.go([](std::int64_t n) { return n < 1500 ? 1.5 : 0.95; });
	EXPECT_GE(*std::max_element(run.tried.begin(), run.tried.end()), 1500);
	EXPECT_LE(run.tried.size(), 5u);
	for (std::size_t i = 0; i < run.shares.size(); ++i)
		EXPECT_DOUBLE_EQ(run.shares[i], 0.2 * double(i));
}

TEST(Plan, RefusesAnErrorThatNoTrialMeets)
{
	RemeshOptions options = forError();
	{
		ErrorRun run(options, 1);
		run.go([](std::int64_t) { return 2.0; });
		EXPECT_EQ(run.tried.size(), 5u);
		EXPECT_THROW(run.plan.outcomeForError(), Failure);
	}
	options.allowNearest = true;
	ErrorRun run(options, 1);
	run.go([](std::int64_t) { return 2.0; });
	EXPECT_NE(run.plan.outcomeForError().find("was not reached"), std::string::npos);
}

TEST(Plan, RefinesATrialThreeTimesAtMost)
{
	const RemeshOptions options = forError();
	ErrorRun            run(options, 1);
	run.addedATime = 5;
	run.go([](std::int64_t) { return 0.98; });
	EXPECT_EQ(run.refinementNum, 3 * int(run.tried.size()));
	EXPECT_EQ(run.plan.decisions().addedNum, 15);
}

// The bound of the whole run.

/// Whatever the attempts come to: the same attempt comes to the same, as in a run.
TEST(Plan, AlwaysComesToAnEnd)
{
	for (std::uint32_t seed : testSeeds(2000)) {
		SCOPED_TRACE("seed " + std::to_string(seed));
		Random             random(seed);
		const std::int64_t asked = 1 + random.below(80), kept = random.chance(0.2) ? asked / 2 : 0;
		const bool         isWish  = random.chance(0.5);
		RemeshOptions      options = isWish ? wish(asked) : order(asked);
		const bool         isExact = random.chance(0.8);
		options.preset             = isExact ? Preset::Default : Preset::Paper;
		options.guard              = false;
		const double hit = random.between(0, 1), flat = random.between(0, 1);
		const bool   isSmooth = random.chance(0.5), isSewn = random.chance(0.5);
		std::map<std::tuple<Way, std::int64_t, bool, Sewing>, RelaxationFacts> known;
		std::int64_t                                                           last = 0;
		PlannedRun                                                             run(options);
		run.keptNum = kept;
		run.mesh    = [&](const Decisions& d) {
            const RelaxationFacts facts{{random.chance(hit) ? d.vertexNum : 1 + random.below(90)},
                                        d.way == Way::WithFeatureLines && random.chance(0.5),
                                        random.chance(flat),
                                        isSmooth && !d.keepsRaggedBorder,
                                        isSewn && d.sewing != Sewing::Never};
            const auto key = std::make_tuple(d.way, d.vertexNum, d.keepsRaggedBorder, d.sewing);
            const RelaxationFacts& made = known.insert({key, facts}).first->second;
            last                        = made.vertexNum;
            return made;
		};
		run.go();
		EXPECT_LE(run.attempts.size(), 25u);
		ASSERT_TRUE(run.failure || run.isTaken());
		if (run.failure) {
			EXPECT_FALSE(isWish) << "a wish is never refused";
			EXPECT_TRUE(run.says(std::to_string(run.failure->possible.vertexNum)));
		}
		else if (isExact && !isWish && kept > 0) {
			EXPECT_EQ(last, asked);
		}
	}
}

/// Steps that would always go back end by a bound of the whole run, not by a bound for each step.
TEST(Plan, BoundsTheReturnsOfAWholeRun)
{
	PlannedRun run(order(500));
	run.lines    = [](const Decisions&) { return LineFacts{2}; };
	run.contacts = [](const Decisions& d) { return ContactFacts{{d.vertexNum}, d.vertexNum}; };
	run.go();
	EXPECT_EQ(run.numOf(Step::Lines), 1 + Plan::mostReturns);
	EXPECT_TRUE(run.isTaken());
	EXPECT_EQ(run.attempts.size(), 1u);
}

} // namespace gpr::test
