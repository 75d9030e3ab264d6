// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare_output.h"

#include <vcg_extras/io/report/formatted_text.h>

#include <functional>

namespace gpr::app {

namespace {

const char* const noFigure = "-";

using OfMesh   = std::function<std::string(const MeshRecord&)>;
using OfMethod = std::function<std::string(const MethodRecord&)>;

/// Makes the rows: each figure for the input, if known, and for every method.
class TableMaker {
public:
	explicit TableMaker(const CompareRecord& record) : record_(record)
	{
		table_.head = {"input"};
		for (const MethodRecord& m : record.methods)
			table_.head.push_back(m.column);
	}

	void shape(const std::string& label, const OfMesh& text)
	{
		add(label, text(record_.input), [&](const MethodRecord& m) { return text(m.record); });
	}
	void result(const std::string& label, const OfMethod& text) { add(label, noFigure, text); }
	/// A distance in mesh units, and the same in percent.
	void distance(const std::string& label, const std::function<double(const MethodRecord&)>& of)
	{
		result(label, [&](const MethodRecord& m) { return formatted("%.4g", of(m)); });
		percent("  % of the diagonal", of);
	}
	void percent(const std::string& label, const std::function<double(const MethodRecord&)>& of)
	{
		result(label, [&](const MethodRecord& m) {
			return formatted("%.4f", record_.percentOfDiagonal(of(m)));
		});
	}

	FigureTable take() { return std::move(table_); }

private:
	const CompareRecord& record_;
	FigureTable          table_;

