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

constexpr gpr_filter::Filter filters[] = {gpr_filter::RemeshFilter, gpr_filter::SamplingFilter,
										  gpr_filter::RetriangulateFilter,
										  gpr_filter::FeatureFilter, gpr_filter::CompareFilter};

gpr::MeshFacts facts()
{
	gpr::MeshFacts known;
	known.vertexNum = 1000;
	known.diagonal  = 2;
	return known;
}

RichParameterList tableList(gpr_filter::Filter filter = gpr_filter::RemeshFilter)
{
	RichParameterList list;
	gpr_filter::fillParameterList(gpr_filter::rowsOf(filter), facts(), list);
	return list;
}

gpr_filter::ReadParameters read(const RichParameterList& list,
								gpr_filter::Filter       filter = gpr_filter::RemeshFilter)
{
	return gpr_filter::readParameterList(gpr_filter::rowsOf(filter), facts(), list);
}

void expectDialogLikeTable(gpr_filter::Filter filter)
{
	Document document;
	addBall(document);
	const RichParameterList list = defaults(document, filter);
	ASSERT_EQ(list.size(), gpr_filter::rowsOf(filter).size());
	unsigned i = 0;
	for (const gpr::Parameter& row : gpr_filter::rowsOf(filter)) {
		EXPECT_EQ(list.at(i).name().toStdString(), row.key);
		EXPECT_EQ(list.at(i).fieldDescription().toStdString(), gpr_filter::dialogLabel(row));
		EXPECT_EQ(list.at(i).toolTip().toStdString(), gpr::dialogHelp(row));
		++i;
	}
}

TEST(Parameters, DialogHasEveryRowInOrder)
{
	for (gpr_filter::Filter filter : filters) {
		expectDialogLikeTable(filter);
	}
}

TEST(Parameters, DialogProposesTheNewestLayerOfPoints)
{
	Document document;
	addPoints(document, {{0, 0, 0}});
	const MeshModel& points = addPoints(document, {{0, 0, 0}});
	addSheet(document);
	addBall(document);
	EXPECT_EQ(defaults(document, gpr_filter::RetriangulateFilter).getInt("SampleLayer"),
			  points.id());
	Document alone;
	addBall(alone);
	EXPECT_EQ(defaults(alone, gpr_filter::RetriangulateFilter).getInt("SampleLayer"), 1);
}

TEST(Parameters, DefaultsAreTheEngines)
{
	const gpr_filter::ReadParameters got = read(tableList());
	ASSERT_TRUE(got.complaints.empty()) << got.complaints.front();
	const gpr::RemeshOptions options = got.values.options();
	const gpr::RemeshOptions engine;
	EXPECT_EQ(options.targetMode, TargetMode::VertexNum);
	EXPECT_EQ(options.targetVertexNum, 100);
	EXPECT_EQ(options.preset, engine.preset);
	EXPECT_EQ(options.adapt, engine.adapt);
	EXPECT_EQ(options.umbrellaSteps, engine.umbrellaSteps);
	EXPECT_EQ(options.allowNearest, engine.allowNearest);
	EXPECT_EQ(options.seed, engine.seed);
	EXPECT_EQ(options.threads, engine.threads);
	EXPECT_FALSE(got.own<bool>("NewLayer"));
}

TEST(Parameters, ValuesComeThroughTheList)
{
	RichParameterList list = tableList();
	list.setValue("TargetVertexNum", IntValue(321));
	list.setValue("RelaxIter", IntValue(7));
	list.setValue("Preset", EnumValue(2));
	list.setValue("Adapt", FloatValue(Scalarm(0.1)));
	list.setValue("AllowNearest", BoolValue(true));
	list.setValue("Seed", IntValue(2147483647));
	list.setValue("Threads", IntValue(3));
	list.setValue("NewLayer", BoolValue(true));
	const gpr_filter::ReadParameters got = read(list);
	ASSERT_TRUE(got.complaints.empty()) << got.complaints.front();
	const gpr::RemeshOptions options = got.values.options();
	EXPECT_EQ(options.targetVertexNum, 321);
	EXPECT_EQ(options.umbrellaSteps, 7);
	EXPECT_EQ(options.preset, gpr::Preset::Paper);
	EXPECT_EQ(options.adapt, 0.1);
	EXPECT_TRUE(options.allowNearest);
	EXPECT_EQ(options.seed, 2147483647u);
	EXPECT_EQ(options.threads, 3);
	EXPECT_TRUE(got.own<bool>("NewLayer"));
}

TEST(Parameters, PercentAndLengthTakeTheCountsPlace)
{
	RichParameterList list = tableList();
	list.setValue("TargetPerc", FloatValue(Scalarm(12.3)));
	EXPECT_EQ(read(list).values.options().targetMode, TargetMode::Percent);
	EXPECT_EQ(read(list).values.options().targetPercent, 12.3); // as for --percent 12.3
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
	EXPECT_EQ(none.values.options().targetVertexNum, 100); // 10 % of the vertices of facts()
	RichParameterList list;
	list.addParam(RichInt("RelaxIter", 3));
	EXPECT_EQ(read(list).values.options().umbrellaSteps, 3);
	EXPECT_EQ(read(list).values.options().seed, 1u);
}

TEST(Parameters, WronglyTypedIsASentence)
{
	RichParameterList                  list;
	const std::vector<gpr::Parameter>& rows = gpr_filter::rowsOf(gpr_filter::RemeshFilter);
	for (const gpr::Parameter& row : rows) {
		list.addParam(RichString(row.key, "text"));
	}
	EXPECT_EQ(read(list).complaints.size(), rows.size());
}

