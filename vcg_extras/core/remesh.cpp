// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh.h"
namespace gpr {
RemeshResult remesh(const MeshView&, const RemeshOptions&, const ProgressCallback&) { return {}; }
SamplingResult samplePoissonDisks(const MeshView&, const RemeshOptions&, const ProgressCallback&) { return {}; }
RemeshResult retriangulate(const MeshView&, const std::vector<Vec3d>&, const RemeshOptions&, const ProgressCallback&) { return {}; }
const char* statusName(Status) { return ""; }
}
