// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare_viewer.h"

#include "base64.h"
#include "embedded_viewer.h"
#include "shown_mesh.h"

#include <vcg_extras/core/mesh/measure.h>
#include <vcg_extras/io/report/json_parts.h>

namespace gpr::app {

namespace {

constexpr std::size_t mostFacesShown = 300000; ///< of each mesh: some 8 MB of the page

Json tripleJson(const Vec3d& p)
{
	return {float(p.x), float(p.y), float(p.z)};
}

/// Meshes for the viewer, all in the same frame.
class MeshJson {
public:
	MeshJson(const MeshView& input, const CompareRecord& record) :
			record_(record), frame_(input), workers_(record.options.threads, nullptr),
			target_(input, workers_)
	{
	}

	Json ofInput(const MeshView& mesh)
	{
		return ofMesh("input", "input", mesh, shownMesh(mesh, frame_, mostFacesShown));
	}

	Json ofMethod(const MethodRecord& method)
	{
		const MeshView  mesh  = method.mesh.view();
		const ShownMesh shown = shownMesh(mesh, frame_, mostFacesShown);
		Json            json  = ofMesh(method.key, method.name, mesh, shown);
		addDistances(mesh, shown, json);
		return json;
	}

private:
	const CompareRecord& record_;
	ShownFrame           frame_;
	Workers              workers_;
	MeasuredSurface      target_;

	Json ofMesh(const std::string& key, const std::string& name, const MeshView& mesh,
				const ShownMesh& shown)
	{
		const std::vector<float> ratios = radiusRatios(mesh, workers_);
		std::vector<float>       ofShown;
		for (const std::uint32_t f : shown.faceOf)
			ofShown.push_back(ratios[f]);
		Json json = {{"key", key},
					 {"name", name},
					 {"faces", mesh.faceNum},
					 {"shown", shown.faceOf.size()},
					 {"positions", base64Of(shown.positions)},
					 {"triangles", base64Of(shown.triangles)},
					 {"quality", base64Of(ofShown)}};
		if (!ratios.empty()) json["worst"] = worstJson(mesh, ratios);
		return json;
	}

	/// Where the triangle of the worst shape lies.
	Json worstJson(const MeshView& mesh, const std::vector<float>& ratios) const
	{
		const auto face =
			std::size_t(std::min_element(ratios.begin(), ratios.end()) - ratios.begin());
		const auto  t = mesh.triangle(face);
		const Vec3d a = frame_.local(mesh.position(t[0])), b = frame_.local(mesh.position(t[1])),
					c        = frame_.local(mesh.position(t[2]));
		const double longest = std::max({length(b - a), length(c - b), length(a - c)});
		return {{"value", ratios[face]},
				{"at", tripleJson((a + b + c) * (1. / 3))},
				{"normal", tripleJson(normalized(cross(b - a, c - a)))},
				{"size", longest}};
	}

	/// In percent of the input's diagonal.
	void addDistances(const MeshView& mesh, const ShownMesh& shown, Json& json)
	{
		const std::vector<FarthestPoint> points =
			target_.farthestPoints(mesh, shown.faceOf, workers_);
		std::vector<float> percents;
		std::size_t        best = 0;
		for (std::size_t i = 0; i < points.size(); ++i) {
			percents.push_back(float(record_.percentOfDiagonal(points[i].distance)));
			if (points[i].distance > points[best].distance) best = i;
		}
		json["distance"] = base64Of(percents);
		if (points.empty()) return;
		const auto  t = mesh.triangle(shown.faceOf[best]);
		const Vec3d a = mesh.position(t[0]), b = mesh.position(t[1]), c = mesh.position(t[2]);
		json["farthest"] = {{"value", percents[best]},
							{"at", tripleJson(frame_.local(points[best].position))},
							{"normal", tripleJson(normalized(cross(b - a, c - a)))},
							{"size", length(b - a) * frame_.scale}};
	}
};

/// The colours of distances end at the largest p99.9, in percent of the diagonal.
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
	MeshJson meshes(input, record);
	Json     json = {{"endOfDistances", endOfColours(record)},
					 {"mostShown", mostFacesShown},
					 {"meshes", Json::array()}};
	json["meshes"].push_back(meshes.ofInput(input));
	for (const MethodRecord& m : record.methods)
		if (m.failure.empty()) json["meshes"].push_back(meshes.ofMethod(m));
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
		   "</script>\n<script>\n" + viewerScript() + "</script>\n";
}

} // namespace gpr::app
