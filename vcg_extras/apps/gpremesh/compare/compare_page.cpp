// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare_output.h"

#include <vcg_extras/viewer/base64.h>

#include <filesystem>
#include <map>

namespace gpr::app {

namespace {

const char* const style = R"(
body { font: 15px/1.5 system-ui, sans-serif; color: #222; background: #fff; margin: 2em auto;
       max-width: 1500px; padding: 0 1em }
table { border-collapse: collapse; font-variant-numeric: tabular-nums }
th, td { padding: .2em .9em; text-align: right; border-bottom: 1px solid #ddd; white-space: pre }
th:first-child, td:first-child { text-align: left }
.scroll { overflow-x: auto }
.row { display: grid; grid-template-columns: repeat(auto-fit, minmax(260px, 1fr)); gap: 1em }
figure { margin: 0 }
img { width: 100%; height: auto; filter: brightness(1.7); border: 1px solid #ddd }
figcaption { color: #555 }
)";

std::string escaped(const std::string& text)
{
	static const std::map<char, std::string> names = {
		{'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}};
	std::string out;
	for (const char c : text) {
		const auto name = names.find(c);
		out += name != names.end() ? name->second : std::string(1, c);
	}
	return out;
}

std::string tableHtml(const FigureTable& table)
{
	std::string html = "<div class=\"scroll\"><table>\n<tr><th></th>";
	for (const std::string& h : table.head)
		html += "<th>" + escaped(h) + "</th>";
	html += "</tr>\n";
	for (const FigureTable::Row& row : table.rows) {
		html += "<tr><td>" + escaped(row.label) + "</td>";
		for (const std::string& cell : row.cells)
			html += "<td>" + escaped(cell) + "</td>";
		html += "</tr>\n";
	}
	return html + "</table></div>\n";
}

std::string figureHtml(const std::string& caption, const std::string& png)
{
	if (png.empty()) return "";
	return "<figure><img alt=\"" + escaped(caption) + "\" src=\"data:image/png;base64," +
		   base64(png) + "\"><figcaption>" + escaped(caption) + "</figcaption></figure>\n";
}

std::string picturesHtml(const std::vector<CaptionedPictures>& list)
{
	std::string whole, closeUp;
	for (const CaptionedPictures& p : list) {
		const char* const note = p.pictures.edgesOfWhole ? "" : " (edges too short to show)";
		whole += figureHtml(p.caption + note, p.pictures.whole);
		closeUp += figureHtml(p.caption, p.pictures.closeUp);
	}
	if (whole.empty() && closeUp.empty()) return "";
	return "<h2>Whole model</h2>\n<div class=\"row\">\n" + whole +
		   "</div>\n<h2>Detail</h2>\n<div class=\"row\">\n" + closeUp + "</div>\n";
}

} // namespace

std::string comparePage(const CompareRecord& record, const std::vector<CaptionedPictures>& pictures,
						const std::string& viewer)
{
	const std::string name  = std::filesystem::path(record.line.input).filename().string();
	const std::string title = "Comparison for " + escaped(name) + " by gpremesh " + GPR_VERSION;
	std::string html = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
					   "<meta name=\"viewport\" content=\"width=device-width\">\n<title>" +
					   title + "</title>\n<style>" + style + "</style>\n</head>\n<body>\n<h1>" +
					   title + "</h1>\n" + tableHtml(figureTable(record)) + "<ul>\n";
	for (const std::string& e : explanations(record))
		html += "<li>" + escaped(e) + "</li>\n";
	return html + "</ul>\n" + viewer + picturesHtml(pictures) + "</body>\n</html>\n";
}

} // namespace gpr::app
