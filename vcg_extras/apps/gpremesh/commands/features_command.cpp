// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands.h"

#include <vcg_extras/apps/gpremesh/platform/end_at_once.h>
#include <vcg_extras/apps/gpremesh/report/progress_bar.h>
#include <vcg_extras/io/base/platform.h>
#include <vcg_extras/io/mesh_io.h>
#include <vcg_extras/io/report/features_report.h>
#include <vcg_extras/io/report/remesh_outcome.h>

#include <algorithm>
#include <cmath>

namespace gpr::app {

namespace {

struct Colour {
	std::uint8_t red, green, blue;
};

constexpr Colour lineColour{0, 0, 0};
constexpr Colour cornerColour{255, 255, 255};
constexpr Colour apexColour{0, 255, 0};
/// Degrees at which the colour is fully red.
constexpr float reddest = 90;

/// Blue for a flat edge over light grey to red for a right angle; marked vertices have other
/// colours.
Colour colourOf(float strengthDeg, std::uint8_t feature)
{
	if (feature & FeatureConeApex) return apexColour;
	if (feature & FeatureCorner) return cornerColour;
	if (feature & OnFeatureLine) return lineColour;
	const float share   = 2 * std::min(strengthDeg / reddest, 1.0f) - 1; // -1 blue, 0 grey, 1 red
	const auto  channel = [](float away) { return std::uint8_t(220 * (1 - std::max(0.0f, away))); };
	return {channel(-share), channel(std::abs(share)), channel(share)};
}

InputMesh readAll(const std::string& path, const RunLimit& limit)
{
	const EndAtOnce  guard(limit);
	WantedAttributes wanted;
	wanted.carried = true;
	wanted.regions = noRegions; // their borders are no creases
	return readMesh(path, wanted);
}

FeatureResult detectWithProgress(const InputMesh& mesh, const CommandLine& line,
								 const RunLimit& limit)
{
	ProgressBar   bar(!line.quiet && errorIsTerminal());
	RemeshOptions options    = line.options;
	options.timeLimitSeconds = limit.secondsLeft();
	FeatureResult result =
		detectFeatures(mesh.view(), options, [&](double share, const char* phrase) {
			bar.show(share, phrase);
			return !stopRequested();
		});
	bar.clear();
	if (stopRequested()) limit.check();
	requireDone(result);
	return result;
}

/// Selection, strength and colour of the vertices, in MeshLab's names.
std::vector<ValueColumn> columnsOf(const FeatureResult& found)
{
	std::vector<ValueColumn> columns = {
		{"flags", PlyType::Int32, {}}, {"quality", PlyType::Float32, {}},
		{"red", PlyType::UInt8, {}},   {"green", PlyType::UInt8, {}},
		{"blue", PlyType::UInt8, {}},  {"alpha", PlyType::UInt8, {}}};
	for (std::size_t v = 0; v < found.vertexStrength.size(); ++v) {
		const float        strength = found.vertexStrength[v];
		const Colour       c        = colourOf(strength, found.vertexFeature[v]);
		const std::int64_t flags    = found.vertexFeature[v] != 0 ? selectedPlyFlag : 0;
		const double       values[] = {double(flags),   strength,       double(c.red),
									   double(c.green), double(c.blue), 255};
		for (std::size_t i = 0; i < columns.size(); ++i)
			columns[i].values.push_back(values[i]);
	}
	return columns;
}

/// Puts columns of the vertices in place of the columns of the same names, which are lost.
void putColumns(std::vector<ValueColumn> columns, MeshAttributes& attributes)
{
	for (ValueColumn& before : attributes.ofVertices) {
		if (columnNamed(columns, before.name) == nullptr)
			columns.push_back(std::move(before));
		else
			attributes.lost.push_back("'" + before.name + "' of vertices");
	}
	attributes.ofVertices = std::move(columns);
}

/// The mesh of the file and its attributes; adds to `lost` of the attributes.
void writeFeatures(InputMesh& mesh, const FeatureResult& found, OutputFile& out)
{
	putColumns(columnsOf(found), mesh.attributes);
	writeMesh(triangleMeshOf(mesh.view()), mesh.doublePrecision, mesh.attributes, out);
}

FeaturesRecord recordOf(const CommandLine& line, const InputMesh& mesh, FeatureResult& found)
{
	FeaturesRecord record;
	record.inputPath       = line.input;
	record.outputPath      = line.output;
	record.doublePrecision = mesh.doublePrecision;
	record.thresholds      = line.options.featureThresholds;
	record.figures         = found.figures;
	record.notes           = mesh.notes;
	record.notes.insert(record.notes.end(), found.notes.begin(), found.notes.end());
	const std::string lost = noteOfLost(mesh.attributes.lost);
	if (!lost.empty()) record.notes.push_back(lost);
	record.report = std::move(found.report);
	return record;
}

} // namespace

void runFeatures(const CommandLine& line, const Stopwatch& programClock)
{
	checkWritable(line.output);
	if (!line.report.empty()) checkWritable(line.report);
	catchStopSignals();
	const RunLimit limit(programClock, line.options.timeLimitSeconds);
	InputMesh      mesh  = readAll(line.input, limit);
	FeatureResult  found = detectWithProgress(mesh, line, limit);
	auto           out   = std::make_unique<OutputFile>(line.output, limit);
	writeFeatures(mesh, found, *out);
	const FeaturesRecord record = recordOf(line, mesh, found);
	Outputs              outputs;
	outputs.push_back(std::move(out));
	endRun(line, featuresJson(record), featuresText(record), outputs);
}

} // namespace gpr::app
