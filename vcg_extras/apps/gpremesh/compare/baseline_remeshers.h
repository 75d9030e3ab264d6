// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_COMPARE_BASELINE_REMESHERS_H
#define VCG_EXTRAS_APPS_GPREMESH_COMPARE_BASELINE_REMESHERS_H

#include <vcg_extras/core/mesh_view.h>

#include <cstdint>
#include <functional>
#include <string>

// MeshLab's remeshers, for the comparison only: vcglib's own code with the default parameters of
// MeshLab's dialogs. In a program built without vcglib each fails with a sentence.

namespace gpr::app {

/// The result of a baseline, and its time.
struct BaselineResult {
	TriangleMesh mesh;
	double       seconds          = 0; ///< from vcglib's mesh in memory to the result in memory
	double       processorSeconds = 0; ///< of the processor; the fairer figure on a busy machine
	std::string  failure;              ///< a sentence if there is no mesh
};

/// Called now and then; true ends the work.
using StopQuestion = std::function<bool()>;

/// MeshLab's "Simplification: Quadric Edge Collapse Decimation" down to faceNum faces; see
/// vcg_extras/complex/baselines/quadric_collapse.h.
BaselineResult collapseQuadricEdges(const MeshView& mesh, std::int64_t faceNum,
									const StopQuestion& shallStop);

/// MeshLab's "Remeshing: Isotropic Explicit Remeshing" with edge length edgeLen, mesh units: three
/// rounds of splits, collapses, flips, smoothing and reprojection; crease angle 30°, no operation
/// further than 1 % of the diagonal from the surface. One thread; cannot be stopped.
BaselineResult remeshIsotropically(const MeshView& mesh, double edgeLen);

} // namespace gpr::app

#endif
