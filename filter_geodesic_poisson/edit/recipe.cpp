// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "recipe.h"

#include "filter_text.h"

#include <QFileInfo>
#include <QStringList>
#include <QXmlStreamWriter>
#include <charconv>

namespace gpr_filter {

namespace {

using gpr::Parameter;
using gpr::ParameterKind;
using gpr::ParameterValue;
using Values = std::map<std::string, ParameterValue>;

/// The shortest text of a number.
QString numberText(double number)
{
	char       text[64];
	const auto written = std::to_chars(text, text + sizeof(text), number);
	return QString::fromLatin1(text, int(written.ptr - text));
}

QString scriptText(const ParameterValue& value)
{
	if (const auto* count = std::get_if<std::int64_t>(&value)) return QString::number(*count);
	if (const auto* number = std::get_if<double>(&value)) return numberText(*number);
	if (std::holds_alternative<gpr::Automatic>(value)) return numberText(kAutomaticNumber);
	return std::get<bool>(value) ? "true" : "false";
}

ParameterValue valueOf(const Parameter& row, const Values& values, const gpr::MeshFacts& facts)
{
	const auto given = values.find(row.key);
	return given != values.end() ? given->second : row.defaultValue(facts);
}

void writeParameter(const Parameter& row, const ParameterValue& value, const gpr::MeshFacts& facts,
					QXmlStreamWriter& xml)
{
	xml.writeEmptyElement("Param");
	xml.writeAttribute("name", row.key);
	xml.writeAttribute("type", scriptType(row.kind));
	xml.writeAttribute("value", scriptText(value));
	if (row.kind == ParameterKind::Length) {
		xml.writeAttribute("min", "0");
		xml.writeAttribute("max", numberText(facts.diagonal > 0 ? facts.diagonal : 1));
	}
	if (row.kind != ParameterKind::Choice) return;
	xml.writeAttribute("enum_cardinality", QString::number(row.choices.size()));
	for (std::size_t i = 0; i < row.choices.size(); ++i)
		xml.writeAttribute("enum_val" + QString::number(i), row.choices[i]);
}

QString scriptFor(const Values& values, const gpr::MeshFacts& facts)
{
	QString          script;
	QXmlStreamWriter xml(&script);
	xml.setAutoFormatting(true);
	xml.setAutoFormattingIndent(1);
	xml.writeDTD("<!DOCTYPE FilterScript>");
	xml.writeStartElement("FilterScript");
	xml.writeStartElement("filter");
	xml.writeAttribute("name", textOf(RemeshFilter).name);
	for (const Parameter& row : rowsOf(RemeshFilter))
		writeParameter(row, valueOf(row, values, facts), facts, xml);
	xml.writeEndElement();
	xml.writeEndElement();
	return script.trimmed() + "\n";
}

/// Whether the row is a row for the size in force.
bool isSizeInForce(const Parameter& row, const Values& values, const gpr::MeshFacts& facts)
{
	const auto isGiven = [&](const char* key) {
		const ParameterValue value = valueOf(*gpr::findParameter(key), values, facts);
		const auto* const    count = std::get_if<std::int64_t>(&value);
		return count != nullptr ? *count > 0 : std::get<double>(value) > 0;
	};
	const std::string key = row.key;
	for (const char* other : {"MaxError", "Detail", "TargetLen", "TargetPerc", "TargetFaceNum"}) {
		if (isGiven(other)) return key == other;
	}
	return key == "TargetVertexNum";
}

/// Whether a row must be named for a host with the defaults for a mesh of these facts.
bool mustBeNamed(const Parameter& row, const Values& values, const gpr::MeshFacts& layer,
				 const gpr::MeshFacts& host)
{
	if (gpr::isSizeParameter(row)) return isSizeInForce(row, values, layer);
	return valueOf(row, values, layer) != row.defaultValue(host);
}

QString quoted(const QString& file)
{
	return "'" + QString(file).replace("'", "'\\''") + "'";
}

QString commandValue(const Parameter& row, const ParameterValue& value)
{
	if (row.kind == ParameterKind::Choice)
		return row.choices[std::size_t(std::get<std::int64_t>(value))];
	if (row.kind == ParameterKind::Switch) return std::get<bool>(value) ? "on" : "off";
	if (std::holds_alternative<gpr::Automatic>(value)) return gpr::automaticName;
	return scriptText(value);
}

QString commandFor(const Values& values, const gpr::MeshFacts& facts, const QString& file)
{
	const QFileInfo info(file);
	QStringList     words = {"gpremesh remesh", quoted(info.fileName()),
							 quoted(info.completeBaseName() + "_remeshed.ply")};
	for (const Parameter& row : gpr::remeshParameters()) {
		if (!mustBeNamed(row, values, facts, gpr::MeshFacts())) continue;
		words << row.option;
		const bool isBare = row.kind == ParameterKind::Switch && *row.argument == '\0';
		if (!isBare) words << commandValue(row, valueOf(row, values, facts));
	}
	const auto regions =
		RegionSource(std::get<std::int64_t>(valueOf(remeshRow("Regions"), values, facts)));
	if (regions == RegionSource::Quality) words << "--regions quality";
	if (regions == RegionSource::Texture || regions == RegionSource::Colour)
		words << "# without the regions, which the program does not take from there";
	return words.join(' ');
}

QString pythonValue(const Parameter& row, const ParameterValue& value)
{
	if (row.kind == ParameterKind::Choice) return "'" + commandValue(row, value) + "'";
	if (row.kind == ParameterKind::Switch) return std::get<bool>(value) ? "True" : "False";
	if (row.kind == ParameterKind::Length) return "pymeshlab.PureValue(" + scriptText(value) + ")";
	return scriptText(value);
}

QString pythonFor(const Values& values, const gpr::MeshFacts& facts)
{
	QStringList arguments;
	for (const Parameter& row : rowsOf(RemeshFilter)) {
		if (!mustBeNamed(row, values, facts, facts)) continue;
		arguments << QString(row.key).toLower() + "=" +
						 pythonValue(row, valueOf(row, values, facts));
	}
	return QString("meshes.%1(%2)").arg(textOf(RemeshFilter).pythonName, arguments.join(", "));
}

} // namespace

QString Recipe::text() const
{
	return "# the same mesh with the program:\n" + command + "\n\n# with PyMeshLab:\n" + python +
		   "\n\n# with meshlabserver or PyMeshLab, as an .mlx script:\n" + script;
}

Recipe recipeFor(const Values& values, const gpr::MeshFacts& facts, const QString& file)
{
	return {scriptFor(values, facts), commandFor(values, facts, file), pythonFor(values, facts)};
}

} // namespace gpr_filter
