// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vcg_extras/core/options.h>
#include <vcg_extras/core/parameters.h>
#include <vcg_extras/core/remesh.h>

#include <cmath>
#include <gtest/gtest.h>
#include <set>
#include <string>

namespace gpr::test {

namespace {

RemeshOptions withCount(std::int64_t n)
{
	RemeshOptions o;
	o.targetMode      = TargetMode::VertexNum;
	o.targetVertexNum = n;
	return o;
}

RemeshOptions withPercent(double p)
{
	RemeshOptions o;
	o.targetPercent = p;
	return o;
}

RemeshOptions withEdgeLen(double l)
{
	RemeshOptions o;
	o.targetMode    = TargetMode::EdgeLength;
	o.targetEdgeLen = l;
	return o;
}

TEST(Validate, DefaultsAreInOrder)
{
	EXPECT_TRUE(validate(RemeshOptions()).empty());
	EXPECT_TRUE(validate(withCount(1)).empty());
	EXPECT_TRUE(validate(withPercent(10000)).empty());
	EXPECT_TRUE(validate(withEdgeLen(1e-12)).empty());
}

TEST(Validate, ComplainsOfEveryValueOutOfRangeInASentence)
{
	RemeshOptions steps, flips, threads, lambda, adapt, scale, weak, both;
	flips.flipPasses               = -1;
	lambda.lambda                  = NAN;
	adapt.adapt                    = 1.5;
	scale.featureDiskScale         = 0.01;
	weak.featureThresholds.weakDeg = 50;
	steps.umbrellaSteps            = 1001;
	threads.threads                = -1;
	both.umbrellaSteps             = -1;
	both.threads                   = 2000;
	for (const RemeshOptions& o :
		 {withCount(0), withCount(-5), withCount(std::int64_t(1) << 31), withPercent(0),
		  withPercent(-1), withPercent(10001), withPercent(NAN), withEdgeLen(0), withEdgeLen(-1),
		  withEdgeLen(NAN), withEdgeLen(HUGE_VAL), steps, flips, threads, lambda, adapt, scale,
		  weak}) {
		const std::vector<std::string> complaints = validate(o);
		ASSERT_EQ(complaints.size(), 1u);
		EXPECT_EQ(complaints[0].back(), '.');
	}
	EXPECT_EQ(validate(both).size(), 2u);
}

/// Only the target in use is checked.
TEST(Validate, LeavesTargetsAloneThatAreNotUsed)
{
	RemeshOptions o = withCount(5);
	o.targetPercent = -1;
	o.targetEdgeLen = NAN;
	EXPECT_TRUE(validate(o).empty());
}

TEST(ParameterTable, KeysAndOptionsAreUniqueAndComplete)
{
	std::set<std::string> keys, options;
	for (const Parameter& p : remeshParameters()) {
		EXPECT_TRUE(keys.insert(p.key).second) << p.key;
		EXPECT_TRUE(options.insert(p.option).second) << p.option;
		EXPECT_EQ(std::string(p.option).substr(0, 2), "--");
		EXPECT_EQ(findParameter(p.key), &p);
		EXPECT_STRNE(p.label, "");
		EXPECT_EQ(std::string(p.help).back(), '.') << p.key << ": full sentences";
		EXPECT_LT(p.minimum, p.maximum);
		EXPECT_EQ(p.kind == ParameterKind::Choice, !p.choices.empty());
		ASSERT_NE(p.defaultValue, nullptr);
		ASSERT_NE(p.store, nullptr);
	}
	for (const char* key : {"TargetVertexNum", "TargetPerc", "TargetLen", "RelaxIter", "Seed",
							"Threads", "AllowNearest"})
		EXPECT_EQ(keys.count(key), 1u) << key << " is public";
	EXPECT_EQ(findParameter("Nonsense"), nullptr);
}

/// Options that a user really states, and choices that the paper leaves to the user.
TEST(ParameterTable, HasAtMostThirtyFourRows)
{
	EXPECT_LE(makeParameterTable().size(), 34u);
}

/// The everyday options: how many, how, which lines, where to.
TEST(ParameterTable, AtMostTwelveParametersComeBeforeThoseForExperts)
{
	for (Tool tool : {RemeshTool, SamplingTool}) {
		const std::vector<Parameter>& rows = parametersOf(tool);
		std::size_t                   num  = 0;
		while (num < rows.size() && !rows[num].isExpert)
			++num;
		EXPECT_LE(num, 12u);
		for (std::size_t i = num; i < rows.size(); ++i)
			EXPECT_TRUE(rows[i].isExpert) << rows[i].key;
		for (const char* key :
			 {"TargetVertexNum", "Adapt", "Lambda", "Features", "FeatureDiskScale"})
			EXPECT_FALSE(findParameter(key, tool)->isExpert) << key;
	}
}

TEST(ParameterTable, DialogsDoNotSpeakOfTheCommandLineNorItOfDialogs)
{
	const auto has = [](const std::string& text, const char* word) {
		return text.find(word) != std::string::npos;
	};
	for (const Parameter& p : makeParameterTable()) {
		EXPECT_FALSE(has(dialogHelp(p), "command line")) << p.key;
		EXPECT_FALSE(has(commandHelp(p), "dialog") || has(commandHelp(p), "layer")) << p.key;
		EXPECT_EQ(dialogHelp(p).back(), '.') << p.key;
		EXPECT_EQ(commandHelp(p).back(), '.') << p.key;
	}
}

TEST(ParameterTable, DefaultsFitTheirKindAndRange)
{
	for (const MeshFacts& facts : {MeshFacts{0, 0}, MeshFacts{3, 1}, MeshFacts{134345, 2.5}}) {
		for (const Parameter& p : remeshParameters()) {
			const ParameterValue v      = p.defaultValue(facts);
			double               number = 0;
			switch (p.kind) {
			case ParameterKind::Count:
			case ParameterKind::Choice:
				number = double(std::get<std::int64_t>(v));
				break;
			case ParameterKind::Number:
			case ParameterKind::Length:
				ASSERT_EQ(std::holds_alternative<Automatic>(v), p.isAutomatic) << p.key;
				number = p.isAutomatic ? p.minimum : std::get<double>(v);
				break;
			case ParameterKind::Switch:
				number = std::get<bool>(v);
				break;
			}
			EXPECT_TRUE(number >= p.minimum && number <= p.maximum) << p.key;
		}
	}
	EXPECT_EQ(std::get<std::int64_t>(findParameter("TargetVertexNum")->defaultValue({134345, 1})),
			  13435);
}

class ParameterSets : public ::testing::Test {
protected:
	ParameterSet set_;

