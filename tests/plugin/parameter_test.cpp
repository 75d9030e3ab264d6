// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The parameter table, the dialog, the shipped scripts: the same thing three times.

#include "filter_text.h"
#include "host.h"
#include "parameter_bridge.h"

#include <cmath>
#include <common/filterscript.h>
#include <gtest/gtest.h>
#include <limits>

namespace {

using namespace plugin_test;
using gpr::TargetMode;

constexpr gpr::Tool tools[] = {gpr::RemeshTool, gpr::SamplingTool, gpr::RetriangulateTool,
							   gpr::FeatureTool, gpr::CompareTool};

gpr::MeshFacts facts()
{
	gpr::MeshFacts known;
	known.vertexNum = 1000;
	known.diagonal  = 2;
	return known;
}

RichParameterList tableList(gpr::Tool tool = gpr::RemeshTool)
{
	RichParameterList list;
	gpr_filter::fillParameterList(gpr::parametersOf(tool), facts(), list);
	return list;
}

gpr_filter::ReadParameters read(const RichParameterList& list, gpr::Tool tool = gpr::RemeshTool)
{
	return gpr_filter::readParameterList(gpr::parametersOf(tool), facts(), list);
}

void expectDialogLikeTable(gpr::Tool tool)
{
	Document document;
	addBall(document);
	const RichParameterList list = defaults(document, tool);
	ASSERT_EQ(list.size(), gpr::parametersOf(tool).size());
	unsigned i = 0;
	for (const gpr::Parameter& row : gpr::parametersOf(tool)) {
		EXPECT_EQ(list.at(i).name().toStdString(), row.key);
		EXPECT_EQ(list.at(i).fieldDescription().toStdString(), row.label);
		EXPECT_EQ(list.at(i).toolTip().toStdString(), gpr::dialogHelp(row));
		++i;
	}
}

TEST(Parameters, DialogHasEveryRowInOrder)
{
	for (gpr::Tool tool : tools) {
		expectDialogLikeTable(tool);
	}
}

TEST(Parameters, DialogProposesTheNewestLayerOfPoints)
{
	Document document;
	addPoints(document, {{0, 0, 0}});
	const MeshModel& points = addPoints(document, {{0, 0, 0}});
	addSheet(document);
	addBall(document);
	EXPECT_EQ(defaults(document, gpr::RetriangulateTool).getInt("SampleLayer"), points.id());
	Document alone;
	addBall(alone);
	EXPECT_EQ(defaults(alone, gpr::RetriangulateTool).getInt("SampleLayer"), 1);
}

TEST(Parameters, DefaultsAreTheEngines)
{
	const gpr_filter::ReadParameters got = read(tableList());
	ASSERT_TRUE(got.complaints.empty()) << got.complaints.front();
	const gpr::RemeshOptions options = got.values.options();
	const gpr::RemeshOptions engine;
	EXPECT_EQ(options.targetMode, TargetMode::VertexNum);
	EXPECT_EQ(options.targetVertexNum, 100);
	EXPECT_EQ(options.relaxIterations, engine.relaxIterations);
	EXPECT_EQ(options.exactCount, engine.exactCount);
	EXPECT_EQ(options.allowNearest, engine.allowNearest);
	EXPECT_EQ(options.seed, engine.seed);
	EXPECT_EQ(options.threads, engine.threads);
	EXPECT_FALSE(got.values.newLayer());
}

TEST(Parameters, ValuesComeThroughTheList)
{
	RichParameterList list = tableList();
	list.setValue("TargetVertexNum", IntValue(321));
	list.setValue("RelaxIter", IntValue(7));
	list.setValue("ExactCount", EnumValue(2));
	list.setValue("AllowNearest", BoolValue(true));
	list.setValue("Seed", IntValue(2147483647));
	list.setValue("Threads", IntValue(3));
	list.setValue("NewLayer", BoolValue(true));
	const gpr_filter::ReadParameters got = read(list);
	ASSERT_TRUE(got.complaints.empty()) << got.complaints.front();
	const gpr::RemeshOptions options = got.values.options();
	EXPECT_EQ(options.targetVertexNum, 321);
	EXPECT_EQ(options.relaxIterations, 7);
	EXPECT_FALSE(options.exactCount);
	EXPECT_TRUE(options.allowNearest);
	EXPECT_EQ(options.seed, 2147483647u);
	EXPECT_EQ(options.threads, 3);
	EXPECT_TRUE(got.values.newLayer());
}

TEST(Parameters, PercentAndLengthTakeTheCountsPlace)
{
	RichParameterList list = tableList();
	list.setValue("TargetPerc", FloatValue(Scalarm(12.3)));
	EXPECT_EQ(read(list).values.options().targetMode, TargetMode::Percent);
	EXPECT_EQ(read(list).values.options().targetPercent, 12.3); // as --percent 12.3 gives it
	list = tableList();
	list.setValue("TargetLen", AbsPercValue(Scalarm(0.05)));
	EXPECT_EQ(read(list).values.options().targetMode, TargetMode::EdgeLength);
	EXPECT_EQ(read(list).values.options().targetEdgeLen, 0.05);
	list.setValue("TargetPerc", FloatValue(10.f));
	EXPECT_FALSE(read(list).complaints.empty());
}

TEST(Parameters, WhatIsOutOfRangeIsToldAndNotWrapped)
{
	for (const char* key : {"TargetVertexNum", "RelaxIter", "Seed", "Threads"}) {
		RichParameterList list = tableList();
		list.setValue(key, IntValue(-1));
		const gpr_filter::ReadParameters got = read(list);
		ASSERT_EQ(got.complaints.size(), 1u) << key;
		EXPECT_NE(got.complaints.front().find(key), std::string::npos) << got.complaints.front();
	}
	RichParameterList list = tableList();
	list.setValue("TargetPerc", FloatValue(std::numeric_limits<float>::quiet_NaN()));
	EXPECT_FALSE(read(list).complaints.empty());
}

TEST(Parameters, MissingIsTheDefault)
{
	const gpr_filter::ReadParameters none = read(RichParameterList());
	ASSERT_TRUE(none.complaints.empty()) << none.complaints.front();
	EXPECT_EQ(none.values.options().targetVertexNum, 100); // 10 % of what facts() has
	RichParameterList list;
	list.addParam(RichInt("RelaxIter", 3));
	EXPECT_EQ(read(list).values.options().relaxIterations, 3);
	EXPECT_EQ(read(list).values.options().seed, 1u);
}

TEST(Parameters, WronglyTypedIsASentence)
{
	RichParameterList list;
	for (const gpr::Parameter& row : gpr::remeshParameters()) {
		list.addParam(RichString(row.key, "text"));
	}
	EXPECT_EQ(read(list).complaints.size(), gpr::remeshParameters().size());
}

TEST(Parameters, TypedNumberIsTheDecimalOne)
{
	for (double number : {0.0, 10.0, 12.3, 0.05, 1e-9, 33.3333, 1234.5}) {
		EXPECT_EQ(gpr_filter::typedNumber(float(number)), number);
		EXPECT_EQ(gpr_filter::typedNumber(number), number);
	}
	EXPECT_TRUE(std::isnan(gpr_filter::typedNumber(std::numeric_limits<float>::quiet_NaN())));
}

/// Opens the shipped script of a tool; its only filter is the tool's.
RichParameterList shippedScript(gpr::Tool tool)
{
	const gpr_filter::FilterText& text = gpr_filter::textOf(tool);
	FilterScript                  script;
	EXPECT_TRUE(script.open(QString(GPR_SCRIPT_DIR "/") + text.pythonName + ".mlx"));
	if (script.size() != 1) {
		ADD_FAILURE() << text.pythonName << " has " << script.size() << " filters";
		return {};
	}
	EXPECT_EQ(script.at(0).filterName().toStdString(), text.name);
	return script.at(0).second;
}

void expectCompleteScript(gpr::Tool tool)
{
	const RichParameterList inScript = shippedScript(tool);
	const RichParameterList inDialog = tableList(tool);
	ASSERT_EQ(inScript.size(), inDialog.size());
	for (unsigned i = 0; i < inDialog.size(); ++i) {
		const RichParameter& wanted = inDialog.at(i);
		const RichParameter& given  = inScript.at(i);
		EXPECT_EQ(given.name().toStdString(), wanted.name().toStdString());
		EXPECT_EQ(given.stringType().toStdString(), wanted.stringType().toStdString())
			<< wanted.name().toStdString();
	}
	EXPECT_TRUE(read(inScript, tool).complaints.empty());
}

// meshlabserver aborts on a script in which one parameter is missing.
TEST(Parameters, ShippedScriptsAreComplete)
{
	for (gpr::Tool tool : tools) {
		expectCompleteScript(tool);
	}
}

/// The number of vertices is what a user edits: nothing else in the script may override it.
TEST(Parameters, ShippedScriptsAskForTheDefaults)
{
	for (gpr::Tool tool : tools) {
		const gpr::RemeshOptions got = read(shippedScript(tool), tool).values.options();
		const gpr::RemeshOptions engine;
		if (gpr::findParameter("TargetVertexNum", tool) != nullptr) {
			EXPECT_EQ(got.targetMode, TargetMode::VertexNum);
			EXPECT_EQ(got.targetVertexNum, 10000);
		}
		EXPECT_EQ(got.relaxIterations, engine.relaxIterations);
		EXPECT_EQ(got.exactCount, engine.exactCount);
		EXPECT_EQ(got.allowNearest, engine.allowNearest);
		EXPECT_EQ(got.seed, engine.seed);
		EXPECT_EQ(got.threads, engine.threads);
	}
}

} // namespace
