// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef TESTS_CLI_SURFACE_CHECK_H
#define TESTS_CLI_SURFACE_CHECK_H

#include "mesh_files.h"

namespace gpr_test {

/// Fails the test unless every index is in range, every position finite, no face repeats a vertex,
/// every vertex is in a face, and every edge has one face, or two faces with opposite directions of
/// the edge.
void expectManifold(const TestMesh& mesh);

/// Vertices - edges + faces.
long eulerCharacteristic(const TestMesh& mesh);

/// The number of edges with one face.
long boundaryEdgeNum(const TestMesh& mesh);

} // namespace gpr_test

#endif
