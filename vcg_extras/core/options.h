// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OPTIONS_H
#define VCG_EXTRAS_CORE_OPTIONS_H

#include "vec.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace gpr {

/// How the wanted size of the result is given.
enum class TargetMode {
	VertexNum,  ///< exactly targetVertexNum vertices; a count below what the topology needs is
				///< refused
	FaceNum,    ///< exactly targetFaceNum faces; refused where the topology does not allow it
	Percent,    ///< targetPercent of the input's vertices; raised where the topology needs more
	EdgeLength, ///< mean edge length targetEdgeLen; raised count where the topology needs more
	MaxError,   ///< the least count found that is proven to be within targetMaxError of the input
	Sizes,      ///< as many as sizes in mesh units take: MeshView::wantedEdge, or maxEdge
	Detail,     ///< the count for which the error is forecast to be that of targetDetail
};

/// How much of a shape is kept, in words: with which count 99.9 % of the surface is forecast to be
/// nearer than this share of the diagonal.
enum class Detail {
	None,
	Coarse, ///< about 1 %
	Normal, ///< about 0.3 %
	Fine,   ///< about 0.1 %
};

/// Which methods the stages use.
enum class Preset {
	Default, ///< the project's own way: the most regular triangles, fitted to the input
	Fast,    ///< the same, without the fit and the passes that cost most
	Paper,   ///< the paper as it is written, stage by stage: docs/paper.md
	/// Fast, with two rounds of the fit: for a mesh that is remeshed again. In no host's list.
	FastFitted,
};

/// Where the features are that §3.1.1 of the paper preserves.
enum class FeatureRegion {
	None,
	Detected,  ///< by second-order difference, see feature_detection.h
	Selection, ///< MeshView::selected
	/// Where a disk scale is given: MeshView::selected, or what is detected where none is
	/// selected. Else None.
	Auto,
};

/// What becomes of the surface's border.
enum class BoundaryMode {
	Resample, ///< its curve and its corners stay, other vertices are placed on it anew
	Keep,     ///< its vertices stay where they are, and no others are put between them
	Free,     ///< evenly spaced vertices on it, past its corners
	Smooth,   ///< a smooth curve near it, past teeth and bays smaller than an edge
	Match,    ///< as Resample, by the border and the edge length alone: see matched_border.h
};

/// Whether the result is its own mirror image: see run/symmetry.h.
enum class Symmetry {
	Off,
	X,   ///< across the plane through the middle of the box, perpendicular to the x-axis
	Y,   ///< to the y-axis
	Z,   ///< to the z-axis
	Auto ///< across that of these planes, or of those of the principal axes, that suits best
};

/// What becomes of junctions: edges with more than two faces, and places where sheets touch.
enum class JunctionMode {
	Cut,  ///< but for the smoothest pair of faces: the result is manifold
	Keep, ///< each is sampled once for all its sheets, which are joined again: see junctions.h
};

/// Whether sharp edges of the input become edges of the result. They never do with Preset::Paper.
enum class FeatureMode {
	Auto,  ///< where they are real creases, not a scan's noise; see crease_lines.h
	Lines, ///< wherever the surface turns by featureAngleDeg
	Off,
	Given, ///< where the caller says so (MeshView::line), and nowhere else
};

/// Thresholds of the second-order difference.
struct FeatureThresholds {
	double support   = 2;  ///< radius of the support in mean edges of the input, > 0, <= 100
	double strongDeg = 40; ///< a feature begins where the normals differ by this, (0, 180]
	double weakDeg   = 20; ///< and goes on down to this, (0, strongDeg]
	double minLength = 3;  ///< shorter chains are dropped; in supports, >= 0
};

/// Everything a caller can choose. Plain data; nothing here is working state.
struct RemeshOptions {
	TargetMode   targetMode      = TargetMode::Percent;
	std::int64_t targetVertexNum = 0;  ///< vertices, >= 1; used with TargetMode::VertexNum
	std::int64_t targetFaceNum   = 0;  ///< faces, >= 1; used with TargetMode::FaceNum
	double       targetPercent   = 10; ///< percent of the input's vertices, > 0, <= 10000
	double       targetEdgeLen   = 0;  ///< mesh units, > 0; used with TargetMode::EdgeLength
	double       targetMaxError  = 0;  ///< mesh units, > 0; used with TargetMode::MaxError
	/// Lengths that are in percent of the diagonal instead of mesh units.
	bool          edgeLenIsPercent = false, maxErrorIsPercent = false;
	bool          minEdgeIsPercent = false, maxEdgeIsPercent = false;
	Detail        targetDetail = Detail::None; ///< used with TargetMode::Detail
	bool          allowNearest = false; ///< take the nearest reachable count instead of refusing
	std::uint32_t seed         = 1;     ///< 0 = a fresh seed, told in the report
	int           threads      = 0;     ///< 0 = one per core; never changes the result
	/// Components with fewer faces are left out; 0 = none.
	std::int64_t dropComponentsBelow = 0;
	bool         sew = true; ///< borders that lie at one place edge by edge are joined: sew_seams.h
	double       timeLimitSeconds = 0; ///< the run ends then without a result; 0 = none
	bool check = false; ///< self-intersections and distances are looked for: thorough_check.h
	/// Self-intersections are looked for and taken out: guard/contact_removal.h. Never with
	/// Preset::Paper. Off for tests and measurements of what comes before: no host offers it.
	bool guard = true;
	/// The fit of the presets that have one. Off for the same uses as `guard`.
	bool fit          = true;
	bool selectedOnly = false; ///< remesh the selected faces, leave the rest as it is
	/// Export RemeshResult::surfacePoints; without them a big surface takes 4 B a face less.
	bool surfacePointsOfVertices = true;
	bool surfacePointsOfFaces    = false; ///< export RemeshResult::facePoints

