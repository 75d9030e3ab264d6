// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_formats.h"

#include <vcg_extras/io/base/exit_code.h>

namespace gpr::app {

bool hasGltfText()
{
	return false;
}

std::string glbOfGltf(std::string_view, const std::string&)
{
	throw AppError(ExitCode::BadInput, "this build has no TinyGLTF");
}

std::string gltfOfGlb(const std::string&)
{
	throw AppError(ExitCode::Failure, "this build has no TinyGLTF.");
}

} // namespace gpr::app
