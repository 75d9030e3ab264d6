// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_RUN_PRODUCTS_H
#define VCG_EXTRAS_CORE_RUN_PRODUCTS_H

#include "plan.h"

#include <vcg_extras/core/features/boundary_curves.h>
#include <vcg_extras/core/features/crease_lines.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/mesh/octree_blocks.h>
#include <vcg_extras/core/optimization/face_repair.h>
#include <vcg_extras/core/optimization/goal_refinement.h>
#include <vcg_extras/core/output/verification.h>
#include <vcg_extras/core/report.h>
#include <vcg_extras/core/sampling/front_sampling.h>
#include <vcg_extras/core/sampling/fused_mesh.h>
#include <vcg_extras/core/sampling/given_samples.h>
#include <vcg_extras/core/sampling/sizing.h>
#include <vcg_extras/core/surface/result_mesh.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace gpr {

/// VertexFeature bits per vertex of the input; empty: no vertex is marked.
using FeatureMarks = std::vector<std::uint8_t>;

/// The working surface. From the step Lines on it does not change.
struct WorkingSurface : Surface {
	double        area            = 0; ///< working units squared; of half a mesh: of both halves
	float         callersMeanEdge = 0; ///< before long edges were split, working units; 0: few were
	CleanCounts   cleaned;             ///< changes by cleaning, connecting and splits of long edges
	BorderFigures border;              ///< with BoundaryMode::Smooth
	MeshFigures   figures;

	bool isSewn() const { return cleaned.sewnEdges > 0; }
	/// Whether some borders lie at one place: see shared_borders.h.
	bool sharesBorders() const { return cleaned.sharedBorderEdges > 0 || mesh.meetsAtPlaces; }
};

/// The facts about local sizes. The sizes themselves go to the working surface.
struct Sizes : Sizing {
	std::optional<double> adapt; ///< adaptivity in force; 0: even sizes; none: not known yet
	Buffer<char>          isFeatureVertex;         ///< of the feature region; empty: no region
	std::vector<int>      kept;                    ///< vertices of the input that must stay
	std::int64_t          regionVertexNum = 0;     ///< vertices of the input in the region
	bool                  followLines     = false; ///< see SizeFacts
};

/// The feature lines of the working surface, and the samples on feature lines and borders.
struct Lines {
	CreaseFindings found;
	std::int64_t   edgeNum = 0; ///< with given lines
	BoundaryCurves curves;      ///< with samples, if the radius is known
	float          radius = 0;  ///< disk radius of the samples; 0: no samples yet

	// From the step Sizes, which looks for lines before sizes are known.
	bool         areKnown = false; ///< `found`, `rules` and `marks` come from the step Sizes
	CreaseRules  rules;            ///< used for the search
	Buffer<char> marks;            ///< for surface.mesh.crease
};

/// The samples of the working surface, and the parts of the sampling that the retriangulation uses.
struct Samples {
	OctreeBlocks   partition;
	BoundaryCurves curves;
	Sampling       sampling;
	FusedMesh      fused;          ///< only of the border-edge placement, else empty
	float          radius     = 0; ///< of the largest disks, working units
	std::int64_t   spacedFor  = 0; ///< count for the spacing
	std::int64_t   num        = 0;
	std::int64_t   onCurveNum = 0; ///< samples on borders and feature lines
	GivenSamples   given;          ///< of the user; `sampling` gets theirs

	/// Frees everything except the figures.
	void release();
};

/// The products of the steps so far, in the order of the steps. A later product refers to earlier
/// products.
struct Products {
	FeatureMarks                  regionMarks; ///< Region
	std::shared_ptr<CleanedInput> input;   ///< Input; Surface consumes it if nothing else holds it
	WorkingSurface                surface; ///< Surface
	Sizes                         sizes;   ///< Sizes
	Lines                         lines;   ///< Lines
	Samples                       samples; ///< Samples; Triangles consumes the samples
	BoundaryCurves                curves;  ///< Triangles: the curves with vertices
	ResultMesh                    result;  ///< Triangles to Contacts
	std::unique_ptr<ResultMesh>   beforeFit; ///< Fit to Angles, if feature lines may be released
	PoorFaces                     poor;      ///< Fit to Angles

	// Figures of the later steps.
	std::int64_t   releasedNum = 0;             ///< vertices released from crowded lines
	GuardedFigures guarded;                     ///< Contacts
	GoalOutcome    refined = GoalOutcome::Open; ///< Refinement
	Verification   verified;                    ///< Error (its proof), Check
	QualityFigures quality;                     ///< Export
	std::int64_t   regularNum = 0;              ///< Export: see RemeshReport::regularVertexNum

	/// Frees the products of a step and of all later steps.
	void dropFrom(Step step);
};

/// The radius of the largest disks for a count, working units.
float usualRadius(const Products& made, const RemeshOptions& options, std::int64_t vertexNum);
/// The edge length of the largest triangles for a count, working units.
float idealEdge(const Products& made, std::int64_t vertexNum);
/// The treatment of the border in force.
BoundaryMode borderMode(const RemeshOptions& options, const Decisions& decisions);

} // namespace gpr

#endif
