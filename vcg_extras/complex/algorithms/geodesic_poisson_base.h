// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_GEODESIC_POISSON_BASE_H
#define VCG_EXTRAS_GEODESIC_POISSON_BASE_H

#include <vcg_extras/core/remesh.h>

#include <cstdint>
#include <string>
#include <vector>

namespace vcg {
namespace tri {

/** \brief The outcome of a call, returned by all geodesic Poisson-disk algorithms.

Any status but gpr::Status::Ok means: the call changed no mesh, and message gives the reason in a
sentence for the user.
*/
struct GeodesicPoissonResult {
	gpr::Status              status = gpr::Status::InternalError;
	std::string              message;   ///< empty when Ok
	std::vector<std::string> notes;     ///< sentences to show even after success
	std::int64_t smallestVertexNum = 0; ///< with CountTooSmall: the count to ask for instead

	bool IsOk() const { return status == gpr::Status::Ok; }
};

/** \brief All choices of a call: the engine's own options, with setters for the size.

Meaning, range and default of each option: gpr::RemeshOptions in core/options.h. A value out of
range ends a call with BadOptions. All algorithms take all options; an option without a meaning for
an algorithm has no effect. The algorithms themselves set two options by the attributes of the
meshes: surfacePointsOfVertices and surfacePointsOfFaces.

Some options read more of the mesh than positions and faces. A call without such data ends with
BadOptions:
- featureRegion Selection: the selected vertices; without selected vertices, the corners of the
  selected faces. FeatureDetection::Select selects the detected features.
- featureDiskScale above 0 without featureRegion: the selected vertices. Without selected vertices
  the region is detected, and the call does not end.
- featureMode Given: the selected edges of faces.
- selectedOnly: the selected faces.

An option can also be set by its key in the parameter table, see core/parameters.h:
\code
gpr::findParameter("FeatureDiskScale")->store(0.3, params);
\endcode
*/
struct GeodesicPoissonParams : public gpr::RemeshOptions {
	GeodesicPoissonParams() = default;
	/// Options from elsewhere: from gpr::ParameterSet, or of another algorithm.
	GeodesicPoissonParams(const gpr::RemeshOptions& options) : gpr::RemeshOptions(options) {}

	/// Exact number of vertices, >= 1.
	void SetTargetVertexNum(std::int64_t num)
	{
		targetMode      = gpr::TargetMode::VertexNum;
		targetVertexNum = num;
	}
	/// Exact number of faces, >= 1; only for the remeshing.
	void SetTargetFaceNum(std::int64_t num)
	{
		targetMode    = gpr::TargetMode::FaceNum;
		targetFaceNum = num;
	}
	/// Percent of the input's vertices, > 0, <= 10000.
	void SetTargetPerc(double perc)
	{
		targetMode    = gpr::TargetMode::Percent;
		targetPercent = perc;
	}
	/// Mean edge length in mesh units, > 0.
	void SetTargetLen(double len)
	{
		targetMode       = gpr::TargetMode::EdgeLength;
		targetEdgeLen    = len;
		edgeLenIsPercent = false;
	}
	/// The number of vertices forecast for a detail; only for the remeshing.
	void SetTargetDetail(gpr::Detail detail)
	{
		targetMode   = gpr::TargetMode::Detail;
		targetDetail = detail;
	}
	/// Largest distance from the input in mesh units, > 0; only for the remeshing.
	void SetTargetMaxError(double distance)
	{
		targetMode        = gpr::TargetMode::MaxError;
		targetMaxError    = distance;
		maxErrorIsPercent = false;
	}
};

} // namespace tri
} // namespace vcg

#endif