	void set(const char* key, const ParameterValue& value) { set_.set(*findParameter(key), value); }
};

TEST_F(ParameterSets, DefaultsGiveDefaultOptionsWithTheCountOfTheTable)
{
	for (const Parameter& p : remeshParameters())
		set_.set(p, p.defaultValue({1000, 1}));
	const RemeshOptions o = set_.options(), plain;
	EXPECT_EQ(o.targetMode, TargetMode::VertexNum);
	EXPECT_EQ(o.targetVertexNum, 100);
	EXPECT_EQ(o.preset, plain.preset);
	EXPECT_EQ(o.adapt, plain.adapt);
	EXPECT_EQ(o.umbrellaSteps, plain.umbrellaSteps);
	EXPECT_EQ(o.seed, plain.seed);
	EXPECT_EQ(o.threads, plain.threads);
	EXPECT_EQ(o.allowNearest, plain.allowNearest);
	EXPECT_TRUE(set_.complaints().empty());
}

TEST_F(ParameterSets, NothingSetMeansTenPercent)
{
	EXPECT_EQ(set_.options().targetMode, TargetMode::Percent);
	EXPECT_EQ(set_.options().targetPercent, 10);
	EXPECT_TRUE(set_.complaints().empty());
}

TEST_F(ParameterSets, PercentageOrLengthTakeThePlaceOfTheCountInAnyOrder)
{
	set("TargetPerc", 25.0);
	set("TargetVertexNum", std::int64_t(500));
	EXPECT_EQ(set_.options().targetMode, TargetMode::Percent);
	EXPECT_EQ(set_.options().targetPercent, 25);
	set("TargetPerc", 0.0);
	EXPECT_EQ(set_.options().targetMode, TargetMode::VertexNum);
	set("TargetLen", 0.5);
	EXPECT_EQ(set_.options().targetMode, TargetMode::EdgeLength);
	EXPECT_EQ(set_.options().targetEdgeLen, 0.5);
	EXPECT_TRUE(set_.complaints().empty());
}

TEST_F(ParameterSets, BothAboveZeroIsTold)
{
	set("TargetPerc", 25.0);
	set("TargetLen", 0.5);
	EXPECT_EQ(set_.complaints().size(), 1u);
}

TEST_F(ParameterSets, ValuesOutOfRangeAreTold)
{
	set("TargetPerc", -3.0);
	EXPECT_FALSE(set_.complaints().empty());
	set("TargetPerc", 0.0);
	set("RelaxIter", std::int64_t(5000));
	EXPECT_FALSE(set_.complaints().empty());
}

TEST_F(ParameterSets, EveryRowReachesItsOption)
{
	set("Preset", std::int64_t(2));
	set("Adapt", 0.1);
	set("RelaxIter", std::int64_t(5));
	set("FlipIter", std::int64_t(6));
	set("Seed", std::int64_t(77));
	set("Threads", std::int64_t(2));
	set("AllowNearest", true);
	set("DropComponentsBelow", std::int64_t(9));
	set("TimeLimit", 60.0);
	const RemeshOptions o = set_.options();
	EXPECT_EQ(o.preset, Preset::Paper);
	EXPECT_EQ(o.adapt, 0.1) << "a number that is given, and not what is usual";
	EXPECT_EQ(o.umbrellaSteps, 5);
	EXPECT_EQ(o.flipPasses, 6);
	EXPECT_EQ(o.seed, 77u);
	EXPECT_EQ(o.threads, 2);
	EXPECT_TRUE(o.allowNearest);
	EXPECT_EQ(o.dropComponentsBelow, 9);
	EXPECT_EQ(o.timeLimitSeconds, 60);
	set("Adapt", Automatic());
	EXPECT_FALSE(set_.options().adapt.has_value());
}

TEST_F(ParameterSets, ALargestErrorTakesThePlaceOfTheCountAndOfNoOtherSize)
{
	set("TargetVertexNum", std::int64_t(500));
	set("MaxError", 0.25);
	EXPECT_EQ(set_.options().targetMode, TargetMode::MaxError);
	EXPECT_EQ(set_.options().targetMaxError, 0.25);
	EXPECT_TRUE(set_.complaints().empty());
	set("TargetPerc", 10.0);
	EXPECT_EQ(set_.complaints().size(), 1u);
}

TEST_F(ParameterSets, ANumberOfFacesTakesThePlaceOfThatOfVerticesAndOfNoOtherSize)
{
	set("TargetVertexNum", std::int64_t(500));
	set("TargetFaceNum", std::int64_t(1024));
	EXPECT_EQ(set_.options().targetMode, TargetMode::FaceNum);
	EXPECT_EQ(set_.options().targetFaceNum, 1024);
	EXPECT_TRUE(set_.complaints().empty());
	for (const char* other : {"TargetPerc", "TargetLen", "MaxError"}) {
		set(other, 10.0);
		EXPECT_EQ(set_.complaints().size(), 1u) << other;
		set(other, 0.0);
	}
}

TEST_F(ParameterSets, ADetailTakesThePlaceOfTheCountAndOfNoOtherSize)
{
	set("TargetVertexNum", std::int64_t(500));
	set("Detail", std::int64_t(2));
	EXPECT_EQ(set_.options().targetMode, TargetMode::Detail);
	EXPECT_EQ(set_.options().targetDetail, Detail::Normal);
	EXPECT_TRUE(set_.complaints().empty());
	set("TargetFaceNum", std::int64_t(500));
	EXPECT_EQ(set_.complaints().size(), 1u);
}

TEST(StatusName, IsOneOfItsOwnForEveryStatus)
{
	std::set<std::string> names;
	for (Status s :
		 {Status::Ok, Status::BadOptions, Status::UnusableInput, Status::CountTooSmall,
		  Status::PromiseBroken, Status::OutOfMemory, Status::Cancelled, Status::InternalError})
		EXPECT_TRUE(names.insert(statusName(s)).second);
	EXPECT_EQ(names.count("unknown"), 0u);
}

TEST(FeatureRegionByItself, IsAskedForByADiskScale)
{
	RemeshOptions none, scale, off;
	scale.featureDiskScale = 0.3;
	off.featureDiskScale   = 0.3;
	off.featureRegion      = FeatureRegion::None;
	for (const bool anySelected : {false, true}) {
		for (RemeshOptions o : {none, off}) {
			resolveFeatureRegion(anySelected, o);
			EXPECT_EQ(o.featureRegion, FeatureRegion::None);
		}
		resolveFeatureRegion(anySelected, scale);
		EXPECT_EQ(scale.featureRegion,
				  anySelected ? FeatureRegion::Selection : FeatureRegion::Detected);
		scale.featureRegion = FeatureRegion::Auto;
	}
}

TEST(FeatureRegionByItself, HasHalfTheRadiusWhereItIsNamedAndNoScaleGiven)
{
	RemeshOptions o;
	o.featureRegion = FeatureRegion::Detected;
	resolveFeatureRegion(true, o);
	EXPECT_EQ(o.featureRegion, FeatureRegion::Detected);
	EXPECT_EQ(o.featureDiskScale, 0.5);
	EXPECT_FALSE(keepsRegionVertices(o));
	o.featureDiskScale = 0.8;
	resolveFeatureRegion(true, o);
	EXPECT_EQ(o.featureDiskScale, 0.8);
}

/// The paper has two ways: every vertex of the region, or disks of the given scale.
TEST(FeatureRegionByItself, IsKeptWithThePaperUnlessAScaleIsGiven)
{
	RemeshOptions o;
	o.preset        = Preset::Paper;
	o.featureRegion = FeatureRegion::Detected;
	resolveFeatureRegion(false, o);
	EXPECT_TRUE(keepsRegionVertices(o));
	o.featureDiskScale = 0.8;
	resolveFeatureRegion(false, o);
	EXPECT_FALSE(keepsRegionVertices(o));
}

TEST(OptionsWithoutEffect, AreNamedInASentenceEach)
{
	EXPECT_TRUE(optionsWithoutEffect(RemeshOptions()).empty());
	RemeshOptions adapt, steps, flips, scale, whole;
	adapt.adapt            = 1;
	adapt.preset           = Preset::Paper;
	steps.umbrellaSteps    = 5;
	flips.flipPasses       = 5;
	scale.featureDiskScale = 0.3;
	scale.featureRegion    = FeatureRegion::None;
	whole.featureRegion    = FeatureRegion::Detected;
	whole.featureDiskScale = 1;
	for (const RemeshOptions& o : {adapt, steps, flips, scale, whole}) {
		const std::vector<std::string> sentences = optionsWithoutEffect(o);
		ASSERT_EQ(sentences.size(), 1u);
		EXPECT_EQ(sentences[0].back(), '.');
	}
}

TEST(OptionsWithoutEffect, AreNotNamedWhereTheyHaveOne)
{
	RemeshOptions adapt, steps, scale;
	adapt.adapt            = 1;
	steps.preset           = Preset::Paper;
	steps.umbrellaSteps    = 5;
	steps.flipPasses       = 5;
	scale.featureRegion    = FeatureRegion::Selection;
	scale.featureDiskScale = 0.3;
	for (const RemeshOptions& o : {adapt, steps, scale})
		EXPECT_TRUE(optionsWithoutEffect(o).empty());
}

TEST(ResolveAdapt, ATenthWhereAFitFollows)
{
	RemeshOptions o;
	EXPECT_EQ(resolveAdapt(o, true), 0.1);
	EXPECT_EQ(resolveAdapt(o, false), 0) << "only samples";
	o.preset = Preset::FastFitted;
	EXPECT_EQ(resolveAdapt(o, true), 0.1);
	o.preset = Preset::Fast;
	EXPECT_EQ(resolveAdapt(o, true), 0);
	o        = RemeshOptions();
	o.lambda = 1;
	EXPECT_EQ(resolveAdapt(o, true), 0) << "another density";
	o            = RemeshOptions();
	o.targetMode = TargetMode::MaxError;
	EXPECT_EQ(resolveAdapt(o, true), 1);
	o.preset = Preset::Fast;
	EXPECT_EQ(resolveAdapt(o, true), 0);
}

/// A given 0.1, the value of 'auto', holds like any other number.
TEST(ResolveAdapt, WhatWasGivenHolds)
{
	for (const double given : {0.0, 0.1, 0.3}) {
		RemeshOptions o;
		o.adapt      = given;
		o.targetMode = TargetMode::MaxError;
		o.lambda     = 1;
		o.preset     = Preset::Fast;
		EXPECT_EQ(resolveAdapt(o, false), given);
		o.preset = Preset::Paper;
		EXPECT_EQ(resolveAdapt(o, true), 0) << "the paper has no such thing";
	}
}

} // namespace

} // namespace gpr::test
