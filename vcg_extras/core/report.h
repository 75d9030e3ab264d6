// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_REPORT_H
#define VCG_EXTRAS_CORE_REPORT_H

#include <cstdint>
#include <string>
#include <vector>

namespace gpr {

/// Counts that describe a mesh's topology and size.
struct MeshFigures {
	std::int64_t vertices            = 0;
	std::int64_t faces               = 0;
	std::int64_t components          = 0; ///< faces linked over edges
	std::int64_t boundaryLoops       = 0;
	std::int64_t eulerCharacteristic = 0;
	double       area                = 0; ///< mesh units squared
	double       diagonal            = 0; ///< of the bounding box, mesh units
};

/// What cleaning repaired, dropped or cut. All zero for a clean mesh.
struct CleanCounts {
	std::int64_t nonFiniteVertices    = 0; ///< NaN or Inf coordinates, dropped with their faces
	std::int64_t unreferencedVertices = 0; ///< in no face, dropped
	std::int64_t weldedVertices       = 0; ///< of a triangle soup: equal positions made one vertex
	std::int64_t contractedEdges      = 0; ///< edges without length, made one vertex
	std::int64_t sewnEdges            = 0; ///< pairs of border edges at one place, made one edge
	std::int64_t sharedBorderEdges    = 0; ///< border edges at the place of others that stay cut
	std::int64_t repeatedIndexFaces   = 0; ///< a vertex twice in one face, dropped
	std::int64_t zeroAreaFaces        = 0; ///< without width, or of a piece without area: dropped
	std::int64_t duplicateFaces       = 0; ///< the same three vertices again, dropped
	std::int64_t reorientedFaces      = 0;
	std::int64_t nonManifoldEdges     = 0; ///< more than two faces: cut but for the smoothest pair
	std::int64_t nonManifoldVertices  = 0; ///< more than one fan: a copy for each further fan
	std::int64_t nonOrientableCuts    = 0; ///< edges cut to make a one-sided surface orientable
	std::int64_t droppedComponents    = 0; ///< with fewer faces than RemeshOptions asks for
	std::int64_t droppedFaces         = 0; ///< of those components
	std::int64_t longEdgesSplit       = 0; ///< edges longer than 0.8 r, split for the sampling only
	/// Of edges with more than two faces: the largest length of those that hang together, in the
	/// engine's units.
	double longestJunction = 0;

	/// Anything that changes what the input was (splitting edges does not).
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

/// Shape of the triangles.
struct QualityFigures {
	double radiusRatioMean = 0; ///< 2·inradius/circumradius, 1 = equilateral
	double radiusRatioMin  = 0;
	double aspectRatioMean = 0; ///< 2√3·inradius/longest edge, the paper's measure, 1 = equilateral
	double aspectRatioMin  = 0;
	double minAngleDeg     = 0; ///< smallest angle of all
	double meanMinAngleDeg = 0; ///< mean over the faces of their smallest angle
	double maxAngleDeg     = 0;
	double below30Percent  = 0; ///< share of faces with an angle below 30°
	double valence6Percent = 0; ///< share of interior vertices with six faces
	double meanEdgeLen     = 0; ///< mesh units
};

/// What was done so that the result does not intersect itself.
struct GuardedFigures {
	bool         isTested     = false;
	std::int64_t foundPairNum = 0; ///< touching pairs of faces before anything was done
	std::int64_t inputPairNum = 0; ///< of the input, near those
	std::int64_t vertexNum    = 0; ///< made anew by guarded collapses of the input
	std::int64_t pairNum      = 0; ///< touching pairs of faces that are left
};

/// What was checked before the result was exported.
struct AuditFigures {
	bool           passed              = false;
	std::int64_t   nonManifoldEdges    = 0;
	std::int64_t   nonManifoldVertices = 0;
	std::int64_t   duplicateFaces      = 0;
	std::int64_t   zeroAreaFaces       = 0;
	std::int64_t   invertedFaces       = 0; ///< normals against the input's; counted, not failed
	std::int64_t   nonFinitePositions  = 0;
	bool           componentsKept      = false;
	bool           boundaryLoopsKept   = false;
	bool           eulerKept           = false;
	bool           junctionsKept       = false; ///< or there are none to keep
	bool           countExact          = false;
	GuardedFigures guarded;
};

/// Distances of the points of one surface from another, mesh units.
struct SurfaceDistance {
	double rms  = 0; ///< over the area: the E_RMS of Metro
	double p999 = 0; ///< 99.9 % of the area is nearer than this
	double max  = 0; ///< over all points measured: the one-sided Hausdorff distance from below

	SurfaceDistance times(double unit) const { return {rms * unit, p999 * unit, max * unit}; }
};

/// Distances of input and result from each other, mesh units.
struct MutualDistance {
	SurfaceDistance toInput;   ///< of the points of the result from the input
	SurfaceDistance fromInput; ///< of the points of the input from the result

