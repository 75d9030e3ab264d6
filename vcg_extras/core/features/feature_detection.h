// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_FEATURES_FEATURE_DETECTION_H
#define VCG_EXTRAS_CORE_FEATURES_FEATURE_DETECTION_H

#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/options.h>
#include <vcg_extras/core/results.h>

#include <cstdint>

namespace gpr {

/// Features of a surface, in the numbering of the surface.
struct FeatureEdges {
	Buffer<float>        edgeStrength; ///< per half-edge, degrees; both halves alike, 0 at borders
	Buffer<float>        vertexStrength; ///< per vertex, degrees
	Buffer<std::uint8_t> vertexFeature;  ///< per vertex: VertexFeature bits, 0 for most

	float          support    = 0;     ///< radius of the half-disks, working units
	float          minLength  = 0;     ///< of a line, working units
	bool           supportCut = false; ///< the requested support was above the largest support
	FeatureFigures figures;            ///< counts of edges, lines, corners and cone apexes only
	std::int64_t   cappedRayNum = 0;   ///< rays cut off before they reached the support
};

/// Mean length of the sides of all faces, working units.
float meanEdgeLength(const IndexedMesh& mesh, Workers& workers);

/// Finds creases and cone apexes, and marks the edges of the creases in surface.mesh.crease, by a
/// uniformly supported second-order difference. Paper §3.1 names the method after Wang 2006 and
/// leaves the thresholds to the user. The formula of Wang could not be found in readable form; the
/// formula here is the project's (docs/features.md).
///
/// The strength of an edge is the angle between the mean normals of its two half-disks (see
/// feature_strength.h). The strength of a vertex is the largest strength of its edges. Strength is
/// also felt beside a crease, up to a support away. So lines are made by sharpness, the mean of
/// strength and dihedral angle. The dihedral angle must be at least half of the strength, and the
/// surface must not be as round on both sides. Candidates are edges sharper than weakDeg and than
/// the edges across. Gaps shorter than a support are bridged, shorter spurs are dropped. A line
/// stays if one of its edges is sharper than strongDeg and its length is minLength supports. A cone
/// apex is a vertex far from lines, with angle defects within half a support that add up to
/// strongDeg.
///
/// meanEdge: the unit of thresholds.support, in working units: the mean edge of the input, even
/// after the surface has been refined. The support is at most 5 % of the square root of the area,
/// so that the half-disks of a box of twelve triangles do not wrap round it. Cost: linear, parallel
/// but for the linking; about 2 s per million faces and core with the default support, growing with
/// the support.
FeatureEdges findFeatures(const FeatureThresholds& thresholds, float meanEdge, Workers& workers,
						  Surface& surface);

} // namespace gpr

#endif
