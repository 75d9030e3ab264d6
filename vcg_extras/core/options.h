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

/// The measure by which the user gives the size of the result.
enum class TargetMode {
	VertexNum,  ///< exactly targetVertexNum vertices; refused if the topology needs more
	FaceNum,    ///< exactly targetFaceNum faces; refused if the topology does not allow the count
	Percent,    ///< targetPercent of the input's vertices; more if the topology needs more
	EdgeLength, ///< mean edge length targetEdgeLen; more vertices if the topology needs more
	MaxError,   ///< the least count found with a proven distance of at most targetMaxError
	Sizes,      ///< the count that sizes in mesh units need: MeshView::wantedEdge, or maxEdge
	Detail,     ///< the count with a forecast error of detailError(targetDetail)
};

/// How much of a shape the result keeps, in words. The program forecasts the count with which
/// 99.9 % of the surface is nearer than this share of the diagonal.
enum class Detail {
	None,
	Coarse, ///< about 1 %
	Normal, ///< about 0.3 %
	Fine,   ///< about 0.1 %
};

/// A choice of methods for all stages.
enum class Preset {
	Default, ///< this project's methods: the most regular triangles, fitted to the input
	Fast,  ///< as Default, with one step in place of the fit, and without the passes that cost most
	Paper, ///< the methods of the paper, stage by stage: docs/paper.md
	/// Fast, with two rounds of the fit, for a result that another run remeshes. No host offers
	/// this preset.
	FastFitted,
};

/// The region of features that §3.1.1 of the paper preserves.
enum class FeatureRegion {
	None,
	Detected,  ///< by second-order difference, see feature_detection.h
	Selection, ///< MeshView::selected
	/// With a disk scale: Selection, or Detected if no vertex is selected. Without: None.
	Auto,
};

/// The treatment of the border.
enum class BoundaryMode {
	Resample, ///< curve and corners stay; the other vertices are placed anew on the curve
	Keep,     ///< all border vertices stay, and no vertex is added between two neighbours
	Free,     ///< evenly spaced vertices on the curve; corners do not stay
	Smooth,   ///< a smooth curve near the border; teeth and bays smaller than an edge go
	Match,    ///< as Resample, but a function of border and edge length only: see matched_border.h
};

/// The plane of symmetry of the result: see run/symmetry.h.
enum class Symmetry {
	Off,
	X,   ///< through the middle of the bounding box, perpendicular to the x-axis
	Y,   ///< likewise, to the y-axis
	Z,   ///< likewise, to the z-axis
	Auto ///< the plane that suits best, of X, Y, Z and the planes of the principal axes
};

/// The treatment of junctions: edges with more than two faces, and vertices of several sheets.
enum class JunctionMode {
	Cut,  ///< only the smoothest pair of faces stays linked: the result is manifold
	Keep, ///< all sheets of a junction get the same samples and are joined again: see junctions.h
};

/// The rule by which edges of the input become feature lines. Preset::Paper has no feature lines.
enum class FeatureMode {
	Auto,  ///< crease edges, unless they look like the noise of a scan; see crease_lines.h
	Lines, ///< all edges at which the surface bends by featureAngleDeg
	Off,
	Given, ///< the edges in MeshView::line only
};

/// Thresholds of the second-order difference.
struct FeatureThresholds {
	double support   = 2;  ///< radius of the support in mean edges of the input, > 0, <= 100
	double strongDeg = 40; ///< difference of normals at which a feature begins, (0, 180]
	double weakDeg   = 20; ///< difference down to which a feature goes on, (0, strongDeg]
	double minLength = 3;  ///< length below which a chain is dropped, in supports, >= 0
};

