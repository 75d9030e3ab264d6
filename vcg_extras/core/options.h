// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OPTIONS_H
#define VCG_EXTRAS_CORE_OPTIONS_H

#include <cstdint>
#include <string>
#include <vector>

namespace gpr {

/// How the wanted size of the result is given.
enum class TargetMode {
	VertexNum,  ///< exactly targetVertexNum vertices; a count below what the topology needs is
				///< refused
	Percent,    ///< targetPercent of the input's vertices; raised where the topology needs more
	EdgeLength, ///< mean edge length targetEdgeLen; raised count where the topology needs more
	MaxError,   ///< the least count found that is proven to be within targetMaxError of the input
};

/// A named set of the stage choices below.
enum class Preset {
	Default, ///< the project's own way: the most regular triangles
	Fast,    ///< the same, without the passes that cost most
	Paper,   ///< the paper as it is written
};

/// Where the next sample is put (docs/paper.md).
enum class Placement {
	DiskIntersection, ///< where the borders of two disks meet
	BorderEdge,       ///< paper §3: a random border edge, eq. (3), fused into the mesh by a split
};

/// How the samples become a mesh.
enum class Retriangulation {
	LabelCollapse, ///< every vertex is merged into its own sample's cell
	VertexRemoval, ///< paper §3: every vertex is removed, its hole closed by constrained Delaunay
};

/// How vertices move after the retriangulation.
enum class Smoothing {
	Barycentric, ///< to the area-weighted barycentre, on the surface
	Umbrella2,   ///< paper §3: second-order umbrella (Kobbelt et al. 1998), tangential part
	None,
};

/// How far the triangles are made regular. Plain where the smoothing is not barycentric.
enum class Regularity {
	Full,  ///< dislocations glide together, triangles become equilateral by conformal steps
	Plain, ///< relaxation steps and flips only
};

/// Whether vertices leave the surface for where the triangles lie closest to it (see fit.h).
enum class Fit {
	Rounds, ///< until little changes
	Quick,  ///< half the time, nearly as close on smooth surfaces
	Off,    ///< every vertex stays on the surface
};

/// Which form of eq. (1), (4) and (5) sets the radius and the density.
enum class Equations {
	Calibrated, ///< a constant that hits the count, a density without units, its area mean
	AsPrinted,  ///< 0.844, signed mean curvature in 1/mesh unit, vertex mean
};

/// What the local density comes from where lambda is above 0.
enum class SizingSource {
	Curvature, ///< eq. (4)
	Quality,   ///< MeshView::quality takes the place of λ·H
};

/// Where the features are that §3.1.1 of the paper preserves.
enum class FeatureRegion {
	None,
	Detected,  ///< by second-order difference, see feature_detection.h
	Selection, ///< MeshView::selected
	/// Where a disk scale is given or vertices are to be kept: MeshView::selected, or what is
	/// detected where none is selected. Else None.
	Auto,
};

/// How a feature region is preserved (paper §3.1.1).
enum class FeatureSampling {
	Disks,    ///< sampled first, with disks scaled by featureDiskScale
	Vertices, ///< every vertex of the region becomes a vertex of the result
};

/// What becomes of the surface's border.
enum class BoundaryMode {
	Resample, ///< its curve and its corners stay, other vertices are placed on it anew
	Keep,     ///< its vertices stay where they are, and no others are put between them
	Free,     ///< evenly spaced vertices on it, past its corners
	Smooth,   ///< a smooth curve near it, past spikes and bays narrower than an edge
};

/// Whether sharp edges of the input become edges of the result. They do with
/// Placement::DiskIntersection and Retriangulation::LabelCollapse only.
enum class FeatureMode {
	Auto,  ///< where they are real creases, not a scan's noise; see crease_lines.h
	Lines, ///< wherever the surface turns by featureAngleDeg
	Off,
	Given, ///< where the caller says so (MeshView::line), and nowhere else
};

/// Adaptivity of a run whose caller does not choose one.
constexpr double usualAdapt = 0.1;

/// Thresholds of the second-order difference.
struct FeatureThresholds {
	double support   = 2;  ///< radius of the support in mean edges of the input, > 0, <= 100
	double strongDeg = 40; ///< a feature begins where the normals differ by this, (0, 180]
	double weakDeg   = 20; ///< and goes on down to this, (0, strongDeg]
	double minLength = 3;  ///< shorter chains are dropped; in supports, >= 0
};

/// Everything a caller can choose. Plain data; nothing here is working state.
struct RemeshOptions {
	TargetMode    targetMode        = TargetMode::Percent;
	std::int64_t  targetVertexNum   = 0;     ///< vertices, >= 1; used with TargetMode::VertexNum
	double        targetPercent     = 10;    ///< percent of the input's vertices, > 0, <= 10000
	double        targetEdgeLen     = 0;     ///< mesh units, > 0; used with TargetMode::EdgeLength
	double        targetMaxError    = 0;     ///< mesh units, > 0; used with TargetMode::MaxError
	bool          maxErrorIsPercent = false; ///< targetMaxError is in percent of the diagonal
	bool          exactCount        = true;  ///< split and collapse until the count is hit exactly
	bool          allowNearest    = false; ///< take the nearest reachable count instead of refusing
	int           relaxIterations = 3;     ///< smoothing steps, 0 to 1000
	int           flipIterations  = 1000;  ///< passes of edge flips at most, each time; 0 to 1000
	std::uint32_t seed            = 1;     ///< 0 = a fresh seed, told in the report
	int           threads         = 0;     ///< 0 = one per core; never changes the result
	/// Components with fewer faces are left out; 0 = none.
	std::int64_t dropComponentsBelow = 0;
	bool         sew = true; ///< borders that lie at one place edge by edge are joined: sew_seams.h
	double       timeLimitSeconds = 0; ///< the run ends then without a result; 0 = none
	bool check = false; ///< self-intersections and distances are looked for: thorough_check.h
	/// Self-intersections are looked for and taken out: run/guarded_result.h. Not with
	/// Equations::AsPrinted.
	bool guard        = true;
	bool selectedOnly = false; ///< remesh the selected faces, leave the rest as it is
	/// Export RemeshResult::surfacePoints; without them a big surface takes 4 B a face less.
	bool surfacePointsOfVertices = true;
	bool surfacePointsOfFaces    = false; ///< export RemeshResult::facePoints

