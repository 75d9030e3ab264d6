// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_RESULTS_H
#define VCG_EXTRAS_CORE_RESULTS_H

#include "mesh_view.h"
#include "report.h"

#include <cstdint>
#include <string>
#include <vector>

namespace gpr {

/// The end of a run. Only Ok comes with a result; otherwise `message` tells why in a sentence.
enum class Status {
	Ok,
	BadOptions,    ///< an option out of range
	UnusableInput, ///< no usable face, indices out of range, no area, ...
	CountTooSmall, ///< the topology needs more vertices: smallestVertexNum
	/// The result failed the audit (report.audit), no mesh met the error bound, or the surface has
	/// no mesh with this number of faces or vertices, but with the numbers below and above.
	PromiseBroken,
	OutOfMemory, ///< an allocation failed, or the forecast need is above the memory
	Cancelled,
	OutOfTime, ///< after RemeshOptions::timeLimitSeconds
	InternalError,
};

/// The common parts of all results.
struct Outcome {
	Status                   status = Status::InternalError;
	std::string              message; ///< empty if Ok; otherwise a sentence for the user
	std::vector<std::string> notes;   ///< sentences for the user, with every status
	RemeshReport             report;
};

/// A result mesh, or the reason of a refusal.
struct RemeshResult : Outcome {
	TriangleMesh mesh; ///< in the frame of the input
	/// Per result vertex: its point on the input. Empty without surfacePointsOfVertices.
	std::vector<BarycentricPoint> surfacePoints;
	/// Per result face: the point on the input of its middle. Empty without surfacePointsOfFaces.
	std::vector<BarycentricPoint> facePoints;
	/// Per result face, if the input has regions: the label of the input face at its facePoints.
	std::vector<std::int32_t> region;
	/// Per result vertex, if some input vertices had to stay: the input vertex of the same
	/// coordinates, bit for bit, or -1.
	std::vector<std::int32_t> callersVertex;
	/// Per result face, with selectedOnly: the same face of the input, or -1 for a new face.
	std::vector<std::int32_t> callersFace;
	std::vector<std::int32_t> sampleOf; ///< retriangulate: the sample of each vertex, or -1
	std::int64_t smallestVertexNum = 0; ///< with CountTooSmall: the least possible count
};

/// Points of a geodesic Poisson-disk sampling.
struct SamplingResult : Outcome {
	std::vector<Vec3d>            points;        ///< in the frame of the input
	std::vector<BarycentricPoint> surfacePoints; ///< per point: its face of the input and weights
	std::vector<double>           radii;         ///< per point: radius of its disk, mesh units
	double diskRadius = 0; ///< radius of the largest disks, mesh units: r of eq. (1) if all are
						   ///< equal; two points are (1-ε) times their mean radius apart, or more
};

/// An edge of the input on a feature line.
struct FeatureEdge {
	std::int32_t vertex[2] = {-1, -1}; ///< of the input
	float        strength  = 0;        ///< degrees
};

/// Counts and lengths of the features that detectFeatures found.
struct FeatureFigures {
	std::int64_t vertexNum   = 0; ///< marked vertices of the input
	std::int64_t faceNum     = 0; ///< marked faces of the input
	std::int64_t edgeNum     = 0;
	std::int64_t lineNum     = 0; ///< connected sets of edges
	std::int64_t cornerNum   = 0; ///< vertices at which a line ends, branches or turns
	std::int64_t coneApexNum = 0; ///< cone apexes off the lines
	double       support     = 0; ///< radius of the half-disks, mesh units
	double       minLength   = 0; ///< length below which lines were dropped, mesh units
};

/// Features of the input, in the order of its vertices and faces. The report has input, cleaned,
/// stages, threads and seconds only.
struct FeatureResult : Outcome {
	std::vector<float>        vertexStrength; ///< per vertex, degrees in [0, 180]
	std::vector<std::uint8_t> vertexFeature;  ///< per vertex: VertexFeature bits, 0 = no feature
	std::vector<std::uint8_t> faceMark;       ///< per face: 1 if a vertex of the face is marked
	std::vector<FeatureEdge>  edges;
	FeatureFigures            figures;
};

/// The name of a status for logs and reports: "ok", "cancelled", ...
const char* statusName(Status status);

} // namespace gpr

#endif
