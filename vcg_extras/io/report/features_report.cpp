// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "features_report.h"

#include "formatted_text.h"
#include "json_parts.h"

namespace gpr::app {

std::string featuresJson(const FeaturesRecord& record)
{
	const FeatureFigures&    f = record.figures;
	const FeatureThresholds& t = record.thresholds;
	Json                     json;
	json["program"]     = programJson();
	json["input"]       = fileJson(record.inputPath, record.doublePrecision, record.report.input);
	json["output"]      = record.outputPath;
	json["thresholds"]  = {{"support", t.support},
						   {"strongDegrees", t.strongDeg},
						   {"weakDegrees", t.weakDeg},
						   {"minLength", t.minLength},
						   {"leastLength", t.minLength}}; // the key of earlier versions
	json["support"]     = f.support;
	json["minLength"]   = f.minLength;
	json["leastLength"] = f.minLength;
	json["features"]    = {{"vertices", f.vertexNum}, {"faces", f.faceNum},
						   {"edges", f.edgeNum},      {"lines", f.lineNum},
						   {"corners", f.cornerNum},  {"coneApexes", f.coneApexNum},
						   {"tips", f.coneApexNum}};
	json["threads"]     = record.report.threads;
	json["seconds"]     = record.report.remeshSeconds;
	json["capsReached"] = record.report.capsReached;
	json["notes"]       = record.notes;
	return textOf(json);
}

std::string featuresText(const FeaturesRecord& record)
{
	const FeatureFigures& f    = record.figures;
	std::string           text = "read      " + record.inputPath + ": " +
					   grouped(record.report.input.vertices) + " vertices, " +
					   grouped(record.report.input.faces) + " faces\n";
	text += "features  " + grouped(f.edgeNum) + " edges in " + grouped(f.lineNum) + " lines, " +
			grouped(f.cornerNum) + " corners, " + grouped(f.coneApexNum) + " cone apexes\n";
	text += "marked    " + grouped(f.vertexNum) + " vertices, " + grouped(f.faceNum) + " faces\n";
	text += formatted("support   %.6g, shortest line %.6g\n", f.support, f.minLength);
	text += "wrote     " + record.outputPath + "\n";
	for (const std::string& note : record.notes)
		text += "note      " + note + "\n";
	return text;
}

} // namespace gpr::app
