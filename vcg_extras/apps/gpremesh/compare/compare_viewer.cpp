// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare_output.h"
#include "embedded_viewer.h"

#include <vcg_extras/viewer/base64.h>
#include <vcg_extras/viewer/mesh_json.h>

namespace gpr::app {

namespace {

Json packed(std::string_view bytes)
{
	return base64(bytes);
}

/// Upper end of the colours of distances: the largest p99.9, in percent of the diagonal.
double endOfColours(const CompareRecord& record)
{
	double end = 0;
	for (const MethodRecord& m : record.methods)
		if (m.failure.empty())
			end = std::max(end, record.percentOfDiagonal(m.distance.toInput.p999));
	return end;
}

std::string dataJson(const MeshView& input, const CompareRecord& record)
{
	Workers        workers(record.line.options.threads, nullptr);
	const MeshJson meshes(input, record.input.figures.diagonal, workers, packed);
	Json           json = {{"endOfDistances", endOfColours(record)},
						   {"mostShown", mostFacesShown},
						   {"panels", Json::array({"input"})},
						   {"meshes", Json::array()}};
	json["meshes"].push_back(meshes.ofMesh("input", "input", input));
	const MeasuredSurface target(input, workers);
	for (const MethodRecord& m : record.methods) {
		if (!m.failure.empty()) continue;
		json["meshes"].push_back(meshes.ofResult(m.key, m.name, m.mesh.view(), target));
		if (m.key == "default" || m.key == "quadricEdgeCollapse") json["panels"].push_back(m.key);
	}
	return json.dump();
}

} // namespace

bool hasViewer()
{
	return !threeScript().empty();
}

std::string viewerHtml(const MeshView& input, const CompareRecord& record)
{
	return "<style>" + viewerStyle() + "</style>\n" + viewerMarkup() +
		   "<script type=\"application/json\" id=\"viewer-data\">" + dataJson(input, record) +
		   "</script>\n<!--\n" + threeLicence() + "-->\n<script>" + threeScript() +
		   "</script>\n<script>\n" + viewerScript() +
		   "makeViewer(document.getElementById(\"viewer\"), "
		   "JSON.parse(document.getElementById(\"viewer-data\").textContent));\n</script>\n";
}

} // namespace gpr::app
