// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GPR_TESTS_SUPPORT_MODEL_FILES_H
#define GPR_TESTS_SUPPORT_MODEL_FILES_H

#include <vcg_extras/core/mesh_view.h>

#include <string>

namespace gpr::test {

// Real scans and parts are no part of the project: the folder that holds them is named by the
// environment variable GPR_MODELS_DIR. One, bunny.obj, is in Debian's glmark2-data, which
// scripts/setup installs.

/// A file of that folder or package.
struct ModelFile {
	std::string path;
	std::string missing; ///< why it cannot be read; empty if it is there

	bool isThere() const { return missing.empty(); }
};

/// One that ends in .gz is unpacked into the folder for temporary files.
ModelFile findModel(const std::string& name);

/// The name of a file up to the first underscore, for the names of tests.
std::string shortName(const std::string& file);

TriangleMesh copyOf(const MeshView& view);

} // namespace gpr::test

#endif