	MutualDistance times(double unit) const { return {toInput.times(unit), fromInput.times(unit)}; }
	/// The larger of both ways, figure by figure.
	SurfaceDistance larger() const
	{
		return {toInput.rms > fromInput.rms ? toInput.rms : fromInput.rms,
				toInput.p999 > fromInput.p999 ? toInput.p999 : fromInput.p999,
				toInput.max > fromInput.max ? toInput.max : fromInput.max};
	}
};

/// A largest distance between proven bounds, mesh units.
struct DistanceBounds {
	double lower         = 0;     ///< some point is so far, or farther
	double upper         = 0;     ///< no point is farther
	bool   isBudgetSpent = false; ///< the bounds are farther from each other than they were to be

	DistanceBounds times(double unit) const { return {lower * unit, upper * unit, isBudgetSpent}; }
};

/// Proven bounds of the largest distance of input and result from each other, both ways.
struct MutualBounds {
	DistanceBounds toInput;   ///< of the points of the result from the input
	DistanceBounds fromInput; ///< of the points of the input from the result

	MutualBounds times(double unit) const { return {toInput.times(unit), fromInput.times(unit)}; }
	/// Of the larger of both: the Hausdorff distance.
	DistanceBounds hausdorff() const
	{
		return {toInput.lower > fromInput.lower ? toInput.lower : fromInput.lower,
				toInput.upper > fromInput.upper ? toInput.upper : fromInput.upper,
				toInput.isBudgetSpent || fromInput.isBudgetSpent};
	}
};

/// What became of the border (BoundaryMode::Smooth), mesh units.
struct BorderFigures {
	double length       = 0; ///< of the input's border
	double resultLength = 0; ///< of the result's

	bool isSmooth() const { return length > 0; } ///< asked for, and there is a border
};

/// What RemeshOptions::check found.
struct CheckFigures {
	bool         done                   = false;
	std::int64_t intersectingFaces      = 0; ///< of the result, that intersect another
	std::int64_t inputIntersectingFaces = 0; ///< looked for only where the result has some
	double       vertexDistance         = 0; ///< largest of a vertex from the input, mesh units
	double       largestDistance        = 0; ///< largest of distance, mesh units
	/// Found by sampling. The largest distances are at least the lower bounds of provenDistance.
	MutualDistance distance;
};

/// What a vertex is to the features, as bits.
enum VertexFeature : std::uint8_t {
	OnFeatureLine   = 1, ///< end of a feature edge
	FeatureCorner   = 2, ///< on a line, which ends, branches or turns here
	FeatureConeApex = 4, ///< apex of a cone: a feature by itself
};

/// Everything a run tells about itself.
struct RemeshReport {
	MeshFigures            input;        ///< as given
	MeshFigures            cleanedInput; ///< after cleaning: what the result is held against
	MeshFigures            result;
	CleanCounts            cleaned;
	QualityFigures         quality;
	AuditFigures           audit;
	CheckFigures           check;
	BorderFigures          border;
	std::vector<StageTime> stages;
	double                 remeshSeconds = 0; ///< wall time from mesh in memory to result in memory

	std::uint32_t seed            = 0;
	double        adapt           = 0; ///< in force: 0 where sizes stayed even
	int           threads         = 0;
	std::int64_t  targetVertexNum = 0; ///< after percent or edge length were resolved
	/// Where many triangles are irregular: vertices with which about 95 % have no angle below 30
	/// degrees, by a forecast. 0: not needed, or not known.
	std::int64_t regularVertexNum  = 0;
	double       diskRadius        = 0; ///< r, mesh units
	double       radiusConstant    = 0; ///< c of eq. (1)
	double radiusConstantForTarget = 0; ///< without the exact count: what would have hit the target
	std::int64_t curvatureClampedNum = 0; ///< vertices where 1 + λH fell below 0.1
	std::int64_t sampleNum           = 0; ///< what the front sampling placed
	std::int64_t boundarySampleNum   = 0;
	std::int64_t featureEdgeNum      = 0; ///< edges of the input on feature lines
	std::int64_t featureConeApexNum  = 0; ///< cone apexes
	std::int64_t releasedVertexNum   = 0; ///< of the result, that left crowded lines
	std::int64_t regionVertexNum     = 0; ///< of the caller's, in the feature region
	std::int64_t keptVertexNum       = 0; ///< vertices that had to stay, and did
	std::int64_t untouchedFaceNum    = 0; ///< selectedOnly: faces that were left alone
	std::int64_t leftoverVertexNum   = 0; ///< input vertices that removal had to keep
	std::int64_t splitNum            = 0; ///< of the exact count
	std::int64_t collapseNum         = 0;
	std::int64_t flipNum             = 0;
	std::int64_t samplesMoved        = 0;     ///< retriangulate: samples that were off the surface
	double       largestSampleMove   = 0;     ///< mesh units
	double       largestFitDistance  = 0;     ///< from surface point to vertex, mesh units
	double       errorGoal           = 0;     ///< largest error asked for, mesh units; 0: none
	bool         isDistanceProven    = false; ///< with RemeshOptions::check, or an error goal
	MutualBounds provenDistance;              ///< of the cleaned input and the result
	int          errorTrialNum = 0;           ///< counts tried for the goal
	std::vector<std::string> capsReached;     ///< loops that ended by their bound, one phrase each
};

} // namespace gpr

#endif