TEST(Parameters, TypedNumberIsTheDecimalOne)
{
	for (double number : {0.0, 10.0, 12.3, 0.05, 1e-9, 33.3333, 1234.5}) {
		EXPECT_EQ(gpr_filter::typedNumber(float(number)), number);
		EXPECT_EQ(gpr_filter::typedNumber(number), number);
	}
	EXPECT_TRUE(std::isnan(gpr_filter::typedNumber(std::numeric_limits<float>::quiet_NaN())));
}

/// A number of no other use means 'auto', in both directions.
TEST(Parameters, TheAutomaticAdaptivityIsANumberOfItsOwn)
{
	RichParameterList list = tableList();
	EXPECT_EQ(list.getFloat("Adapt"), -1);
	EXPECT_FALSE(read(list).values.options().adapt.has_value());
	list.setValue("Adapt", FloatValue(Scalarm(-0.5)));
	EXPECT_EQ(read(list).complaints.size(), 1u);
}

/// The only filter of a script.
RichParameterList filterOf(const QString& path, const char* name)
{
	FilterScript script;
	EXPECT_TRUE(script.open(path));
	if (script.size() != 1) {
		ADD_FAILURE() << path.toStdString() << " has " << script.size() << " filters";
		return {};
	}
	EXPECT_EQ(script.at(0).filterName().toStdString(), name);
	return script.at(0).second;
}

/// A complete script of before, when each stage had a parameter.
TEST(OldScripts, WithTheDefaultsMeanTheDefaults)
{
	const char* const                name = gpr_filter::textOf(gpr_filter::RemeshFilter).name;
	const gpr_filter::ReadParameters got  = read(filterOf(GPR_DATA_DIR "/old_defaults.mlx", name));
	ASSERT_TRUE(got.complaints.empty()) << got.complaints.front();
	EXPECT_TRUE(got.notes.empty()) << got.notes.front();
	const gpr::RemeshOptions options = got.values.options(), engine;
	EXPECT_EQ(options.preset, engine.preset);
	EXPECT_FALSE(options.adapt.has_value()) << "0.1 meant none was chosen";
	EXPECT_EQ(options.targetVertexNum, 10000);
	EXPECT_TRUE(gpr::optionsWithoutEffect(options).empty());
}

TEST(OldScripts, TellWhatIsNotFollowed)
{
	const char* const name = gpr_filter::textOf(gpr_filter::RemeshFilter).name;
	RichParameterList list = filterOf(GPR_DATA_DIR "/old_defaults.mlx", name);
	list.setValue("Fit", EnumValue(3));
	list.setValue("MaxStretch", FloatValue(Scalarm(6)));
	list.setValue("Adapt", FloatValue(Scalarm(0.5)));
	const gpr_filter::ReadParameters got = read(list);
	ASSERT_TRUE(got.complaints.empty()) << got.complaints.front();
	ASSERT_EQ(got.notes.size(), 2u);
	EXPECT_NE(got.notes[0].find("Fit is gone"), std::string::npos) << got.notes[0];
	EXPECT_NE(got.notes[1].find("MaxStretch is gone"), std::string::npos) << got.notes[1];
	EXPECT_EQ(got.values.options().adapt, 0.5);
}

/// Opens the shipped script of a tool; its only filter is the tool's.
RichParameterList shippedScript(gpr_filter::Filter filter)
{
	const gpr_filter::FilterText& text = gpr_filter::textOf(filter);
	return filterOf(QString(GPR_SCRIPT_DIR "/") + text.pythonName + ".mlx", text.name);
}

void expectCompleteScript(gpr_filter::Filter filter)
{
	const RichParameterList inScript = shippedScript(filter);
	const RichParameterList inDialog = tableList(filter);
	ASSERT_EQ(inScript.size(), inDialog.size());
	for (unsigned i = 0; i < inDialog.size(); ++i) {
		const RichParameter& wanted = inDialog.at(i);
		const RichParameter& given  = inScript.at(i);
		EXPECT_EQ(given.name().toStdString(), wanted.name().toStdString());
		EXPECT_EQ(given.stringType().toStdString(), wanted.stringType().toStdString())
			<< wanted.name().toStdString();
	}
	EXPECT_TRUE(read(inScript, filter).complaints.empty());
}

// meshlabserver aborts on a script with a missing parameter.
TEST(Parameters, ShippedScriptsAreComplete)
{
	for (gpr_filter::Filter filter : filters) {
		expectCompleteScript(filter);
	}
}

/// A user edits the number of vertices: no other parameter of the script may override this number.
TEST(Parameters, ShippedScriptsAskForTheDefaults)
{
	for (gpr_filter::Filter filter : filters) {
		const gpr::RemeshOptions got = read(shippedScript(filter), filter).values.options();
		const gpr::RemeshOptions engine;
		if (gpr::findParameter("TargetVertexNum", gpr_filter::toolOf(filter)) != nullptr) {
			EXPECT_EQ(got.targetMode, TargetMode::VertexNum);
			EXPECT_EQ(got.targetVertexNum, 10000);
		}
		EXPECT_EQ(got.preset, engine.preset);
		EXPECT_EQ(got.adapt, engine.adapt);
		EXPECT_EQ(got.allowNearest, engine.allowNearest);
		EXPECT_EQ(got.seed, engine.seed);
		EXPECT_EQ(got.threads, engine.threads);
	}
}

} // namespace
