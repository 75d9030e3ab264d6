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

/** \brief How a call ended: what all geodesic Poisson-disk algorithms return.

Everything but gpr::Status::Ok means that no mesh of the caller was touched, and message says why in
one sentence for the user.
*/
struct GeodesicPoissonResult {
	gpr::Status              status = gpr::Status::InternalError;
	std::string              message;   ///< empty when Ok
	std::vector<std::string> notes;     ///< sentences worth showing even when all went well
	std::int64_t smallestVertexNum = 0; ///< with CountTooSmall: the count to ask for instead

	bool IsOk() const { return status == gpr::Status::Ok; }
};

/** \brief Everything that a caller can choose: the engine's own options, with setters for the size.

What each option means, its range and its default: gpr::RemeshOptions in core/options.h. A value out
of range ends a call with BadOptions. All algorithms take all options and hand them to the engine,
which leaves alone those that a stage does not need. Two are set by the algorithms, by the
attributes that the meshes have: surfacePointsOfVertices and surfacePointsOfFaces.

Some options read more of the mesh than positions and faces. Without it a call ends with BadOptions:
- featureRegion Selection: the selected vertices; where none is selected, the corners of the
  selected faces. FeatureDetection::Select selects what was detected.
- featureDiskScale above 0, and no featureRegion named: the selected vertices. Where none is
  selected the region is detected, and the call does not end.
- featureMode Given: the selected edges of faces.
- selectedOnly: the selected faces.

An option can also be set by its key in the parameter table, see core/parameters.h:
\code
gpr::findParameter("FeatureDiskScale")->store(0.3, params);
\endcode
*/
struct GeodesicPoissonParams : public gpr::RemeshOptions {
	GeodesicPoissonParams() = default;
	/// Options made elsewhere: by gpr::ParameterSet, or for another algorithm.
	GeodesicPoissonParams(const gpr::RemeshOptions& options) : gpr::RemeshOptions(options) {}

	/// Exactly so many vertices, >= 1.
	void SetTargetVertexNum(std::int64_t num)
	{
		targetMode      = gpr::TargetMode::VertexNum;
		targetVertexNum = num;
	}
	/// Exactly so many faces, >= 1; only the remeshing can aim at it.
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
	/// As many vertices as a detail is forecast to take; only the remeshing can aim at it.
	void SetTargetDetail(gpr::Detail detail)
	{
		targetMode   = gpr::TargetMode::Detail;
		targetDetail = detail;
	}
	/// Largest distance from the input in mesh units, > 0; only the remeshing can aim at it.
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
