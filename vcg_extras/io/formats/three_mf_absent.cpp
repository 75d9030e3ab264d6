// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_formats.h"

#include <vcg_extras/io/base/exit_code.h>

namespace gpr::app {

bool hasThreeMf()
{
	return false;
}

InputMesh readThreeMf(std::string_view)
{
	throw AppError(ExitCode::BadInput, "this build has no lib3mf");
}

void writeThreeMf(const TriangleMesh&, const std::string&, OutputFile&)
{
	throw AppError(ExitCode::Failure, "this build has no lib3mf.");
}

} // namespace gpr::app
