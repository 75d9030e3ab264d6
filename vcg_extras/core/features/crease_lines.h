// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_FEATURES_CREASE_LINES_H
#define VCG_EXTRAS_CORE_FEATURES_CREASE_LINES_H

#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/options.h>

#include <limits>
#include <vector>

namespace gpr {

/// The rules by which crease edges become feature lines. Lengths in working units.
struct CreaseRules {
	FeatureMode mode      = FeatureMode::Auto;
	float       strongDeg = 40; ///< a line begins at edges with this dihedral angle
	float       weakDeg   = 20; ///< a line continues from its ends down to this angle
	float       minLength = 0;  ///< connected lines with less total length are dropped
	float       minSpur   = 0;  ///< shorter chains with a free end are dropped
	/// Connected lines without a free end, like the rims of holes, stay from this length on, even
	/// if shorter than minLength.
	float minLoop = std::numeric_limits<float>::infinity();
	float minGap  = 0; ///< Auto: of two lines nearer than this, the weaker is dropped
	/// Auto: edges that are no noise if sharp, each by its smaller half-edge, ascending.
	std::vector<int> seams;
	/// Mean edge of the input if its edges have been split; 0: not split.
	float callersMeanEdge = 0;
};

/// The result of markCreases.
struct CreaseFindings {
	std::vector<int> coneApexes;    ///< cone apexes, on no line
	std::int64_t     creaseNum = 0; ///< crease edges that are no noise
	std::int64_t     edgeNum   = 0; ///< edges marked: of lines neither too short nor too close
	/// So often the least lengths of lines may double, and all lines stay.
	int spareDoublings = 0;
};

/// Marks the edges of feature lines in surface.mesh.crease, or leaves crease empty if there are
/// none.
///
/// An edge is sharp if its dihedral angle is at least strongDeg. From the free ends of sharp chains
/// a line continues along the sharpest edge ahead, as long as the edge has weakDeg. Auto mode takes
/// lines only if the sharp ones stand out. In a scan, sharp noise has neighbours nearly as sharp,
/// and its chains break off after a few edges. If less than 70 % of the sharp length is clear of
/// noise, only seams become lines; splitting edges beforehand does not change this. A cone apex is
/// a vertex whose angle defect is at least strongDeg while the vertices round it are smooth. Off
/// and Given mark nothing. Needs: connected, crease empty. Cost: linear, parallel, a few
/// milliseconds per million faces; the steps after the test for sharpness are serial, over the
/// edges found.
CreaseFindings markCreases(const CreaseRules& rules, Workers& workers, Surface& surface);

} // namespace gpr

#endif
