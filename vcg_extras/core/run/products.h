// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_RUN_PRODUCTS_H
#define VCG_EXTRAS_CORE_RUN_PRODUCTS_H

#include "plan.h"

#include <vcg_extras/core/base/run_context.h>
#include <vcg_extras/core/features/boundary_curves.h>
#include <vcg_extras/core/features/crease_lines.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/mesh/face_contact.h>
#include <vcg_extras/core/mesh/octree_blocks.h>
#include <vcg_extras/core/output/verification.h>
#include <vcg_extras/core/report.h>
#include <vcg_extras/core/sampling/front_sampling.h>
#include <vcg_extras/core/sampling/fused_mesh.h>
#include <vcg_extras/core/surface/result_mesh.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace gpr {

/// Per vertex of the caller's: VertexFeature bits; empty: no vertex is marked.
using FeatureMarks = std::vector<std::uint8_t>;

/// The surface that is remeshed. From the step Lines on it does not change any more.
struct WorkingSurface : Surface {
	double      area            = 0; ///< working units squared
	float       callersMeanEdge = 0; ///< before edges were split, working units; 0: hardly any were
	CleanCounts cleaned;  ///< what cleaning and connecting did, and edges that were split
	BorderFigures border; ///< with BoundaryMode::Smooth
	MeshFigures   figures;

	bool isSewn() const { return cleaned.sewnEdges > 0; }
	/// Some borders lie at one place: see shared_borders.h.
	bool sharesBorders() const { return cleaned.sharedBorderEdges > 0 || mesh.meetsAtPlaces; }
};

/// How large the triangles are to be where; the sizes themselves are the surface's.
struct Sizes {
	double radiusFactor = 1;     ///< largest disk radius over that of eq. (1): see Sizing
	std::optional<double> adapt; ///< in force, once it is known: 0 where sizes stayed even
	Buffer<char>          isFeatureVertex;         ///< of the region to be preserved; empty: none
	std::vector<int>      kept;                    ///< the caller's vertices that stay
	std::int64_t          regionVertexNum = 0;     ///< of the caller's, in the region
	double                vertexNum       = 0;     ///< with TargetMode::Sizes: that they take
	std::int64_t          clampedNum      = 0;     ///< see Sizing
	bool                  followLines     = false; ///< see SizeFacts
};

/// The feature lines that are marked on the surface, and the samples on them and on the border.
struct Lines {
	CreaseFindings found;
	std::int64_t   edgeNum = 0; ///< with given ones
	BoundaryCurves curves;      ///< with samples, where they are known already
	float          radius = 0;  ///< for which they were sampled; 0: not yet

	// From the step Sizes, which asks whether there are lines.
	bool         areKnown = false; ///< the others below and `found` are those lines
	CreaseRules  rules;            ///< by which they were found
	Buffer<char> marks;            ///< for surface.mesh.crease
};

/// Samples of the surface, and what the retriangulation takes over from the sampling.
struct Samples {
	OctreeBlocks   partition;
	BoundaryCurves curves;
	Sampling       sampling;
	FusedMesh      fused;          ///< with the samples of the border-edge placement, else empty
	float          radius     = 0; ///< of the largest disks, working units
	std::int64_t   spacedFor  = 0; ///< count that they were placed for
	std::int64_t   num        = 0;
	std::int64_t   onCurveNum = 0; ///< of these, on borders and feature lines

	// Of samples that the caller gave: see GivenSamples.
	std::vector<char> isMoved;
	std::int64_t      movedNum = 0;
	float             farthest = 0;

	/// Frees all but the figures.
	void release();
};

/// What the steps have made so far, in their order. A later product refers to earlier ones.
struct Products {
	FeatureMarks                  regionMarks; ///< Region
	std::shared_ptr<CleanedInput> input;       ///< Input; Surface uses it up where it is alone
	WorkingSurface                surface;     ///< Surface
	Sizes                         sizes;       ///< Sizes
	Lines                         lines;       ///< Lines
	Samples                       samples;     ///< Samples; Triangles uses them up
	BoundaryCurves                curves;      ///< Triangles: those that vertices lie on
	ResultMesh                    result;      ///< Triangles to Contacts
	std::unique_ptr<ResultMesh>   beforeFit;   ///< Fit, where feature lines may be released
	KnownContacts                 contacts;    ///< Fit

	// What the later steps tell.
	std::int64_t   releasedNum = 0; ///< vertices that left crowded lines
	float          fitDistance = 0; ///< largest of a vertex from its surface point, working units
	GuardedFigures guarded;         ///< Contacts
	bool           hasMadeVertices = false; ///< Contacts, the last time
	bool           keepsGoal       = false; ///< Refinement: no point was beyond the goal
	Verification   verified;                ///< Error (its proof), Check
	QualityFigures quality;                 ///< Export
	std::int64_t   regularNum = 0;          ///< Export: see RemeshReport::regularVertexNum

	/// Drops what a step and later ones have made, so that its memory is free.
	void dropFrom(Step step);
};

/// Radius of the largest disks for a count, working units.
float usualRadius(const Products& made, const RemeshOptions& options, std::int64_t vertexNum);
/// Edge length of the largest triangles with a count, working units.
float idealEdge(const Products& made, std::int64_t vertexNum);
/// What becomes of the border.
BoundaryMode borderMode(const RemeshOptions& options, const Decisions& decisions);

} // namespace gpr

#endif
