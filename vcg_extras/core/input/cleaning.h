// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_INPUT_CLEANING_H
#define VCG_EXTRAS_CORE_INPUT_CLEANING_H

#include "load.h"

#include <vcg_extras/core/base/run_context.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/mesh/indexed_mesh.h>
#include <vcg_extras/core/report.h>

#include <memory>

namespace gpr {

/// Whether seams are sewn before the mesh is connected.
enum class Sewing { First, NotYet, Never };

/// What the options ask for. Components must be whole where small ones are dropped.
Sewing sewingFor(const RemeshOptions& options, Sewing wanted);

/// The input without faults, before its edges are split.
struct CleanedInput {
	IndexedMesh mesh;
	FaceExtents extents;
	CleanCounts counts; ///< of what cleaning did
};

// Each function below adds to the counts what it did, and throws Failure where nothing is left.

/// The caller's mesh without faulty faces and without the components that the options drop.
std::shared_ptr<CleanedInput> clean(RunContext& run, Sewing sewing, CleanCounts& counts);

/// Orders the mesh in space and connects its faces; repairs it where it is not manifold. The mesh
/// is used up.
void connectOrRepair(RunContext& run, IndexedMesh& mesh, CleanCounts& counts, Surface& surface);

/// Pieces without area, left by repair or there from the start, could only be meshed by triangles
/// without area. Pieces that hold others together stay.
void dropFlatPieces(RunContext& run, CleanCounts& counts, Surface& surface);

/// Orders and connects a mesh, which is used up, and drops pieces without area. False where its
/// seams must be sewn first: most meshes have none, which is soon seen where the border is known.
/// To look for them before would take a tenth of a quick run.
bool connectCleaned(RunContext& run, Sewing sewing, IndexedMesh& mesh, CleanCounts& counts,
					Surface& surface);

} // namespace gpr

#endif