	void add(const std::string& label, const std::string& ofInput, const OfMethod& text)
	{
		FigureTable::Row row = {label, {ofInput}};
		for (const MethodRecord& m : record_.methods)
			row.cells.push_back(m.failure.empty() ? text(m) : noFigure);
		table_.rows.push_back(row);
	}
};

void addShapes(TableMaker& table)
{
	table.shape("mean aspect ratio",
				[](const MeshRecord& m) { return formatted("%.4f", m.quality.aspectRatioMean); });
	table.shape("mean 2r/R",
				[](const MeshRecord& m) { return formatted("%.4f", m.quality.radiusRatioMean); });
	table.shape("mean of the smallest angles, deg",
				[](const MeshRecord& m) { return formatted("%.2f", m.quality.meanMinAngleDeg); });
	table.shape("worst angle, deg",
				[](const MeshRecord& m) { return formatted("%.2f", m.quality.minAngleDeg); });
	table.shape("widest angle, deg",
				[](const MeshRecord& m) { return formatted("%.2f", m.quality.maxAngleDeg); });
	table.shape("faces below 30 deg, %",
				[](const MeshRecord& m) { return formatted("%.3g", m.quality.below30Percent); });
	table.shape("inner vertices with 6 faces, %",
				[](const MeshRecord& m) { return formatted("%.2f", m.quality.valence6Percent); });
}

void addDistances(TableMaker& table)
{
	table.distance("E_RMS, result to input",
				   [](const MethodRecord& m) { return m.distance.toInput.rms; });
	table.distance("E_RMS, input to result",
				   [](const MethodRecord& m) { return m.distance.fromInput.rms; });
	table.distance("p99.9, result to input",
				   [](const MethodRecord& m) { return m.distance.toInput.p999; });
	table.distance("p99.9, input to result",
				   [](const MethodRecord& m) { return m.distance.fromInput.p999; });
	table.distance("Hausdorff, result to input",
				   [](const MethodRecord& m) { return m.distance.toInput.max; });
	table.percent("  % proven, at most",
				  [](const MethodRecord& m) { return m.distance.proven.toInput.upper; });
	table.distance("Hausdorff, input to result",
				   [](const MethodRecord& m) { return m.distance.fromInput.max; });
	table.percent("  % proven, at most",
				  [](const MethodRecord& m) { return m.distance.proven.fromInput.upper; });
}

std::string changed(const char* what, std::int64_t from, std::int64_t to)
{
	if (from == to) return "";
	return std::string(what) + " " + grouped(from) + " to " + grouped(to) + ", ";
}

/// "QEC: the topology changed: components 1 to 3."
std::string topologyChange(const CompareRecord& all, const MethodRecord& m)
{
	const MeshFigures &from = all.input.figures, &to = m.record.figures;
	std::string        list =
		changed("components", from.components, to.components) +
		changed("border loops", from.boundaryLoops, to.boundaryLoops) +
		changed("Euler characteristic", from.eulerCharacteristic, to.eulerCharacteristic) +
		changed("non-manifold edges", all.input.nonManifoldEdges, m.record.nonManifoldEdges);
	if (list.size() >= 2) list.resize(list.size() - 2);
	return m.column + ": the topology changed: " + list + ".";
}

std::string sizesText(const CompareRecord& record)
{
	const MethodRecord& first = record.methods.front();
	return "Distances: " + grouped(first.distance.toInput.sampleNum) +
		   " evenly spread points of each surface, and all its vertices. E_RMS and p99.9 use the "
		   "even points; Hausdorff uses all points, also of the proof. No point is farther than "
		   "the proven bound. 99.9 % of the points are nearer than p99.9. Judge a result by "
		   "p99.9: Hausdorff depends on a single point, and varies much with the seed. Diagonal "
		   "of the input: " +
		   formatted("%.6g.", record.input.figures.diagonal);
}

std::string budgetText(const MethodRecord& m)
{
	return m.column + ": the budget of the proof was spent; the proven bound may be more than 1 % "
					  "above the largest distance.";
}

std::string methodsText(const CompareRecord& record)
{
	std::string text = "gpremesh: the default preset, on " + std::to_string(record.threads) +
					   (record.threads == 1 ? " thread" : " threads") +
					   "; paper: the preset paper; QEC: MeshLab's Quadric Edge Collapse (vcglib) "
					   "with the values of "
					   "its dialog and gpremesh's number of faces, on one thread";
	if (record.methods.size() > 3) {
		text +=
			"; isotropic: MeshLab's Isotropic Explicit Remeshing (vcglib) with the values of its "
			"dialog and gpremesh's mean edge length, on one thread";
	}
	return text + ".";
}

} // namespace

FigureTable figureTable(const CompareRecord& record)
{
	TableMaker table(record);
	table.shape("faces", [](const MeshRecord& m) { return grouped(m.figures.faces); });
	table.shape("vertices", [](const MeshRecord& m) { return grouped(m.figures.vertices); });
	const std::string ofRuns =
		record.line.runNum == 1 ? "" : ", median of " + std::to_string(record.line.runNum);
	table.result("seconds" + ofRuns,
				 [](const MethodRecord& m) { return formatted("%.3f", median(m.seconds)); });
	table.result("processor seconds" + ofRuns, [](const MethodRecord& m) {
		return formatted("%.3f", median(m.processorSeconds));
	});
	addDistances(table);
	addShapes(table);
	table.result("topology", [](const MethodRecord& m) {
		return std::string(m.topologyKept ? "kept" : "changed");
	});
	return table.take();
}

std::vector<std::string> explanations(const CompareRecord& record)
{
	std::vector<std::string> list = {methodsText(record), sizesText(record)};
	list.push_back("Aspect ratio: 2 sqrt(3) inradius / longest edge, the paper's; 2r/R: 2 inradius "
				   "/ circumradius. Both are 1 for an equilateral triangle.");
	for (const MethodRecord& m : record.methods) {
		if (!m.failure.empty())
			list.push_back(m.column + ": " + m.failure);
		else if (!m.topologyKept)
			list.push_back(topologyChange(record, m));
		if (m.distance.proven.hausdorff().isBudgetSpent) list.push_back(budgetText(m));
	}
	list.insert(list.end(), record.notes.begin(), record.notes.end());
	return list;
}

std::string compareText(const CompareRecord& record)
{
	const FigureTable table = figureTable(record);
	std::string       text  = record.line.input + "\n" + formatted("%-34s", "");
	for (const std::string& h : table.head)
		text += formatted("%15s", h.c_str());
	text += "\n";
	for (const FigureTable::Row& row : table.rows) {
		text += formatted("%-34s", row.label.c_str());
		for (const std::string& cell : row.cells)
			text += formatted("%15s", cell.c_str());
		text += "\n";
	}
	for (const std::string& e : explanations(record))
		text += wrapped(e, 110, "  ") + "\n";
	return text;
}

} // namespace gpr::app