	Preset preset        = Preset::Default;
	int    umbrellaSteps = 3;    ///< of Preset::Paper only: smoothing steps, 0 to 1000
	int    flipPasses    = 1000; ///< of Preset::Paper only: edge flips, each time; 0 to 1000

	double lambda = 0; ///< weight of the density, >= 0; without unit but with Preset::Paper
	std::optional<double> adapt; ///< sizes by the error, [0, 1]; 0 = evenly; see resolveAdapt

	double minEdge = 0;    ///< no edge is wanted shorter than this, mesh units; 0 = any
	double maxEdge = 0;    ///< nor longer than this; 0 = any
	double growth  = 1.15; ///< of the wanted length from one edge to the next, [1.05, 2]

	BoundaryMode boundary = BoundaryMode::Resample;
	/// Lengths of a periodic cell, mesh units, 0 along an axis without a period: the border's
	/// vertices at opposite ends of the cell match; BoundaryMode::Match is in force then.
	Vec3d period;

	Symmetry     symmetry  = Symmetry::Off;
	JunctionMode junctions = JunctionMode::Cut; ///< never kept with Preset::Paper

	FeatureMode featureMode     = FeatureMode::Auto;
	double      featureAngleDeg = 40; ///< feature lines: between the normals of two faces, [5, 175]

	FeatureRegion featureRegion = FeatureRegion::Auto;
	/// Disk radius in the region over r, [0.05, 1]. 0 where a region is named: 0.5, or with
	/// Preset::Paper no disks: every vertex of the region is kept. 0 else: no region.
	double            featureDiskScale = 0;
	FeatureThresholds featureThresholds;
};

inline bool isPaper(const RemeshOptions& options)
{
	return options.preset == Preset::Paper;
}

inline bool isPeriodic(const RemeshOptions& options)
{
	return !(options.period == Vec3d());
}

inline bool keepsJunctions(const RemeshOptions& options)
{
	return options.junctions == JunctionMode::Keep && !isPaper(options);
}

/// Whether vertices leave the surface for where the triangles lie closest to it (see fit.h).
inline bool isFitted(const RemeshOptions& options)
{
	return options.fit &&
		   (options.preset == Preset::Default || options.preset == Preset::FastFitted);
}

/// Whether a feature region is asked for, by its name or by its disk scale.
bool asksForFeatureRegion(const RemeshOptions& options);

/// Of options in force (resolveFeatureRegion): whether every vertex of the feature region becomes a
/// vertex of the result (paper §3.1.1). Otherwise it is sampled first, with smaller disks.
inline bool keepsRegionVertices(const RemeshOptions& options)
{
	return isPaper(options) && options.featureDiskScale == 0;
}

/// Whether the region is made of the selected vertices, or may be: it is named so, or not named.
bool mayUseSelectedVertices(const RemeshOptions& options);

/// Puts the region that FeatureRegion::Auto stands for, and the disk scale that 0 stands for, in
/// their places.
void resolveFeatureRegion(bool anySelected, RemeshOptions& options);

/// The adaptivity in force. Preset::Paper has none. One that is not given is 0 where the caller
/// asked for another density (lambda), and where no fit makes the result closer: in the presets
/// without it, and where only samples are wanted (`makesMesh` is false). Else it is 0.1; with
/// TargetMode::MaxError 1: a distance is kept with fewest vertices where they are spent on it.
double resolveAdapt(const RemeshOptions& options, bool makesMesh);

/// The error that targetDetail stands for, over the diagonal.
double detailError(Detail detail);

/// Complaints about values out of range, one sentence each; empty when all is well.
std::vector<std::string> validate(const RemeshOptions& options);

/// Which of the options that differ from their defaults have no effect beside the others, one
/// sentence each.
std::vector<std::string> optionsWithoutEffect(const RemeshOptions& options);

} // namespace gpr

#endif
