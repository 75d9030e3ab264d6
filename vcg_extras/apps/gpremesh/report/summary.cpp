// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "summary.h"

#include <vcg_extras/core/report_rows.h>
#include <vcg_extras/io/report/formatted_text.h>

#include <algorithm>

namespace gpr::app {

namespace {

std::string counted(std::int64_t count, const char* one, const char* many)
{
	return grouped(count) + " " + (count == 1 ? one : many);
}

std::string countsText(const MeshFigures& m)
{
	return counted(m.vertices, "vertex", "vertices") + ", " + counted(m.faces, "face", "faces") +
		   ", " + counted(m.components, "component", "components") + ", " +
		   counted(m.boundaryLoops, "border loop", "border loops");
}

std::string qualityText(const QualityFigures& q)
{
	return formatted("mean aspect ratio %.4f, mean 2r/R %.4f, smallest angle %.2f deg, "
					 "largest %.2f deg, %.4g %% of faces below 30 deg",
					 q.aspectRatioMean, q.radiusRatioMean, q.minAngleDeg, q.maxAngleDeg,
					 q.below30Percent);
}

/// A list of the repairs; empty without repairs.
std::string cleanedText(const CleanCounts& cleaned)
{
	std::string list;
	for (const CountRow& row : describe(cleaned)) {
		if (row.isTold())
			list += (list.empty() ? "" : ", ") + grouped(row.count) + " " + row.words();
	}
	return list;
}

/// "RMS 0.0123 (0.045 %), p99.9 ...".
std::string distanceText(const SurfaceDistance& d, double diagonal)
{
	const auto length = [&](const char* name, double value) {
		return formatted("%s %.4g (%.3g %%)", name, value,
						 diagonal > 0 ? 100 * value / diagonal : 0);
	};
	return length("RMS", d.rms) + ", " + length("p99.9", d.p999) + ", " + length("largest", d.max);
}

std::string checkText(const CheckFigures& c, double diagonal)
{
	return "check    " +
		   counted(c.intersectingFaces, "self-intersecting face", "self-intersecting faces") +
		   "\n         result to input: " + distanceText(c.distance.toInput, diagonal) +
		   "\n         input to result: " + distanceText(c.distance.fromInput, diagonal) +
		   "\n         % of the diagonal; 99.9 % of the surface is nearer than p99.9\n";
}

std::string provenText(const MutualBounds& proven, double diagonal)
{
	const DistanceBounds b       = proven.hausdorff();
	const double         percent = diagonal > 0 ? 100 / diagonal : 0;
	return formatted("error    proven: the largest distance between input and result is between "
					 "%.4g and %.4g\n         (%.4f and %.4f %% of the diagonal)%s\n",
					 b.lower, b.upper, percent * b.lower, percent * b.upper,
					 b.isBudgetSpent ? "; the budget of the proof was spent" : "");
}

std::string notesText(const std::vector<std::string>& notes)
{
	std::string lines;
	for (const std::string& n : notes)
		lines += "note     " + n + "\n";
	return lines;
}

/// The regions with their areas; of many, the first ones.
std::string regionsText(const std::vector<MeshParts::Region>& regions)
{
	constexpr std::size_t most = 20;
	if (regions.empty()) return "";
	std::int64_t pieceNum = 0;
	for (const MeshParts::Region& region : regions)
		pieceNum += region.pieces;
	std::string text = "regions   " + counted(std::int64_t(regions.size()), "region", "regions") +
					   " in " + counted(pieceNum, "piece", "pieces") + "\n";
	for (std::size_t i = 0; i < std::min(most, regions.size()); ++i) {
		const MeshParts::Region& r = regions[i];
		text += "          " + (r.name.empty() ? "(without a name)" : r.name) + ": " +
				counted(r.faces, "face", "faces") + formatted(", area %.6g", r.area) +
				(r.pieces > 1 ? ", " + grouped(r.pieces) + " pieces" : "") + "\n";
	}
	if (regions.size() > most)
		text += "          and " + grouped(std::int64_t(regions.size() - most)) +
				" more, which --json names\n";
	return text;
}

std::string junctionsText(const MeshParts& parts)
{
	if (parts.junctionEdges == 0) return "";
	return "junctions " + counted(parts.junctionEdges, "edge", "edges") +
		   formatted(" with more than two faces, %.6g long\n", parts.junctionLength);
}

} // namespace

std::string remeshSummary(const RunRecord& run)
{
	const std::string cleaned = cleanedText(run.report.cleaned);
	std::string text = "read     " + run.inputPath + ": " + countsText(run.report.input) + "\n";
	if (!cleaned.empty()) text += "cleaned  " + cleaned + "\n";
	text += "wrote    " + run.outputPath + ": " + countsText(run.report.result) + "\n";
	for (const MadeFile& file : run.files)
		text += "         " + file.path + ": " + counted(file.vertices, "vertex", "vertices") +
				", " + counted(file.faces, "face", "faces") + "\n";
	if (run.report.untouchedFaceNum > 0)
		text += "         all figures are of the selected part; " +
				counted(run.report.untouchedFaceNum, "face", "faces") + " stayed unchanged\n";
	text += "quality  " + qualityText(run.report.quality) + "\n";
	if (run.report.check.done) text += checkText(run.report.check, run.report.input.diagonal);
	if (run.report.isDistanceProven)
		text += provenText(run.report.provenDistance, run.report.input.diagonal);
	text += formatted("seconds  %.3f: %.3f read, %.3f remesh, %.3f write\n", run.times.total(),
					  run.times.read, run.times.remesh, run.times.write);
	return text + notesText(run.notes);
}

std::string meshInfoText(const MeshInfo& info)
{
	const MeshFigures& figures = info.figures;
	std::string        text    = info.path + ": " + countsText(figures) + "\n";
	text +=
		formatted("topology  Euler characteristic %lld\n", (long long) figures.eulerCharacteristic);
	text += formatted("size      area %.9g, diagonal %.9g, mean edge %.9g, coordinates %s\n",
					  figures.area, figures.diagonal, info.quality.meanEdgeLen,
					  info.doublePrecision ? "double" : "float");
	text += "quality   " + qualityText(info.quality) + "\n";
	text += regionsText(info.parts.regions) + junctionsText(info.parts);
	return text + notesText(info.notes);
}

} // namespace gpr::app
