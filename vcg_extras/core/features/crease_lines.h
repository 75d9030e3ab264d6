// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_FEATURES_CREASE_LINES_H
#define VCG_EXTRAS_CORE_FEATURES_CREASE_LINES_H

#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/options.h>

#include <limits>
#include <vector>

namespace gpr {

/// By which rules sharp edges become feature lines. Lengths in working units.
struct CreaseRules {
	FeatureMode mode      = FeatureMode::Auto;
	float       strongDeg = 40; ///< a line begins where the faces' normals differ by this
	float       weakDeg   = 20; ///< and goes on, from its ends, down to this
	float       minLength = 0;  ///< connected lines shorter than this in all are dropped
	float       minSpur   = 0;  ///< so are pieces with a free end
	/// Lines without an end, like the rims of holes, stay from this length on, be it below
	/// minLength.
	float minLoop = std::numeric_limits<float>::infinity();
	float minGap  = 0; ///< Auto: so is the weaker of two lines nearer than this to each other
	/// Auto: edges that are no noise if they are sharp, each by its smaller half-edge, ascending.
	std::vector<int> seams;
	/// Of the caller's mesh if its edges have been split; 0: they were not.
	float callersMeanEdge = 0;
};

/// What was found.
struct CreaseFindings {
	std::vector<int> coneApexes;       ///< vertices where a cone has its apex, off the lines
	std::int64_t     edgeNum  = 0;     ///< edges marked
	bool             wasNoise = false; ///< Auto: there are sharp edges, but they look like noise
};

/// Marks the edges of feature lines in surface.mesh.crease, or leaves it empty if there are none.
///
/// An edge is sharp where the normals of its faces differ by strongDeg. From the free ends of sharp
/// chains the line goes on along the edge that continues it best, as long as that has weakDeg. In
/// Auto mode lines are only taken if sharp edges stand out: those of a scan's noise have others
/// nearly as sharp beside them and break off after a few edges; where less than 70 % of the sharp
/// length is clear of that, there are no lines but the seams; splitting edges before changes
/// nothing of it. Cone apexes are vertices whose angle defect exceeds strongDeg while the
/// vertices round them are smooth. With Off and Given nothing is marked. Needs: connected, crease
/// empty. Cost: linear, parallel, a few milliseconds a million faces; what follows the test for
/// sharpness is serial, over the sharp edges.
CreaseFindings markCreases(const CreaseRules& rules, Workers& workers, Surface& surface);

} // namespace gpr

#endif
