// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_RUN_LOADING_H
#define VCG_EXTRAS_CORE_RUN_LOADING_H

#include <vcg_extras/core/base/run_context.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/mesh/indexed_mesh.h>

namespace gpr {

/// Whether seams are sewn before the mesh is connected.
enum class Sewing { First, NotYet, Never };

/// What the options ask for. Components must be whole where small ones are dropped.
Sewing sewingFor(const RemeshOptions& options, Sewing wanted);

/// The caller's mesh without faulty faces and without the components that the options drop. They
/// must go before the area is found, and with it the radius.
IndexedMesh loadCleaned(RunContext& run, Sewing sewing = Sewing::First);

/// Orders the mesh in space and connects its faces; repairs it where it is not manifold. The mesh
/// is used up.
void connectOrRepair(RunContext& run, IndexedMesh& mesh, Surface& surface);

/// Pieces without area, left by repair or there from the start, could only be meshed by triangles
/// without area. Pieces that hold others together stay.
void dropFlatPieces(RunContext& run, Surface& surface);

/// Tells counts and size of the input and of its cleaned surface.
void describeInput(RunContext& run, const Surface& surface);

} // namespace gpr

#endif
