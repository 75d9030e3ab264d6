// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare_output.h"

#include <vcg_extras/io/report/json_parts.h>

namespace gpr::app {

namespace {

Json distanceJson(const CompareRecord& record, const DistanceFigures& d)
{
	return {{"rms", d.rms},
			{"rmsPercent", record.percentOfDiagonal(d.rms)},
			{"mean", d.mean},
			{"p999", d.p999},
			{"p999Percent", record.percentOfDiagonal(d.p999)},
			{"hausdorff", d.max},
			{"hausdorffPercent", record.percentOfDiagonal(d.max)},
			{"samples", d.sampleNum},
			{"vertices", d.vertexNum}};
}

Json methodJson(const CompareRecord& record, const MethodRecord& m)
{
	Json json = {{"key", m.key}, {"name", m.name}};
	if (!m.failure.empty()) {
		json["failure"] = m.failure;
		return json;
	}
	json["seconds"]          = {{"median", median(m.seconds)}, {"runs", m.seconds}};
	json["processorSeconds"] = {{"median", median(m.processorSeconds)},
								{"runs", m.processorSeconds}};
	json.update(figuresJson(m.record.figures));
	json["nonManifoldEdges"] = m.record.nonManifoldEdges;
	json["topologyKept"]     = m.topologyKept;
	json["toInput"]          = distanceJson(record, m.distance.toInput);
	json["fromInput"]        = distanceJson(record, m.distance.fromInput);
	json["error"]            = boundsJson(m.distance.proven, record.input.figures.diagonal);
	json["quality"]          = qualityJson(m.record.quality);
	return json;
}

} // namespace

std::string compareJson(const CompareRecord& record)
{
	Json json;
	json["program"] = programJson();
	json["input"]   = fileJson(record.line.input, record.inputDouble, record.input.figures);
	json["input"]["nonManifoldEdges"] = record.input.nonManifoldEdges;
	json["input"]["quality"]          = qualityJson(record.input.quality);
	json["cleanedInput"]              = figuresJson(record.cleanedInput);
	json["options"]                   = record.line.optionsText;
	json["seed"]                      = record.line.options.seed;
	json["threads"]                   = record.threads;
	json["runs"]                      = record.line.runNum;
	json["methods"]                   = Json::array();
	for (const MethodRecord& m : record.methods)
		json["methods"].push_back(methodJson(record, m));
	json["notes"] = record.notes;
	return textOf(json);
}

} // namespace gpr::app
