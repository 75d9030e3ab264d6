// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run_report.h"

#include <QString>
#include <QStringList>

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

QString countsLine(const gpr::RemeshReport& r)
{
	return QStringLiteral("Remeshed %1 vertices, %2 faces to %3 vertices, %4 faces")
		.arg(count(r.input.vertices), count(r.input.faces), count(r.result.vertices),
			 count(r.result.faces));
}

QString topologyLine(const gpr::RemeshReport& r)
{
	return QStringLiteral("Components %1, boundary loops %2, Euler characteristic %3")
		.arg(count(r.result.components), count(r.result.boundaryLoops),
			 count(r.result.eulerCharacteristic));
}

QString radiusLine(const gpr::RemeshReport& r)
{
	return QStringLiteral("Disk radius %1, mean edge length %2, seed %3")
		.arg(number(r.diskRadius, 6), number(r.quality.meanEdgeLen, 6), QString::number(r.seed));
}

QString qualityLine(const gpr::QualityFigures& q)
{
	return QStringLiteral("Quality: mean 2r/R %1, mean aspect ratio %2, angles %3 to %4 degrees, "
						  "%5 % of the faces below 30 degrees")
		.arg(fixed(q.radiusRatioMean, 4), fixed(q.aspectRatioMean, 4), fixed(q.minAngleDeg, 1),
			 fixed(q.maxAngleDeg, 1), number(q.below30Percent, 3));
}

/// "Cleaned: 3 duplicate faces, ..."; empty where there was nothing to clean.
QString cleanedLine(const gpr::CleanCounts& c)
{
	const std::pair<std::int64_t, const char*> rows[] = {
		{c.nonFiniteVertices, "vertices without finite coordinates dropped"},
		{c.unreferencedVertices, "unreferenced vertices dropped"},
		{c.weldedVertices, "vertices welded"},
		{c.repeatedIndexFaces, "faces with a vertex twice dropped"},
		{c.zeroAreaFaces, "faces without area"},
		{c.duplicateFaces, "duplicate faces dropped"},
		{c.reorientedFaces, "faces turned round"},
		{c.nonManifoldEdges, "non-manifold edges cut"},
		{c.nonManifoldVertices, "non-manifold vertices split"},
		{c.nonOrientableCuts, "edges cut to orient the surface"},
	};
	QStringList parts;
	for (const auto& [amount, what] : rows) {
		if (amount != 0) parts << count(amount) + ' ' + QString::fromUtf8(what);
	}
	return parts.isEmpty() ? QString() : "Cleaned: " + parts.join(", ");
}

QString auditLine(const gpr::AuditFigures& a)
{
	const QString verdict = a.passed ? QStringLiteral("passed") : QStringLiteral("FAILED");
	return QStringLiteral("Audit %1: %2 non-manifold edges, %3 non-manifold vertices, %4 flipped, "
						  "%5 without area, %6 duplicate faces")
		.arg(verdict, count(a.nonManifoldEdges), count(a.nonManifoldVertices),
			 count(a.flippedFaces), count(a.zeroAreaFaces), count(a.duplicateFaces));
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

} // namespace

std::vector<std::string> logLines(const gpr::RemeshResult& result)
{
	const gpr::RemeshReport& r = result.report;

	QStringList lines;
	for (const std::string& note : result.notes) {
		lines << QString::fromStdString(note);
	}
	lines << cleanedLine(r.cleaned);
	for (const std::string& cap : r.capsReached) {
		lines << "Ended by its bound: " + QString::fromStdString(cap);
	}
	lines << countsLine(r) << topologyLine(r) << radiusLine(r) << qualityLine(r.quality)
		  << auditLine(r.audit) << timeLine(r);
	lines.removeAll(QString());

	std::vector<std::string> texts;
	for (const QString& line : lines) {
		texts.push_back(line.toStdString());
	}
	return texts;
}

} // namespace gpr_filter
