// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_FEATURES_FEATURE_DETECTION_H
#define VCG_EXTRAS_CORE_FEATURES_FEATURE_DETECTION_H

#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/options.h>
#include <vcg_extras/core/report.h>

#include <cstdint>

namespace gpr {

/// Features of a surface, in its numbering.
struct FeatureEdges {
	Buffer<float>        edgeStrength;  ///< per half-edge, degrees; both halves alike, 0 at borders
	Buffer<std::uint8_t> isFeatureEdge; ///< per half-edge, 0 or 1; both halves alike
	Buffer<float>        vertexStrength; ///< per vertex, degrees
	Buffer<std::uint8_t> vertexFeature;  ///< per vertex: VertexFeature bits, 0 for most

	float        support      = 0;     ///< radius of the half-disks, working units
	float        minLength    = 0;     ///< of a line, working units
	bool         supportCut   = false; ///< the support asked for was above the largest one
	std::int64_t edgeNum      = 0;     ///< feature edges
	std::int64_t lineNum      = 0;     ///< connected sets of feature edges
	std::int64_t cornerNum    = 0;
	std::int64_t coneApexNum  = 0;
	std::int64_t cappedRayNum = 0; ///< rays that ended by their bound instead of at the support
};

/// Mean length of the faces' sides, working units.
float meanEdgeLength(const HalfEdgeMesh& mesh, Workers& workers);
float meanEdgeLength(const IndexedMesh& mesh, Workers& workers);

/// Finds creases and cone apexes by a uniformly supported second-order difference (paper §3.1 names
/// it after Wang 2006 and leaves the thresholds to the user; its formula could not be found in
/// readable form, this one is the project's, docs/features.md).
///
/// The strength of an edge is the angle between the mean normals of its two half-disks (see
/// feature_strength.h), that of a vertex the largest of its edges'. A crease is felt up to a
/// support away, so lines are made of what is sharp: the mean of strength and dihedral angle, where
/// the latter makes up half of the strength at least and the surface is not as round on both sides.
/// Edges sharp by weakDeg and sharper than those across are candidates; gaps shorter than a support
/// are bridged, spurs shorter than that dropped. A line stays that has an edge sharp by strongDeg
/// and is minLength supports long. A cone apex is a vertex on no line about which the angle defects
/// within half a support add up to strongDeg.
///
/// meanEdge: working units, the length that thresholds.support counts in; that of the caller's mesh
/// even where the surface has been refined since. The support is at most 5 % of the square root of
/// the area, so that the half-disks of a box of twelve triangles do not wrap round it.
/// Cost: linear, parallel but for the linking; about 2 s per million faces and core with the
/// default support, growing with it.
FeatureEdges findFeatures(const Surface& surface, const FeatureThresholds& thresholds,
						  float meanEdge, Workers& workers);

} // namespace gpr

#endif
