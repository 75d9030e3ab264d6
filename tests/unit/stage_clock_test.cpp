// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Times of stages, and progress.

#include <vcg_extras/core/base/stage_clock.h>

#include <chrono>
#include <gtest/gtest.h>
#include <thread>

namespace gpr::test {

namespace {

/// Clocks with access to the last progress.
class StageClocks : public ::testing::Test {
protected:
	double  told_ = -1;
	Workers workers_{1, [this](double share, const char*) {
						 told_ = share;
						 return true;
					 }};

	/// Waits, as progress is reported only some times a second.
	double shareNow()
	{
		std::this_thread::sleep_for(std::chrono::milliseconds(60));
		workers_.poll();
		return told_;
	}
};

TEST_F(StageClocks, AddUpTheTimesOfAStage)
{
	StageClock clock(workers_, Pipeline::Remeshing);
	for (Stage stage : {Stage::Order, Stage::Connect, Stage::Order, Stage::Connect}) {
		clock.enter(stage);
		std::this_thread::sleep_for(std::chrono::milliseconds(5));
	}
	const std::vector<StageTime>& stages = clock.finish();
	ASSERT_EQ(stages.size(), 2u);
	EXPECT_EQ(stages[0].stage, "order");
	EXPECT_EQ(stages[1].stage, "connect");
	for (const StageTime& time : stages)
		EXPECT_GE(time.seconds, 0.01);
}

/// Also after the end of a stage, and after a restart.
TEST_F(StageClocks, CountTheTimeBeforeAStageInTheStage)
{
	const auto wait = [] { std::this_thread::sleep_for(std::chrono::milliseconds(5)); };
	StageClock clock(workers_, Pipeline::Remeshing);
	wait();
	clock.restart({0, 1});
	wait();
	clock.enter(Stage::Load);
	clock.finish();
	wait();
	clock.enter(Stage::Order);
	const std::vector<StageTime>& stages = clock.finish();
	ASSERT_EQ(stages.size(), 2u);
	EXPECT_GE(stages[0].seconds, 0.01);
	EXPECT_GE(stages[1].seconds, 0.005);
}

TEST_F(StageClocks, AddTheTimesOfAnotherClock)
{
	StageClock clock(workers_, Pipeline::Remeshing);
	clock.enter(Stage::Load);
	clock.finish();
	std::this_thread::sleep_for(std::chrono::milliseconds(20));
	clock.add({{"load", 100}, {"order", 10}});
	clock.enter(Stage::Export);
	const std::vector<StageTime>& stages = clock.finish();
	ASSERT_EQ(stages.size(), 3u);
	EXPECT_GE(stages[0].seconds, 100);
	EXPECT_EQ(stages[1].stage, "order");
	EXPECT_EQ(stages[1].seconds, 10);
	EXPECT_LT(stages[2].seconds, 0.02) << "the time of the other clock is not counted twice";
}

TEST_F(StageClocks, TellTheShareOfTheStageBefore)
{
	StageClock clock(workers_, Pipeline::Remeshing);
	clock.enter(Stage::Sampling);
	EXPECT_EQ(shareNow(), 0);
	clock.enter(Stage::Retriangulation);
	EXPECT_DOUBLE_EQ(shareNow(), shareAtEnd(Stage::Sampling, Pipeline::Remeshing));
}

TEST_F(StageClocks, WaitWhereStagesAreGoneThroughAgain)
{
	StageClock clock(workers_, Pipeline::Remeshing);
	clock.enter(Stage::Relaxation);
	const double done = shareAtEnd(Stage::Relaxation, Pipeline::Remeshing);
	clock.enter(Stage::Load);
	EXPECT_DOUBLE_EQ(shareNow(), done);
	clock.enter(Stage::Sampling);
	EXPECT_DOUBLE_EQ(shareNow(), done);
}

TEST_F(StageClocks, BeginAnewWithOtherWork)
{
	StageClock clock(workers_, Pipeline::Remeshing);
	clock.enter(Stage::Sampling);
	clock.restart({0.5, 1});
	EXPECT_TRUE(clock.finish().empty());
	clock.enter(Stage::Load);
	EXPECT_DOUBLE_EQ(shareNow(), 0.5);
}

TEST_F(StageClocks, GiveAnotherPipelineTheFirstPart)
{
	StageClock clock(workers_, Pipeline::Remeshing, {0.2, 0.6});
	clock.beginFirstPart(Pipeline::Detection, 0.5);
	clock.enter(Stage::Detection);
	EXPECT_DOUBLE_EQ(shareNow(), 0.2);
	clock.enter(Stage::Export);
	EXPECT_DOUBLE_EQ(shareNow(), 0.2 + 0.2 * shareAtEnd(Stage::Detection, Pipeline::Detection));
	clock.endFirstPart();
	clock.enter(Stage::Load);
	EXPECT_DOUBLE_EQ(shareNow(), 0.4) << "the rest begins";
	clock.enter(Stage::Export);
	EXPECT_DOUBLE_EQ(shareNow(), 0.4 + 0.2 * shareAtEnd(Stage::Load, Pipeline::Remeshing));
}

} // namespace

} // namespace gpr::test
