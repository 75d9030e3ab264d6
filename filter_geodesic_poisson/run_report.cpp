// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run_report.h"

#include <vcg_extras/core/report_rows.h>

#include <QString>
#include <QStringList>
#include <algorithm>

namespace gpr_filter {

namespace {

QString number(double value, int digits = 4)
{
	return QString::number(value, 'g', digits);
}

QString fixed(double value, int decimals)
{
	return QString::number(value, 'f', decimals);
}

QString count(std::int64_t value)
{
	return QString::number(value);
}

QString countsLine(const char* done, const gpr::RemeshReport& r)
{
	return QStringLiteral("%1 %2 vertices, %3 faces to %4 vertices, %5 faces")
		.arg(QString::fromUtf8(done), count(r.input.vertices), count(r.input.faces),
			 count(r.result.vertices), count(r.result.faces));
}

QString pointsLine(const gpr::SamplingResult& result)
{
	const gpr::MeshFigures& input = result.report.input;
	return QStringLiteral("Sampled %1 vertices, %2 faces by %3 points, radius of the largest disks "
						  "%4; seed %5")
		.arg(count(input.vertices), count(input.faces), count(std::int64_t(result.points.size())),
			 number(result.diskRadius, 6), QString::number(result.report.seed));
}

QString foundLine(const gpr::FeatureResult& result)
{
	const gpr::FeatureFigures& f = result.figures;
	return QStringLiteral("Features of %1 vertices, %2 faces: %3 edges in %4 lines, %5 corners, "
						  "%6 cone apexes")
		.arg(count(result.report.input.vertices), count(result.report.input.faces),
			 count(f.edgeNum), count(f.lineNum), count(f.cornerNum), count(f.coneApexNum));
}

QString markedLine(const gpr::FeatureFigures& f)
{
	return QStringLiteral("Selected %1 vertices; support %2, least length %3")
		.arg(count(f.vertexNum), number(f.support, 6), number(f.minLength, 6));
}

/// "Samples: 700, of which 3 were off the surface and were put on the surface, the farthest by
/// 0.01".
QString samplesLine(const gpr::RemeshReport& r)
{
	QString line = QStringLiteral("Samples: %1, of which %2 were off the surface")
					   .arg(count(r.sampleNum), count(r.samplesMoved));
	if (r.samplesMoved == 0) return line;
	return line + " and moved to the surface, the farthest by " + number(r.largestSampleMove) +
		   QStringLiteral(" (%1 % of the diagonal)")
			   .arg(number(100 * r.largestSampleMove / r.input.diagonal, 3));
}

/// Empty if every sample is a vertex and every vertex a sample.
QString leftoverLine(const gpr::RemeshResult& result)
{
	const std::int64_t used = std::count_if(result.sampleOf.begin(), result.sampleOf.end(),
											[](std::int32_t sample) { return sample >= 0; });
	const std::int64_t lost = result.report.sampleNum - used;
	const std::int64_t kept = std::int64_t(result.sampleOf.size()) - used;
	QStringList        parts;
	if (lost > 0)
		parts << count(lost) + " samples were too near to other samples and became no vertices";
	if (kept > 0) parts << count(kept) + " vertices of the original stay for the topology";
	return parts.join("; ");
}

/// Empty if the whole mesh was remeshed.
QString untouchedLine(const gpr::RemeshReport& r)
{
	if (r.untouchedFaceNum == 0) return QString();
	return QStringLiteral("Only the selected part; %1 faces were left as they were")
		.arg(count(r.untouchedFaceNum));
}

QString topologyLine(const gpr::RemeshReport& r)
{
	return QStringLiteral("Components %1, border loops %2, Euler characteristic %3")
		.arg(count(r.result.components), count(r.result.boundaryLoops),
			 count(r.result.eulerCharacteristic));
}

/// "0.0123 (0.45 % of the diagonal)".
QString lengthText(double length, const gpr::RemeshReport& r)
{
	if (!(r.input.diagonal > 0)) return number(length, 6);
	return QStringLiteral("%1 (%2 % of the diagonal)")
		.arg(number(length, 6), number(100 * length / r.input.diagonal, 3));
}

QString radiusLine(const gpr::RemeshReport& r)
{
	return QStringLiteral("Disk radius %1, mean edge length %2, seed %3")
		.arg(lengthText(r.diskRadius, r), lengthText(r.quality.meanEdgeLen, r),
			 QString::number(r.seed));
}

QString qualityLine(const gpr::QualityFigures& q, const char* when = "Quality")
{
	return QString::fromUtf8(when) +
		   QStringLiteral(": mean 2r/R %1, mean aspect ratio %2, angles %3 to %4 degrees, "
						  "%5 % of the faces below 30 degrees")
			   .arg(fixed(q.radiusRatioMean, 4), fixed(q.aspectRatioMean, 4),
					fixed(q.minAngleDeg, 1), fixed(q.maxAngleDeg, 1), number(q.below30Percent, 3));
}

/// "Cleaned: 3 duplicate faces, ..."; empty without faults.
QString cleanedLine(const gpr::CleanCounts& cleaned)
{
	QStringList parts;
	for (const gpr::CountRow& row : gpr::describe(cleaned)) {
		if (row.isTold()) parts << count(row.count) + ' ' + QString::fromUtf8(row.words());
	}
	return parts.isEmpty() ? QString() : "Cleaned: " + parts.join(", ");
}

QString auditLine(const gpr::AuditFigures& a)
{
	const QString verdict = a.passed ? QStringLiteral("passed") : QStringLiteral("FAILED");
	return QStringLiteral(
			   "Audit %1: %2 non-manifold edges, %3 non-manifold vertices, %4 inverted faces, "
			   "%5 degenerate faces, %6 duplicate faces")
		.arg(verdict, count(a.nonManifoldEdges), count(a.nonManifoldVertices),
			 count(a.invertedFaces), count(a.zeroAreaFaces), count(a.duplicateFaces));
}

/// The distance of the result, as far as known: by the error bound, by the thorough check, or by
/// the moves of the fit. Empty if no vertex left the surface.
QString errorLine(const gpr::RemeshReport& r)
{
	if (r.check.done) {
		return QStringLiteral(
				   "Checked: %1 self-intersecting faces, vertices are at most %2 from the input")
			.arg(count(r.check.intersectingFaces), lengthText(r.check.vertexDistance, r));
	}
	if (r.errorGoal > 0) return "Error: asked for " + lengthText(r.errorGoal, r);
	if (!(r.largestFitDistance > 0)) return QString();
	return QStringLiteral(
			   "Error: vertices are at most %1 off the surface; the check and the filter "
			   "Compare measure the distance of the surfaces")
		.arg(lengthText(r.largestFitDistance, r));
}

/// Empty without a proof.
QString provenLine(const gpr::RemeshReport& r)
{
	if (!r.isDistanceProven) return QString();
	const gpr::DistanceBounds b = r.provenDistance.hausdorff();
	return QStringLiteral(
			   "Proven: the largest distance between input and result is between %1 and %2")
			   .arg(lengthText(b.lower, r), lengthText(b.upper, r)) +
		   (b.isBudgetSpent ? "; the budget of the proof was spent" : "");
}

QString distanceLine(const char* way, const gpr::SurfaceDistance& d, const gpr::RemeshReport& r)
{
	return QStringLiteral("Distance from the %1: RMS %2, p99.9 %3, largest %4")
		.arg(QString::fromUtf8(way), lengthText(d.rms, r), lengthText(d.p999, r),
			 lengthText(d.max, r));
}

/// One line for each direction; none without the thorough check.
QStringList distanceLines(const gpr::RemeshReport& r)
{
	if (!r.check.done) return {};
	return {distanceLine("result to the input", r.check.distance.toInput, r),
			distanceLine("input to the result", r.check.distance.fromInput, r),
			QStringLiteral("99.9 % of the surface is nearer than p99.9")};
}

QString timeLine(const gpr::RemeshReport& r)
{
	QStringList stages;
	for (const gpr::StageTime& stage : r.stages) {
		stages << QString::fromStdString(stage.stage) + ' ' + fixed(stage.seconds, 3);
	}
	return QStringLiteral("%1 s on %2 threads: %3")
		.arg(fixed(r.remeshSeconds, 3), QString::number(r.threads), stages.join(", "));
}

/// The common begin of all reports.
template <class Result>
QStringList firstLines(const Result& result)
{
	QStringList lines;
	for (const std::string& note : result.notes) {
		lines << QString::fromStdString(note);
	}
	lines << cleanedLine(result.report.cleaned);
	for (const std::string& cap : result.report.capsReached) {
		lines << "Ended by its bound: " + QString::fromStdString(cap);
	}
	return lines;
}

std::vector<std::string> withoutEmpty(const QStringList& lines)
{
	std::vector<std::string> texts;
	for (const QString& line : lines) {
		if (!line.isEmpty()) texts.push_back(line.toStdString());
	}
	return texts;
}

} // namespace

std::vector<std::string> remeshingLines(const gpr::RemeshResult&   result,
										const gpr::QualityFigures& before)
{
	const gpr::RemeshReport& r = result.report;
	return withoutEmpty(firstLines(result)
						<< countsLine("Remeshed", r) << untouchedLine(r) << topologyLine(r)
						<< radiusLine(r) << qualityLine(before, "Quality before")
						<< qualityLine(r.quality, "Quality after") << auditLine(r.audit)
						<< errorLine(r) << provenLine(r) << distanceLines(r) << timeLine(r));
}

std::vector<std::string> featureLines(const gpr::FeatureResult& result)
{
	return withoutEmpty(firstLines(result) << foundLine(result) << markedLine(result.figures)
										   << timeLine(result.report));
}

std::vector<std::string> samplingLines(const gpr::SamplingResult& result)
{
	return withoutEmpty(firstLines(result) << pointsLine(result) << timeLine(result.report));
}

std::vector<std::string> retriangulationLines(const gpr::RemeshResult& result)
{
	const gpr::RemeshReport& r = result.report;
	return withoutEmpty(firstLines(result)
						<< countsLine("Retriangulated", r) << samplesLine(r) << leftoverLine(result)
						<< topologyLine(r) << qualityLine(r.quality) << auditLine(r.audit)
						<< errorLine(r) << provenLine(r) << distanceLines(r) << timeLine(r));
}

} // namespace gpr_filter
