// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GPR_TESTS_SUPPORT_MODEL_FILES_H
#define GPR_TESTS_SUPPORT_MODEL_FILES_H

#include <vcg_extras/core/mesh_view.h>

#include <string>

namespace gpr::test {

// The project contains no real scans and parts. The environment variable GPR_MODELS_DIR names their
// folder; bunny.obj comes from Debian's package glmark2-data (scripts/setup installs the package).

/// A model file, or the reason for its absence.
struct ModelFile {
	std::string path;
	std::string missing; ///< why the file cannot be read; else empty

	bool isThere() const { return missing.empty(); }
};

/// Finds a model by its name. A file with the end .gz is unpacked into the folder for temporary
/// files.
ModelFile findModel(const std::string& name);

/// The name of a file up to the first underscore, for the names of tests.
std::string shortName(const std::string& file);

} // namespace gpr::test

#endif
