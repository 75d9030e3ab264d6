// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "json_parts.h"

namespace gpr::app {

Json figuresJson(const MeshFigures& m)
{
	return {{"vertices", m.vertices},
			{"faces", m.faces},
			{"components", m.components},
			{"boundaryLoops", m.boundaryLoops},
			{"eulerCharacteristic", m.eulerCharacteristic},
			{"area", m.area},
			{"diagonal", m.diagonal}};
}

Json fileJson(const std::string& path, bool doublePrecision, const MeshFigures& figures)
{
	Json json = {{"file", path}, {"precision", doublePrecision ? "double" : "float"}};
	json.update(figuresJson(figures));
	return json;
}

Json qualityJson(const QualityFigures& q)
{
	return {{"radiusRatio", {{"mean", q.radiusRatioMean}, {"min", q.radiusRatioMin}}},
			{"aspectRatio", {{"mean", q.aspectRatioMean}, {"min", q.aspectRatioMin}}},
			{"angles",
			 {{"min", q.minAngleDeg},
			  {"meanOfMinimum", q.meanMinAngleDeg},
			  {"max", q.maxAngleDeg},
			  {"below30Percent", q.below30Percent}}},
			{"valence6Percent", q.valence6Percent},
			{"meanEdgeLength", q.meanEdgeLen}};
}

Json programJson()
{
	return {{"name", "gpremesh"}, {"version", GPR_VERSION}};
}

std::string textOf(const Json& json)
{
	return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace gpr::app
