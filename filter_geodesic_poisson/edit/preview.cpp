// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "preview.h"

#include <vcg_extras/core/mesh/measure.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vcg/space/color4.h>

namespace gpr_filter {

namespace {

/// The three corners of a face.
struct Corners {
	gpr::Vec3d at[3];

	Corners(const gpr::MeshView& mesh, std::size_t f)
	{
		for (std::size_t k = 0; k < 3; ++k)
			at[k] = mesh.position(std::size_t(mesh.vertexOf(3 * f + k)));
	}
	gpr::Vec3d normal() const { return normalized(cross(at[1] - at[0], at[2] - at[0])); }
	gpr::Vec3d middle() const { return (at[0] + at[1] + at[2]) * (1 / 3.0); }
	double     longestEdge() const
	{
		return std::max({length(at[1] - at[0]), length(at[2] - at[1]), length(at[0] - at[2])});
	}
};

void put(const gpr::Vec3d& from, float (&to)[3])
{
	to[0] = float(from.x);
	to[1] = float(from.y);
	to[2] = float(from.z);
}

void putGrey(std::uint8_t (&to)[4])
{
	to[0] = to[1] = to[2] = 190;
	to[3]                 = 255;
}

/// On MeshLab's scale from red over green to blue.
void putColour(double red, double blue, double figure, std::uint8_t (&to)[4])
{
	vcg::Color4b colour;
	colour.SetColorRamp(float(red), float(blue), float(figure));
	for (int i = 0; i < 4; ++i)
		to[i] = colour[i];
}

DrawnFaces facesByQuality(const gpr::MeshView& mesh, const std::vector<float>& quality,
						  gpr::Workers& workers)
{
	DrawnFaces faces(3 * mesh.faceNum);
	workers.forEach(mesh.faceNum, [&](int f) {
		const Corners    corners(mesh, std::size_t(f));
		const gpr::Vec3d normal = corners.normal();
		for (int k = 0; k < 3; ++k) {
			DrawnCorner& corner = faces[3 * std::size_t(f) + std::size_t(k)];
			put(corners.at[k], corner.position);
			put(normal, corner.normal);
			putColour(0, 1, quality[std::size_t(f)], corner.byQuality);
			putGrey(corner.byDistance);
		}
	});
	return faces;
}

void colourByDistance(const std::vector<float>& deviation, double largest, DrawnFaces& faces)
{
	for (std::size_t c = 0; c < faces.size(); ++c)
		putColour(largest, 0, deviation[c / 3], faces[c].byDistance);
}

double largestOf(const std::vector<float>& figures)
{
	return figures.empty() ? 0 : double(*std::max_element(figures.begin(), figures.end()));
}

Spot spotAt(const gpr::MeshView& mesh, const std::vector<float>& figures,
			std::vector<float>::const_iterator at)
{
	Spot spot;
	if (at == figures.end()) return spot;
	const Corners corners(mesh, std::size_t(at - figures.begin()));
	spot.isKnown = true;
	spot.middle  = corners.middle();
	spot.normal  = corners.normal();
	spot.size    = corners.longestEdge();
	spot.figure  = double(*at);
	return spot;
}

} // namespace

Preview shownResult(std::shared_ptr<const gpr::RemeshResult> result, gpr::Workers& workers)
{
	const gpr::MeshView      mesh    = result->mesh.view();
	const std::vector<float> quality = gpr::radiusRatios(mesh, workers);
	Preview                  preview;
	preview.faces         = std::make_shared<DrawnFaces>(facesByQuality(mesh, quality, workers));
	preview.result        = std::move(result);
	preview.worstTriangle = spotAt(mesh, quality, std::min_element(quality.begin(), quality.end()));
	return preview;
}

Preview measuredResult(const Preview& shown, const gpr::MeshView& input,
					   const gpr::MeasuredSurface& target, gpr::Workers& workers)
{
	const gpr::MeshView       mesh      = shown.result->mesh.view();
	const std::vector<float>  deviation = target.ofFaces(mesh, workers);
	const std::int64_t        pointNum  = gpr::distanceSampleNum(mesh.faceNum);
	const gpr::MutualDistance both      = {
			 target.from(mesh, pointNum, workers),
			 gpr::MeasuredSurface(mesh, workers).from(input, pointNum, workers)};
	Preview measured          = shown;
	measured.isMeasured       = true;
	measured.distance         = both.larger();
	measured.largestDeviation = largestOf(deviation);
	measured.farthest =
		spotAt(mesh, deviation, std::max_element(deviation.begin(), deviation.end()));
	DrawnFaces faces = *shown.faces;
	colourByDistance(deviation, measured.largestDeviation, faces);
	measured.faces = std::make_shared<DrawnFaces>(std::move(faces));
	return measured;
}

DrawnFaces drawnFaces(const gpr::MeshView& mesh, const gpr::MeasuredSurface* target, double largest,
					  gpr::Workers& workers)
{
	DrawnFaces faces = facesByQuality(mesh, gpr::radiusRatios(mesh, workers), workers);
	if (target == nullptr) return faces;
	const std::vector<float> deviation = target->ofFaces(mesh, workers);
	colourByDistance(deviation, largest > 0 ? largest : largestOf(deviation), faces);
	return faces;
}

} // namespace gpr_filter
