// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_REPORT_H
#define VCG_EXTRAS_CORE_REPORT_H

#include <cstdint>
#include <string>
#include <vector>

namespace gpr {

/// Counts and measures of a mesh.
struct MeshFigures {
	std::int64_t vertices            = 0;
	std::int64_t faces               = 0;
	std::int64_t components          = 0; ///< faces linked over edges
	std::int64_t boundaryLoops       = 0;
	std::int64_t eulerCharacteristic = 0;
	double       area                = 0; ///< mesh units squared
	double       diagonal            = 0; ///< of the bounding box, mesh units

	bool hasTopologyOf(const MeshFigures& other) const
	{
		return components == other.components && boundaryLoops == other.boundaryLoops &&
			   eulerCharacteristic == other.eulerCharacteristic;
	}
};

/// Counts of repairs, drops and cuts during cleaning. All zero for a clean mesh.
struct CleanCounts {
	std::int64_t nonFiniteVertices    = 0; ///< NaN or Inf coordinates, dropped with their faces
	std::int64_t unreferencedVertices = 0; ///< in no face, dropped
	std::int64_t weldedVertices       = 0; ///< of a triangle soup: equal positions made one vertex
	std::int64_t contractedEdges      = 0; ///< edges without length, made one vertex
	std::int64_t sewnEdges            = 0; ///< pairs of border edges at one place, made one edge
	std::int64_t sharedBorderEdges    = 0; ///< at the place of another border edge, unsewn
	std::int64_t repeatedIndexFaces   = 0; ///< a vertex twice in one face, dropped
	std::int64_t zeroAreaFaces        = 0; ///< no width, or in a component without area; dropped
	std::int64_t duplicateFaces       = 0; ///< the same three vertices again, dropped
	std::int64_t reorientedFaces      = 0;
	std::int64_t nonManifoldEdges     = 0; ///< more than two faces: cut but for the smoothest pair
	std::int64_t nonManifoldVertices  = 0; ///< more than one fan: a copy for each further fan
	std::int64_t nonOrientableCuts    = 0; ///< edges cut to make a one-sided surface orientable
	std::int64_t droppedComponents    = 0; ///< with fewer faces than RemeshOptions asks for
	std::int64_t droppedFaces         = 0; ///< faces of the dropped components
	std::int64_t longEdgesSplit       = 0; ///< edges longer than 0.8 r, split for the sampling only
	/// Junction edges: the largest length of a connected set, in working units.
	double longestJunction = 0;

	/// Whether cleaning changed the input (splitting edges does not count).
	bool changedInput() const
	{
		return nonFiniteVertices || weldedVertices || contractedEdges || sewnEdges ||
			   repeatedIndexFaces || zeroAreaFaces || duplicateFaces || reorientedFaces ||
			   nonManifoldEdges || nonManifoldVertices || nonOrientableCuts || droppedComponents;
	}
};

/// Wall time of one stage.
struct StageTime {
	std::string stage; ///< a lowerCamelCase key: "order", "sampling", ...
	double      seconds = 0;
};

/// Shape measures of the triangles.
struct QualityFigures {
	double radiusRatioMean = 0; ///< 2·inradius/circumradius, 1 = equilateral
	double radiusRatioMin  = 0;
	double aspectRatioMean = 0; ///< 2√3·inradius/longest edge, the paper's measure, 1 = equilateral
	double aspectRatioMin  = 0;
	double minAngleDeg     = 0; ///< smallest angle of all faces
	double meanMinAngleDeg = 0; ///< mean over the faces of their smallest angle
	double maxAngleDeg     = 0;
	double below30Percent  = 0; ///< share of faces with an angle below 30°
	double valence6Percent = 0; ///< share of interior vertices with six faces
	double meanEdgeLen     = 0; ///< mesh units
};

/// Counts of the search for self-intersections and of their removal.
struct GuardedFigures {
	bool         isTested     = false;
	std::int64_t foundPairNum = 0; ///< contacts before any removal
	std::int64_t inputFaceNum = 0; ///< faces of the input in contact, near the contacts found
	std::int64_t vertexNum    = 0; ///< vertices made anew by guarded collapses of the input
	std::int64_t pairNum      = 0; ///< contacts left
};

/// Findings of the check before the export.
struct AuditFigures {
	bool           passed              = false;
	std::int64_t   nonManifoldEdges    = 0;
	std::int64_t   nonManifoldVertices = 0;
	std::int64_t   duplicateFaces      = 0;
	std::int64_t   zeroAreaFaces       = 0;
	std::int64_t   invertedFaces       = 0; ///< normals against the input's; no failure
	std::int64_t   nonFinitePositions  = 0;
	bool           componentsKept      = false;
	bool           boundaryLoopsKept   = false;
	bool           eulerKept           = false;
	bool           junctionsKept       = false; ///< true also without junctions
	bool           countExact          = false;
	GuardedFigures guarded;
};

/// Distances of the points of one surface from another, mesh units.
struct SurfaceDistance {
	double rms  = 0; ///< over the area: the E_RMS of Metro
	double p999 = 0; ///< 99.9 % of the area is nearer
	double max  = 0; ///< over all measured points: a lower bound of the one-sided Hausdorff
					 ///< distance

	SurfaceDistance times(double unit) const { return {rms * unit, p999 * unit, max * unit}; }
};

/// Distances of input and result from each other, mesh units.
struct MutualDistance {
	SurfaceDistance toInput;   ///< from points of the result to the input
	SurfaceDistance fromInput; ///< from points of the input to the result

