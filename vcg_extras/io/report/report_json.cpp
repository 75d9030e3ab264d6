// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report_json.h"

#include "json_parts.h"

#include <vcg_extras/core/parameters.h>
#include <vcg_extras/core/report_rows.h>

namespace gpr::app {

namespace {

/// By TargetMode.
constexpr const char* modeNames[] = {"vertices", "faces", "percent", "edgeLength",
									 "maxError", "sizes", "detail"};

/// The name of a value on the command line; options.h and the table have the same order.
template <class Value>
const char* choiceName(const char* key, Value value)
{
	return findParameter(key)->choices[std::size_t(value)];
}

Json featuresJson(const RemeshOptions& o)
{
	return {{"features", choiceName("Features", o.featureMode)},
			{"featureAngle", o.featureAngleDeg},
			{"featureRegion", choiceName("FeatureRegion", o.featureRegion)},
			{"featureDiskScale", o.featureDiskScale},
			{"featureSupport", o.featureThresholds.support},
			{"featureStrong", o.featureThresholds.strongDeg},
			{"featureWeak", o.featureThresholds.weakDeg},
			{"featureLength", o.featureThresholds.minLength}};
}

/// The options in force; of the sizes only the used size.
Json optionsJson(const RemeshOptions& o)
{
	const char* const mode = modeNames[int(o.targetMode)];
	Json              json = {{"target", mode}};
	if (o.targetMode == TargetMode::VertexNum) json[mode] = o.targetVertexNum;
	if (o.targetMode == TargetMode::FaceNum) json[mode] = o.targetFaceNum;
	if (o.targetMode == TargetMode::Percent) json[mode] = o.targetPercent;
	if (o.targetMode == TargetMode::EdgeLength)
		json[o.edgeLenIsPercent ? "edgeLengthPercent" : mode] = o.targetEdgeLen;
	if (o.targetMode == TargetMode::MaxError)
		json[o.maxErrorIsPercent ? "maxErrorPercent" : mode] = o.targetMaxError;
	if (o.targetMode == TargetMode::Detail) json[mode] = choiceName("Detail", o.targetDetail);
	json["preset"] = choiceName("Preset", o.preset);
	json["relax"]  = o.umbrellaSteps;
	json["flips"]  = o.flipPasses;
	json["lambda"] = o.lambda;
	json["adapt"]  = o.adapt ? Json(*o.adapt) : Json("auto");
	json[o.minEdgeIsPercent ? "minEdgePercent" : "minEdge"] = o.minEdge;
	json[o.maxEdgeIsPercent ? "maxEdgePercent" : "maxEdge"] = o.maxEdge;
	json["growth"]                                          = o.growth;
	json["boundary"]                                        = choiceName("Boundary", o.boundary);
	if (isPeriodic(o)) json["period"] = {o.period.x, o.period.y, o.period.z};
	json["junctions"]           = choiceName("Junctions", o.junctions);
	json["symmetry"]            = choiceName("Symmetry", o.symmetry);
	json["selectedOnly"]        = o.selectedOnly;
	json["allowNearest"]        = o.allowNearest;
	json["dropComponentsBelow"] = o.dropComponentsBelow;
	json["sew"]                 = o.sew;
	json["timeLimit"]           = o.timeLimitSeconds;
	json["check"]               = o.check;
	json.update(featuresJson(o));
	json["seed"]    = o.seed;
	json["threads"] = o.threads;
	return json;
}

/// One key a stage of the engine, then the parts of the total.
Json secondsJson(const std::vector<StageTime>& stages, const RunTimes& times)
{
	Json json = Json::object();
	for (const StageTime& s : stages)
		json[s.stage] = s.seconds;
	json["read"]   = times.read;
	json["remesh"] = times.remesh;
	json["write"]  = times.write;
	json["total"]  = times.total();
	return json;
}

Json cleanedJson(const CleanCounts& cleaned)
{
	Json json;
	for (const CountRow& row : describe(cleaned))
		json[row.key] = row.count;
	return json;
}

Json guardedJson(const AuditFigures& a, const MeshFigures& result)
{
	const GuardedFigures& g    = a.guarded;
	Json                  json = {{"tested", g.isTested}};
	if (!g.isTested) return json;
	const double share =
		result.vertices > 0 ? 100 * double(g.vertexNum) / double(result.vertices) : 0;
	json["pairsFound"]      = g.foundPairNum;
	json["facesOfInput"]    = g.inputFaceNum;
	json["pairsLeft"]       = g.pairNum;
	json["vertices"]        = g.vertexNum;
	json["verticesPercent"] = share;
	return json;
}

Json auditJson(const AuditFigures& a, const MeshFigures& result)
{
	return {{"passed", a.passed},
			{"nonManifoldEdges", a.nonManifoldEdges},
			{"nonManifoldVertices", a.nonManifoldVertices},
			{"duplicateFaces", a.duplicateFaces},
			{"zeroAreaFaces", a.zeroAreaFaces},
			{"invertedFaces", a.invertedFaces},
			{"flippedFaces", a.invertedFaces}, // the key of earlier versions
			{"nonFinitePositions", a.nonFinitePositions},
			{"componentsKept", a.componentsKept},
			{"boundaryLoopsKept", a.boundaryLoopsKept},
			{"eulerKept", a.eulerKept},
			{"junctionsKept", a.junctionsKept},
			{"countExact", a.countExact},
			{"guarded", guardedJson(a, result)}};
}

Json checkJson(const CheckFigures& c, double diagonal)
{
	return {{"selfIntersectingFaces", c.intersectingFaces},
			{"inputSelfIntersectingFaces", c.inputIntersectingFaces},
			{"crossingFaces", c.intersectingFaces}, // keys of earlier versions
			{"inputCrossingFaces", c.inputIntersectingFaces},
			{"vertexDistance", c.vertexDistance},
			{"largestDistance", c.largestDistance},
			{"p999Distance", c.distance.larger().p999},
			{"toInput", distanceJson(c.distance.toInput, diagonal)},
			{"fromInput", distanceJson(c.distance.fromInput, diagonal)}};
}

Json borderJson(const BorderFigures& b)
{
	return {{"length", b.length},
			{"resultLength", b.resultLength},
			{"lengthLostPercent", 100 * (1 - b.resultLength / b.length)}};
}

Json countsJson(const RemeshReport& r)
{
	return {{"targetVertices", r.targetVertexNum},
			{"regularVertices", r.regularVertexNum},
			{"samples", r.sampleNum},
			{"boundarySamples", r.boundarySampleNum},
			{"featureEdges", r.featureEdgeNum},
			{"featureConeApexes", r.featureConeApexNum},
			{"featureTips", r.featureConeApexNum}, // the key of earlier versions
			{"releasedLineVertices", r.releasedVertexNum},
			{"featureRegionVertices", r.regionVertexNum},
			{"keptVertices", r.keptVertexNum},
			{"curvatureClamped", r.curvatureClampedNum},
			{"leftoverVertices", r.leftoverVertexNum},
			{"untouchedFaces", r.untouchedFaceNum},
			{"splits", r.splitNum},
			{"collapses", r.collapseNum},
			{"flips", r.flipNum}};
}

Json errorJson(const RemeshReport& r)
{
	Json json = boundsJson(r.provenDistance, r.input.diagonal);
	if (r.errorTrialNum == 0) return json;
	json["goal"]    = r.errorGoal;
	json["largest"] = r.provenDistance.hausdorff().upper; // the key of earlier versions
	json["trials"]  = r.errorTrialNum;
	return json;
}

Json remeshJson(const RunRecord& run)
{
	const RemeshReport& r = run.report;
	Json                json;
	json["program"]      = programJson();
	json["input"]        = fileJson(run.inputPath, run.inputDouble, r.input);
	json["cleanedInput"] = figuresJson(r.cleanedInput);
	json["result"]       = fileJson(run.outputPath, run.outputDouble, r.result);
	for (const MadeFile& file : run.files)
		json["files"].push_back(
			{{"path", file.path}, {"vertices", file.vertices}, {"faces", file.faces}});
	json["options"]        = optionsJson(run.options);
	json["seed"]           = r.seed;
	json["adapt"]          = r.adapt;
	json["threads"]        = r.threads;
	json["diskRadius"]     = r.diskRadius;
	json["radiusConstant"] = r.radiusConstant;
	if (r.radiusConstantForTarget > 0) json["radiusConstantForTarget"] = r.radiusConstantForTarget;
	json["counts"]  = countsJson(r);
	json["seconds"] = secondsJson(r.stages, run.times);
	json["quality"] = qualityJson(r.quality);
	json["cleaned"] = cleanedJson(r.cleaned);
	json["audit"]   = auditJson(r.audit, r.result);
	if (r.check.done) json["check"] = checkJson(r.check, r.input.diagonal);
	if (r.border.isSmooth()) json["border"] = borderJson(r.border);
	if (r.isDistanceProven) json["error"] = errorJson(r);
	json["fitDistance"]     = r.largestFitDistance;
	json["capsReached"]     = r.capsReached;
	json["notes"]           = run.notes;
	json["peakMemoryBytes"] = run.peakMemoryBytes;
	return json;
}

Json regionsJson(const std::vector<MeshParts::Region>& regions)
{
	Json list = Json::array();
	for (const MeshParts::Region& region : regions) {
		Json json;
		json["label"]  = region.label;
		json["name"]   = region.name;
		json["faces"]  = region.faces;
		json["pieces"] = region.pieces;
		json["area"]   = region.area;
		list.push_back(std::move(json));
	}
	return list;
}

} // namespace

std::string remeshReportJson(const RunRecord& run)
{
	return textOf(remeshJson(run));
}

std::string levelsReportJson(const std::vector<RunRecord>& levels)
{
	Json json;
	json["program"] = programJson();
	json["levels"]  = Json::array();
	for (const RunRecord& run : levels)
		json["levels"].push_back(remeshJson(run));
	return textOf(json);
}

std::string meshInfoJson(const MeshInfo& info)
{
	Json json;
	json["program"]             = programJson();
	json["input"]               = fileJson(info.path, info.doublePrecision, info.figures);
	json["quality"]             = qualityJson(info.quality);
	json["regions"]             = regionsJson(info.parts.regions);
	json["junctions"]["edges"]  = info.parts.junctionEdges;
	json["junctions"]["length"] = info.parts.junctionLength;
	json["notes"]               = info.notes;
	return textOf(json);
}

} // namespace gpr::app