	Placement       placement       = Placement::DiskIntersection;
	Retriangulation retriangulation = Retriangulation::LabelCollapse;
	Smoothing       smoothing       = Smoothing::Barycentric;
	Regularity      regularity      = Regularity::Full;
	Fit             fit             = Fit::Rounds;
	Equations       equations       = Equations::Calibrated;

	double       lambda         = 0; ///< weight of the density, >= 0; without unit if calibrated
	double       largestStretch = 4; ///< s_max of the density, [1, 100]; calibrated only
	SizingSource sizing         = SizingSource::Curvature;
	double       adapt = usualAdapt; ///< sizes by the error, [0, 1]; 0 = evenly; see resolveAdapt

	BoundaryMode boundary = BoundaryMode::Resample;

	FeatureMode featureMode     = FeatureMode::Auto;
	double      featureAngleDeg = 40; ///< feature lines: between the normals of two faces, [5, 175]

	FeatureRegion   featureRegion   = FeatureRegion::Auto;
	FeatureSampling featureSampling = FeatureSampling::Disks;
	/// Disk radius in the region over r, [0.05, 1]; 0 = 0.5 where a region is named, else no
	/// region.
	double            featureDiskScale = 0;
	FeatureThresholds featureThresholds;
};

/// Sets placement, retriangulation, smoothing, regularity, fit, equations, exactCount and
/// featureMode to those of a preset and leaves the rest alone.
void applyPreset(Preset preset, RemeshOptions& options);

/// Whether a feature region is asked for, and where none is named, by its disk scale or its
/// vertices.
bool asksForFeatureRegion(const RemeshOptions& options);

/// Whether the region is made of the selected vertices, or may be: it is named so, or not named.
bool mayUseSelectedVertices(const RemeshOptions& options);

/// Puts the region that FeatureRegion::Auto stands for, and the disk scale that 0 stands for, in
/// their places.
void resolveFeatureRegion(bool anySelected, RemeshOptions& options);

/// What RemeshOptions::adapt comes to. The paper's equations have no adaptivity. The usual one
/// stands for 0 where the caller asked for another density (lambda), and where no fit makes the
/// result closer: in the quick presets, and where only samples are wanted (`isFitted` is false).
/// With TargetMode::MaxError it stands for 1: a distance is kept with fewest vertices where they
/// are spent on it.
double resolveAdapt(const RemeshOptions& options, bool isFitted);

/// Complaints about values out of range, one sentence each; empty when all is well.
std::vector<std::string> validate(const RemeshOptions& options);

/// Which of the options that differ from their defaults have no effect beside the others, one
/// sentence each.
std::vector<std::string> optionsWithoutEffect(const RemeshOptions& options);

} // namespace gpr

#endif