/// All options of a run. Plain data without working state.
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
	std::uint32_t seed         = 1;     ///< 0 = a fresh seed, which the report names
	int           threads      = 0;     ///< 0 = a thread per core; never changes the result
	/// Components with fewer faces are dropped; 0 = no component.
	std::int64_t dropComponentsBelow = 0;
	bool         sew                 = true; ///< joins border edges at the same place: sew_seams.h
	double timeLimitSeconds = 0; ///< time after which a run ends without a result; 0 = no limit
	bool   check = false; ///< searches self-intersections, measures distances: thorough_check.h
	/// Finds and removes self-intersections: guard/contact_removal.h. Without effect with
	/// Preset::Paper. Off only in tests and measurements of earlier stages; no host offers this.
	bool guard = true;
	/// The fit of the presets with a fit. Off for the same uses as `guard`.
	bool fit          = true;
	bool selectedOnly = false; ///< remeshes the selected faces, keeps all others
	/// Exports RemeshResult::surfacePoints. Off, a big surface takes 4 B a face less.
	bool surfacePointsOfVertices = true;
	bool surfacePointsOfFaces    = false; ///< exports RemeshResult::facePoints

	Preset preset        = Preset::Default;
	int    umbrellaSteps = 3;    ///< Preset::Paper only: smoothing steps, 0 to 1000
	int    flipPasses    = 1000; ///< Preset::Paper only: passes of edge flips each time, 0 to 1000

	double lambda = 0; ///< weight of the density, >= 0; has a unit only with Preset::Paper
	std::optional<double> adapt; ///< adaptivity, [0, 1]; 0 = even sizes; see resolveAdapt

	double minEdge = 0;    ///< least local size, mesh units; 0 = no bound
	double maxEdge = 0;    ///< largest local size, mesh units; 0 = no bound
	double growth  = 1.15; ///< largest ratio of the local sizes at neighbouring edges, [1.05, 2]

	BoundaryMode boundary = BoundaryMode::Resample;
	/// Lengths of a periodic cell, mesh units, 0 along an axis without a period. Border vertices at
	/// opposite ends of the cell match, as BoundaryMode::Match is then in force.
	Vec3d period;

	Symmetry     symmetry  = Symmetry::Off;
	JunctionMode junctions = JunctionMode::Cut; ///< always Cut with Preset::Paper

	FeatureMode featureMode     = FeatureMode::Auto;
	double      featureAngleDeg = 40; ///< feature lines: between the normals of two faces, [5, 175]

	FeatureRegion featureRegion = FeatureRegion::Auto;
	/// Disk radius in the feature region over r, [0.05, 1]. 0 with a named region: 0.5, or with
	/// Preset::Paper no disks but all vertices of the region. 0 with FeatureRegion::Auto:
	/// no region.
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

/// Whether vertices leave the surface so that the triangles lie closer to the surface (fit.h).
inline bool isFitted(const RemeshOptions& options)
{
	return options.fit && !isPaper(options);
}

/// Whether the fit has rounds, which cost most of a run; the fit of Preset::Fast has a single step.
inline bool isFittedInRounds(const RemeshOptions& options)
{
	return isFitted(options) && options.preset != Preset::Fast;
}

/// Whether the options ask for a feature region, by its name or by its disk scale.
bool asksForFeatureRegion(const RemeshOptions& options);

/// Whether every vertex of the feature region becomes a vertex of the result (paper §3.1.1).
/// Otherwise the region is sampled first, with smaller disks. Needs resolveFeatureRegion before.
inline bool keepsRegionVertices(const RemeshOptions& options)
{
	return isPaper(options) && options.featureDiskScale == 0;
}

/// Whether the selected vertices are, or may become, the feature region: Selection or Auto.
bool mayUseSelectedVertices(const RemeshOptions& options);

/// Replaces FeatureRegion::Auto and a disk scale of 0 by the region and the scale in force.
void resolveFeatureRegion(bool anySelected, RemeshOptions& options);

/// The adaptivity in force: 0 with Preset::Paper, else `adapt` if given. Otherwise 0 if sizes come
/// from lambda or TargetMode::Sizes, and 0 without a fit (other presets, or `makesMesh` is false),
/// as adaptive sizes bring the result closer only together with the fit. Otherwise 0.1, but 1 with
/// TargetMode::MaxError: adaptive sizes keep a distance with the fewest vertices.
double resolveAdapt(const RemeshOptions& options, bool makesMesh);

/// The error of a Detail, as a share of the diagonal.
double detailError(Detail detail);

/// A sentence for each value out of range and each conflict; empty if the options are valid.
std::vector<std::string> validate(const RemeshOptions& options);

/// A sentence for each changed option without effect under the other options.
std::vector<std::string> optionsWithoutEffect(const RemeshOptions& options);

} // namespace gpr

#endif
