// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters.h"

#include <utility>

namespace gpr {

namespace {

std::vector<Parameter> rowsOf(Tool tool)
{
	std::vector<Parameter> rows;
	for (Parameter& p : makeParameterTable()) {
		if (p.tools & tool) rows.push_back(p);
	}
	return rows;
}

} // namespace

const std::vector<Parameter>& parametersOf(Tool tool)
{
	static const std::map<Tool, std::vector<Parameter>> rows = {
		{RemeshTool, rowsOf(RemeshTool)},
		{SamplingTool, rowsOf(SamplingTool)},
		{RetriangulateTool, rowsOf(RetriangulateTool)},
		{FeatureTool, rowsOf(FeatureTool)}};
	return rows.at(tool);
}

const Parameter* findParameter(const std::string& key, Tool tool)
{
	for (const Parameter& p : parametersOf(tool)) {
		if (key == p.key) return &p;
	}
	return nullptr;
}

bool isSizeParameter(const Parameter& p)
{
	const std::string key = p.key;
	return key == "TargetVertexNum" || key == "TargetFaceNum" || key == "TargetPerc" ||
		   key == "TargetLen" || key == "MaxError" || key == "Detail";
}

void ParameterSet::set(const Parameter& parameter, const ParameterValue& value)
{
	given_.insert_or_assign(parameter.key, Given{&parameter, value});
}

/// The given values; sizes without a value are 0.
RemeshOptions ParameterSet::raw() const
{
	RemeshOptions o;
	o.targetPercent = 0;
	for (const auto& [key, row] : given_)
		row.parameter->store(row.value, o);
	return o;
}

RemeshOptions ParameterSet::options() const
{
	RemeshOptions o = raw();
	// The first given size counts.
	const std::pair<bool, TargetMode> sizes[] = {
		{o.targetMaxError != 0, TargetMode::MaxError},
		{o.targetDetail != Detail::None, TargetMode::Detail},
		{o.targetEdgeLen != 0, TargetMode::EdgeLength},
		{o.targetPercent != 0, TargetMode::Percent},
		{o.targetFaceNum != 0, TargetMode::FaceNum},
		{o.targetVertexNum != 0, TargetMode::VertexNum},
		{o.maxEdge > 0, TargetMode::Sizes}};
	for (const auto& [isGiven, mode] : sizes) {
		if (!isGiven) continue;
		o.targetMode = mode;
		return o;
	}
	o.targetMode    = TargetMode::Percent;
	o.targetPercent = RemeshOptions().targetPercent;
	return o;
}

std::vector<std::string> ParameterSet::complaints() const
{
	std::vector<std::string> sentences = validate(options());
	const RemeshOptions      given     = raw();
	if (given.targetEdgeLen != 0 && given.targetPercent != 0) {
		sentences.push_back("Give either a percentage or an edge length, not both.");
	}
	if (given.targetMaxError != 0 && (given.targetEdgeLen != 0 || given.targetPercent != 0)) {
		sentences.push_back("Give either a size or a largest error, not both.");
	}
	const bool hasOther =
		given.targetPercent != 0 || given.targetEdgeLen != 0 || given.targetMaxError != 0;
	if (given.targetDetail != Detail::None && (hasOther || given.targetFaceNum != 0))
		sentences.push_back("Give either a detail or another size, not both.");
	if (given.targetFaceNum != 0 && hasOther) {
		sentences.push_back("Give either a number of faces or another size, not both.");
	}
	return sentences;
}

} // namespace gpr
