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

/// The time of sewing seams: before the mesh is connected, not yet, or never.
enum class Sewing { First, NotYet, Never };

/// The sewing for the options. Small components can only be counted in a sewn mesh.
Sewing sewingFor(const RemeshOptions& options, Sewing wanted);

/// The input without faults, before its edges are split.
struct CleanedInput {
	IndexedMesh mesh;
	FaceExtents extents;
	CleanCounts counts; ///< counts of the cleaning
};

// Each function below adds to the counts, and throws Failure if no face is left.

/// The input mesh without faulty faces and without the components that the options drop.
std::shared_ptr<CleanedInput> clean(RunContext& run, Sewing sewing, CleanCounts& counts);

/// Orders the mesh in space and connects its faces; repairs a mesh that is not manifold. Uses up
/// the mesh. keepsRings: see connect.
void connectOrRepair(RunContext& run, IndexedMesh& mesh, bool keepsRings, CleanCounts& counts,
					 Surface& surface);

/// Drops thin pieces (findFlatPieces), left by repair or there from the start: a result could mesh
/// such pieces by degenerate faces only. Pieces between other pieces stay.
void dropFlatPieces(RunContext& run, CleanCounts& counts, Surface& surface);

/// Orders and connects a mesh, and drops thin pieces; uses up the mesh. False if seams must be sewn
/// first. Most meshes have no seams, which a known border shows quickly; a search before connecting
/// would take a tenth of a quick run.
bool connectCleaned(RunContext& run, Sewing sewing, IndexedMesh& mesh, CleanCounts& counts,
					Surface& surface);

} // namespace gpr

#endif
