// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "comparison_report.h"

#include <QString>
#include <algorithm>

namespace gpr_filter {

namespace {

QString count(std::int64_t value)
{
	return QString::number(value);
}

QString fixed(double value, int decimals)
{
	return QString::number(value, 'f', decimals);
}

/// MeshLab's log has letters of equal width, and room for some fifty. The log is HTML, which joins
/// several spaces, but not non-breaking spaces.
QString tableRow(const QString& label, const QString& input, const QString& remeshed,
				 const QString& collapsed)
{
	constexpr QChar noBreak(QChar::Nbsp);
	return label.leftJustified(23, noBreak) + input.rightJustified(9, noBreak) +
		   remeshed.rightJustified(10, noBreak) + collapsed.rightJustified(10, noBreak);
}

/// Collects the lines of the table.
class Table {
public:
	explicit Table(const Comparison& comparison) : _comparison(comparison) {}

	/// A figure that the input has, too.
	template <class TextOf>
	void ofMeshes(const char* label, const TextOf& text)
	{
		add(tableRow(label, text(_comparison.input), text(_comparison.remeshed.measured),
					 text(_comparison.collapsed.measured)));
	}
	template <class TextOf>
	void ofResults(const char* label, const TextOf& text)
	{
		add(tableRow(label, "-", text(_comparison.remeshed), text(_comparison.collapsed)));
	}
	/// A distance in mesh units, and the same in percent of the diagonal.
	template <class Of>
	void ofDistances(const char* label, const Of& of)
	{
		const double diagonal = _comparison.input.figures.diagonal;
		ofResults(label, [&](const ComparedResult& r) { return QString::number(of(r), 'g', 4); });
		ofResults("- % of the diagonal", [&](const ComparedResult& r) {
			return fixed(diagonal > 0 ? 100 * of(r) / diagonal : 0, 4);
		});
	}
	void add(const QString& line) { lines.push_back(line.toStdString()); }

	std::vector<std::string> lines;

private:
	const Comparison& _comparison;
};

void addCounts(Table& table)
{
	table.ofMeshes("faces", [](const MeasuredMesh& m) { return count(m.figures.faces); });
	table.ofMeshes("vertices", [](const MeasuredMesh& m) { return count(m.figures.vertices); });
	table.ofResults("seconds", [](const ComparedResult& r) { return fixed(r.seconds, 3); });
}

void addShapes(Table& table)
{
	table.ofMeshes("mean 2r/R",
				   [](const MeasuredMesh& m) { return fixed(m.quality.radiusRatioMean, 4); });
	table.ofMeshes("mean aspect ratio",
				   [](const MeasuredMesh& m) { return fixed(m.quality.aspectRatioMean, 4); });
	table.ofMeshes("smallest angle, deg",
				   [](const MeasuredMesh& m) { return fixed(m.quality.minAngleDeg, 2); });
	table.ofMeshes("largest angle, deg",
				   [](const MeasuredMesh& m) { return fixed(m.quality.maxAngleDeg, 2); });
	table.ofMeshes("faces below 30 deg, %",
				   [](const MeasuredMesh& m) { return fixed(m.quality.below30Percent, 2); });
	table.ofMeshes("6 faces at a vertex, %",
				   [](const MeasuredMesh& m) { return fixed(m.quality.valence6Percent, 2); });
}

double largerRms(const ComparedResult& r)
{
	return std::max(r.toInput.rms, r.fromInput.rms);
}

double largerP999(const ComparedResult& r)
{
	return std::max(r.toInput.p999, r.fromInput.p999);
}

double largerMax(const ComparedResult& r)
{
	return std::max(r.toInput.max, r.fromInput.max);
}

double provenMost(const ComparedResult& r)
{
	return r.proven.upper;
}

void addDistances(Table& table)
{
	table.ofDistances("RMS distance", largerRms);
	table.ofDistances("p99.9 distance", largerP999);
	table.ofDistances("largest distance", largerMax);
	table.ofDistances("proven, at most", provenMost);
}

void addTopology(Table& table)
{
	table.ofMeshes("components", [](const MeasuredMesh& m) { return count(m.figures.components); });
	table.ofMeshes("border loops",
				   [](const MeasuredMesh& m) { return count(m.figures.boundaryLoops); });
	table.ofMeshes("Euler characteristic",
				   [](const MeasuredMesh& m) { return count(m.figures.eulerCharacteristic); });
}

void addFigures(const std::string& prefix, const ComparedResult& r, Figures& figures)
{
	const gpr::QualityFigures& q             = r.measured.quality;
	figures[prefix + "vertex_number"]        = double(r.measured.figures.vertices);
	figures[prefix + "face_number"]          = double(r.measured.figures.faces);
	figures[prefix + "seconds"]              = r.seconds;
	figures[prefix + "mean_radius_ratio"]    = q.radiusRatioMean;
	figures[prefix + "mean_aspect_ratio"]    = q.aspectRatioMean;
	figures[prefix + "min_angle"]            = q.minAngleDeg;
	figures[prefix + "max_angle"]            = q.maxAngleDeg;
	figures[prefix + "below_30_percent"]     = q.below30Percent;
	figures[prefix + "valence_6_percent"]    = q.valence6Percent;
	figures[prefix + "rms_distance"]         = largerRms(r);
	figures[prefix + "p999_distance"]        = largerP999(r);
	figures[prefix + "max_distance"]         = largerMax(r);
	figures[prefix + "hausdorff_lower"]      = r.proven.lower;
	figures[prefix + "hausdorff_upper"]      = r.proven.upper;
	figures[prefix + "component_number"]     = double(r.measured.figures.components);
	figures[prefix + "boundary_loop_number"] = double(r.measured.figures.boundaryLoops);
	figures[prefix + "euler_characteristic"] = double(r.measured.figures.eulerCharacteristic);
}

} // namespace

std::vector<std::string> comparisonLines(const Comparison& comparison)
{
	Table table(comparison);
	table.lines = comparison.notes;
	table.add(tableRow("", "input", "Poisson", "quadrics"));
	addCounts(table);
	addShapes(table);
	addDistances(table);
	addTopology(table);
	table.add("Poisson: Geodesic Poisson Disk, on " + count(comparison.report.threads) +
			  " threads; quadrics: MeshLab's Quadric Edge Collapse with the values of its dialog, "
			  "on one thread. Distances: the larger of both directions; 99.9 % of the points are "
			  "nearer than "
			  "p99.9; 2r/R and aspect ratio are 1 for equilateral triangles");
	return table.lines;
}

Figures comparisonFigures(const Comparison& comparison)
{
	Figures figures;
	addFigures("", comparison.remeshed, figures);
	addFigures("quadric_", comparison.collapsed, figures);
	return figures;
}

} // namespace gpr_filter
