// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_COMPARE_BASELINE_REMESHERS_H
#define VCG_EXTRAS_APPS_GPREMESH_COMPARE_BASELINE_REMESHERS_H

#include <vcg_extras/core/mesh_view.h>

#include <cstdint>
#include <functional>
#include <string>

// What MeshLab offers for the same purpose, for the comparison only: vcglib's own code with the
// parameters that MeshLab's dialogs propose. In a program built without vcglib every one fails with
// a sentence.

namespace gpr::app {

/// What a baseline made of a mesh, and how long that took.
struct BaselineResult {
	TriangleMesh mesh;
	double       seconds          = 0; ///< from vcglib's mesh in memory to the result in memory
	double       processorSeconds = 0; ///< of the same; the fairer figure on a busy machine
	std::string  failure;              ///< a sentence where there is no mesh
};

/// Asked now and then; true ends the work.
using StopQuestion = std::function<bool()>;

/// MeshLab's "Simplification: Quadric Edge Collapse Decimation" down to faceNum faces; see
/// vcg_extras/complex/baselines/quadric_collapse.h.
BaselineResult collapseQuadricEdges(const MeshView& mesh, std::int64_t faceNum,
									const StopQuestion& shallStop);

/// MeshLab's "Remeshing: Isotropic Explicit Remeshing" with that target length, mesh units: three
/// rounds of splits, collapses, flips, smoothing and reprojection; crease angle 30°, no operation
/// further than 1 % of the diagonal from the surface. One thread; cannot be stopped.
BaselineResult remeshIsotropically(const MeshView& mesh, double edgeLen);

} // namespace gpr::app

#endif