	MutualDistance times(double unit) const { return {toInput.times(unit), fromInput.times(unit)}; }
	/// The larger of both ways, figure by figure.
	SurfaceDistance larger() const
	{
		return {toInput.rms > fromInput.rms ? toInput.rms : fromInput.rms,
				toInput.p999 > fromInput.p999 ? toInput.p999 : fromInput.p999,
				toInput.max > fromInput.max ? toInput.max : fromInput.max};
	}
};

/// Proven bounds of a largest distance, mesh units.
struct DistanceBounds {
	double lower         = 0;     ///< at least one point is at this distance or farther
	double upper         = 0;     ///< no point is farther
	bool   isBudgetSpent = false; ///< the gap of the bounds is larger than wanted

	DistanceBounds times(double unit) const { return {lower * unit, upper * unit, isBudgetSpent}; }
};

/// Proven bounds of the largest distance between input and result, both ways.
struct MutualBounds {
	DistanceBounds toInput;   ///< from points of the result to the input
	DistanceBounds fromInput; ///< from points of the input to the result

	MutualBounds times(double unit) const { return {toInput.times(unit), fromInput.times(unit)}; }
	/// Bounds of the larger of both: the Hausdorff distance.
	DistanceBounds hausdorff() const
	{
		return {toInput.lower > fromInput.lower ? toInput.lower : fromInput.lower,
				toInput.upper > fromInput.upper ? toInput.upper : fromInput.upper,
				toInput.isBudgetSpent || fromInput.isBudgetSpent};
	}
};

/// Lengths of the border before and after BoundaryMode::Smooth, mesh units.
struct BorderFigures {
	double length       = 0; ///< border of the input
	double resultLength = 0; ///< border of the result

	bool isSmooth() const { return length > 0; } ///< Smooth was in force and there is a border
};

/// Findings of RemeshOptions::check.
struct CheckFigures {
	bool         done                   = false;
	std::int64_t intersectingFaces      = 0; ///< faces of the result with self-intersections
	std::int64_t inputIntersectingFaces = 0; ///< of the input, if the result has some
	double       vertexDistance         = 0; ///< largest from a vertex to the input, mesh units
	double       largestDistance        = 0; ///< largest distance measured, mesh units
	/// Distances of sampled points. The largest is at least the lower bound of provenDistance.
	MutualDistance distance;
};

/// The role of a vertex in the features, as bits.
enum VertexFeature : std::uint8_t {
	OnFeatureLine   = 1, ///< end of an edge of a feature line
	FeatureCorner   = 2, ///< vertex at which a line ends, branches or turns
	FeatureConeApex = 4, ///< apex of a cone: a feature without lines
};

/// All figures of a run.
struct RemeshReport {
	MeshFigures            input;        ///< before cleaning
	MeshFigures            cleanedInput; ///< after cleaning; for comparison with the result
	MeshFigures            result;
	CleanCounts            cleaned;
	QualityFigures         quality;
	AuditFigures           audit;
	CheckFigures           check;
	BorderFigures          border;
	std::vector<StageTime> stages;
	double                 remeshSeconds = 0; ///< wall time from mesh in memory to result in memory

	std::uint32_t seed            = 0;
	double        adapt           = 0; ///< adaptivity in force; 0 with even sizes
	int           threads         = 0;
	std::int64_t  targetVertexNum = 0; ///< the count that percent or edge length resolve to
	/// If many triangles are irregular, or round crease edges off: the number of vertices with
	/// which about 95 % of the faces have no angle below 30 degrees, by a forecast. 0: not needed,
	/// or not known.
	std::int64_t regularVertexNum        = 0;
	double       diskRadius              = 0; ///< r, mesh units
	double       radiusConstant          = 0; ///< c of eq. (1)
	double       radiusConstantForTarget = 0; ///< without the exact count: c for the target
	std::int64_t curvatureClampedNum     = 0; ///< vertices at which 1 + λH fell below 0.1
	std::int64_t sampleNum               = 0; ///< samples placed by the front sampling
	std::int64_t boundarySampleNum       = 0;
	std::int64_t featureEdgeNum          = 0; ///< edges of the input on feature lines
	std::int64_t featureConeApexNum      = 0; ///< cone apexes
	std::int64_t releasedVertexNum       = 0; ///< vertices of the result that left crowded lines
	std::int64_t regionVertexNum         = 0; ///< input vertices in the feature region
	std::int64_t keptVertexNum           = 0; ///< vertices that had to stay, and stayed
	std::int64_t untouchedFaceNum        = 0; ///< selectedOnly: faces outside the selection
	std::int64_t leftoverVertexNum       = 0; ///< input vertices that could not be removed
	std::int64_t splitNum                = 0; ///< splits for the exact count
	std::int64_t collapseNum             = 0;
	std::int64_t flipNum                 = 0;
	std::int64_t samplesMoved            = 0;     ///< retriangulate: samples off the surface
	double       largestSampleMove       = 0;     ///< mesh units
	double       largestFitDistance      = 0;     ///< from surface point to vertex, mesh units
	double       errorGoal               = 0;     ///< the error bound, mesh units; 0: none
	bool         isDistanceProven        = false; ///< with RemeshOptions::check, or an error bound
	MutualBounds provenDistance;                  ///< between cleaned input and result
	int          errorTrialNum = 0;               ///< counts tried for the error bound
	std::vector<std::string> capsReached;         ///< a phrase for each cap that was reached
};

} // namespace gpr

#endif
