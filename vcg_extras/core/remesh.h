// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_REMESH_H
#define VCG_EXTRAS_CORE_REMESH_H

#include "mesh_view.h"
#include "options.h"
#include "report.h"

#include <string>
#include <vector>

namespace gpr {

/// How a run ended. Everything but Ok hands out no mesh; message says why in one sentence.
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
	std::vector<SurfacePoint> anchors;
	/// Where options ask for it, per result face: where on the caller's mesh its middle lies.
	std::vector<SurfacePoint> faceAnchors;
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
	Status                    status = Status::InternalError;
	std::string               message;
	std::vector<std::string>  notes;
	std::vector<Vec3d>        points;  ///< in the caller's frame
	std::vector<SurfacePoint> anchors; ///< per point: where on the caller's mesh it lies
	std::vector<double>       radii;   ///< per point: of its disk, mesh units
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
	std::int64_t tipNum      = 0; ///< tips of cones, on no line
	double       support     = 0; ///< radius of the half-disks, mesh units
	double       leastLength = 0; ///< shorter lines were dropped, mesh units
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

/// Remeshes a surface with about-equilateral triangles of equal size: the whole way of
/// "Fast Edge-based geodesic Poisson Disk Remeshing" with the placement by disk intersection.
/// Needs any triangle mesh; what is not 2-manifold is repaired or cut, counted in report.cleaned.
/// With selectedOnly the result is the faces that are not selected, in their order, then the new
/// ones; both share the vertices of the seam between them. Counts, figures and checks are of the
/// selected part. Refused where the seam has an edge of more than two faces.
/// The input is never modified. The result depends on input, options and seed only, not on threads.
/// Cost: linear in the input; docs/measurements.md has seconds.
/// Never throws but for programming errors.
RemeshResult remesh(const MeshView& input, const RemeshOptions& options,
					const ProgressCallback& progress = nullptr);

/// The sampling stage alone (paper §3, steps 1–8): points at least (1-ε) r apart, every vertex of
/// the input within r of one. The count lands within about a tenth of the target (no correction).
SamplingResult samplePoissonDisks(const MeshView& input, const RemeshOptions& options,
								  const ProgressCallback& progress = nullptr);

/// Retriangulation from given samples (paper §3, last paragraph): a mesh with the input's topology
/// whose vertices are the samples, each exactly where it was given. Samples off the surface are put
/// on it first (nearest point); report.samplesMoved and report.largestSampleMove tell how many and
/// how far. Where the topology needs more vertices than there are samples, vertices of the input
/// stay: report.leftoverVertexNum. Of the options, seed and threads count; relaxIterations and
/// count do not.
RemeshResult retriangulate(const MeshView& input, const std::vector<Vec3d>& samples,
						   const RemeshOptions&    options,
						   const ProgressCallback& progress = nullptr);

/// Finds creases and tips by a uniformly supported second-order difference (paper §3.1; see
/// feature_detection.h and docs/features.md). Of the options, featureThresholds and threads count.
/// A mesh that is not 2-manifold is repaired or cut for this; edges cut are no features.
/// The input is never modified. Cost: linear; about 2 s per million faces and core.
FeatureResult detectFeatures(const MeshView& input, const RemeshOptions& options,
							 const ProgressCallback& progress = nullptr);

/// One word for a status, for logs and reports: "ok", "cancelled", ...
const char* statusName(Status status);

} // namespace gpr

#endif
