// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model_files.h"

#include <cstdlib>
#include <fstream>

namespace gpr::test {

ModelFile findModel(const std::string& name)
{
	const char* folder = std::getenv("GPR_MODELS_DIR");
	if (folder == nullptr) return {"", "GPR_MODELS_DIR is not set"};
	const std::string path = std::string(folder) + "/" + name;
	return {path, std::ifstream(path) ? "" : name + " is not there"};
}

std::string shortName(const std::string& file)
{
	return file.substr(0, file.find('_'));
}

TriangleMesh copyOf(const MeshView& view)
{
	TriangleMesh mesh;
	for (std::size_t v = 0; v < view.vertexNum; ++v)
		mesh.positions.push_back(view.position(v));
	mesh.triangles = trianglesOf(view);
	return mesh;
}

} // namespace gpr::test
