// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The table of stages, the source of reports and progress bars.

#include <tests/support/stages_of.h>
#include <vcg_extras/core/base/stages.h>

#include <gtest/gtest.h>
#include <set>
#include <string>

namespace gpr::test {

namespace {

class Pipelines : public ::testing::TestWithParam<Pipeline> {};

TEST(StageTable, HasEveryStageAtItsPlace)
{
	std::size_t place = 0;
	for (const StageRow& row : stageTable)
		EXPECT_EQ(std::size_t(row.stage), place++) << row.key;
	EXPECT_EQ(std::size_t(Stage::Export) + 1, place) << "Export is the last stage";
}

TEST(StageTable, HasNoStageThatNoPipelineGoesThrough)
{
	for (const StageRow& row : stageTable) {
		EXPECT_STRNE(row.phrase, "") << row.key;
		bool isUsed = false;
		for (double until : row.until)
			isUsed = isUsed || until > 0;
		EXPECT_TRUE(isUsed) << row.key;
	}
}

TEST_P(Pipelines, HaveAKeyOfItsOwnForEveryStage)
{
	std::set<std::string> keys, phrases;
	for (Stage stage : stagesOf(GetParam())) {
		EXPECT_TRUE(keys.insert(rowOf(stage).key).second) << rowOf(stage).key;
		EXPECT_TRUE(phrases.insert(rowOf(stage).phrase).second) << rowOf(stage).phrase;
	}
}

TEST_P(Pipelines, RiseFromStageToStageUpToTheWhole)
{
	double last = 0;
	for (Stage stage : stagesOf(GetParam())) {
		const double share = shareAtEnd(stage, GetParam());
		EXPECT_GT(share, last) << rowOf(stage).key;
		last = share;
	}
	EXPECT_EQ(last, 1);
}

TEST_P(Pipelines, BeginWithTheInputAndEndWithTheExport)
{
	const std::vector<Stage> stages = stagesOf(GetParam());
	ASSERT_GE(stages.size(), 3u);
	EXPECT_EQ(stages.front(), Stage::Load);
	EXPECT_EQ(stages.back(), Stage::Export);
}

INSTANTIATE_TEST_SUITE_P(, Pipelines,
						 ::testing::Values(Pipeline::Remeshing, Pipeline::Sampling,
										   Pipeline::Retriangulation, Pipeline::Detection));

} // namespace

} // namespace gpr::test
