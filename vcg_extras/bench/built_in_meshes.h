// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_BENCH_BUILT_IN_MESHES_H
#define VCG_EXTRAS_BENCH_BUILT_IN_MESHES_H

#include <vcg_extras/core/mesh_view.h>

#include <cstdint>
#include <string>

namespace gpr::bench {

// Meshes made in code, of about faceNum faces, with features that decide the time of a run: a
// scan's roughness, a border, creases.

/// A closed surface, rough on every scale.
TriangleMesh roughStone(std::int64_t faceNum);
/// An open surface: rough land over a square.
TriangleMesh roughLand(std::int64_t faceNum);
/// A box with flat sides and crease edges, unevenly meshed.
TriangleMesh sharpBox(std::int64_t faceNum);

/// Makes the mesh of a name: stone, land or box. False for an unknown name.
bool makeBuiltIn(const std::string& name, std::int64_t faceNum, TriangleMesh& mesh);

} // namespace gpr::bench

#endif
