// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_json.h"

#include <vcg_extras/core/mesh/measure.h>

#include <algorithm>

namespace gpr::app {

namespace {

Json tripleJson(const Vec3d& p)
{
	return {float(p.x), float(p.y), float(p.z)};
}

/// The corners of a face.
struct Corners {
	Vec3d a, b, c;

	Corners(const MeshView& mesh, std::size_t face)
	{
		const auto t = mesh.triangle(face);
		a            = mesh.position(std::size_t(t[0]));
		b            = mesh.position(std::size_t(t[1]));
		c            = mesh.position(std::size_t(t[2]));
	}

	Vec3d normal() const { return normalized(cross(b - a, c - a)); }
};

} // namespace

MeshJson::MeshJson(const MeshView& input, double diagonal, Workers& workers, Pack pack) :
		frame_(input), diagonal_(diagonal), workers_(workers), pack_(pack)
{
}

Json MeshJson::ofMesh(const std::string& key, const std::string& name, const MeshView& mesh) const
{
	return jsonOf(key, name, mesh, shownMesh(mesh, frame_, mostFacesShown));
}

Json MeshJson::ofResult(const std::string& key, const std::string& name, const MeshView& mesh,
						const MeasuredSurface& input) const
{
	const ShownMesh                  shown  = shownMesh(mesh, frame_, mostFacesShown);
	Json                             json   = jsonOf(key, name, mesh, shown);
	const std::vector<FarthestPoint> points = input.farthestPoints(mesh, shown.faceOf, workers_);
	std::vector<float>               percents;
	for (const FarthestPoint& p : points)
		percents.push_back(diagonal_ > 0 ? float(100 * p.distance / diagonal_) : 0);
	json["distance"] = packed(percents);
	if (points.empty()) return json;
	const auto best =
		std::size_t(std::max_element(points.begin(), points.end(),
									 [](const FarthestPoint& a, const FarthestPoint& b) {
										 return a.distance < b.distance;
									 }) -
					points.begin());
	json["farthest"]          = farthestJson(mesh, shown.faceOf[best], points[best]);
	json["farthest"]["value"] = percents[best];
	return json;
}

template <class Value>
Json MeshJson::packed(const std::vector<Value>& values) const
{
	const auto* const bytes = reinterpret_cast<const char*>(values.data());
	return pack_({bytes, values.size() * sizeof(Value)});
}

Json MeshJson::jsonOf(const std::string& key, const std::string& name, const MeshView& mesh,
					  const ShownMesh& shown) const
{
	const std::vector<float> ratios = radiusRatios(mesh, workers_);
	std::vector<float>       ofShown;
	for (const std::uint32_t f : shown.faceOf)
		ofShown.push_back(ratios[f]);
	Json json = {{"key", key},
				 {"name", name},
				 {"faces", mesh.faceNum},
				 {"shown", shown.faceOf.size()},
				 {"positions", packed(shown.positions)},
				 {"triangles", packed(shown.triangles)},
				 {"quality", packed(ofShown)}};
	if (!ratios.empty()) json["worst"] = worstJson(mesh, ratios);
	return json;
}

/// The place of the triangle of the worst shape.
Json MeshJson::worstJson(const MeshView& mesh, const std::vector<float>& ratios) const
{
	const auto face = std::size_t(std::min_element(ratios.begin(), ratios.end()) - ratios.begin());
	const Corners t(mesh, face);
	const Vec3d   a = frame_.local(t.a), b = frame_.local(t.b), c = frame_.local(t.c);
	const double  longest = std::max({length(b - a), length(c - b), length(a - c)});
	return {{"value", ratios[face]},
			{"at", tripleJson((a + b + c) * (1. / 3))},
			{"normal", tripleJson(t.normal())},
			{"size", longest}};
}

Json MeshJson::farthestJson(const MeshView& mesh, std::size_t face,
							const FarthestPoint& point) const
{
	const Corners t(mesh, face);
	return {{"at", tripleJson(frame_.local(point.position))},
			{"normal", tripleJson(t.normal())},
			{"size", length(t.b - t.a) * frame_.scale}};
}

} // namespace gpr::app
