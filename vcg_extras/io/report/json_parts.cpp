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

Json distanceJson(const SurfaceDistance& d, double diagonal)
{
	const double percent = diagonal > 0 ? 100 / diagonal : 0;
	return {{"rms", d.rms},       {"rmsPercent", percent * d.rms},
			{"p999", d.p999},     {"p999Percent", percent * d.p999},
			{"hausdorff", d.max}, {"hausdorffPercent", percent * d.max}};
}

namespace {

Json boundsOfOne(const DistanceBounds& b, double diagonal)
{
	const double percent = diagonal > 0 ? 100 / diagonal : 0;
	return {{"lower", b.lower},
			{"upper", b.upper},
			{"lowerPercent", percent * b.lower},
			{"upperPercent", percent * b.upper},
			{"budgetSpent", b.isBudgetSpent}};
}

} // namespace

Json boundsJson(const MutualBounds& b, double diagonal)
{
	return {{"hausdorff", boundsOfOne(b.hausdorff(), diagonal)},
			{"toInput", boundsOfOne(b.toInput, diagonal)},
			{"fromInput", boundsOfOne(b.fromInput, diagonal)}};
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
