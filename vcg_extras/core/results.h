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

/// How a run ended. Everything but Ok exports no mesh; message says why in one sentence.
enum class Status {
	Ok,
	BadOptions,    ///< an option out of range
	UnusableInput, ///< no usable face, indices out of range, no area, ...
	CountTooSmall, ///< fewer vertices asked than the topology needs; smallestVertexNum is set
	PromiseBroken, ///< the audit of the result failed; report.audit says how
	OutOfMemory,   ///< or more than there is would be needed
	Cancelled,
	OutOfTime, ///< RemeshOptions::timeLimitSeconds have passed
	InternalError,
};

/// A remeshed surface, or the reason why there is none.
struct RemeshResult {
	Status                   status = Status::InternalError;
	std::string              message; ///< empty when Ok; a sentence for the user otherwise
	std::vector<std::string> notes;   ///< sentences worth showing even when all went well
	TriangleMesh             mesh;    ///< in the caller's frame
	/// Unless options do without, per result vertex: where on the caller's mesh it lies.
	std::vector<BarycentricPoint> surfacePoints;
	/// Where options ask for it, per result face: where on the caller's mesh its middle lies.
	std::vector<BarycentricPoint> facePoints;
	/// Where the caller's mesh has regions, per result face: the label of the region it belongs to,
	/// which is that of the caller's face with its point in facePoints.
	std::vector<std::int32_t> region;
	/// Per result vertex, where some had to stay: which of the caller's it is, bit for bit, or -1.
	std::vector<std::int32_t> callersVertex;
	/// Per result face, with selectedOnly: which of the caller's it is, or -1 for the new ones.
	std::vector<std::int32_t> callersFace;
	std::vector<std::int32_t> sampleOf; ///< retriangulate: which sample each vertex is, or -1
	std::int64_t smallestVertexNum = 0; ///< set with CountTooSmall: what to ask for instead
	RemeshReport report;
};

/// Points of a geodesic Poisson-disk sampling.
struct SamplingResult {
	Status                        status = Status::InternalError;
	std::string                   message;
	std::vector<std::string>      notes;
	std::vector<Vec3d>            points;        ///< in the caller's frame
	std::vector<BarycentricPoint> surfacePoints; ///< per point: where on the caller's mesh it lies
	std::vector<double>           radii;         ///< per point: of its disk, mesh units
	double diskRadius = 0; ///< of the largest disks, mesh units: r of eq. (1) where all are
						   ///< the same; the smallest spacing is (1-ε) times the mean of two
	RemeshReport report;
};

/// An edge of the caller's mesh that is a feature.
struct FeatureEdge {
	std::int32_t vertex[2] = {-1, -1}; ///< the caller's
	float        strength  = 0;        ///< degrees
};

/// What was found by detectFeatures, in numbers.
struct FeatureFigures {
	std::int64_t vertexNum   = 0; ///< the caller's vertices that are marked
	std::int64_t faceNum     = 0; ///< the caller's faces that are marked
	std::int64_t edgeNum     = 0;
	std::int64_t lineNum     = 0; ///< connected sets of feature edges
	std::int64_t cornerNum   = 0; ///< vertices where a line ends, branches or turns
	std::int64_t coneApexNum = 0; ///< cone apexes, on no line
	double       support     = 0; ///< radius of the half-disks, mesh units
	double       minLength   = 0; ///< shorter lines were dropped, mesh units
};

/// Features of the caller's mesh.
struct FeatureResult {
	Status                    status = Status::InternalError;
	std::string               message;
	std::vector<std::string>  notes;
	std::vector<float>        vertexStrength; ///< per vertex of the caller's, degrees in [0, 180]
	std::vector<std::uint8_t> vertexFeature;  ///< per vertex: VertexFeature bits, 0 = no feature
	std::vector<std::uint8_t> faceMark;       ///< per face: 1 where one of its vertices is marked
	std::vector<FeatureEdge>  edges;
	FeatureFigures            figures;
	RemeshReport              report; ///< input, cleaned, stages, threads and seconds only
};

/// One word for a status, for logs and reports: "ok", "cancelled", ...
const char* statusName(Status status);

} // namespace gpr

#endif
